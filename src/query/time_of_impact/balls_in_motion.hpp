// Two balls in straight motion: what is the quadratic of time that is not positive where they meet?
//
// A statement over a world: c + 2 h t + e t^2, its value and half its slope at time 1, a quarter of its discriminant.
// Law: of floats all are as near to those of the exact numbers as their types say; the distance and the motion are of
// scale 0, the motion is of scale 1 as well.
// Source: RTCD 5.5.5.
// Cost: three dot products, and one more.
#pragma once

#include "plumb/certify/certainly.hpp"
#include "query/time_of_impact/quick_hull.hpp"

namespace plumb::query::quick {

template <class Listener = NoBoundListener>
using BallsWorld = certify::one_lane::Floats<double, 4, Scales{.count = 2}, Listener>;

template <class C, class H, class E, class V, class S, class D>
struct BallsInMotion {
  C c;
  H h;
  E e;
  V value_at_end;
  S slope_at_end;
  D discriminant;
};
template <class C, class H, class E, class V, class S, class D>
BallsInMotion(C, H, E, V, S, D) -> BallsInMotion<C, H, E, V, S, D>;

template <class W>
[[gnu::always_inline]] inline auto balls_in_motion(W& w, const Point3& a, const Point3& b, double of_a, double of_b,
                                                   const Vector3& by_a, const Vector3& by_b) {
  const auto from = [&]<std::size_t scale>(const auto& p, const auto& q) {
    using N = decltype(w.template difference<scale>(0.0, 0.0));
    return Vec3<N>{w.template difference<scale>(p.x, q.x), w.template difference<scale>(p.y, q.y),
                   w.template difference<scale>(p.z, q.z)};
  };
  const auto d = from.template operator()<0>(a, b), v = from.template operator()<0>(by_a, by_b);
  const auto way = from.template operator()<1>(by_a, by_b);
  const auto reach = w.template number<0>(of_a) + w.template number<0>(of_b);
  const auto c = inner(d, d) - reach * reach;
  const auto slope_at_end = inner(d, v) + inner(v, v);
  const auto h = inner(d, way);
  const auto e = inner(way, way);
  return BallsInMotion{c, h, e, (c + inner(d, v)) + slope_at_end, slope_at_end, h * h - e * c};
}

}  // namespace plumb::query::quick
