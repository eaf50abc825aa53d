// Swept spheres around points: cores by principal axes in plain doubles, radii for certain.
#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/frame.hpp"
#include "figure/basic/in_space.hpp"
#include "figure/measures/local_frame.hpp"
#include "figure/swept_sphere/swept_guess.hpp"
#include "figure/swept_sphere/swept_reach.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

namespace plumb {
namespace {

using figure::LocalFrame;

// (p, a, b, s, r): |p - (a + s (b - a))|^2 - r^2.  Negative is proof for any s in [0, 1].
struct BeyondCapsule {
  static constexpr std::string_view name = "fit_capsule";
  static constexpr std::array arguments{3, 3, 3, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 11>& p) const {
    const auto difference = [&](std::size_t i) { return (p[i] - p[3 + i]) - p[9] * (p[6 + i] - p[3 + i]); };
    const auto x = difference(0), y = difference(1), z = difference(2);
    return x * x + y * y + z * z - p[10] * p[10];
  }
};

// (p, corner, e, f, s, t, r): |p - (corner + s e + t f)|^2 - r^2.
struct BeyondLozenge {
  static constexpr std::string_view name = "fit_lozenge";
  static constexpr std::array arguments{3, 3, 3, 3, 1, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto difference = [&](std::size_t i) { return (p[i] - p[3 + i]) - (p[12] * p[6 + i] + p[13] * p[9 + i]); };
    const auto x = difference(0), y = difference(1), z = difference(2);
    return x * x + y * y + z * z - p[14] * p[14];
  }
};

double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double part(double x, double of) { return of > 0 ? std::clamp(x / of, 0.0, 1.0) : 0; }

bool is_certainly_within(const Capsule3& c, const Point3& p) {
  const Vector3 d{c.b.x - c.a.x, c.b.y - c.a.y, c.b.z - c.a.z}, w{p.x - c.a.x, p.y - c.a.y, p.z - c.a.z};
  return filter<BeyondCapsule>(
             {p.x, p.y, p.z, c.a.x, c.a.y, c.a.z, c.b.x, c.b.y, c.b.z, part(dot(w, d), dot(d, d)), c.radius}) < 0;
}

bool is_certainly_within(const Lozenge3& l, const Point3& p) {
  const auto& [e, f] = l.edges;
  const Vector3 w{p.x - l.corner.x, p.y - l.corner.y, p.z - l.corner.z};
  return filter<BeyondLozenge>({p.x, p.y, p.z, l.corner.x, l.corner.y, l.corner.z, e.x, e.y, e.z, f.x, f.y, f.z,
                                part(dot(w, e), dot(e, e)), part(dot(w, f), dot(f, f)), l.radius}) < 0;
}

// Gives the shape the least radius that reaches all points; false where none, or not even its core, is in doubles.
template <class Shape>
bool reaches_all(std::span<const Point3> points, Shape& shape) {
  shape.radius = 0;
  if (!figure::swept::is_finite(shape)) return false;
  for (const Point3& p : points) {
    if (!is_certainly_within(shape, p)) shape.radius = std::max(shape.radius, figure::swept::distance_up(p, shape));
    if (!(shape.radius < std::numeric_limits<double>::infinity())) return false;
  }
  return true;
}

template <class Shape>
Shape smallest(std::string_view function, std::span<const Point3> points, std::vector<Shape> candidates) {
  std::erase_if(candidates, [&](Shape& s) { return !reaches_all(points, s); });
  return figure::swept::smallest(function, candidates);
}

void check_points(std::string_view function, std::span<const Point3> points) {
  if (points.empty()) throw InvalidShape(std::string(function).append(": no points; give at least one"));
  figure::require_finite_points(function, "points", points);
}

std::vector<figure::swept::LocalBall> balls(const LocalFrame& frame, std::span<const Point3> points) {
  std::vector<figure::swept::LocalBall> all;
  all.reserve(points.size());
  for (const Point3& p : points) all.push_back({frame.local(p), 0});
  return all;
}

// Cores along the principal axis.
std::vector<Capsule3> capsules_around(std::span<const Point3> points) {
  const LocalFrame frame = figure::principal_frame(points);
  // The segment between the extremal points themselves: exact for points on a line.
  const auto order = [&](const Point3& p, const Point3& q) {
    return sign_of(predicates::OrderAlongDirection3d{}, p, q, frame.axes[0]) == Sign::negative;
  };
  const auto [least, most] = std::ranges::minmax_element(points, order);
  return {figure::swept::guess_capsule(frame, balls(frame, points)), {*least, *most, 0}};
}

// From the line: the square of the area over that of the length.
struct AreaSquare {
  static constexpr std::string_view name = "fit_cylinder";
  static constexpr std::array arguments{3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    const auto w = predicates::difference(p, 0, 1), d = predicates::difference(p, 2, 1);
    const auto c = predicates::cross(w, d);
    return predicates::dot(c, c);
  }
};
struct LengthSquare {
  static constexpr std::string_view name = "fit_cylinder";
  static constexpr std::array arguments{3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    const auto d = predicates::difference(p, 2, 1);
    return predicates::dot(d, d);
  }
};

double line_distance_up(const Point3& p, const Point3& a, const Point3& b) {
  return rounded_root_of_quotient(Rounding::up, AreaSquare{}, LengthSquare{}, p, a, b);
}

bool lies_between(const Point3& p, const Point3& a, const Point3& b) {
  return sign_of(predicates::OrderAlongLine3d{}, p, a, a, b) != Sign::negative &&
         sign_of(predicates::OrderAlongLine3d{}, p, b, a, b) != Sign::positive;
}

}  // namespace

Capsule3 fit_capsule(std::span<const Point3> points) {
  check_points("fit_capsule", points);
  return smallest("fit_capsule", points, capsules_around(points));
}

Capsule2 fit_capsule(std::span<const Point2> points) {
  if (points.empty()) throw InvalidShape("fit_capsule: no points; give at least one");
  figure::require_finite_points("fit_capsule", "points", points);
  std::vector<Point3> raised;
  raised.reserve(points.size());
  for (const Point2& p : points) raised.push_back(in_space(p));
  std::vector<Capsule3> candidates = capsules_around(raised);
  for (Capsule3& c : candidates) c = in_space(figure::swept::flattened(c));
  return figure::swept::flattened(smallest("fit_capsule", raised, std::move(candidates)));
}

Lozenge3 fit_lozenge(std::span<const Point3> points) {
  check_points("fit_lozenge", points);
  const LocalFrame frame = figure::principal_frame(points);
  return smallest("fit_lozenge", points, figure::swept::guess_lozenges(frame, balls(frame, points)));
}

Cylinder3 fit_cylinder(std::span<const Point3> points) {
  check_points("fit_cylinder", points);
  if (std::ranges::all_of(points, [&](const Point3& p) { return p == points[0]; })) return {points[0], points[0], 0};
  const LocalFrame frame = figure::principal_frame(points);
  std::vector<Point2> across;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Point3& p : points) {
    const Vector3 x = frame.local(p);
    across.push_back({x.y, x.z});
    least = std::min(least, x.x), most = std::max(most, x.x);
  }
  const Point2 center = minimum_circle(across).circle.center;
  Cylinder3 c{};
  // The planes of the ends move outward, from a guess, until no point is beyond them.
  const auto end = [&](double along) {
    constexpr double largest = std::numeric_limits<double>::max();
    const Point3 p = frame.world({along, center.x, center.y});
    return Point3{std::clamp(p.x, -largest, largest), std::clamp(p.y, -largest, largest),
                  std::clamp(p.z, -largest, largest)};
  };
  // Until it is beyond all doubles, and throws.
  for (double margin = figure::frame::first_margin(frame.exponent);; margin *= 4) {
    figure::within_doubles(margin, "fit_cylinder", "an end");
    c.a = end(least - margin);
    c.b = end(most + margin);
    if (!(c.a == c.b) && std::ranges::all_of(points, [&](const Point3& p) { return lies_between(p, c.a, c.b); })) break;
  }
  for (const Point3& p : points)
    c.radius = std::max(c.radius, figure::within_doubles(line_distance_up(p, c.a, c.b), "fit_cylinder", "radius"));
  return c;
}

}  // namespace plumb
