// Embree asked of meshes: rays, points, and pairs of its boxes; in single precision.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/distance_tests.hpp"
#include "lab/trial/mesh_questions.hpp"

namespace plumb::bench {
namespace {

using namespace lab::trial;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

RTCDevice mesh_device() {
  static RTCDevice const one = rtcNewDevice("threads=1");
  return one;
}

struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using SceneOfMesh = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

struct EmbreeMesh {
  SceneOfMesh scene;
  std::vector<std::array<float, 9>> triangles;
};

EmbreeMesh embree_mesh(const TriangleMesh& mesh, RTCSceneFlags flags) {
  RTCGeometry geometry = rtcNewGeometry(mesh_device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    vertices[3 * i] = static_cast<float>(mesh.vertices[i].x);
    vertices[3 * i + 1] = static_cast<float>(mesh.vertices[i].y);
    vertices[3 * i + 2] = static_cast<float>(mesh.vertices[i].z);
  }
  auto* const corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
  EmbreeMesh made;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::array<float, 9> one{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[3 * i + k] = mesh.triangles[i][k];
      std::copy_n(vertices + std::size_t{3} * mesh.triangles[i][k], 3, &one[3 * k]);
    }
    made.triangles.push_back(one);
  }
  rtcCommitGeometry(geometry);
  made.scene = SceneOfMesh(rtcNewScene(mesh_device()));
  rtcSetSceneFlags(made.scene.get(), flags);
  rtcAttachGeometry(made.scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(made.scene.get());
  return made;
}

RTCRayHit cast_of(std::span<const double> q) {
  RTCRayHit cast{};
  cast.ray.org_x = static_cast<float>(q[4]);
  cast.ray.org_y = static_cast<float>(q[5]);
  cast.ray.org_z = static_cast<float>(q[6]);
  cast.ray.dir_x = static_cast<float>(q[7]);
  cast.ray.dir_y = static_cast<float>(q[8]);
  cast.ray.dir_z = static_cast<float>(q[9]);
  cast.ray.tfar = std::numeric_limits<float>::infinity();
  cast.ray.mask = ~0U;
  cast.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return cast;
}

double first_of(const EmbreeMesh& mesh, const RTCRayHit& cast) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit one = cast;
  rtcIntersect1(mesh.scene.get(), &context, &one);
  return one.hit.geomID == RTC_INVALID_GEOMETRY_ID ? no_item : one.hit.primID;
}

struct Nearest {
  const EmbreeMesh* mesh;
  double number;
};

/// The distance to one triangle as Embree's manual has its users compute it, in floats.
bool look_at(RTCPointQueryFunctionArguments* args) {
  auto& nearest = *static_cast<Nearest*>(args->userPtr);
  std::array<float, 12> q{args->query->x, args->query->y, args->query->z};
  std::copy_n(nearest.mesh->triangles[args->primID].begin(), 9, &q[3]);
  const auto far = static_cast<float>(PointTriangleDistance{}(q, 0.0F));
  if (!(far < args->query->radius)) return false;
  args->query->radius = far;
  nearest.number = args->primID;
  return true;
}

double nearest_of(const EmbreeMesh& mesh, const std::array<float, 3>& p) {
  RTCPointQuery query{};
  query.x = p[0], query.y = p[1], query.z = p[2];
  query.radius = std::numeric_limits<float>::infinity();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  Nearest nearest{&mesh, no_item};
  rtcPointQuery(mesh.scene.get(), &query, &context, look_at, &nearest);
  return nearest.number;
}

/// Boxes for rtcCollide, which takes geometry of users only, and triangles for CGAL.
struct Boxes {
  SceneOfMesh scene;
  std::unique_ptr<std::vector<Kernel::Triangle_3>> triangles;
};

void bound(const RTCBoundsFunctionArguments* args) {
  const auto& t = (*static_cast<const std::vector<Kernel::Triangle_3>*>(args->geometryUserPtr))[args->primID];
  const CGAL::Bbox_3 box = t.bbox();
  const auto down = [](double x) {
    const auto f = static_cast<float>(x);
    return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
  };
  const auto up = [down](double x) { return -down(-x); };
  *args->bounds_o = {down(box.xmin()), down(box.ymin()), down(box.zmin()), 0,
                     up(box.xmax()),   up(box.ymax()),   up(box.zmax()),   0};
}

Boxes boxes_of(const TriangleMesh& mesh) {
  Boxes made{nullptr, std::make_unique<std::vector<Kernel::Triangle_3>>()};
  const auto at = [&mesh](std::uint32_t i) {
    const Point3& p = mesh.vertices[i];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  for (const auto& [a, b, c] : mesh.triangles) made.triangles->emplace_back(at(a), at(b), at(c));
  RTCGeometry geometry = rtcNewGeometry(mesh_device(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(made.triangles->size()));
  rtcSetGeometryUserData(geometry, made.triangles.get());
  rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
  rtcCommitGeometry(geometry);
  made.scene = SceneOfMesh(rtcNewScene(mesh_device()));
  rtcAttachGeometry(made.scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(made.scene.get());
  return made;
}

struct Collected {
  const Boxes *a, *b;
  Pairs pairs;
};

void collect(void* to, RTCCollision* collisions, unsigned count) {
  auto& found = *static_cast<Collected*>(to);
  for (unsigned i = 0; i < count; ++i) {
    const unsigned s = collisions[i].primID0, t = collisions[i].primID1;
    if (CGAL::do_intersect((*found.a->triangles)[s], (*found.b->triangles)[t])) found.pairs.push_back({s, t});
  }
}

}  // namespace

void add_embree_meshes(Rivals& all) {
  for (const auto& [name, about, flags] :
       {std::tuple{"embree", "Embree's rtcIntersect1, its default", RTC_SCENE_FLAG_NONE},
        std::tuple{"embree-robust", "Embree's rtcIntersect1, a scene with RTC_SCENE_FLAG_ROBUST",
                   RTC_SCENE_FLAG_ROBUST}}) {
    all.push_back(
        {"closest-hit", of_one_mesh<ray_numbers>(
                            name, about, [flags = flags](const TriangleMesh& m) { return embree_mesh(m, flags); },
                            cast_of, first_of)});
  }
  all.push_back({"closest-point-on-mesh",
                 of_one_mesh<place_numbers>(
                     "embree", "Embree's rtcPointQuery, distances in floats",
                     [](const TriangleMesh& m) { return embree_mesh(m, RTC_SCENE_FLAG_ROBUST); },
                     [](std::span<const double> q) {
                       return std::array{static_cast<float>(q[4]), static_cast<float>(q[5]), static_cast<float>(q[6])};
                     },
                     nearest_of)});
  all.push_back(
      {"mesh-pairs", without_flat_triangles(
                         of_two_meshes("embree-cgal", "Embree's rtcCollide, and CGAL's do_intersect of Epick", boxes_of,
                                       [](const Boxes& a, const Boxes& b) {
                                         Collected found{&a, &b, {}};
                                         rtcCollide(a.scene.get(), b.scene.get(), collect, &found);
                                         // Of a scene with itself it leaves these out.
                                         for (unsigned i = 0; &a == &b && i < a.triangles->size(); ++i)
                                           found.pairs.push_back({i, i});
                                         return std::move(found.pairs);
                                       }),
                         2)});
}

}  // namespace plumb::bench
