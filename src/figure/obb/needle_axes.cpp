#include "figure/obb/needle_axes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "arith/vec.hpp"
#include "figure/basic/frame.hpp"
#include "figure/obb/calipers.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/figure/hull/hull2.hpp"

namespace plumb::figure::frame {
namespace {

// A fourth of the way, which no difference of doubles exceeds; powers of two change no direction.
Vector3 fourth_between(const Point3& a, const Point3& b) {
  return {b.x / 4 - a.x / 4, b.y / 4 - a.y / 4, b.z / 4 - a.z / 4};
}

std::size_t farthest_from(std::span<const Point3> points, std::size_t start) {
  std::size_t far = start;
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 d = fourth_between(points[start], points[i]);
    const double size = std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
    if (size > most) most = size, far = i;
  }
  return far;
}

}  // namespace

std::array<Vector3, 3> needle_axes(std::span<const Point3> points) {
  const std::size_t from = farthest_from(points, 0), to = farthest_from(points, from);
  const Vector3 way = fourth_between(points[from], points[to]);
  if (!(largest(way) > 0)) return {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  const Vector3 along = scaled(way, -exponent(largest(way)));
  const auto [d, u, v] = orthonormal({along, axis_beside(unit(along)), Vector3{0, 0, 0}});
  const auto e = arith::vec<Ball>(along), start = arith::vec<Ball>(points[from]);
  const auto right = cross(e, arith::vec<Ball>(v)), up = cross(arith::vec<Ball>(u), e);  // nearly -u and -v
  std::vector<Point2> seen;
  seen.reserve(points.size());
  for (const Point3& p : points) {
    const auto off = arith::vec<Ball>(p) - start;
    seen.push_back({dot(off, right).high, dot(off, up).high});
    if (!(std::fabs(seen.back().x) + std::fabs(seen.back().y) < Ball::infinity)) return {along, u, v};
  }
  double most = 0;
  for (const Point2& p : seen) most = std::max({most, std::fabs(p.x), std::fabs(p.y)});
  std::vector<Vector2> polygon;
  const int shift = -exponent(most) - 1;
  for (const std::uint32_t i : convex_hull(seen).vertices)
    polygon.push_back({std::ldexp(seen[i].x, shift), std::ldexp(seen[i].y, shift)});
  const Vector2 direction = smallest_rectangle(polygon).direction;
  const Vector3 second = plus(times(u, direction.x), times(v, direction.y));
  return {along, second, cross(d, second)};
}

}  // namespace plumb::figure::frame
