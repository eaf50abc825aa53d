#include "plumb/figure/obb/obb.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/frame.hpp"
#include "figure/basic/in_space.hpp"
#include "figure/obb/enclose.hpp"
#include "figure/obb/exact_volume.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

using figure::require_finite_parts;
using figure::require_finite_points;
using figure::within_doubles;

using Axes = std::array<Vector3, 3>;

Obb3 checked(const Obb3& box, std::string_view function) {
  for (const double x : {box.half.x, box.half.y, box.half.z}) (void)within_doubles(x, function, "a half extent");
  for (const double x : {box.center.x, box.center.y, box.center.z}) (void)within_doubles(x, function, "the center");
  for (const Vector3& a : box.axes) {
    for (const double x : {a.x, a.y, a.z}) (void)within_doubles(x, function, "an axis");
  }
  return box;
}

bool is_finite(const Obb3& box) {
  double zero = (box.half.x - box.half.x) + (box.half.y - box.half.y) + (box.half.z - box.half.z);
  for (const Vector3& a : box.axes) zero += (a.x - a.x) + (a.y - a.y) + (a.z - a.z);
  return zero + (box.center.x - box.center.x) + (box.center.y - box.center.y) + (box.center.z - box.center.z) == 0;
}

// Volume first, exactly; then surface in doubles.
bool is_tighter(const Obb3& a, const Obb3& b) {
  const Sign order = figure::compare_volumes(a, b);
  if (order != Sign::zero) return order == Sign::negative;
  const auto surface = [](const Obb3& box) {
    const auto length = [](const Vector3& v) { return std::hypot(v.x, v.y, v.z); };
    const double x = box.half.x * length(box.axes[0]), y = box.half.y * length(box.axes[1]),
                 z = box.half.z * length(box.axes[2]);
    return x * y + y * z + z * x;
  };
  return surface(a) < surface(b);
}

Point3 halfway(const Point3& a, const Point3& b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2}; }

// In doubles, or the largest ones where there are none: to guess a center.
std::array<Point3, 16> near_corners(const Obb3& a, const Obb3& b) {
  constexpr double most = std::numeric_limits<double>::max();
  std::array<Point3, 16> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Obb3& box = i < 8 ? a : b;
    const auto end = [&](std::size_t k, double half) {
      return figure::frame::times(box.axes[k], (i >> k & 1) != 0 ? half : -half);
    };
    const Vector3 way =
        figure::frame::plus(end(0, box.half.x), figure::frame::plus(end(1, box.half.y), end(2, box.half.z)));
    const auto at = [&](double x, double by) { return by - by == 0 ? std::clamp(x + by, -most, most) : x; };
    all[i] = {at(box.center.x, way.x), at(box.center.y, way.y), at(box.center.z, way.z)};
  }
  return all;
}

// b's axes as far as they go with a's, in the order and with the signs that are nearest to a's.
Axes between(const Axes& a, const Axes& b) {
  Axes sum{};
  std::array<bool, 3> taken{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t best = 3;
    double most = -1;
    for (std::size_t j = 0; j < 3; ++j) {
      const double along = std::fabs(figure::frame::dot(a[i], b[j]));
      if (taken[j] || !(along > most)) continue;
      best = j;
      most = along;
    }
    taken[best] = true;
    sum[i] =
        figure::frame::plus(a[i], figure::frame::times(b[best], figure::frame::dot(a[i], b[best]) < 0 ? -1.0 : 1.0));
  }
  return figure::frame::orthonormal(sum);
}

// The same directions as doubles of magnitude one, right angles where they do not span space.
Axes spanning(const Axes& axes) {
  const Axes units{figure::frame::unit(axes[0]), figure::frame::unit(axes[1]), figure::frame::unit(axes[2])};
  const double volume = std::fabs(figure::frame::dot(units[0], figure::frame::cross(units[1], units[2])));
  constexpr double slant = 0x1p-20;  // a guess: flatter than this a frame of right angles is tighter
  return volume > slant && figure::enclosing::independent(axes) ? axes : figure::frame::orthonormal(axes);
}

}  // namespace

std::array<Point3, 8> corners(const Obb3& box) {
  figure::require_sound("corners", box);
  const auto coordinate = [&](double Point3::*p, double Vector3::*v, const std::array<double, 3>& half) {
    return rounded_value(
        Rounding::nearest,
        [](auto c, auto x, auto y, auto z, auto hx, auto hy, auto hz) { return c + (x * hx + (y * hy + z * hz)); },
        box.center.*p, box.axes[0].*v, box.axes[1].*v, box.axes[2].*v, half[0], half[1], half[2]);
  };
  std::array<Point3, 8> all{};
  for (std::size_t i = 0; i < 8; ++i) {
    const std::array<double, 3> half{(i & 1) != 0 ? box.half.x : -box.half.x, (i & 2) != 0 ? box.half.y : -box.half.y,
                                     (i & 4) != 0 ? box.half.z : -box.half.z};
    all[i] = {coordinate(&Point3::x, &Vector3::x, half), coordinate(&Point3::y, &Vector3::y, half),
              coordinate(&Point3::z, &Vector3::z, half)};
    for (const double x : {all[i].x, all[i].y, all[i].z}) (void)within_doubles(x, "corners", "a corner");
  }
  return all;
}

std::array<Point2, 4> corners(const Obb2& box) {
  const auto all = corners(
      Obb3{in_space(box.center), {in_space(box.axes[0]), in_space(box.axes[1]), Vector3{0, 0, 0}}, in_space(box.half)});
  return {Point2{all[0].x, all[0].y}, Point2{all[1].x, all[1].y}, Point2{all[2].x, all[2].y},
          Point2{all[3].x, all[3].y}};
}

Obb3 fit_obb(const Axes& axes, std::span<const Point3> points) {
  require_finite_parts("fit_obb", {"axes[0]", "axes[1]", "axes[2]"}, axes[0], axes[1], axes[2]);
  require_finite_points("fit_obb", "points", points);
  if (points.empty()) throw InvalidShape("fit_obb: no points; give at least one");
  if (!figure::enclosing::independent(axes))
    throw InvalidShape("fit_obb: the axes lie in one plane; give three that span space");
  const Point3 center = figure::enclosing::center(axes, points);
  return checked({center, axes, figure::enclosing::half(axes, center, points)}, "fit_obb");
}

Obb2 fit_obb(const std::array<Vector2, 2>& axes, std::span<const Point2> points) {
  require_finite_parts("fit_obb", {"axes[0]", "axes[1]"}, axes[0], axes[1]);
  require_finite_points("fit_obb", "points", points);
  std::vector<Point3> lifted;
  lifted.reserve(points.size());
  for (const Point2& p : points) lifted.push_back({p.x, p.y, 0});
  const Axes upright{Vector3{axes[0].x, axes[0].y, 0}, Vector3{axes[1].x, axes[1].y, 0}, Vector3{0, 0, 1}};
  if (points.empty()) throw InvalidShape("fit_obb: no points; give at least one");
  if (!figure::enclosing::independent(upright))
    throw InvalidShape("fit_obb: the axes are parallel; give two that span the plane");
  const Obb3 box = fit_obb(upright, lifted);
  return {{box.center.x, box.center.y}, axes, {box.half.x, box.half.y}};
}

Obb3 oriented_box(const Aabb3& box) {
  figure::require_sound("oriented_box", box);
  if (is_empty(box)) throw InvalidShape("oriented_box: the box is empty; give one with min <= max in every axis");
  return fit_obb({Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, std::array{box.min, box.max});
}

Obb3 merge(const Obb3& a, const Obb3& b) {
  figure::require_sound("merge", "a", a);
  figure::require_sound("merge", "b", b);
  const auto within = [](const Obb3& outer, const Obb3& inner) {
    if (!figure::enclosing::independent(outer.axes)) return false;
    const figure::enclosing::Body body{inner};
    const Vector3 h = figure::enclosing::half(outer.axes, outer.center, std::span(&body, 1));
    return h.x <= std::fabs(outer.half.x) && h.y <= std::fabs(outer.half.y) && h.z <= std::fabs(outer.half.z);
  };
  if (a == b || within(a, b)) return a;
  if (within(b, a)) return b;
  const Axes of_a = spanning(a.axes), of_b = spanning(b.axes);
  const Axes right_a = figure::frame::orthonormal(a.axes), right_b = figure::frame::orthonormal(b.axes);
  const Point3 from = halfway(a.center, {-b.center.x, -b.center.y, -b.center.z});
  const Vector3 apart{from.x, from.y, from.z};
  const auto all = near_corners(a, b);
  const std::array bodies{figure::enclosing::Body{a}, figure::enclosing::Body{b}};
  std::optional<Obb3> best;
  for (const Axes& axes :
       {of_a, of_b, between(right_a, right_b), figure::frame::orthonormal({apart, right_a[0], right_a[1]}),
        figure::frame::orthonormal({apart, right_b[0], right_b[1]})}) {
    const Point3 center = figure::enclosing::center(axes, all);
    const Obb3 box{center, axes, figure::enclosing::half(axes, center, bodies)};
    if (!best || (is_finite(box) && (!is_finite(*best) || is_tighter(box, *best)))) best = box;
  }
  return checked(*best, "merge");
}

Obb3 figure::enclosing::transformed(const Obb3& box, const CertainPose& pose) {
  const auto rounded = [&](const auto& v, bool is_point) {
    const auto number = [&](std::size_t axis) {
      return pose.rounded(Rounding::nearest, [&]<class T>(const PoseNumbers<T>& n) {
        const arith::Vec<T> x = arith::vec<T>(v);
        return is_point ? n.image(x, axis) : n.turned(x, axis);
      });
    };
    return Vector3{number(0), number(1), number(2)};
  };
  const Vector3 c = rounded(box.center, true);
  const Point3 center{c.x, c.y, c.z};
  const Axes images{rounded(box.axes[0], false), rounded(box.axes[1], false), rounded(box.axes[2], false)};
  (void)checked({center, images, {0, 0, 0}}, "transform");
  const Axes axes = spanning(images);
  const Body body{box, &pose};
  return checked({center, axes, half(axes, center, std::span(&body, 1))}, "transform");
}

Obb3 transform(const Obb3& box, PoseView pose) {
  figure::require_sound("transform", box);
  figure::require_sound("transform", pose);
  return figure::enclosing::transformed(box, figure::CertainPose(pose));
}

}  // namespace plumb
