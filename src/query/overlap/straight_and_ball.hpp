// How does a ball lie to a line, a ray or a segment?  By the discriminant of both, and from where its center is seen.
//
// Over any world (certify/world.hpp).  A direction that is zero makes a line the point that it starts from.
// Laws: exact where the world is; for a radius of zero what is touched is the center.
// Source: RTCD 5.3.2, 5.2.7.
// Cost: that of the plain operations, and a product or two for each sign.
#pragma once

#include "plumb/certify/certainly.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/predicates/cross.hpp"
#include "query/overlap/signs.hpp"

namespace plumb::query {

/// How does a ball, of a radius that is not negative, lie to the points o + t d?  With t from 0 where they begin; up to
/// 1 where they end, and d is end - o there.
template <bool begins, bool ends>
struct StraightAndBall {
  static constexpr Scales scales{.count = 2, .squares = 0b11};
  static constexpr int highest = 4;

  template <class W>
  Relation operator()(W& w, const Point3& o, const auto& to, const Sphere3& ball) const {
    const auto from_center = [&](const Point3& p) {
      return predicates::Triple{w.difference(p.x, ball.center.x), w.difference(p.y, ball.center.y),
                                w.difference(p.z, ball.center.z)};
    };
    const auto start = from_center(o);
    const auto d = [&] {
      if constexpr (ends) {
        return predicates::Triple{w.template difference<1>(to.x, o.x), w.template difference<1>(to.y, o.y),
                                  w.template difference<1>(to.z, o.z)};
      } else {
        return predicates::Triple{w.template number<1>(to.x), w.template number<1>(to.y), w.template number<1>(to.z)};
      }
    }();
    const auto radius = w.number(ball.radius);
    const auto reach = radius * radius;
    const auto beyond = predicates::dot(start, start) - reach;
    const auto along = predicates::dot(start, d);
    const auto length = predicates::dot(d, d);
    const auto crossed = along * along - length * beyond;
    if (w.negative(crossed)) return Relation::disjoint;
    const auto as_point = [](Sign s) { return static_cast<Relation>(-s); };
    if constexpr (begins) {
      const Sign from = w.sign(beyond);
      if (from == Sign::negative) return Relation::overlapping;
      if (w.sign(along) != Sign::negative) return as_point(from);  // it leads away
      if constexpr (ends) {
        const auto stop = from_center(to);
        const Sign at_end = w.sign(predicates::dot(stop, stop) - reach);
        if (at_end == Sign::negative) return Relation::overlapping;
        if (w.sign(predicates::dot(stop, d)) != Sign::positive) return as_point(at_end);
      }
    }
    const Sign passes = w.sign(crossed);
    if constexpr (!begins) {
      if (passes == Sign::zero && w.sign(length) == Sign::zero) return as_point(w.sign(beyond));
    }
    return relation(passes);
  }
};

}  // namespace plumb::query
