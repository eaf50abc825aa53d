// Conservative advancement, interval halving: when can two figures first meet, if all that is known is how far apart
// they are and how fast that can change?
//
//   struct Door { double distance_at(double t) const; double speed_between(double from, double to) const; };
//   first_contact_span(Door{})   // a span of 2^-20 in which they may meet, and never before it
//
// For motions that have no formula of their own: turning, bending, driven by anything.  A motion has
//   distance_at(t): no more than the distance at time t, 0 <= t <= 1
//   speed_between(from, to): no less than how fast the distance falls or rises anywhere between the two times
// Laws: (1) nothing means that they never meet in [0, 1], and a span that they do not meet before it: as certain as
// what the motion says, for no rounding of the computation here can hide a contact.  (2) The span is no longer than the
// resolution; that they do meet in it is not said.  (3) Its ends are multiples of a power of two.
// A distance or speed that is NaN or negative says nothing; a resolution that is not positive throws Error.
// Source: RTCD 5.5.1.
// Cost: two halves for each span that cannot be told apart; what the motion costs.  Bounded by a fixed number of calls
// of the motion, 2 / resolution of each, and by 50 levels.
#pragma once

#include <optional>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"

namespace plumb {

/// From one time to another, both included.
struct TimeSpan {
  double from, to;
  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

struct HalvingOptions {
  double resolution = 0x1p-20;               // of time, a guess of what pays; below 2^-50 it is taken for that
  std::vector<TimeSpan>* history = nullptr;  // every span that was looked at, in turn
};

namespace query {

/// No contact from one time to the other: what is left at both ends is more than can be covered on the way.  A contact
/// at time t would need d0 <= s (t - t0) and d1 <= s (t1 - t).
inline bool stays_apart(const TimeSpan& span, double distance_from, double distance_to, double speed) {
  if (!(distance_from > 0 && distance_to > 0 && speed >= 0)) return false;
  const Interval way = Interval(speed) * (Interval(span.to) - Interval(span.from));
  return (Interval(distance_from) + Interval(distance_to)).lower > way.upper;
}

/// Ends, for no span is halved more than 50 times; where short ones tell what long ones do not, all of them are asked.
template <class Motion>
std::optional<TimeSpan> first_span(const Motion& motion, const HalvingOptions& options, const TimeSpan& span,
                                   double distance_from, double distance_to) {
  if (options.history != nullptr) options.history->push_back(span);
  if (stays_apart(span, distance_from, distance_to, motion.speed_between(span.from, span.to))) return {};
  const double length = span.to - span.from, middle = span.from + length / 2;  // exact: multiples of 2^-51
  constexpr double finest = 0x1p-50;  // a guess of what pays: a span is told as it is
  if (length <= options.resolution || length <= finest) return span;
  const double distance_middle = motion.distance_at(middle);
  const auto first = first_span(motion, options, {span.from, middle}, distance_from, distance_middle);
  return first ? first : first_span(motion, options, {middle, span.to}, distance_middle, distance_to);
}

}  // namespace query

/// The first span of time in which the two may meet; nothing where they never do.
template <class Motion>
std::optional<TimeSpan> first_contact_span(const Motion& motion, const HalvingOptions& options = {}) {
  if (!(options.resolution > 0)) throw Error("first_contact_span: the resolution must be above zero");
  return query::first_span(motion, options, {0, 1}, motion.distance_at(0), motion.distance_at(1));
}

}  // namespace plumb
