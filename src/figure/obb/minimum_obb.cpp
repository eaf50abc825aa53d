#include "plumb/figure/obb/minimum_obb.hpp"

#include <algorithm>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "figure/hull/local_points.hpp"
#include "figure/obb/box_search.hpp"
#include "figure/obb/calipers.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb {
namespace {

using namespace figure::frame;

std::vector<Point3> vertices_of(const Hull3& hull, std::span<const Point3> points) {
  std::vector<Point3> kept;
  kept.reserve(hull.vertices.size());
  for (const std::uint32_t v : hull.vertices) {
    if (v >= points.size()) throw InvalidShape("minimum_obb: the hull names a point beyond the last one given");
    kept.push_back(points[v]);
  }
  return kept;
}

// Of points on a line or in a plane.
std::array<Vector3, 3> flat_axes(const Hull3& hull, std::span<const Point3> points) {
  std::vector<Point3> around;
  for (const std::uint32_t c : hull.dimension == 2 ? hull.corners : hull.vertices) around.push_back(points[c]);
  const std::vector<Vector3> local = localized(around);
  if (hull.dimension < 2) return orthonormal({minus(local.back(), local.front()), Vector3{}, Vector3{}});
  Vector3 normal{0, 0, 0};
  for (std::size_t i = 1; i + 1 < local.size(); ++i) {
    normal = plus(normal, cross(minus(local[i], local[0]), minus(local[i + 1], local[0])));
  }
  const auto [d, u, v] = orthonormal({normal, axis_beside(unit(normal)), Vector3{0, 0, 0}});
  std::vector<Vector2> polygon;
  polygon.reserve(local.size());
  for (const Vector3& p : local) polygon.push_back({dot(p, u), dot(p, v)});
  const Vector2 along = smallest_rectangle(polygon).direction;
  const Vector3 first = plus(times(u, along.x), times(v, along.y));
  return {first, cross(d, first), d};
}

// The faces along whose normals the hull is thinnest, and the axes of space: the best box of each, then turned.
FoundBox good_start(const HullModel& model) {
  constexpr std::size_t tried = 24, turned = 6;
  struct Thin {
    double width;
    Vector3 normal;
  };
  std::vector<Thin> thin;
  const ClimbStarts starts(model);
  for (std::size_t f = 0; f < model.normals.size(); ++f) {
    const Vector3& n = model.normals[f];
    const std::uint32_t on = model.corners[model.first[f]], beyond = starts.farthest({-n.x, -n.y, -n.z});
    thin.push_back({dot(minus(model.vertices[on], model.vertices[beyond]), n), n});
  }
  const auto by_width = [](const Thin& a, const Thin& b) { return a.width < b.width; };
  std::ranges::stable_sort(thin, by_width);
  if (thin.size() > tried) thin.resize(tried);
  for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) thin.push_back({0, axis});
  std::vector<FoundBox> boxes;
  for (const Thin& t : thin) boxes.push_back(box_along(model, t.normal));
  std::ranges::stable_sort(boxes, {}, &FoundBox::volume);
  FoundBox best = boxes.front();
  for (std::size_t i = 0; i < std::min(turned, boxes.size()); ++i) {
    const FoundBox better = turned_about_axes(model, boxes[i]);
    if (better.volume < best.volume) best = better;
  }
  return best;
}

}  // namespace

Obb3 minimum_obb(std::span<const Point3> points, const Hull3& hull, const MinimumObbOptions& options) {
  if (points.empty()) throw InvalidShape("minimum_obb: no points; give at least one");
  const std::vector<Point3> vertices = vertices_of(hull, points);
  if (hull.dimension < 3) return fit_obb(flat_axes(hull, points), vertices);
  const HullModel model(hull, points);
  FoundBox found = good_start(model);
  if (vertices.size() <= options.most_vertices) found = turned_about_axes(model, smallest_box(model, found));
  return fit_obb(found.axes, vertices);
}

Obb3 minimum_obb(std::span<const Point3> points, const MinimumObbOptions& options) {
  figure::require_finite_points("minimum_obb", "points", points);
  if (points.empty()) throw InvalidShape("minimum_obb: no points; give at least one");
  return minimum_obb(points, convex_hull(points, {.execution = options.execution}), options);
}

}  // namespace plumb
