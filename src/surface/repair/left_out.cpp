// What is one too many: triangles on the same points, walls, small components.
#include <algorithm>

#include "figure/basic/lists_by_number.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/surface/topology/components.hpp"
#include "plumb/surface/topology/defects.hpp"
#include "plumb/surface/topology/shells.hpp"
#include "surface/repair/steps.hpp"
#include "surface/topology/mesh_corner.hpp"
#include "surface/topology/windings.hpp"

namespace plumb::surface {
namespace {

/// Triangles on the same three points: the first and those that coincide with it.
struct Heap {
  std::vector<std::uint32_t> same, opposite;  // as the first, which is the first of same
};

std::vector<Heap> heaps_of(const TriangleMesh& mesh, std::span<const std::uint32_t> first_of_points) {
  std::vector<CoincidentTriangle> found = coincident_triangles(mesh, first_of_points);
  std::ranges::stable_sort(found, {}, &CoincidentTriangle::first);
  std::vector<Heap> heaps;
  for (const CoincidentTriangle& c : found) {
    if (heaps.empty() || heaps.back().same.front() != c.first) heaps.push_back({{c.first}, {}});
    (c.opposite ? heaps.back().opposite : heaps.back().same).push_back(c.triangle);
  }
  return heaps;
}

/// How other triangles than those of heaps run along edges, between points.
class OtherRuns {
 public:
  OtherRuns(const TriangleMesh& mesh, std::span<const std::uint32_t> point, std::span<const std::uint8_t> in_heap)
      : point_(point) {
    TriangleMesh others{mesh.vertices, {}};
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      if (in_heap[t] == 0) others.triangles.push_back({point[a], point[b], point[c]});
    }
    edges_ = find_edges(others);
  }
  /// As many more run from a to b as from b to a.
  [[nodiscard]] int from_to(std::uint32_t a, std::uint32_t b) const {
    a = point_[a], b = point_[b];
    const std::array<std::uint32_t, 2> edge{std::min(a, b), std::max(a, b)};
    const auto at = std::ranges::lower_bound(edges_.edges, edge);
    if (at == edges_.edges.end() || *at != edge) return 0;
    int runs = 0;
    for (const EdgeUse& use : edges_.uses_of(static_cast<std::size_t>(at - edges_.edges.begin())))
      runs += use.forward == (a < b) ? 1 : -1;
    return runs;
  }

 private:
  std::span<const std::uint32_t> point_;
  MeshEdges edges_;
};

/// Which of the heap stays: 1 for the first, -1 for one that is opposite to it, 0 for none.  The one that leaves most
/// edges passed as often one way as the other; none where neither is better than the other, or than none.
int what_stays(const TriangleMesh& mesh, const Heap& heap, const OtherRuns& others) {
  if (heap.opposite.empty()) return 1;
  const TriangleMesh::Triangle& t = mesh.triangles[heap.same.front()];
  const auto even = [&](int stays) {
    int edges = 0;
    for (std::size_t k = 0; k < 3; ++k) edges += others.from_to(t[k], t[(k + 1) % 3]) + stays == 0;
    return edges;
  };
  const int first = even(1), opposite = even(-1), none = even(0);
  if (first == opposite || std::max(first, opposite) <= none) return 0;
  return first > opposite ? 1 : -1;
}

/// Does a shell all but enclose a space: is the area that its triangles leave over, as vectors in sum, less than half of
/// their own?  Both are measured by the magnitudes of coordinates; a sheet leaves all of its area over, a cavity with a
/// hole that of the hole.
bool is_all_but_closed(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, const Windings& windings) {
  std::array<Rational, 3> left_over;
  Rational all;
  for (const std::uint32_t t : triangles) {
    if (windings.orientable[windings.components.of[t]] == 0) return false;
    std::array<std::array<Rational, 3>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& q = mesh.vertices[mesh.triangles[t][k]];
      p[k] = {q.x, q.y, q.z};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      const Rational normal = (p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) - (p[1][v] - p[0][v]) * (p[2][u] - p[0][u]);
      left_over[k] = windings.against[t] != 0 ? left_over[k] - normal : left_over[k] + normal;
      all = all + (normal.sign() == Sign::negative ? -normal : normal);
    }
  }
  Rational sum;
  for (const Rational& x : left_over) sum = sum + (x.sign() == Sign::negative ? -x : x);
  return sum + sum < all;
}

}  // namespace

void duplicates_step(RepairWork& work) {
  const std::vector<std::uint32_t> first = first_equal(work.mesh.vertices);
  const std::vector<Heap> heaps = heaps_of(work.mesh, first);
  if (heaps.empty()) return;
  std::vector<std::uint8_t> marked(work.mesh.triangles.size());
  for (const Heap& heap : heaps) {
    for (const std::uint32_t t : heap.same) marked[t] = 1;
    for (const std::uint32_t t : heap.opposite) marked[t] = 1;
  }
  const OtherRuns others(work.mesh, first, marked);
  for (const Heap& heap : heaps) {
    const int stays = what_stays(work.mesh, heap, others);
    if (stays != 0) marked[(stays > 0 ? heap.same : heap.opposite).front()] = 0;
    for (const bool same : {true, false}) {
      const ChangeKind kind =
          heap.opposite.empty() || same == (stays > 0) ? ChangeKind::duplicate_triangle : ChangeKind::opposite_triangle;
      for (const std::uint32_t t : same ? heap.same : heap.opposite)
        if (marked[t] != 0) work.note(stays == 0 ? ChangeKind::opposite_triangle : kind, work.mesh.triangles[t][0]);
    }
  }
  work.leave_out(marked);
}

void walls_step(RepairWork& work) {
  const MeshEdges edges = find_edges(work.mesh);
  const Components manifold = connected_components(work.mesh, edges, JoinedOver::manifold_edges);
  bool any_open = false;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) any_open = any_open || edges.uses_of(e).size() != 2;
  if (!any_open || manifold.count < 2) return;
  const Shells found =
      find_shells(work.mesh, edges, build_bvh(work.mesh, {.execution = work.execution}), {.execution = work.execution});
  if (std::ranges::none_of(found.shells, &Shell::wall)) return;
  std::vector<std::uint8_t> marked(work.mesh.triangles.size());
  const Windings windings = find_windings(work.mesh, edges);
  const figure::ListsByNumber lists(found.shell_of, found.shells.size());
  for (std::size_t s = 0; s < found.shells.size(); ++s) {
    if (!found.shells[s].wall || is_all_but_closed(work.mesh, lists[s], windings)) continue;
    for (const std::uint32_t t : lists[s]) marked[t] = 1;
    work.note(ChangeKind::removed_wall, work.mesh.triangles[lists[s][0]][0], lists[s].size());
  }
  work.leave_out(marked);
}

void small_components_step(RepairWork& work) {
  const Components found = connected_components(work.mesh, find_edges(work.mesh), JoinedOver::edges);
  std::vector<std::uint64_t> size(found.count);
  for (const std::uint32_t c : found.of) ++size[c];
  std::vector<std::uint8_t> marked(work.mesh.triangles.size()), told(found.count);
  for (std::uint32_t t = 0; t < marked.size(); ++t) {
    const std::uint32_t c = found.of[t];
    marked[t] = size[c] < work.step.size;
    if (marked[t] == 0 || told[c] != 0) continue;
    told[c] = 1;
    work.note(ChangeKind::removed_component, work.mesh.triangles[t][0], size[c]);
  }
  work.leave_out(marked);
}

}  // namespace plumb::surface
