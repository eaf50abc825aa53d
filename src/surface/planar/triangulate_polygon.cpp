#include "plumb/surface/planar/triangulate_polygon.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "plumb/surface/planar/arrange_segments.hpp"
#include "surface/planar/checked_points.hpp"
#include "surface/planar/ring_edges.hpp"
#include "surface/planar/ring_points.hpp"
#include "surface/planar/triangulator.hpp"

namespace plumb {
namespace {

using surface::HalfEdge, surface::Triangles;

void require_rings(std::size_t points, std::span<const std::uint32_t> first) {
  if (first.empty() || first.front() != 0 || first.back() != points)
    throw Error("triangulate: the rings are not all of the points; first begins with 0 and ends with their number");
  for (std::size_t r = 0; r + 1 < first.size(); ++r)
    if (first[r + 1] < first[r] || first[r + 1] - first[r] < 3)
      throw InvalidShape(std::string("triangulate: ring ")
                             .append(std::to_string(r))
                             .append(" of the polygon has fewer than three vertices; give three or more"));
}

bool is_inside(std::int32_t winding, WindingRule rule) {
  return rule == WindingRule::odd ? winding % 2 != 0 : rule == WindingRule::nonzero ? winding != 0 : winding > 0;
}

// Which way triangles turn: counterclockwise, or as the rings wind.
enum class Turn { left, as_wound };

CornerTriangles inside(std::span<const Point2> points, std::span<const std::uint32_t> first, WindingRule rule,
                       Turn turn) {
  surface::require_points("triangulate", points);
  const std::vector<PlanarSegment> edges = surface::ring_edges(first);
  auto made = surface::triangulator_of(points);
  if (const auto crossing = made.constrain(edges)) surface::throw_crossing(points, edges, *crossing);
  const Triangles& t = made.triangles();
  CornerTriangles result;
  if (!t.has_marks()) return result;
  const std::vector<std::int32_t> windings = made.windings();
  for (HalfEdge e = 0; e < t.end(); e += 4) {
    const std::int32_t w = windings[e / 4];
    if (!is_inside(w, rule)) continue;
    const auto label = [&](HalfEdge corner) { return made.points().label(t.origin(corner)); };
    result.push_back({label(e), label(e + 1), label(e + 2)});
    if (turn == Turn::as_wound && w < 0) std::swap(result.back()[1], result.back()[2]);
  }
  return result;
}

}  // namespace

CornerTriangles triangulate(std::span<const Point2> points, std::span<const std::uint32_t> first, WindingRule rule) {
  require_rings(points.size(), first);
  return inside(points, first, rule, Turn::left);
}

CornerTriangles triangulate(std::span<const Point3> points, std::span<const std::uint32_t> first, WindingRule rule) {
  require_rings(points.size(), first);
  require_finite_points("triangulate", "points", points);
  if (points.empty()) return {};
  const PlaneOfPoints plane = plane_of_points(points);
  require_planar("triangulate", "polygon", plane);
  if (plane.dimension < 2) return {};
  const Look look = look_at_plane(points[plane.span[0]], points[plane.span[1]], points[plane.span[2]]);
  std::vector<Point2> seen;
  seen.reserve(points.size());
  for (const Point3& p : points) seen.push_back(projected(look, p));
  return inside(seen, first, rule, Turn::as_wound);
}

CornerTriangles triangulate(const Polygon2& polygon, WindingRule rule) {
  return triangulate(HoledPolygon2{polygon, {}}, rule);
}
CornerTriangles triangulate(const Polygon3& polygon, WindingRule rule) {
  return triangulate(HoledPolygon3{polygon, {}}, rule);
}
CornerTriangles triangulate(const HoledPolygon2& polygon, WindingRule rule) {
  const auto [points, first] = surface::ring_points<Point2>(polygon);
  return triangulate(points, first, rule);
}
CornerTriangles triangulate(const HoledPolygon3& polygon, WindingRule rule) {
  const auto [points, first] = surface::ring_points<Point3>(polygon);
  return triangulate(points, first, rule);
}

ExactTriangles triangulate_with_crossings(const Polygon2& polygon, WindingRule rule) {
  return triangulate_with_crossings(HoledPolygon2{polygon, {}}, rule);
}

ExactTriangles triangulate_with_crossings(const HoledPolygon2& polygon, WindingRule rule) {
  const auto [points, first] = surface::ring_points<Point2>(polygon);
  require_rings(points.size(), first);
  surface::require_points("triangulate_with_crossings", points);
  std::vector<Segment2> edges;
  for (const auto& [a, b] : surface::ring_edges(first)) edges.push_back({points[a], points[b]});
  PlanarArrangement made = arrange_segments(edges);
  ExactTriangles result{std::move(made.vertices), {}};
  for (std::size_t t = 0; t < made.triangles.size(); ++t)
    if (is_inside(made.windings[made.face_of[t]], rule)) result.triangles.push_back(made.triangles[t]);
  return result;
}

}  // namespace plumb
