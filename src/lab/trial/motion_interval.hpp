// Do four moving points meet, in interval arithmetic alone?  Time is halved until intervals tell.
//
// Laws: (1) a yes or a no is true for every finite double; (2) unsure where a number of halvings does not tell, and so
// wherever figures only touch.
// Source: RTCD 5.5.1; Snyder 1992 (interval analysis); Redon, Kheddar and Coquillart 2002.
// Cost: some microseconds for each half.
#pragma once

#include <array>

#include "lab/trial/motion_tests.hpp"
#include "plumb/arith/interval.hpp"

namespace plumb::lab::trial {

template <bool VertexFace>
class IntervalContact {
 public:
  double operator()(const std::array<double, motion_numbers>& q) const {
    int left = most_pieces;
    const Unsure<bool> meets = within(q, 0, 1, left);
    return meets.certain() ? as_answer(meets.value()) : unsure;
  }

 private:
  static constexpr int most_pieces = 32;
  using Points = std::array<Vec<Interval>, 4>;

  static Points at(const std::array<double, motion_numbers>& q, Interval t) {
    Points p{zero, zero, zero, zero};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto coordinate = [&](std::size_t axis) {
        const Interval from(q[3 * i + axis]), to(q[12 + 3 * i + axis]);
        return from + (to - from) * t;
      };
      p[i] = {coordinate(0), coordinate(1), coordinate(2)};
    }
    return p;
  }

  static Unsure<Sign> side(const Points& p) { return dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])).sign(); }

  static bool apart(const Points& p) {
    constexpr std::size_t first = VertexFace ? 1 : 2;  // of the second figure
    const auto along = [&](Interval Vec<Interval>::*axis) {
      Interval a = p[0].*axis, b = p[first].*axis;
      for (std::size_t i = 1; i < 4; ++i) {
        Interval& of = i < first ? a : b;
        of = {std::min(of.lower, (p[i].*axis).lower), std::max(of.upper, (p[i].*axis).upper)};
      }
      return a.upper < b.lower || b.upper < a.lower;
    };
    return along(&Vec<Interval>::x) || along(&Vec<Interval>::y) || along(&Vec<Interval>::z);
  }

  /// Do the projections along the normal certainly meet, in the interior?
  static bool above(const Points& p) {
    const auto all_positive = [](std::initializer_list<Interval> values) {
      return std::ranges::all_of(values, [](const Interval& x) { return x.lower > 0; });
    };
    if constexpr (VertexFace) {
      const Vec<Interval> n = cross(p[2] - p[1], p[3] - p[1]);
      const auto turn = [&](std::size_t i, std::size_t j) { return dot(cross(p[i] - p[0], p[j] - p[0]), n); };
      return all_positive({turn(2, 3), turn(3, 1), turn(1, 2)});
    } else {
      const Vec<Interval> e = p[1] - p[0], f = p[3] - p[2], w = p[2] - p[0], n = cross(e, f);
      const Interval u = dot(cross(w, f), n), v = dot(cross(w, e), n), whole = dot(n, n);
      return all_positive({u, v, whole - u, whole - v});
    }
  }

  static Unsure<bool> within(const std::array<double, motion_numbers>& q, double from, double to, int& left) {
    const Points all = at(q, {from, to});
    const Unsure<Sign> sign = side(all);
    if (apart(all) || (sign.certain() && sign.value() != Sign::zero)) return Unsure(false);
    if (above(all)) {
      const Unsure<Sign> before = side(at(q, Interval(from))), after = side(at(q, Interval(to)));
      if (before.certain() && after.certain() && before.value() * after.value() != Sign::positive) return Unsure(true);
    }
    const double middle = (from + to) / 2;
    if (--left <= 0) return {};
    const Unsure<bool> earlier = within(q, from, middle, left);
    if (earlier.certain() && earlier.value()) return earlier;
    const Unsure<bool> later = within(q, middle, to, left);
    return earlier.certain() || (later.certain() && later.value()) ? later : Unsure<bool>();
  }

  static inline const Vec<Interval> zero{Interval(0), Interval(0), Interval(0)};
};

}  // namespace plumb::lab::trial
