// How long does it take to find all pairs of triangles that meet?  One thread; beside CGAL's tree of boxes, the pairs of
// Embree's boxes asked by CGAL's exact test, and FCL, which rounds.
//
// Meshes: a torus of 4 n^2 / 2 triangles against itself turned a little, which crosses it along curves; against itself
// moved by nothing, where every pair is exactly degenerate; and itself alone, which has no pairs but neighbors.  Others
// against themselves: of short integers, of floats, in one plane, and so many times one triangle.
// `s_pair` is the time of each pair found, `s_triangle` that of each triangle of a mesh; trees are built beforehand.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "bench/rivals/mesh_rival.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/space.hpp"
#ifdef PLUMB_BENCH_EMBREE
#include <embree3/rtcore.h>
#endif
#ifdef PLUMB_BENCH_FCL
#include <fcl/narrowphase/collision.h>

#include "bench/rivals/fcl_meshes.hpp"
#endif

namespace plumb::bench {
namespace {

#ifdef PLUMB_BENCH_EMBREE
/// Boxes for rtcCollide, which takes geometry of users only.
class EmbreeBoxes {
 public:
  explicit EmbreeBoxes(const TriangleMesh& mesh) : triangles_(mesh) {
    static const RTCDevice device = rtcNewDevice("threads=1");
    for (const auto& [a, b, c] : mesh.triangles) {
      boxes_.push_back(float_box(Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}));
    }
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes_.size()));
    rtcSetGeometryUserData(geometry, boxes_.data());
    rtcSetGeometryBoundsFunction(
        geometry,
        [](const RTCBoundsFunctionArguments* args) {
          *args->bounds_o = static_cast<const RTCBounds*>(args->geometryUserPtr)[args->primID];
        },
        nullptr);
    rtcCommitGeometry(geometry);
    scene_ = rtcNewScene(device);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeBoxes() { rtcReleaseScene(scene_); }
  EmbreeBoxes(const EmbreeBoxes&) = delete;
  EmbreeBoxes& operator=(const EmbreeBoxes&) = delete;

  [[nodiscard]] std::size_t pairs_with(const EmbreeBoxes& other) const {
    struct Found {
      const CgalMesh *a, *b;
      std::size_t pairs;
    } found{&triangles_, &other.triangles_, 0};
    rtcCollide(
        scene_, other.scene_,
        [](void* to, RTCCollision* collisions, unsigned count) {
          auto& all = *static_cast<Found*>(to);
          for (unsigned i = 0; i < count; ++i) {
            all.pairs += all.a->meeting(*all.b, {{{collisions[i].primID0, collisions[i].primID1}}});
          }
        },
        &found);
    return found.pairs;
  }

 private:
  static RTCBounds float_box(const Triangle3& t) {
    const auto down = [](double x) {
      const auto f = static_cast<float>(x);
      return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
    };
    const auto up = [&](double x) { return -down(-x); };
    const auto least = [&](double Point3::*at) { return down(std::min({t.a.*at, t.b.*at, t.c.*at})); };
    const auto most = [&](double Point3::*at) { return up(std::max({t.a.*at, t.b.*at, t.c.*at})); };
    return {least(&Point3::x), least(&Point3::y), least(&Point3::z), 0,
            most(&Point3::x),  most(&Point3::y),  most(&Point3::z),  0};
  }
  CgalMesh triangles_;
  std::vector<RTCBounds> boxes_;
  RTCScene scene_;
};
#endif

#ifdef PLUMB_BENCH_FCL
std::size_t fcl_pairs(const FclModel& a, const FclModel& b) {
  const fcl::Transform3d place = fcl::Transform3d::Identity();
  const fcl::CollisionRequestd request(std::size_t{1} << 30, false);
  fcl::CollisionResultd result;
  fcl::collide(&a, place, &b, place, request, result);
  return result.numContacts();
}
#endif

TriangleMesh torus(std::uint32_t around) { return solids::torus(300, 100, around, around / 2); }

TriangleMesh turned(TriangleMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point3& p : mesh.vertices) p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
  return mesh;
}

void add_pairs(const std::string& name, std::size_t triangles, std::function<std::size_t()> count) {
  benchmark::RegisterBenchmark(name.c_str(), [triangles, count = std::move(count)](benchmark::State& state) {
    std::size_t pairs = 0;
    for (auto _ : state) benchmark::DoNotOptimize(pairs = count());
    const auto each = [&](std::size_t n) {
      return benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(n),
                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    };
    state.counters["pairs"] = static_cast<double>(pairs);
    state.counters["s_pair"] = each(pairs);
    state.counters["s_triangle"] = each(triangles);
  })->Unit(benchmark::kMillisecond);
}

void add_mesh(std::uint32_t around) {
  const auto mesh = std::make_shared<TriangleMesh>(torus(around));
  const auto bvh = std::make_shared<Bvh>(build_bvh(*mesh));
  const auto cgal = std::make_shared<CgalMesh>(*mesh);
  const std::string size = std::to_string(mesh->triangles.size());
  const std::size_t n = mesh->triangles.size();
  const PairOptions serial{.execution = Execution::serial};
  for (const double angle : {0.0, 0.1}) {
    const auto other = std::make_shared<TriangleMesh>(turned(*mesh, angle));
    const auto tree = std::make_shared<Bvh>(build_bvh(*other));
    const std::string name = "mesh_pairs/" + std::string(angle == 0 ? "same/" : "turned/") + size;
    add_pairs(name + "/plumb", n, [=] { return intersecting_pairs(*bvh, *tree, serial).size(); });
    add_pairs(name + "/plumb_any", n, [=] { return any_intersecting_pair(*bvh, *tree, serial) ? 1u : 0u; });
    add_pairs(name + "/cgal", n, [=] { return cgal->pairs_with(*other); });
#ifdef PLUMB_BENCH_EMBREE
    const auto boxes = std::make_shared<EmbreeBoxes>(*mesh), other_boxes = std::make_shared<EmbreeBoxes>(*other);
    add_pairs(name + "/embree_cgal", n, [=] { return boxes->pairs_with(*other_boxes); });
#endif
#ifdef PLUMB_BENCH_FCL
    add_pairs(name + "/fcl", n, [model = std::shared_ptr(fcl_model(*mesh)), to = std::shared_ptr(fcl_model(*other))] {
      return fcl_pairs(*model, *to);
    });
#endif
  }
  add_pairs("mesh_pairs/itself/" + size + "/plumb", n, [=] { return intersecting_pairs(*bvh, serial).size(); });
}

/// On itself as it is, where each pair is exactly degenerate.
void add_same(const std::string& about, const TriangleMesh& mesh) {
  const auto bvh = std::make_shared<Bvh>(build_bvh(mesh));
  const auto cgal = std::make_shared<CgalMesh>(mesh);
  const auto own = std::make_shared<TriangleMesh>(mesh);
  const std::string name = "mesh_pairs/same_" + about + "/" + std::to_string(mesh.triangles.size());
  const std::size_t n = mesh.triangles.size();
  const PairOptions serial{.execution = Execution::serial};
  add_pairs(name + "/plumb", n, [=] { return intersecting_pairs(*bvh, *bvh, serial).size(); });
  add_pairs(name + "/cgal", n, [=] { return cgal->pairs_with(*own); });
}

TriangleMesh rounded(TriangleMesh mesh, double (*round)(double)) {
  for (Point3& p : mesh.vertices) p = {round(p.x), round(p.y), round(p.z)};
  return mesh;
}

TriangleMesh flat_grid(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i)
    mesh.vertices.push_back({0.25 * (i % (n + 1)), 0.5 * (i / (n + 1)), 0});
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const std::uint32_t a = i / n * (n + 1) + i % n;
    mesh.triangles.push_back({a, a + 1, a + n + 2});
    mesh.triangles.push_back({a, a + n + 2, a + n + 1});
  }
  return mesh;
}

const bool added = [] {
  add_same("lattice", rounded(torus(208), [](double x) { return std::round(1024 * x) / 1024; }));  // of 20 bits
  add_same("float", rounded(torus(208), [](double x) { return static_cast<double>(static_cast<float>(x)); }));
  add_same("flat", flat_grid(100));
  add_same("copies", {{{1, 2, 3}, {4, 5.1, 6}, {7.3, 8, 10}}, {1000, {0, 1, 2}}});
  add_mesh(64);
  add_mesh(294);
  add_mesh(416);
  return true;
}();

}  // namespace
}  // namespace plumb::bench
