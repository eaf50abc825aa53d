// Swept spheres that hold others: contained, merged, moved.
#include <algorithm>
#include <cmath>
#include <functional>

#include "certify/carried_errors.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/frame.hpp"
#include "figure/basic/in_space.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "figure/swept_sphere/swept_guess.hpp"
#include "figure/swept_sphere/swept_reach.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

namespace plumb {
namespace {

using arith::Vec;

// The corners of the core: a swept sphere lies in a convex set with all sides curved alike when its corners' balls do.
template <class T>
std::vector<Vec<T>> vertices(const Capsule3& c) {
  return figure::swept::core_of<T>(c).vertices;
}
template <class T>
std::vector<Vec<T>> vertices(const Lozenge3& l) {
  return figure::swept::core_of<T>(l).vertices;
}

// Of the greatest distance of the inner core from the outer one, against the difference of the radii.
template <class T, class Shape>
Sign sign_of_excess(const Shape& outer, const Shape& inner, CertainSigns& ask) {
  const T left = T(outer.radius) - T(inner.radius), square = left * left;
  const figure::swept::Core<T> core = figure::swept::core_of<T>(outer);
  Sign most = Sign::negative;
  for (const Vec<T>& v : vertices<T>(inner)) {
    Sign least = Sign::positive;
    figure::swept::visit_distances({{v}, {}, false}, core, ask, [&](const T& numerator, const T& denominator) {
      least = std::min(least, ask(numerator - square * denominator));
    });
    most = std::max(most, least);
  }
  return most;
}

// A core has no interior: around each of its points the distance from it grows as fast as one goes, some way.
template <class Shape>
bool holds(const Shape& outer, const Shape& inner) {
  if (inner.radius > outer.radius) return false;
  return certainly<SignWorlds<Interval, BigDyadic>>(
             [&]<class T>(Carrying<T>& ask) { return sign_of_excess<T>(outer, inner, ask); }) != Sign::positive;
}

template <class Shape>
bool contained(const Shape& outer, const Shape& inner) {
  figure::require_sound("contains", "outer", outer);
  figure::require_sound("contains", "inner", inner);
  return holds(outer, inner);
}

// The radius that `core` needs to hold the shape.
template <class Shape>
double radius_for(const Shape& core, const Shape& shape) {
  double radius = 0;
  for (std::size_t i = 0; i < vertices<Interval>(shape).size(); ++i) {
    const double off = figure::swept::distance_up([&]<class T>() { return vertices<T>(shape)[i]; }, core);
    radius = std::max(radius, Interval::sum_up(off, shape.radius));
  }
  return radius;
}

Point3 about(const Vec<double>& v) { return {v.x, v.y, v.z}; }

template <class Shape>
std::vector<figure::swept::LocalBall> balls(const figure::LocalFrame& frame, const Shape& a, const Shape& b) {
  std::vector<figure::swept::LocalBall> all;
  for (const Shape* s : {&a, &b}) {
    for (const Vec<double>& v : vertices<double>(*s))
      all.push_back({frame.local(about(v)), std::ldexp(s->radius, -frame.exponent)});
  }
  return all;
}

std::vector<Capsule3> guesses(const figure::LocalFrame& frame, const Capsule3& a, const Capsule3& b) {
  return {figure::swept::guess_capsule(frame, balls(frame, a, b))};
}
std::vector<Lozenge3> guesses(const figure::LocalFrame& frame, const Lozenge3& a, const Lozenge3& b) {
  return figure::swept::guess_lozenges(frame, balls(frame, a, b));
}

std::array<Vector3, 3> directions(const Capsule3& c) {
  return {Vector3{c.b.x - c.a.x, c.b.y - c.a.y, c.b.z - c.a.z}, {0, 0, 0}, {0, 0, 0}};
}
std::array<Vector3, 3> directions(const Lozenge3& l) { return {l.edges[0], l.edges[1], {0, 0, 0}}; }

// `settled` makes the shape that is wanted of a guess.
template <class Shape, class Settle = std::identity>
Shape merged(const Shape& a, const Shape& b, Settle settled = {}) {
  figure::require_sound("merge", "a", a);
  figure::require_sound("merge", "b", b);
  if (holds(a, b)) return a;
  if (holds(b, a)) return b;
  std::vector<Point3> corners;
  for (const Shape* s : {&a, &b}) {
    for (const Vec<double>& v : vertices<double>(*s)) {
      const Point3 p = about(v);
      for (const double x : {p.x, p.y, p.z}) figure::within_doubles(x, "merge", "a corner");
      corners.push_back(p);
    }
  }
  figure::LocalFrame principal = figure::principal_frame(corners);
  principal.exponent = std::max(principal.exponent, figure::frame::exponent(std::max(a.radius, b.radius)));
  std::vector<Shape> candidates;
  for (const auto& axes : {principal.axes, directions(a), directions(b)}) {
    figure::LocalFrame frame = principal;
    frame.axes = figure::frame::orthonormal(axes);
    for (const Shape& guess : guesses(frame, a, b)) {
      Shape s = settled(guess);
      if (!figure::swept::is_finite(s)) continue;
      s.radius = std::max(radius_for(s, a), radius_for(s, b));
      if (figure::swept::is_finite(s)) candidates.push_back(s);
    }
  }
  return figure::swept::smallest("merge", candidates);
}

/// The nearest doubles of the image of a point or vector, infinite beyond them.
template <class Part>
Part near_image(const figure::CertainPose& pose, const Part& x) {
  const auto number = [&](std::size_t axis) {
    return pose.rounded(Rounding::nearest, [&]<class T>(const figure::PoseNumbers<T>& n) {
      const Vec<T> v = arith::vec<T>(x);
      return std::is_same_v<Part, Point3> ? n.image(v, axis) : n.turned(v, axis);
    });
  };
  return {number(0), number(1), number(2)};
}

Capsule3 near_core(const figure::CertainPose& pose, const Capsule3& c) {
  return {near_image(pose, c.a), near_image(pose, c.b), 0};
}
Lozenge3 near_core(const figure::CertainPose& pose, const Lozenge3& l) {
  return {near_image(pose, l.corner), {near_image(pose, l.edges[0]), near_image(pose, l.edges[1])}, 0};
}

template <class Shape>
Shape moved(const Shape& shape, const figure::CertainPose& pose, double stretch) {
  Shape core = near_core(pose, shape);
  if (!figure::swept::is_finite(core)) return figure::swept::smallest("transform", std::vector<Shape>{});
  double off = 0;
  for (std::size_t i = 0; i < vertices<Interval>(shape).size(); ++i) {
    const auto vertex = [&]<class T>() {
      const figure::PoseNumbers<T>& n = pose.in<T>();
      return figure::swept::Weighted<T>{n.image(vertices<T>(shape)[i]), n.weight};
    };
    off = std::max(off, figure::swept::distance_up(vertex, core));
  }
  const double stretched =
      stretch == 1 || shape.radius == 0 ? shape.radius + 0.0 : Interval::product_up(stretch, shape.radius);
  core.radius = figure::within_doubles(off == 0 ? stretched : Interval::sum_up(off, stretched), "transform", "radius");
  return core;
}

}  // namespace

bool contains(const Capsule3& outer, const Capsule3& inner) { return contained(outer, inner); }
bool contains(const Lozenge3& outer, const Lozenge3& inner) { return contained(outer, inner); }

Capsule2 merge(const Capsule2& a, const Capsule2& b) {
  return figure::swept::flattened(
      merged(in_space(a), in_space(b), [](const Capsule3& c) { return in_space(figure::swept::flattened(c)); }));
}
Capsule3 merge(const Capsule3& a, const Capsule3& b) { return merged(a, b); }
Lozenge3 merge(const Lozenge3& a, const Lozenge3& b) { return merged(a, b); }

Capsule3 transform(const Capsule3& capsule, PoseView pose) {
  figure::require_sound("transform", capsule);
  figure::require_sound("transform", pose);
  return moved(capsule, figure::CertainPose(pose), largest_stretch(pose));
}

Capsule2 transform(const Capsule2& capsule, PoseView2 pose) {
  figure::require_sound("transform", capsule);
  figure::require_sound("transform", pose);
  return figure::swept::flattened(moved(in_space(capsule), figure::CertainPose(pose), largest_stretch(pose)));
}

Lozenge3 transform(const Lozenge3& lozenge, PoseView pose) {
  figure::require_sound("transform", lozenge);
  figure::require_sound("transform", pose);
  return moved(lozenge, figure::CertainPose(pose), largest_stretch(pose));
}

}  // namespace plumb
