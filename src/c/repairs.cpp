#include <memory>

#include "c/faults.hpp"
#include "c/handles.hpp"
#include "plumb/surface/parts/covering_parts.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "plumb/surface/repair/repair.hpp"

using namespace plumb;
using c::guarded, c::need, c::need_size;

namespace {

static_assert(PLUMB_UNUSED + 1 == repair_kinds && PLUMB_UNUSED == static_cast<int>(RepairKind::unused) &&
              PLUMB_HOLES == static_cast<int>(RepairKind::holes));

RepairStep step_in(const plumb_repair_step* given) {
  need_size(given, "steps");
  c::need_choice(given->kind, PLUMB_UNUSED, "steps->kind");
  c::need_choice(given->rule, PLUMB_CHAINS, "steps->rule");
  return {static_cast<RepairKind>(given->kind),
          given->tolerance,
          given->smallest,
          static_cast<WeldRule>(given->rule),
          given->keeps_turned != 0 ? TurnedOver::kept : TurnedOver::refused,
          given->keeps_collinear != 0 ? CollinearVertices::kept : CollinearVertices::dropped};
}

}  // namespace

extern "C" {

plumb_status plumb_mesh_repair_by(const plumb_mesh* mesh, const plumb_repair_step* steps, std::size_t count,
                                  const plumb_progress* progress, plumb_mesh** repaired, plumb_faults* faults,
                                  int (*take)(const plumb_repair_change* change, void* user), void* user) {
  return guarded("plumb_mesh_repair_by", [&] {
    need(mesh, "mesh");
    need(steps, count, "steps");
    need(repaired, "repaired");
    if (faults != nullptr) need_size(faults, "faults");
    std::vector<RepairStep> plan;
    for (std::size_t i = 0; i < count; ++i) plan.push_back(step_in(steps + i));
    Repaired done = repair(mesh->mesh, plan, {.progress = c::progress_of(progress), .judge = faults != nullptr});
    std::unique_ptr<plumb_mesh> made(new plumb_mesh{std::move(done.mesh)});
    if (take != nullptr) {
      for (const RepairChange& change : done.changes) {
        plumb_repair_change told{sizeof told,
                                 text_of(change.kind).data(),
                                 {},
                                 change.distance,
                                 change.count,
                                 static_cast<std::int32_t>(change.step),
                                 is_left(change.kind)};
        c::copy(told.place, change.place);
        if (take(&told, user) == 0) break;
      }
    }
    if (faults != nullptr) c::write(faults, c::told_faults(done.faults));
    *repaired = made.release();
  });
}

plumb_status plumb_mesh_covering_parts(const plumb_mesh* mesh, double concavity, std::uint32_t most_parts,
                                       int (*take)(const plumb_mesh* hull, double concavity, void* user), void* user) {
  return guarded("plumb_mesh_covering_parts", [&] {
    need(mesh, "mesh");
    if (take == nullptr) throw c::InvalidArgument("take is NULL");
    CoveringOptions wanted{concavity};
    if (most_parts != 0) wanted.most_parts = most_parts;
    for (const CoveringPart& part : covering_parts(mesh->mesh, wanted).parts) {
      const plumb_mesh told{
          triangulate(PolygonMesh{part.proxy.vertices, part.proxy.hull.corners, part.proxy.hull.first})};
      if (take(&told, part.concavity, user) == 0) return;
    }
  });
}

}  // extern "C"
