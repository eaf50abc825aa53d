#include "plumb/surface/repair/repair.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "figure/basic/mesh_input.hpp"
#include "surface/repair/steps.hpp"
#include "surface/repair/still_left.hpp"
#include "surface/repair/weld_groups.hpp"

namespace plumb {
namespace {

struct StepOfRepair {
  std::string_view name;
  void (*run)(surface::RepairWork&);
};

constexpr std::array<StepOfRepair, repair_kinds> steps_of_repair{{{"weld", surface::weld_step},
                                                                  {"degenerate", surface::flat_triangles_step},
                                                                  {"slivers", surface::flat_triangles_step},
                                                                  {"t-junctions", surface::junctions_step},
                                                                  {"zip", surface::zip_step},
                                                                  {"duplicates", surface::duplicates_step},
                                                                  {"walls", surface::walls_step},
                                                                  {"small-components", surface::small_components_step},
                                                                  {"orientation", surface::orientation_step},
                                                                  {"holes", surface::holes_step},
                                                                  {"outward", surface::outward_step},
                                                                  {"split", surface::split_step},
                                                                  {"merge-coplanar", surface::coplanar_step},
                                                                  {"unused", surface::unused_step}}};

constexpr std::array<std::string_view, change_kinds> change_texts{
    "vertex merged with another",
    "triangle collapsed",
    "triangle without area left out",
    "edge divided at a vertex",
    "duplicate triangle left out",
    "triangle opposite to another left out",
    "wall inside of a solid left out",
    "small component left out",
    "component whose triangles were turned to agree",
    "hole filled",
    "shell turned that was inside out",
    "vertex split, one for each fan",
    "coplanar triangles merged",
    "unused vertex left out",
    "group of vertices not merged: a triangle would turn over",
    "thin triangle left: its neighbor cannot be divided",
    "vertex left on an edge that cannot be divided there",
    "one-sided component (a Moebius strip) left",
    "hole left: its filling would meet the surface",
    "hole left: two fillings fit it equally well",
    "hole left in a one-sided component",
    "open edges left that end at an edge of more than two triangles",
    "edge of more than two triangles left as it was",
    "coplanar triangles left: they cover or touch one another"};

void require_step(const RepairStep& step) {
  if (static_cast<std::size_t>(step.kind) >= repair_kinds)
    throw InvalidShape("repair: there is no step " + std::to_string(static_cast<int>(step.kind)));
  surface::require_tolerance("repair", step.tolerance);
}

}  // namespace

std::string_view name_of(RepairKind kind) { return steps_of_repair.at(static_cast<std::size_t>(kind)).name; }

std::string_view text_of(ChangeKind kind) { return change_texts.at(static_cast<std::size_t>(kind)); }

std::vector<RepairStep> printable_solid(double tolerance) {
  std::vector<RepairStep> steps{{RepairKind::weld, tolerance}, {RepairKind::degenerate}, {RepairKind::t_junctions}};
  if (tolerance != 0) {  // zip takes what is open; what is near an edge that is not is left to t_junctions
    steps.push_back({RepairKind::zip, tolerance});
    steps.push_back({RepairKind::t_junctions, tolerance});
  }
  // What is within a solid that has a hole is a wall once the hole is filled.
  for (const RepairKind kind : {RepairKind::duplicates, RepairKind::walls, RepairKind::orientation, RepairKind::holes,
                                RepairKind::walls, RepairKind::outward, RepairKind::split, RepairKind::unused})
    steps.push_back({kind});
  return steps;
}

Repaired repair(TriangleMesh mesh, std::span<const RepairStep> steps, const RepairOptions& options) {
  for (const RepairStep& step : steps) require_step(step);
  require_mesh("repair", mesh);
  surface::RepairWork work{std::move(mesh), {}, options.execution};
  const std::size_t parts = steps.size() + (options.judge ? 1 : 0);
  std::vector<std::size_t> first_change;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    work.step = steps[i];
    first_change.push_back(work.changes.size());
    steps_of_repair[static_cast<std::size_t>(steps[i].kind)].run(work);
    if (options.progress && !options.progress(static_cast<double>(i + 1) / static_cast<double>(parts)))
      throw Cancelled("repair: stopped by its progress");
  }
  surface::leave_out_what_was_mended(work, steps, first_change);
  Repaired done{std::move(work.mesh), std::move(work.changes), {}};
  if (options.judge) done.faults = find_faults(done.mesh, {.execution = options.execution});
  if (options.judge && options.progress) options.progress(1.0);
  return done;
}

Repaired repair(TriangleMesh mesh, std::initializer_list<RepairStep> steps, const RepairOptions& options) {
  return repair(std::move(mesh), std::span(steps.begin(), steps.size()), options);
}

Repaired repair(TriangleMesh mesh, const RepairOptions& options) {
  return repair(std::move(mesh), printable_solid(), options);
}

}  // namespace plumb
