// Solids whose corners are exact, chained without rounding, and the curves where surfaces meet.
#include <memory>
#include <string>

#include "c/figures.hpp"
#include "c/solids.hpp"
#include "c/texts.hpp"
#include "plumb/surface/solid/intersection_curves.hpp"

using namespace plumb;
using c::guarded, c::need, c::need_size;

struct plumb_exact_mesh {
  ExactMesh mesh;
};

struct plumb_curves {
  std::vector<std::vector<Point3>> points;
  std::vector<IntersectionCurve> exact;
  std::vector<plumb_curve> each;
};

extern "C" {

plumb_status plumb_exact_mesh_create(const plumb_mesh* mesh, const plumb_rigid3* pose, plumb_exact_mesh** exact) {
  return guarded("plumb_exact_mesh_create", [&] {
    need(mesh, "mesh");
    need(exact, "exact");
    *exact =
        new plumb_exact_mesh{pose == nullptr ? exact_mesh(mesh->mesh) : exact_mesh(mesh->mesh, c::rigid_of(*pose))};
  });
}

void plumb_exact_mesh_destroy(plumb_exact_mesh* exact) { delete exact; }

plumb_status plumb_exact_mesh_posed(const plumb_exact_mesh* exact, const plumb_rigid3* pose,
                                    plumb_exact_mesh** result) {
  return guarded("plumb_exact_mesh_posed", [&] {
    need(exact, "exact");
    need(pose, "pose");
    need(result, "result");
    *result = new plumb_exact_mesh{exact_mesh(exact->mesh, c::rigid_of(*pose))};
  });
}

plumb_status plumb_exact_mesh_combine(int operation, const plumb_exact_mesh* const* meshes, std::size_t count,
                                      int merges, plumb_exact_mesh** result) {
  return guarded("plumb_exact_mesh_combine", [&] {
    need(meshes, count, "meshes");
    need(result, "result");
    std::vector<ExactMesh> solids;
    for (std::size_t i = 0; i < count; ++i) {
      need(meshes[i], "a mesh");
      solids.push_back(meshes[i]->mesh);
    }
    *result = new plumb_exact_mesh{c::combined(operation, solids, c::pieces_of(merges))};
  });
}

plumb_status plumb_exact_mesh_resolve(const plumb_exact_mesh* exact, int rule, int merges, plumb_exact_mesh** result) {
  return guarded("plumb_exact_mesh_resolve", [&] {
    need(exact, "exact");
    need(result, "result");
    c::need_choice(rule, PLUMB_POSITIVE, "rule");
    *result = new plumb_exact_mesh{resolve(exact->mesh, static_cast<WindingRule>(rule), c::pieces_of(merges))};
  });
}

plumb_status plumb_exact_mesh_round(const plumb_exact_mesh* exact, plumb_mesh** result, plumb_solid_report* report) {
  return guarded("plumb_exact_mesh_round", [&] {
    need(exact, "exact");
    need(result, "result");
    if (report != nullptr) need_size(report, "report");
    *result = c::told_solid(round(exact->mesh), report);
  });
}

plumb_status plumb_exact_mesh_size(const plumb_exact_mesh* exact, std::size_t* vertices, std::size_t* triangles) {
  return guarded("plumb_exact_mesh_size", [&] {
    need(exact, "exact");
    need(vertices, "vertices");
    need(triangles, "triangles");
    *vertices = exact->mesh.vertices.size(), *triangles = exact->mesh.triangles.size();
  });
}

plumb_status plumb_exact_mesh_triangles(const plumb_exact_mesh* exact, const std::uint32_t** triangles,
                                        const std::uint32_t** sources, std::size_t* count) {
  return guarded("plumb_exact_mesh_triangles", [&] {
    need(exact, "exact");
    need(triangles, "triangles");
    need(count, "count");
    static_assert(sizeof(SourceFace) == 2 * sizeof(std::uint32_t));
    *triangles = reinterpret_cast<const std::uint32_t*>(exact->mesh.triangles.data());
    if (sources != nullptr) *sources = reinterpret_cast<const std::uint32_t*>(exact->mesh.sources.data());
    *count = exact->mesh.triangles.size();
  });
}

plumb_status plumb_exact_mesh_volume(const plumb_exact_mesh* exact, char* text, std::size_t capacity,
                                     std::size_t* length) {
  return guarded("plumb_exact_mesh_volume", [&] {
    need(exact, "exact");
    c::need_text(text, capacity, length);
    c::write_text(exact_volume(exact->mesh).text(), text, capacity, length);
  });
}

plumb_status plumb_exact_mesh_vertex(const plumb_exact_mesh* exact, std::size_t vertex, char* text,
                                     std::size_t capacity, std::size_t* length) {
  return guarded("plumb_exact_mesh_vertex", [&] {
    need(exact, "exact");
    c::need_text(text, capacity, length);
    if (vertex >= exact->mesh.vertices.size()) {
      throw c::InvalidArgument("vertex " + std::to_string(vertex) + " is none of the " +
                               std::to_string(exact->mesh.vertices.size()) + " that there are");
    }
    const RationalPoint3 p = rational_point(exact->mesh.vertices[vertex]);
    c::write_text(p.x.text() + " " + p.y.text() + " " + p.z.text(), text, capacity, length);
  });
}

plumb_status plumb_intersection_curves(const plumb_mesh* a, const plumb_mesh* b, plumb_curves** curves) {
  return guarded("plumb_intersection_curves", [&] {
    need(a, "a");
    need(b, "b");
    need(curves, "curves");
    auto made = std::make_unique<plumb_curves>();
    made->exact = intersection_curves(a->mesh, b->mesh);
    for (const IntersectionCurve& curve : made->exact) {
      std::vector<Point3>& points = made->points.emplace_back();
      for (const ExactPoint3& p : curve.points) points.push_back(approximate(p));
      made->each.push_back({reinterpret_cast<const double*>(points.data()),
                            reinterpret_cast<const std::uint32_t*>(curve.faces.data()), points.size(),
                            curve.faces.size(), curve.closed});
    }
    *curves = made.release();
  });
}

plumb_status plumb_curves_of(const plumb_curves* curves, const plumb_curve** each, std::size_t* count) {
  return guarded("plumb_curves_of", [&] {
    need(curves, "curves");
    need(each, "each");
    need(count, "count");
    *each = curves->each.data();
    *count = curves->each.size();
  });
}

void plumb_curves_destroy(plumb_curves* curves) { delete curves; }

}  // extern "C"
