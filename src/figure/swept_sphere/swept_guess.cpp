#include "figure/swept_sphere/swept_guess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "figure/basic/frame.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"

namespace plumb::figure::swept {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// An interval that grows, and shrinks to its middle when its ends have passed one another.
struct BallExtent {
  double min = infinity, max = -infinity;
  void add(double from, double to) { min = std::min(min, from), max = std::max(max, to); }
  [[nodiscard]] double middle() const { return min / 2 + max / 2; }
  [[nodiscard]] BallExtent ordered() const { return min <= max ? *this : BallExtent{middle(), middle()}; }
};

double reach(double radius, const LocalBall& ball, double off2) {
  const double left = radius - ball.radius;
  return left > 0 ? std::sqrt(std::max(0.0, left * left - off2)) : 0;
}

// Around which line along the first axis, and how far from it?
struct Line {
  Point2 center;
  double radius;
};

Line line_among(const std::vector<LocalBall>& balls) {
  std::vector<Point2> across;
  across.reserve(balls.size());
  double largest = 0;
  for (const LocalBall& b : balls) {
    across.push_back({b.center.y, b.center.z});
    largest = std::max(largest, b.radius);
  }
  if (largest == 0) {
    const Circle2 circle = minimum_circle(across).circle;
    return {circle.center, circle.radius};
  }
  // Of disks: by the box of their extents.
  BallExtent y, z;
  for (const LocalBall& b : balls) {
    y.add(b.center.y - b.radius, b.center.y + b.radius);
    z.add(b.center.z - b.radius, b.center.z + b.radius);
  }
  Line line{{y.middle(), z.middle()}, 0};
  for (const LocalBall& b : balls)
    line.radius = std::max(line.radius, b.radius + std::hypot(b.center.y - line.center.x, b.center.z - line.center.y));
  return line;
}

double rough_volume(const Capsule3& c) {
  const double length = std::hypot(c.b.x - c.a.x, c.b.y - c.a.y, c.b.z - c.a.z);
  return std::numbers::pi * c.radius * c.radius * (4 * c.radius / 3 + length);
}

double rough_volume(const Lozenge3& l) {
  const auto& [e, f] = l.edges;
  const double a = std::hypot(e.x, e.y, e.z), b = std::hypot(f.x, f.y, f.z);
  return 2 * a * b * l.radius + std::numbers::pi * l.radius * l.radius * (4 * l.radius / 3 + a + b);
}

template <class Shape>
Shape of_least_volume(std::string_view function, const std::vector<Shape>& candidates) {
  if (candidates.empty()) {
    throw BeyondDoubles(
        std::string(function).append(": the bound is beyond all doubles; scale the shape down by a power of two"));
  }
  return *std::ranges::min_element(candidates, {}, [](const Shape& s) { return rough_volume(s); });
}

}  // namespace

Capsule3 guess_capsule(const figure::LocalFrame& frame, const std::vector<LocalBall>& balls) {
  const Line line = line_among(balls);
  BallExtent ends;  // max: the end must be there at least, for the ball before it to be reached
  for (const LocalBall& b : balls) {
    const double y = b.center.y - line.center.x, z = b.center.z - line.center.y;
    const double h = reach(line.radius, b, y * y + z * z);
    ends.add(b.center.x + h, b.center.x - h);
  }
  ends = ends.ordered();
  return {frame.world({ends.min, line.center.x, line.center.y}), frame.world({ends.max, line.center.x, line.center.y}),
          0};
}

std::vector<Lozenge3> guess_lozenges(const figure::LocalFrame& frame, const std::vector<LocalBall>& balls) {
  BallExtent z;
  for (const LocalBall& b : balls) z.add(b.center.z - b.radius, b.center.z + b.radius);
  const double height = z.middle(), radius = z.max - height;
  std::vector<Lozenge3> all;
  // Balls at a corner are beyond both edges; with 1 / sqrt(2) of the reach in each they are reached all the same.
  for (const double share : {1.0, std::numbers::sqrt2 / 2, 0.0}) {
    BallExtent x, y;
    for (const LocalBall& b : balls) {
      const double off = b.center.z - height, h = share * reach(radius, b, off * off);
      x.add(b.center.x + h, b.center.x - h);
      y.add(b.center.y + h, b.center.y - h);
    }
    x = x.ordered(), y = y.ordered();
    all.push_back({frame.world({x.min, y.min, height}),
                   {frame.world_vector({x.max - x.min, 0, 0}), frame.world_vector({0, y.max - y.min, 0})},
                   0});
  }
  return all;
}

bool is_finite(const Capsule3& c) {
  return std::isfinite(c.a.x) && std::isfinite(c.a.y) && std::isfinite(c.a.z) && std::isfinite(c.b.x) &&
         std::isfinite(c.b.y) && std::isfinite(c.b.z) && std::isfinite(c.radius);
}

bool is_finite(const Lozenge3& l) {
  const auto& [e, f] = l.edges;
  return std::isfinite(l.corner.x) && std::isfinite(l.corner.y) && std::isfinite(l.corner.z) && std::isfinite(e.x) &&
         std::isfinite(e.y) && std::isfinite(e.z) && std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z) &&
         std::isfinite(l.radius);
}

Capsule3 smallest(std::string_view function, const std::vector<Capsule3>& candidates) {
  return of_least_volume(function, candidates);
}
Lozenge3 smallest(std::string_view function, const std::vector<Lozenge3>& candidates) {
  return of_least_volume(function, candidates);
}

}  // namespace plumb::figure::swept
