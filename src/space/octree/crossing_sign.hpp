// Which of two planes that are square to axes does a straight way cross first?  A statement over any world.
//
// Laws: those of certify/world.hpp.  The parameters at which x = c and y = d are crossed are (c - o) / f and
// (d - p) / e: times the signs of f and e the sign is that of the first less the second.
// Source: RTCD 5.3.3, 7.4.1.
// Cost: two products of differences; where exponents are far apart some ten times that.
#pragma once

#include "certify/carried_errors.hpp"

namespace plumb::space {

/// The sign of (c - o) e - (d - p) f, where o and p are the origin's coordinates along two axes, f and e the
/// directions'.
template <bool is_segment>
struct CrossingOrder {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2};

  template <class W>
  Sign operator()(W& w, double c, double o, double f, double d, double p, double e) const {
    const auto along = [&](double to, double from) {
      if constexpr (is_segment) {
        return w.template difference<1>(to, from);
      } else {
        return w.template number<1>(to);
      }
    };
    return w.compare(w.difference(c, o) * along(e, p), w.difference(d, p) * along(f, o));
  }
};

/// The same, of borders and ways whose exponents may be far apart.
inline Sign crossing_order(bool is_segment, double c, double o, double f, double d, double p, double e) {
  const auto ask = [&]<class Statement>(const Statement& statement) {
    return certainly<SpreadWorlds<Statement>>(statement, c, o, f, d, p, e);
  };
  return is_segment ? ask(CrossingOrder<true>{}) : ask(CrossingOrder<false>{});
}

}  // namespace plumb::space
