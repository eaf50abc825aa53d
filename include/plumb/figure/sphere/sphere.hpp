// Bounding volume (sphere): do two balls meet, does one hold the other, and which ball holds both?
//
// Laws: (1) relate, intersects and contains are those of real arithmetic on the closed balls; relate and intersects are
// symmetric.  (2) A merged ball certainly contains what it was made of, and is as small as its rounding allows: one of
// the two where it holds the other, exactly decided; otherwise its center is a guess in doubles, its radius the least
// double that will do from there, above that of the smallest ball by 2^-48 of itself or of the largest coordinate of its
// center at most.  merge(a, b) is merge(b, a).  (3) A transformed ball certainly
// contains the exact image, whatever the matrix; its center is the image's rounded once, its radius above the least by
// some ulps, and by what the center is off.  Under a rigid pose the radius grows by what the center is off alone.
// A negative radius and an empty span throw InvalidShape; NaN and infinity throw NonFinite, naming the part; a bound
// that no double holds throws BeyondDoubles.
// Source: RTCD 4.3, 4.3.1, 6.5.2.
// Cost: relate and intersects about that of the plain test, inline; merge some 300 ns; transform some 10 us, nearly all
// for the stretch.  Nothing is searched: a span is passed through once.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include "plumb/arith/square_sum.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/predicates/distance.hpp"

namespace plumb {

namespace figure::sphere {

inline constexpr std::array<std::string_view, 4> two_balls{"a.center", "a.radius", "b.center", "b.radius"};

/// The square of the distance of the centers against that of the sum of the radii: positive when apart.
struct Gap2 {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{2, 1, 2, 1};
  static constexpr auto argument_names = two_balls;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    using predicates::squared;
    return squared(p[0] - p[3]) + squared(p[1] - p[4]) - squared(p[2] + p[5]);
  }
};
struct Gap3 {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 1, 3, 1};
  static constexpr auto argument_names = two_balls;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    using predicates::squared;
    return squared(p[0] - p[4]) + squared(p[1] - p[5]) + squared(p[2] - p[6]) - squared(p[3] + p[7]);
  }
};

/// What the filter leaves in doubt, and what is no pair of balls.
Sign gap_exactly(std::string_view function, const Circle2& a, const Circle2& b);
Sign gap_exactly(std::string_view function, const Sphere3& a, const Sphere3& b);

inline auto square_of_distance(const Point2& a, const Point2& b) {
  using arith::squares::difference, arith::squares::squared;
  return squared(difference(a.x, b.x)) + squared(difference(a.y, b.y));
}
inline auto square_of_distance(const Point3& a, const Point3& b) {
  using arith::squares::difference, arith::squares::squared;
  return squared(difference(a.x, b.x)) + squared(difference(a.y, b.y)) + squared(difference(a.z, b.z));
}
inline auto square_of_reach(double a, double b) { return arith::squares::squared(arith::squares::sum(a, b)); }

/// Is one of them negative, or -0?  Asked of integers, who have time left.
inline bool has_sign(double x, double y) {
  return static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x) | std::bit_cast<std::uint64_t>(y)) < 0;
}

/// Gap2 and Gap3 in doubles.
template <class Ball>
PLUMB_CHECKABLE arith::squares::Comparison gap(const Ball& a, const Ball& b) {
  assert_sound_thread();
  const auto [value, sure] = compare(square_of_distance(a.center, b.center), square_of_reach(a.radius, b.radius));
  return {value, sure && !has_sign(a.radius, b.radius)};
}

template <class Ball>
Relation relate(const Ball& a, const Ball& b) {
  const auto g = gap(a, b);
  if (g.sure) [[likely]]
    return g.value > 0 ? Relation::disjoint : Relation::overlapping;
  const Sign s = gap_exactly("relate", a, b);
  // Two equal points: each is the interior of itself.
  if (s == Sign::zero && a.radius == 0 && b.radius == 0) return Relation::overlapping;
  return static_cast<Relation>(-s);
}

template <class Ball>
bool intersects(const Ball& a, const Ball& b) {
  const auto g = gap(a, b);
  if (g.sure) [[likely]]
    return g.value < 0;
  return gap_exactly("intersects", a, b) != Sign::positive;
}

}  // namespace figure::sphere

inline Relation relate(const Circle2& a, const Circle2& b) { return figure::sphere::relate(a, b); }
inline Relation relate(const Sphere3& a, const Sphere3& b) { return figure::sphere::relate(a, b); }
inline bool intersects(const Circle2& a, const Circle2& b) { return figure::sphere::intersects(a, b); }
inline bool intersects(const Sphere3& a, const Sphere3& b) { return figure::sphere::intersects(a, b); }

/// Does the outer ball hold every point of the inner one?
bool contains(const Circle2& outer, const Circle2& inner);
bool contains(const Sphere3& outer, const Sphere3& inner);

/// A ball around both.
Circle2 merge(const Circle2& a, const Circle2& b);
Sphere3 merge(const Sphere3& a, const Sphere3& b);

/// A ball around the ball and the point.
Circle2 merge(const Circle2& circle, const Point2& p);
Sphere3 merge(const Sphere3& sphere, const Point3& p);

/// A ball around all, merged in turn; minimum_sphere finds the smallest.
Circle2 merge(std::span<const Circle2> circles);
Sphere3 merge(std::span<const Sphere3> spheres);

/// A ball around the image.
Circle2 transform(const Circle2& circle, PoseView2 pose);
Sphere3 transform(const Sphere3& sphere, PoseView pose);

/// How much the matrix stretches the vector that it stretches most, certainly not less, and more by some ulps at most:
/// its spectral norm.  Of rigid poses 1.
double largest_stretch(PoseView2 pose);
double largest_stretch(PoseView pose);

}  // namespace plumb
