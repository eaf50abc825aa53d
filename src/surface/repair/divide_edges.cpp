#include "surface/repair/divide_edges.hpp"

#include <algorithm>
#include <span>

#include "plumb/certify/direction.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "surface/repair/least_area.hpp"
#include "surface/repair/moved.hpp"
#include "surface/repair/point_order.hpp"

namespace plumb::surface {
namespace {

using Edge = std::array<std::uint32_t, 2>;

Edge edge_between(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// A triangle with the vertices on its edges, and the triangles that it becomes; none where that cannot be.
struct DividedTriangle {
  std::uint32_t triangle;
  std::vector<std::uint32_t> corners;
  std::vector<TriangleMesh::Triangle> parts;
};

class Divisions {
 public:
  Divisions(const TriangleMesh& mesh, std::vector<EdgeDivision> all) : mesh_(mesh), all_(std::move(all)) {
    std::ranges::sort(all_);
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
    at_end_.assign(mesh.vertices.size(), 0);
    for (const EdgeDivision& d : all_) at_end_[d.edge[0]] = at_end_[d.edge[1]] = 1;
  }

  [[nodiscard]] std::span<const EdgeDivision> on(const Edge& edge) const {
    const std::size_t first = first_on(edge);
    std::size_t end = first;
    while (end < all_.size() && all_[end].edge == edge) ++end;
    return std::span(all_).subspan(first, end - first);
  }
  /// The triangle's corners and the vertices on its edges, in their order.
  [[nodiscard]] std::vector<std::uint32_t> corners_of(const TriangleMesh::Triangle& t) const {
    std::vector<std::uint32_t> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      corners.push_back(from);
      if (at_end_[from] == 0 || at_end_[to] == 0) continue;
      const auto first = static_cast<std::ptrdiff_t>(corners.size());
      for (const EdgeDivision& d : on(edge_between(from, to)))
        if (std::ranges::find(t, d.vertex) == t.end()) corners.push_back(d.vertex);
      const auto& at = mesh_.vertices;
      std::sort(corners.begin() + first, corners.end(), [&](std::uint32_t l, std::uint32_t r) {
        const Sign along = compare_along_line(at[l], at[r], at[from], at[to]);
        return along != Sign::zero ? along == Sign::negative : comes_before(at[l], at[r]);
      });
    }
    return corners;
  }
  void refuse(const TriangleMesh::Triangle& t, std::vector<EdgeDivision>& refused) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge = edge_between(t[k], t[(k + 1) % 3]);
      const auto here = on(edge);
      refused.insert(refused.end(), here.begin(), here.end());
      const auto first = all_.begin() + static_cast<std::ptrdiff_t>(first_on(edge));
      all_.erase(first, first + static_cast<std::ptrdiff_t>(here.size()));
    }
  }
  [[nodiscard]] const std::vector<EdgeDivision>& all() const { return all_; }

  /// The place in all() of the edge's first division.
  [[nodiscard]] std::size_t first_on(const Edge& edge) const {
    return static_cast<std::size_t>(std::lower_bound(all_.begin(), all_.end(), EdgeDivision{edge, 0}) - all_.begin());
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<EdgeDivision> all_;
  std::vector<std::uint8_t> at_end_;  // of each vertex: is it the end of an edge that is divided?
};

/// Are both on one side of the triangle, whose corners and vertices on edges these are?  Then they are no diagonal.
bool on_one_side(const TriangleMesh::Triangle& t, std::span<const std::uint32_t> corners, std::uint32_t u,
                 std::uint32_t v) {
  const auto place = [&](std::uint32_t w) { return std::ranges::find(corners, w) - corners.begin(); };
  for (std::size_t k = 0; k < 3; ++k) {
    const auto from = place(t[k]), to = k == 2 ? std::ssize(corners) : place(t[k + 1]);
    const auto holds = [&](std::uint32_t w) { return (from <= place(w) && place(w) <= to) || (k == 2 && w == t[0]); };
    if (holds(u) && holds(v)) return true;
  }
  return false;
}

/// The triangles that these corners make; none where that turns one over, or leaves one without area.
std::vector<TriangleMesh::Triangle> parts_of(const TriangleMesh& mesh, const TriangleMesh::Triangle& t,
                                             const std::vector<std::uint32_t>& corners, OnEdge on_edge) {
  auto sorted = corners;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end()) return {};
  std::vector<TriangleMesh::Triangle> parts;
  auto loop = corners;
  begin_with_first(mesh.vertices, loop);
  if (on_edge == OnEdge::exactly) {
    if (!triangulate_face(mesh.vertices, loop, parts)) parts.clear();
    return parts;
  }
  const auto is_side = [&](std::uint32_t u, std::uint32_t v) { return on_one_side(t, corners, u, v); };
  if (auto least = least_area_filling(mesh.vertices, loop, is_side)) parts = std::move(least->filling);  // tied or not
  const auto points = [&](const TriangleMesh::Triangle& of) {
    return std::array{mesh.vertices[of[0]], mesh.vertices[of[1]], mesh.vertices[of[2]]};
  };
  const auto is_turned = [&](const TriangleMesh::Triangle& part) {
    return keeps_facing(points(t), points(part)) != Sign::positive;
  };
  if (std::ranges::any_of(parts, is_turned)) parts.clear();
  return parts;
}

}  // namespace

Divided divide_edges(RepairWork& work, std::vector<EdgeDivision> all, OnEdge on_edge) {
  Divided divided;
  if (all.empty()) return divided;
  TriangleMesh& mesh = work.mesh;
  Divisions divisions(mesh, std::move(all));
  std::vector<DividedTriangle> triangles;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    auto corners = divisions.corners_of(mesh.triangles[t]);
    if (corners.size() > 3) triangles.push_back({t, std::move(corners), {}});
  }
  for (bool refused = true; refused;) {
    refused = false;
    std::vector<std::uint32_t> impossible;
    for (DividedTriangle& d : triangles) {
      const TriangleMesh::Triangle& t = mesh.triangles[d.triangle];
      auto corners = divisions.corners_of(t);
      if (!d.parts.empty() && corners == d.corners) continue;
      d.corners = std::move(corners);
      d.parts = d.corners.size() == 3 ? Filling{t} : parts_of(mesh, t, d.corners, on_edge);
      if (d.parts.empty()) impossible.push_back(d.triangle);
    }
    for (const std::uint32_t t : impossible) divisions.refuse(mesh.triangles[t], divided.refused);
    refused = !impossible.empty();
  }
  std::ranges::sort(divided.refused);
  std::vector<std::uint32_t> times(divisions.all().size());
  std::vector<TriangleMesh::Triangle> out;
  out.reserve(mesh.triangles.size() + 2 * triangles.size());
  auto next = triangles.begin();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (next == triangles.end() || next->triangle != t) {
      out.push_back(mesh.triangles[t]);
      continue;
    }
    if (next->parts.size() == 1) {  // its divisions were refused on account of others
      out.push_back(mesh.triangles[t]);
    } else {
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge edge = edge_between(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
        for (std::size_t i = 0; i < divisions.on(edge).size(); ++i) ++times[divisions.first_on(edge) + i];
      }
      for (const auto& part : next->parts) {
        divided.parts.push_back(static_cast<std::uint32_t>(out.size()));
        out.push_back(part);
      }
    }
    ++next;
  }
  mesh.triangles = std::move(out);
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i] != 0) work.note(ChangeKind::divided_edge, divisions.all()[i].vertex, times[i]);
  return divided;
}

}  // namespace plumb::surface
