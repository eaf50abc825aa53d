#include "surface/repair/steps.hpp"
#include "surface/repair/weld_groups.hpp"

namespace plumb::surface {

void RepairWork::leave_out(std::span<const std::uint8_t> marked) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (marked[t] == 0) mesh.triangles[kept++] = mesh.triangles[t];
  mesh.triangles.resize(kept);
}

void apply_weld(RepairWork& work, const Weld& weld) {
  for (const MergedVertex& m : weld.merged) work.note(ChangeKind::merged_vertex, m.vertex, 1, m.distance);
  for (const std::uint32_t t : weld.collapsed) work.note(ChangeKind::collapsed_triangle, work.mesh.triangles[t][0]);
  for (const std::uint32_t v : weld.refused) work.note(ChangeKind::turning_group, v);
  if (!weld.merged.empty()) work.mesh.triangles = welded(work.mesh, weld).triangles;
}

void weld_step(RepairWork& work) {
  const RepairStep& s = work.step;
  apply_weld(
      work,
      find_weld(work.mesh,
                {.tolerance = s.tolerance, .rule = s.rule, .turned_over = s.turned_over, .execution = work.execution}));
}

}  // namespace plumb::surface
