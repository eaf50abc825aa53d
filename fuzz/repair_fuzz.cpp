// Is a repaired mesh what it is said to be, whatever the order of what went in?  With and without a tolerance.
#include "plumb/surface/repair/repair.hpp"
#include "triangle_heap.hpp"

namespace plumb::fuzz {
namespace {

void ask_steps(const TriangleMesh& mesh, std::span<const RepairStep> steps) {
  const Repaired done = repair(mesh, steps, {.execution = Execution::serial});
  const Repaired other = repair(turned_round(mesh), steps, {.execution = Execution::serial, .judge = false});
  if (triangles_of(done.mesh) != triangles_of(other.mesh)) {
    for (const RepairStep& step : steps) std::cerr << name_of(step.kind) << " " << step.tolerance << "\n";
    fail("the order of the input changes the result");
  }
  if (done.changes.empty() && done.mesh.triangles != mesh.triangles) fail("a change that is not told");
  std::set<std::array<double, 3>> places;
  for (const Point3& p : mesh.vertices) places.insert({p.x, p.y, p.z});
  for (const Point3& p : done.mesh.vertices)
    if (!places.contains({p.x, p.y, p.z})) fail("a coordinate that was not there");
}

void ask_plan(const TriangleMesh& mesh) {
  ask_steps(mesh, printable_solid());
  const Repaired done = repair(mesh, RepairOptions{.execution = Execution::serial});
  const auto told = [&](ChangeKind kind) { return std::ranges::count(done.changes, kind, &RepairChange::kind) != 0; };
  const SurfaceFaults& f = done.faults;
  if (f.inside_out()) fail("inside out");
  if (f.non_manifold_vertices != 0 && !told(ChangeKind::kept_edge)) fail("a vertex of several fans");
  if (f.non_manifold_edges != 0 && !told(ChangeKind::kept_edge)) fail("a crowded edge that is not told");
  const bool open_told = told(ChangeKind::kept_hole) || told(ChangeKind::one_sided_hole) ||
                         told(ChangeKind::open_chain) || told(ChangeKind::kept_edge);
  if (f.open_edges != 0 && !open_told) fail("an open edge that is not told");
  if (f.open_edges == 0 && (told(ChangeKind::kept_hole) || told(ChangeKind::tied_hole))) fail("a hole that is none");
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy entropy = Entropy::from_bytes({data, size});
  const TriangleMesh mesh = fuzz::heap_from(entropy);
  fuzz::ask_plan(mesh);
  for (const double tolerance : {1.0, 0.5}) fuzz::ask_steps(mesh, printable_solid(tolerance));
  const RepairStep weld{RepairKind::weld};
  fuzz::ask_steps(mesh, std::array{weld, RepairStep{RepairKind::slivers, 0.5}, RepairStep{RepairKind::zip, 2}});
  for (std::size_t k = 0; k < repair_kinds; ++k)
    fuzz::ask_steps(mesh, std::array{weld, RepairStep{static_cast<RepairKind>(k), 0, 3}});
  return 0;
}
