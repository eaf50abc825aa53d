// Separating axis, in motion: how far do the differences of two shapes' points reach along a direction, and how fast do
// they go along it?
//
// Statements over a world.  Coordinates of the motion are of its scale 0; a direction is one as given, of scale 1, or
// the cross product of two ways, of scales 1 and 2.  Of floats the numbers that a search has computed are the leaves:
// what each was rounded is in its type.
// Law: of shapes and directions of any kind, what is told is that of the exact numbers, or not told.
// Source: RTCD 5.2.1, 5.5.2.
// Cost: a dot product for each way.
#pragma once

#include "plumb/certify/certainly.hpp"
#include "query/time_of_impact/quick_motion.hpp"

namespace plumb::query::quick {

inline double size_of(const Vec3<double>& v) { return magnitude_of(v.x) + magnitude_of(v.y) + magnitude_of(v.z); }
inline double largest_of(const Vec3<double>& v) {
  const double x = magnitude_of(v.x), y = magnitude_of(v.y), z = magnitude_of(v.z);
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

/// Two shapes and how far they reach together, over any number type.
template <class N, class A, class B>
struct Moved {
  using HullA = decltype(hull_of<N>(std::declval<A>()));
  using HullB = decltype(hull_of<N>(std::declval<B>()));

  Moved(const Translating<A>& of_a, const Translating<B>& of_b)
      : a(hull_of<N>(of_a.shape)),
        b(hull_of<N>(of_b.shape)),
        by(velocity<N>(of_a.by, of_b.by)),
        apart(between<N>(a.place, b.place)),
        reach(N(reach_of(of_a.shape)) + N(reach_of(of_b.shape))) {}

  HullA a;
  HullB b;
  Vec3<N> by, apart;  // the motion of a, seen from b; from the place of a to that of b
  N reach;
};

template <class Listener = NoBoundListener>
using MotionWorld = certify::one_lane::Floats<double, 4, Scales{.count = 3}, Listener>;

template <std::size_t scale>
using GivenLeaf = decltype(std::declval<MotionWorld<>&>().template number<scale>(0.0));
/// A difference of two numbers as given, or their product: rounded once.
template <std::size_t scale>
constexpr Track track_of_coordinate() {
  using Leaf = GivenLeaf<scale>;
  Track t = Leaf::track;
  t.error = t.root = decltype(Leaf{0} * Leaf{0})::track.error;
  return t;
}
template <std::size_t scale>
using Coordinate = certify::one_lane::Tracked<double, track_of_coordinate<scale>()>;

template <std::size_t scale>
[[gnu::always_inline]] inline Vec3<GivenLeaf<scale>> given(const Vec3<double>& v) {
  return {{v.x}, {v.y}, {v.z}};
}
template <std::size_t scale>
[[gnu::always_inline]] inline Vec3<Coordinate<scale>> known(const Vec3<double>& v) {
  return {{v.x}, {v.y}, {v.z}};
}

/// As Moved has them, over other numbers.
template <class HullA, class HullB, class N>
struct KnownMotion {
  HullA a;
  HullB b;
  Vec3<N> by, apart;
  N reach;
};
template <class HullA, class HullB, class N>
KnownMotion(HullA, HullB, Vec3<N>, Vec3<N>, N) -> KnownMotion<HullA, HullB, N>;

template <class A, class B>
[[gnu::always_inline]] inline auto known_motion(const Moved<double, A, B>& m) {
  const auto coordinates = [](const Vec3<double>& v) { return known<0>(v); };
  return KnownMotion{m.a.made(coordinates), m.b.made(coordinates), known<0>(m.by), known<0>(m.apart),
                     Coordinate<0>{m.reach}};
}

/// The differences b - a of points at the start, along n.
template <class N>
[[gnu::always_inline]] inline auto reaches_along(const Vec3<N>& n, const auto& motion) {
  const auto at = inner(n, motion.apart);
  const auto with_b = [&] {
    if constexpr (std::remove_cvref_t<decltype(motion.b)>::way_count == 0) {
      return Reaches{at, at};
    } else {
      const auto of_b = motion.b.along(n);
      return Reaches{at + of_b.low, at + of_b.high};
    }
  }();
  if constexpr (std::remove_cvref_t<decltype(motion.a)>::way_count == 0) {
    return with_b;
  } else {
    const auto of_a = motion.a.along(n);
    return Reaches{with_b.low - of_a.high, with_b.high - of_a.low};
  }
}

/// Do the shapes stay beyond their reach along n?
template <bool reaches, class W, class N>
[[gnu::always_inline]] inline bool stays_beyond(const W& w, const Vec3<N>& n, const auto& motion) {
  const auto start = reaches_along(n, motion).low;
  if (!w.positive(start)) return false;
  const auto end = start - inner(n, motion.by);
  if (!w.positive(end)) return false;
  if constexpr (reaches) {
    const auto limit = motion.reach * motion.reach * inner(n, n);
    return w.positive(start * start - limit) && w.positive(end * end - limit);
  }
  return true;
}

}  // namespace plumb::query::quick
