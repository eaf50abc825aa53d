#include "surface/repair/still_left.hpp"

#include <algorithm>

#include "plumb/surface/topology/topology.hpp"
#include "surface/repair/point_order.hpp"

namespace plumb::surface {
namespace {

class PointSet {
 public:
  explicit PointSet(std::vector<Point3> points) : points_(std::move(points)) {
    std::ranges::sort(points_, comes_before);
  }
  [[nodiscard]] bool has(const Point3& p) const { return std::ranges::binary_search(points_, p, comes_before); }
  [[nodiscard]] bool empty() const { return points_.empty(); }

 private:
  std::vector<Point3> points_;
};

PointSet ends_of_open_edges(const TriangleMesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  std::vector<Point3> ends;
  for (std::size_t e = 0; e < edges.edges.size(); ++e)
    if (edges.uses_of(e).size() == 1)
      for (const std::uint32_t v : edges.edges[e]) ends.push_back(mesh.vertices[v]);
  return PointSet(std::move(ends));
}

PointSet points_of_triangles(const TriangleMesh& mesh) {
  std::vector<Point3> corners;
  for (const TriangleMesh::Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) corners.push_back(mesh.vertices[v]);
  return PointSet(std::move(corners));
}

bool is_hole_left(ChangeKind kind) {
  return kind == ChangeKind::kept_hole || kind == ChangeKind::tied_hole || kind == ChangeKind::one_sided_hole ||
         kind == ChangeKind::open_chain;
}

/// Did a later step look for the same again?
bool is_asked_again(std::span<const RepairStep> steps, std::size_t i) {
  return std::ranges::any_of(steps.subspan(i + 1), [&](const RepairStep& later) {
    return later.kind == steps[i].kind && later.tolerance >= steps[i].tolerance;
  });
}

}  // namespace

void leave_out_what_was_mended(RepairWork& work, std::span<const RepairStep> steps,
                               std::span<const std::size_t> first_change) {
  if (std::ranges::none_of(work.changes, is_left, &RepairChange::kind)) return;
  const PointSet open = ends_of_open_edges(work.mesh), corners = points_of_triangles(work.mesh);
  std::size_t last_move = 0;  // changes up to here stand before a vertex that was merged over a distance
  for (std::size_t c = 0; c < work.changes.size(); ++c)
    if (work.changes[c].kind == ChangeKind::merged_vertex && work.changes[c].distance != 0) last_move = c;
  const auto is_there = [&](std::size_t c, std::span<const Point3> around) {
    const RepairChange& change = work.changes[c];
    if (is_hole_left(change.kind) && open.empty()) return false;
    if (c < last_move) return true;
    if (!is_hole_left(change.kind)) return corners.has(change.place);
    return std::ranges::count_if(around, [&](const Point3& p) { return open.has(p); }) >= 2;
  };
  std::vector<RepairChange> told;
  std::size_t step = 0, hole = 0;
  for (std::size_t c = 0; c < work.changes.size(); ++c) {
    const RepairChange& change = work.changes[c];
    while (step + 1 < steps.size() && first_change[step + 1] <= c) ++step;
    const std::span<const Point3> around =
        is_hole_left(change.kind) ? std::span<const Point3>(work.around_holes.at(hole++)) : std::span<const Point3>();
    if (!is_left(change.kind) || (!is_asked_again(steps, step) && is_there(c, around))) told.push_back(change);
  }
  work.changes = std::move(told);
}

}  // namespace plumb::surface
