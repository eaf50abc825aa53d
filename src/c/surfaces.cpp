#include <algorithm>
#include <memory>

#include "c/handles.hpp"
#include "c/loops.hpp"
#include "plumb/surface/repair/merge_coplanar.hpp"
#include "plumb/surface/repair/weld.hpp"
#include "plumb/surface/topology/components.hpp"

using namespace plumb;
using c::guarded, c::need, c::need_size;

struct plumb_weld {
  Weld weld;
  std::vector<plumb_merged_vertex> merged;
};

struct plumb_coplanar {
  CoplanarFaces faces;
};

extern "C" {

plumb_status plumb_mesh_components(const plumb_mesh* mesh, int over, std::uint32_t* component_of, std::size_t* count) {
  return guarded("plumb_mesh_components", [&] {
    need(mesh, "mesh");
    need(component_of, mesh->mesh.triangles.size(), "component_of");
    need(count, "count");
    c::need_choice(over, PLUMB_OVER_VERTICES, "over");
    const Components found = connected_components(mesh->mesh, find_edges(mesh->mesh), static_cast<JoinedOver>(over));
    std::ranges::copy(found.of, component_of);
    *count = found.count;
  });
}

plumb_status plumb_mesh_surface_kinds(const plumb_mesh* mesh, plumb_surface_kind* kinds, std::size_t capacity,
                                      std::size_t* count) {
  return guarded("plumb_mesh_surface_kinds", [&] {
    need(mesh, "mesh");
    need(kinds, capacity, "kinds");
    need(count, "count");
    const std::vector<SurfaceKind> found = surface_kinds(mesh->mesh, find_edges(mesh->mesh));
    for (std::size_t i = 0; i < std::min(capacity, found.size()); ++i) {
      const SurfaceKind& k = found[i];
      kinds[i] = {k.vertices, k.edges, k.faces, k.loops, k.euler(), k.genus(), k.orientable};
    }
    *count = found.size();
  });
}

plumb_status plumb_mesh_boundary_loops(const plumb_mesh* mesh, plumb_loops** loops) {
  return guarded("plumb_mesh_boundary_loops", [&] {
    need(mesh, "mesh");
    need(loops, "loops");
    auto made = std::make_unique<plumb_loops>();
    for (BoundaryLoop& loop : boundary_loops(mesh->mesh, find_edges(mesh->mesh)))
      made->add(std::move(loop.vertices), loop.closed);
    *loops = made.release();
  });
}

plumb_status plumb_loops_of(const plumb_loops* loops, const plumb_loop** each, std::size_t* count) {
  return guarded("plumb_loops_of", [&] {
    need(loops, "loops");
    need(each, "each");
    need(count, "count");
    *each = loops->each.data();
    *count = loops->each.size();
  });
}

void plumb_loops_destroy(plumb_loops* loops) { delete loops; }

plumb_status plumb_mesh_weld(const plumb_mesh* mesh, const plumb_weld_options* options, plumb_mesh** result,
                             plumb_weld** weld) {
  return guarded("plumb_mesh_weld", [&] {
    need(mesh, "mesh");
    need(result, "welded");
    WeldOptions wanted;
    if (options != nullptr) {
      need_size(options, "options");
      c::need_choice(options->rule, PLUMB_CHAINS, "options->rule");
      wanted.tolerance = options->tolerance;
      wanted.rule = static_cast<WeldRule>(options->rule);
      wanted.turned_over = options->keeps_turned != 0 ? TurnedOver::kept : TurnedOver::refused;
    }
    std::unique_ptr<plumb_weld> report(new plumb_weld{find_weld(mesh->mesh, wanted), {}});
    for (const MergedVertex& m : report->weld.merged) report->merged.push_back({m.vertex, m.into, m.distance});
    *result = new plumb_mesh{welded(mesh->mesh, report->weld)};
    if (weld != nullptr) *weld = report.release();
  });
}

plumb_status plumb_weld_of(const plumb_weld* weld, plumb_weld_report* report) {
  return guarded("plumb_weld_of", [&] {
    need(weld, "weld");
    need_size(report, "report");
    const Weld& w = weld->weld;
    c::write(report, {0, w.into.data(), weld->merged.data(), w.collapsed.data(), w.turned.data(), w.refused.data(),
                      w.into.size(), weld->merged.size(), w.collapsed.size(), w.turned.size(), w.refused.size()});
  });
}

void plumb_weld_destroy(plumb_weld* weld) { delete weld; }

plumb_status plumb_mesh_merge_coplanar(const plumb_mesh* mesh, double tolerance, int drops_collinear,
                                       plumb_mesh** fewer, plumb_coplanar** faces) {
  return guarded("plumb_mesh_merge_coplanar", [&] {
    need(mesh, "mesh");
    need(fewer, "fewer");
    const CoplanarOptions wanted{tolerance,
                                 drops_collinear != 0 ? CollinearVertices::dropped : CollinearVertices::kept};
    std::unique_ptr<plumb_coplanar> made(new plumb_coplanar{merge_coplanar(mesh->mesh, wanted)});
    *fewer = new plumb_mesh{triangulated(mesh->mesh, made->faces)};
    if (faces != nullptr) *faces = made.release();
  });
}

plumb_status plumb_coplanar_of(const plumb_coplanar* faces, plumb_coplanar_report* report) {
  return guarded("plumb_coplanar_of", [&] {
    need(faces, "faces");
    need_size(report, "report");
    const CoplanarFaces& f = faces->faces;
    c::write(report, {0, f.corners.data(), f.first_corner.data(), f.first_ring.data(), f.triangles.data(),
                      f.first_triangle.data(), f.plane.data(), f.apart.data(), f.plane.size(), f.apart.size()});
  });
}

void plumb_coplanar_destroy(plumb_coplanar* faces) { delete faces; }

}  // extern "C"
