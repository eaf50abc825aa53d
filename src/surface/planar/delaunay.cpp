#include "plumb/surface/planar/delaunay.hpp"

#include "surface/planar/checked_points.hpp"
#include "surface/planar/triangulator.hpp"

namespace plumb {
namespace {

using surface::HalfEdge, surface::Triangles;

PlanarTriangulation told(const surface::Triangulator<surface::GivenPoints>& made, std::size_t points) {
  const Triangles& t = made.triangles();
  PlanarTriangulation result;
  result.same.resize(points);
  for (std::uint32_t i = 0; i < points; ++i) result.same[i] = made.same(i);
  std::vector<std::uint32_t> number(t.end() / 4, PlanarTriangulation::none);
  std::uint32_t count = 0;
  for (HalfEdge first = 0; first < t.end(); first += 4)
    if (!t.is_ghost(first)) number[first / 4] = count++;
  result.triangles.reserve(count);
  result.neighbors.reserve(count);
  if (t.has_marks()) result.segments.reserve(count);
  for (HalfEdge first = 0; first < t.end(); first += 4) {
    if (number[first / 4] == PlanarTriangulation::none) continue;
    std::array<std::uint32_t, 3> corners{}, beyond{}, covers{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      corners[k] = made.points().label(t.origin(first + k));
      beyond[k] = number[t.twin(first + k) / 4];
      if (t.has_marks()) covers[k] = t.mark(first + k).constraint;
    }
    result.triangles.push_back(corners);
    result.neighbors.push_back(beyond);
    if (t.has_marks()) result.segments.push_back(covers);
  }
  return result;
}

}  // namespace

CrossingSegments::CrossingSegments(std::uint32_t one, std::uint32_t other, ExactPoint2 common)
    : Error(surface::crossing_text(one, other, common)),
      segments{std::min(one, other), std::max(one, other)},
      place(std::move(common)) {}

PlanarTriangulation delaunay(std::span<const Point2> points) {
  surface::require_points("delaunay", points);
  return told(surface::triangulator_of(points), points.size());
}

PlanarTriangulation delaunay(std::span<const Point2> points, std::span<const PlanarSegment> segments) {
  surface::require_points("delaunay", points);
  surface::require_segments("delaunay", points, segments);
  auto made = surface::triangulator_of(points);
  if (const auto crossing = made.constrain(segments)) surface::throw_crossing(points, segments, *crossing);
  return told(made, points.size());
}

}  // namespace plumb
