// Quadric against line: does a line, a ray or a segment pass by a cylinder, or begin or end in it?  As far as doubles tell.
//
// With m the way from one end of the axis to where the line begins, n its direction and d the axis, the line's distance
// from that of the axis is m . (d x n) / |d x n|.
// Over any world that tells signs for certain or not (certify/world.hpp).
// Laws: disjoint and overlapping are so, of a radius that is not negative; all else is left open: what touches, what
// passes through an end alone or by a rim, an axis or a line that is a point.
// Source: RTCD 5.3.7.
// Cost: 25 operations for what lies beyond an end of the axis, 50 for what lies off it, and their bounds.
#pragma once

#include "plumb/certify/certainly.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb::query {

/// Of a line, or what begins, and ends.
template <bool begins, bool ends>
struct PastCylinder {
  static constexpr Scales scales{.count = 2, .squares = 0b11};  // all from the axis; the direction
  static constexpr int highest = 8;

  template <class W>
  [[gnu::always_inline]] Relation operator()(W& w, const Point3& start, const auto& to, const Cylinder3& c) const {
    using predicates::cross, predicates::dot, predicates::Triple;
    const auto from_axis = [&](const auto& p) {
      return Triple{w.difference(p.x, c.a.x), w.difference(p.y, c.a.y), w.difference(p.z, c.a.z)};
    };
    const auto d = from_axis(c.b);
    const auto m = from_axis(start);
    const auto radius = w.number(c.radius);
    const auto top = dot(d, d);
    const auto height = dot(m, d);
    const auto stop = [&] {
      if constexpr (ends) {
        return from_axis(to);
      } else {
        return m;
      }
    }();
    const auto last = [&] {
      if constexpr (ends) {
        return dot(stop, d);
      } else {
        return height;
      }
    }();
    if constexpr (ends) {
      const auto below = negated(larger(height, last));
      const auto above = smaller(height, last) - top;
      if (w.positive(larger(below, above))) return Relation::disjoint;
    }
    const auto n = [&] {
      if constexpr (ends) {
        return Triple{w.template difference<1>(to.x, start.x), w.template difference<1>(to.y, start.y),
                      w.template difference<1>(to.z, start.z)};
      } else {
        return Triple{w.template number<1>(to.x), w.template number<1>(to.y), w.template number<1>(to.z)};
      }
    }();
    if constexpr (begins && !ends) {
      const auto rise = dot(n, d);
      const bool is_below = w.negative(height), falls = w.negative(rise);
      const bool is_above = w.positive(height - top), rises = w.positive(rise);
      if ((is_below & falls) | (is_above & rises)) return Relation::disjoint;
    }
    const auto turn = cross(d, n);
    const auto reach_of = radius * radius;
    const auto gap = dot(m, turn);
    const auto steep = dot(turn, turn);
    const auto beside = gap * gap - steep * reach_of;
    if (w.positive(beside)) return Relation::disjoint;

    // A point outside, from which it leads away; or one that is inside.
    const auto off = cross(d, m);
    const auto widens = dot(off, turn);
    bool narrows = w.negative(beside);  // to its nearest point, which lies inside of the surface
    if constexpr (begins) {
      const auto limit = reach_of * top;
      const auto told = [&](const auto& outside, const auto& up, bool leads_away) {
        const bool is_outside = w.positive(outside), is_inside = w.negative(outside);
        const bool is_above = w.positive(up), is_below = w.negative(up - top);
        if (is_outside & leads_away) return Relation::disjoint;
        return (is_inside & is_above & is_below) ? Relation::overlapping : Relation::touching;
      };
      if (const Relation r = told(dot(off, off) - limit, height, w.positive(widens)); r != Relation::touching) return r;
      narrows = narrows & w.negative(widens);
      if constexpr (ends) {
        const auto off_end = cross(d, stop);
        const auto widens_end = dot(off_end, turn);
        const Relation r = told(dot(off_end, off_end) - limit, last, w.negative(widens_end));
        if (r != Relation::touching) return r;
        narrows = narrows & w.positive(widens_end);
      }
    }
    const auto up = height * steep - dot(n, d) * widens;
    const bool is_above = w.positive(up), is_below = w.negative(up - top * steep);
    if (narrows & is_above & is_below) return Relation::overlapping;
    w.leave_open();
    return Relation::touching;
  }
};

}  // namespace plumb::query
