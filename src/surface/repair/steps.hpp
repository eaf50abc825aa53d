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
  std::vector<std::vector<Point3>>
      around_holes{};  // the loop of each change that tells of a hole left (still_left.hpp)

  void note(ChangeKind kind, std::uint32_t vertex, std::uint64_t count = 1, double distance = 0) {
    changes.push_back({kind, step.kind, mesh.vertices[vertex], count, distance});
  }
  /// Notes a hole that is left, by its loop.
  void note_hole(ChangeKind kind, std::span<const std::uint32_t> loop, std::uint64_t edges) {
    note(kind, loop[0], edges);
    around_holes.emplace_back();
    for (const std::uint32_t v : loop) around_holes.back().push_back(mesh.vertices[v]);
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
