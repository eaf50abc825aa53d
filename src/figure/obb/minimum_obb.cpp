#include "plumb/figure/obb/minimum_obb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "arith/big_rounding.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/hull/canonical_hull.hpp"
#include "figure/hull/local_points.hpp"
#include "figure/obb/box_search.hpp"
#include "figure/obb/calipers.hpp"
#include "figure/obb/exact_volume.hpp"
#include "figure/obb/frame_volume.hpp"
#include "figure/obb/needle_axes.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb {
namespace {

using namespace figure::frame;

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

std::optional<Obb3> fitted(const std::array<Vector3, 3>& axes, std::span<const Point3> points) {
  try {
    return fit_obb(axes, points);
  } catch (const BeyondDoubles&) {
    return {};
  }
}

BigDyadic exact_volume(const Obb3& box) { return magnitude(figure::signed_volume_of<BigDyadic>(box)); }

using Axes = std::array<Vector3, 3>;

// The smallest of boxes with these axes, with those of space and with those of a needle.
Obb3 smallest_fit(const Axes& axes, const Axes& others, std::span<const Point3> points) {
  std::optional<Obb3> best;
  constexpr std::array upright{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  for (const auto& tried : {axes, others, upright, needle_axes(points)}) {
    const auto box = fitted(tried, points);
    if (box && (!best || figure::compare_volumes(*box, *best) == Sign::negative)) best = box;
  }
  return best ? *best : fit_obb(axes, points);
}

// By which part of `least` cubes of side 2^exponent the box is larger, rounded up.
double excess_of(const Obb3& box, double least, int exponent) {
  const BigDyadic volume = exact_volume(box);
  if (!(least > 0)) return volume.sign() == Sign::zero ? 0 : std::numeric_limits<double>::infinity();
  const BigDyadic some(std::ldexp(1.0, exponent / 2)), rest(std::ldexp(1.0, exponent - exponent / 2));
  const BigDyadic side = some * rest, floor = BigDyadic(least) * (side * side * side);
  return std::max(0.0, rounded_quotient(Rounding::up, volume - floor, floor));
}

}  // namespace

CertifiedObb3 certified_minimum_obb(std::span<const Point3> points, const Hull3& given,
                                    const MinimumObbOptions& options) {
  if (points.empty()) throw InvalidShape("minimum_obb: no points; give at least one");
  const auto [vertices, hull] = figure::CanonicalHull("minimum_obb", given, points);
  if (hull.dimension < 3) {
    const Axes axes = flat_axes(hull, vertices);
    const Obb3 flat = smallest_fit(axes, axes, vertices);
    return {flat, Interval(0), 0, excess_of(flat, 0, 0)};
  }
  HullModel model(hull, vertices);
  FlushArcs flush(model, vertices);
  model.vertices = flush.vertices;
  model.normals = flush.normals;
  SearchedBox found{good_start(model), 0};
  Axes turned = found.best.axes;
  double most = std::numeric_limits<double>::infinity();
  if (vertices.size() <= options.most_vertices) {
    found = smallest_box(model, flush, found.best, options.most_parts);
    most = found.best.volume;
    turned = turned_about_axes(model, found.best).axes;
  }
  const Obb3 box = smallest_fit(found.best.axes, turned, vertices);
  for (const Axes& axes : {found.best.axes, box.axes}) most = std::min(most, volume_above(flush, right_angle(axes)));
  const Interval least{std::max(found.least, flush.hull_volume), most};
  const double excess = excess_of(box, least.lower, flush.exponent);
  if (std::abs(flush.exponent) > 256) return {box, least, flush.exponent, excess};
  return {box, {std::ldexp(least.lower, 3 * flush.exponent), std::ldexp(least.upper, 3 * flush.exponent)}, 0, excess};
}

CertifiedObb3 certified_minimum_obb(std::span<const Point3> points, const MinimumObbOptions& options) {
  figure::require_finite_points("minimum_obb", "points", points);
  if (points.empty()) throw InvalidShape("minimum_obb: no points; give at least one");
  return certified_minimum_obb(points, convex_hull(points), options);
}

Obb3 minimum_obb(std::span<const Point3> points, const Hull3& hull, const MinimumObbOptions& options) {
  return certified_minimum_obb(points, hull, options).box;
}

Obb3 minimum_obb(std::span<const Point3> points, const MinimumObbOptions& options) {
  return certified_minimum_obb(points, options).box;
}

}  // namespace plumb
