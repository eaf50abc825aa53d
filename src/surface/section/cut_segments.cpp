#include "surface/section/cut_segments.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "surface/section/cut_corners.hpp"

namespace plumb::surface {
namespace {

using Edge = std::array<std::uint32_t, 2>;  // the vertex below, the vertex above

/// The edges that triangles are cut at, two by two: where the segment begins, where it ends.
std::vector<Edge> cut_edges(const TriangleMesh& mesh, const PlaneSweep& sweep, std::size_t place, Section& section) {
  const Sign zero_is = section.on_plane == OnPlane::above ? Sign::positive : Sign::negative;
  std::vector<Edge> edges;
  for (const std::uint32_t t : sweep.triangles(place)) {
    const TriangleMesh::Triangle& corners = mesh.triangles[t];
    std::array<Sign, 3> side;
    for (std::size_t k = 0; k < 3; ++k) side[k] = sweep.side(corners[k], place);
    if (side == std::array{Sign::zero, Sign::zero, Sign::zero}) section.coplanar_triangles.push_back(t);
    const auto above = [&](std::size_t k) { return (side[k] == Sign::zero ? zero_is : side[k]) == Sign::positive; };
    if (above(0) == above(1) && above(1) == above(2)) continue;
    ++section.cut_triangles;
    // Around the triangle one edge goes down and one goes up: with the solid behind the triangle, the segment from the
    // first to the second has it to the left.
    std::array<Edge, 2> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (above(k) == above(next)) continue;
      std::uint32_t low = corners[above(k) ? next : k], high = corners[above(k) ? k : next];
      if (side[above(k) ? next : k] == Sign::zero) high = low;
      if (side[above(k) ? k : next] == Sign::zero) low = high;
      ends[above(k) ? 0 : 1] = {low, high};
    }
    edges.insert(edges.end(), ends.begin(), ends.end());
  }
  return edges;
}

/// The different ones; the corner of each edge.
std::vector<SectionCorner> number_edges(std::span<const Edge> edges, std::vector<std::uint32_t>& corner_of) {
  std::vector<std::uint32_t> order(edges.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return edges[a] < edges[b]; });
  std::vector<SectionCorner> corners;
  corner_of.resize(edges.size());
  for (const std::uint32_t e : order) {
    const auto& [below, above] = edges[e];
    if (corners.empty() || corners.back().below != below || corners.back().above != above)
      corners.push_back({below, above, {}});
    corner_of[e] = static_cast<std::uint32_t>(corners.size() - 1);
  }
  return corners;
}

/// For each corner the first that is the same point.
std::vector<std::uint32_t> first_of_point(const CutCorners& corners) {
  std::vector<std::uint32_t> order(corners.size()), first(corners.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto nearest = [&](std::uint32_t c) { return std::pair(corners.nearest(c, 0), corners.nearest(c, 1)); };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(nearest(a), a) < std::pair(nearest(b), b); });
  for (std::size_t from = 0, to = 0; from < order.size(); from = to) {
    std::vector<std::uint32_t> points;  // of those that have these nearest doubles
    for (; to < order.size() && nearest(order[to]) == nearest(order[from]); ++to) {
      const auto same = [&](std::uint32_t point) { return corners.equal(point, order[to]); };
      const auto at = std::ranges::find_if(points, same);
      first[order[to]] = at == points.end() ? points.emplace_back(order[to]) : *at;
    }
  }
  return first;
}

/// Leaves those that no other undoes, in order.
std::uint64_t cancel(std::vector<std::array<std::uint32_t, 2>>& segments) {
  std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) {
    return std::pair(std::minmax(a[0], a[1]), a[0]) < std::pair(std::minmax(b[0], b[1]), b[0]);
  });
  std::uint64_t canceled = 0;
  std::vector<std::array<std::uint32_t, 2>> left;
  for (std::size_t from = 0, to = 0; from < segments.size(); from = to) {
    const auto [a, b] = std::minmax(segments[from][0], segments[from][1]);
    std::array<std::size_t, 2> runs{};  // onward, back
    for (; to < segments.size() && std::minmax(segments[to][0], segments[to][1]) == std::minmax(a, b); ++to)
      ++runs[segments[to][0] == a ? 0 : 1];
    const std::size_t both = std::min(runs[0], runs[1]);
    canceled += both;
    left.insert(left.end(), runs[0] - both, {a, b});
    left.insert(left.end(), runs[1] - both, {b, a});
  }
  segments = std::move(left);
  return canceled;
}

}  // namespace

CutSegments cut_segments(const TriangleMesh& mesh, const CutPlane& plane, const PlaneSweep& sweep, std::size_t place,
                         Section& section) {
  const std::vector<Edge> edges = cut_edges(mesh, sweep, place, section);
  CutSegments cut;
  std::vector<std::uint32_t> corner_of;
  cut.corners = number_edges(edges, corner_of);
  for (SectionCorner& c : cut.corners) {
    const Point3 &p = mesh.vertices[c.below], &q = mesh.vertices[c.above];
    c.nearest = c.below == c.above ? Point3{p.x + 0.0, p.y + 0.0, p.z + 0.0} : plane.nearest(p, q);  // no -0
  }
  const auto first = first_of_point(CutCorners(mesh, plane, cut.corners));
  for (std::size_t e = 0; e < edges.size(); e += 2) {
    const std::uint32_t from = first[corner_of[e]], to = first[corner_of[e + 1]];
    if (from != to) cut.segments.push_back({from, to});
  }
  section.canceled_segments = cancel(cut.segments);
  return cut;
}

}  // namespace plumb::surface
