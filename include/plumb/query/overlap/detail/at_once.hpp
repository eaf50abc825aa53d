// A ball against a plane, a halfspace or a box with the axes of space: does the first filter tell?  So short that it is
// inlined where it is asked.
//
// Law: where doubles leave a doubt, and of what is no figure, `exactly` answers.
// Source: that of query/overlap/overlap.hpp.
// Cost: the filter of a formula or two.
#pragma once

#include <array>

#include "plumb/arith/filtered.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/predicates/plane_distance.hpp"

namespace plumb::query {

/// The filter's constant of the square of the distance from a plane against that of the radius, times that of the
/// normal.
extern const double plane_constant;

/// The sign of that, and the side on which the center is; 0 is unsure, as it is for anything but real numbers.
struct PlaneGap {
  int gap, side;
};
inline PlaneGap plane_gap(const Vector3& n, double offset, const Sphere3& ball) {
  const auto& [p, r] = ball;
  using Input = Filtered::Input;
  const std::array<Input, 8> x{{{n.x}, {n.y}, {n.z}, {offset}, {p.x}, {p.y}, {p.z}, {r}}};
  const Filtered height = x[0] * x[4] + x[1] * x[5] + x[2] * x[6] - x[3];
  const Filtered square = predicates::NormalDistanceAgainst3d{}(x);
  const bool sound = !figure::sphere::has_sign(r, r);
  const int gap = sound ? beyond(square.value, plane_constant * square.magnitude) : 0;
  return {gap, beyond(height.value, plane_constant * height.magnitude)};
}

template <class Exactly>
Relation at_once(const Plane3& a, const Sphere3& b, Exactly exactly) {
  const auto [gap, side] = plane_gap(a.normal, a.offset, b);
  if (gap != 0) [[likely]]
    return gap > 0 ? Relation::disjoint : Relation::overlapping;
  return exactly();
}
template <class Exactly>
Relation at_once(const Halfspace3& a, const Sphere3& b, Exactly exactly) {
  const auto [gap, side] = plane_gap(a.normal, a.offset, b);
  if (gap != 0 && (gap < 0 || side != 0)) [[likely]]
    return gap > 0 && side > 0 ? Relation::disjoint : Relation::overlapping;
  return exactly();
}

constexpr double clamped(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

/// By the nearest point of the box, whose numbers are input.
template <class Exactly>
Relation at_once(const Sphere3& a, const Aabb3& b, Exactly exactly) {
  const auto& [p, q] = b;
  const auto& c = a.center;
  const double all = ((p.x + q.x) + (p.y + q.y)) + (p.z + q.z);
  const Point3 nearest{clamped(c.x, p.x, q.x), clamped(c.y, p.y, q.y), clamped(c.z, p.z, q.z)};
  const auto [gap, sure] = figure::sphere::gap(Sphere3{nearest, 0}, a);
  const bool sound = (p.x <= q.x) & (p.y <= q.y) & (p.z <= q.z) & (all - all == 0);
  if (sure & sound) [[likely]]
    return gap > 0 ? Relation::disjoint : Relation::overlapping;
  return exactly();
}

}  // namespace plumb::query
