// The steps of a repair, on the mesh as it is by then (plumb/surface/repair/repair.hpp).
//
// Law: what a step does is in the list of changes.
// Cost: each step's, as the public header says.
#pragma once

#include <span>
#include <vector>

#include "plumb/surface/repair/repair.hpp"

namespace plumb::surface {

struct RepairWork {
  TriangleMesh mesh;
  RepairStep step{};
  Execution execution = Execution::parallel;
  std::vector<RepairChange> changes{};

  void note(ChangeKind kind, std::uint32_t vertex, std::uint64_t count = 1, double distance = 0) {
    changes.push_back({kind, step.kind, mesh.vertices[vertex], count, distance});
  }
  /// Leaves out the triangles that are marked; the others keep their order.
  void leave_out(std::span<const std::uint8_t> marked);
};

void apply_weld(RepairWork& work, const Weld& weld);

void weld_step(RepairWork& work);
void zip_step(RepairWork& work);
void flat_triangles_step(RepairWork& work);  // degenerate, slivers
void junctions_step(RepairWork& work);
void duplicates_step(RepairWork& work);
void walls_step(RepairWork& work);
void small_components_step(RepairWork& work);
void orientation_step(RepairWork& work);
void outward_step(RepairWork& work);
void holes_step(RepairWork& work);
void split_step(RepairWork& work);
void coplanar_step(RepairWork& work);
void unused_step(RepairWork& work);

}  // namespace plumb::surface
