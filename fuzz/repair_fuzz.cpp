// Is a repaired mesh what it is said to be, whatever the order of what went in?  Heaps of triangles in special position,
// many of them on the same points, with and without a tolerance; and their topology, table against table.
#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <set>

#include "plumb/degenerate/points.hpp"
#include "plumb/surface/repair/repair.hpp"
#include "plumb/surface/topology/adjacency.hpp"
#include "plumb/surface/topology/components.hpp"

namespace plumb::fuzz {
namespace {

[[noreturn]] void fail(const char* text) {
  std::cerr << text << std::endl;
  std::abort();
}

TriangleMesh heap_from(Entropy& entropy) {
  TriangleMesh mesh;
  const std::size_t points = 3 + entropy.below(14);
  if (entropy.coin()) {
    mesh.vertices = points3(any_family(entropy), degeneracies[entropy.below(degeneracies.size())], points, entropy);
  } else {
    const auto coordinate = [&] { return static_cast<double>(entropy.within(2)); };
    for (std::size_t i = 0; i < points; ++i) {
      const double x = coordinate(), y = coordinate();
      mesh.vertices.push_back({x, y, coordinate()});
    }
  }
  const auto vertex = [&] { return static_cast<std::uint32_t>(entropy.below(points)); };
  for (std::uint64_t n = entropy.below(30); n > 0; --n) {
    const std::uint32_t a = vertex(), b = vertex();
    mesh.triangles.push_back({a, b, vertex()});
  }
  for (std::uint32_t v = 0; v + 3 < points && entropy.coin(); v += 2)
    for (const TriangleMesh::Triangle& t : {TriangleMesh::Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      mesh.triangles.push_back({t[0] + v, t[1] + v, t[2] + v});
  return mesh;
}

/// Vertices the other way round, triangles as well, each from another corner on.
TriangleMesh turned_round(const TriangleMesh& mesh) {
  TriangleMesh other = mesh;
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  std::ranges::reverse(other.vertices);
  std::ranges::reverse(other.triangles);
  for (auto& [a, b, c] : other.triangles) {
    const std::uint32_t first = last - a;
    a = last - b, b = last - c, c = first;
  }
  return other;
}

using Corners = std::array<std::array<double, 3>, 3>;
std::multiset<Corners> triangles_of(const TriangleMesh& mesh) {
  std::multiset<Corners> all;
  for (const auto& t : mesh.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = mesh.vertices[t[k]];
      corners[k] = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
    }
    const auto turned = [&](std::size_t k) { return Corners{corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]}; };
    all.insert(std::min({turned(0), turned(1), turned(2)}));
  }
  return all;
}

void ask_topology(const TriangleMesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  const HalfEdges half = half_edges(mesh, edges);
  for (std::uint32_t h = 0; h < half.twin.size(); ++h)
    if (half.twin[h] != no_half_edge && half.twin[half.twin[h]] != h) fail("a twin's twin is another");
  std::size_t in_loops = 0;
  for (const BoundaryLoop& loop : boundary_loops(mesh, edges)) in_loops += loop.vertices.size() - (loop.closed ? 0 : 1);
  if (in_loops != half.boundary.size()) fail("the loops are not the boundary");
  std::uint64_t faces = 0;
  for (const SurfaceKind& kind : surface_kinds(mesh, edges)) {
    faces += kind.faces;
    if (kind.edges != 0 && kind.genus() < 0) fail("a negative genus");
  }
  if (faces != mesh.triangles.size()) fail("a triangle is in no surface");
}

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
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy entropy = Entropy::from_bytes({data, size});
  const TriangleMesh mesh = fuzz::heap_from(entropy);
  fuzz::ask_topology(mesh);
  fuzz::ask_plan(mesh);
  for (const double tolerance : {1.0, 0.5}) fuzz::ask_steps(mesh, printable_solid(tolerance));
  const RepairStep weld{RepairKind::weld};
  fuzz::ask_steps(mesh, std::array{weld, RepairStep{RepairKind::slivers, 0.5}, RepairStep{RepairKind::zip, 2}});
  for (std::size_t k = 0; k < repair_kinds; ++k)
    fuzz::ask_steps(mesh, std::array{weld, RepairStep{static_cast<RepairKind>(k), 0, 3}});
  return 0;
}
