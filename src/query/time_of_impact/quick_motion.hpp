// Time of impact: do two shapes meet in straight motion, and when first?  Plain doubles, and pairs of them for the
// time; no more.
//
// Laws: (1) yes and no are those of real arithmetic; unsure says nothing.  (2) Asked when, the contact is that of
// query/time_of_impact/translating_contact.hpp: its time is rounded down, and its features are the only ones that meet then, or the
// first of those of boxes.  (3) Nothing is allocated.  Numbers are to be finite, but where it looks at them itself; radii
// not negative, and boxes not empty.
// Source: RTCD 5.5.2, 5.5.3, 5.5.4, 5.5.5, 5.5.6, 5.5.8; magnitudes bound the errors (arith/approximate.hpp).
// Cost: about that of the plain test; some 0.1 to 0.5 us where there is a time to round.
#pragma once

#include <concepts>
#include <optional>

#include "arith/twofold.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/query/time_of_impact/motion.hpp"
#include "query/time_of_impact/contact_wanted.hpp"
#include "query/time_of_impact/quick_hull.hpp"

namespace plumb::query::quick {

/// Where they start in one another, as it seems, no more is told.
enum class MotionVerdict : unsigned char { no, yes, unsure, starts };

struct Answer {
  MotionVerdict told = MotionVerdict::unsure;
  Contact contact{};  // of a yes, where asked when
};

inline constexpr Answer no{MotionVerdict::no}, unsure{MotionVerdict::unsure};
inline constexpr Answer overlap{MotionVerdict::yes, {0, {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}};

using Pairs = Twofold<false>;

/// A yes at this time, if its double is certain.
inline Answer at(const Ball& time, Feature a, Feature b) {
  const std::optional<double> down = time.rounded(Rounding::down);
  return down ? Answer{MotionVerdict::yes, {*down, a, b}} : unsure;
}
inline Answer at(const Pairs& time, Feature a, Feature b) {
  const Rounded s = two_sum(time.high, time.low);
  const double off = time.reach();
  constexpr double usual = 0x1p1000;  // a guess: what is larger is left to exact numbers
  if (!(off < Ball::infinity) || !(magnitude_of(s.value) < usual)) return unsure;
  return at(Ball{s.value, s.error, off}, a, b);
}

/// The motion of the first shape, seen from the second.
template <class T>
[[gnu::always_inline]] inline Vec3<T> velocity(const Vector3& a, const Vector3& b) {
  return {coordinate_difference<T>(a.x, b.x), coordinate_difference<T>(a.y, b.y), coordinate_difference<T>(a.z, b.z)};
}

template <ContactWanted asked>
Answer contact(const Translating<Sphere3>& a, const Translating<Sphere3>& b);
template <ContactWanted asked>
Answer contact(const Translating<Sphere3>& a, const Translating<Point3>& b);
template <ContactWanted asked>
Answer contact(const Translating<Aabb3>& a, const Translating<Aabb3>& b);
/// Without reach.
template <class Shape>
inline constexpr int rank_of = std::same_as<Shape, Point3>      ? 0
                               : std::same_as<Shape, Segment3>  ? 1
                               : std::same_as<Shape, Triangle3> ? 2
                               : std::same_as<Shape, Aabb3>     ? 3
                               : std::same_as<Shape, Obb3>      ? 4
                                                                : -1;
template <class Shape>
concept Flat = rank_of<Shape>
>= 0;

/// In the order of Flat, two boxes Aabb3 apart.
template <ContactWanted asked, Flat A, Flat B>
requires(rank_of<A> <= rank_of<B> && !(std::same_as<A, Aabb3> && std::same_as<B, Aabb3>)) Answer
    contact(const Translating<A>& a, const Translating<B>& b);

/// Of a fixed number of vertices.
template <class Shape>
concept Small = !std::same_as<Shape, Plane3> && !std::same_as<Shape, ConvexPolyhedron3>;

template <ContactWanted asked, Small Shape>
Answer contact(const Translating<Shape>& a, const Translating<Plane3>& b);

template <class Shape>
inline constexpr bool is_ball = std::same_as<Shape, Sphere3>;
template <class Shape>
concept Round = is_ball<Shape> || std::same_as<Shape, Capsule3>;
/// Of which nothing is told where a number is none.
template <class A, class B>
inline constexpr bool looks_at_numbers = is_ball<A> && (is_ball<B> || std::same_as<B, Point3>);
/// One quadratic, or in the other order.
template <class A, class B>
concept IsBalls = (is_ball<A> && (is_ball<B> || std::same_as<B, Point3>)) || (std::same_as<A, Capsule3> && is_ball<B>);
template <ContactWanted asked, Round A, Small B>
requires(!IsBalls<A, B>) Answer contact(const Translating<A>& a, const Translating<B>& b);

// Of a pair, both.
#define PLUMB_QUICK_PAIR(A, B)                                                                   \
  template Answer contact<ContactWanted::whether>(const Translating<A>&, const Translating<B>&); \
  template Answer contact<ContactWanted::when>(const Translating<A>&, const Translating<B>&);

}  // namespace plumb::query::quick
