// GJK: between which corners of two hulls is the least way, as far as doubles prove it, and how long is it?
//
// Laws: what is told is so; what is not told is left to query/separation/exact_corners.hpp.  Every number is the
// nearest double of the exact one (Ziv's test).  Of hulls of points of doubles as given (QuickHull::is_given).  The
// nearest pair is the only one where `is_alone`.  Doubles are asked first, then numbers of just the width that certify
// needs: what all but touches, has level faces or touches costs a few times as much.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5; Ziv 1991.
// Cost: some 60 ns a corner for the search, 100 for the proof, 150 for the distance; no allocation.
#pragma once

#include <optional>

#include "plumb/query/gjk/gjk.hpp"
#include "query/gjk/quick_hull.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query {

struct QuickNearest {
  ProvedCorners proved;
  NamedCorners of_a, of_b;  // where they do not meet
  arith::Plain way;         // from b to a, about
  std::uint32_t steps;
};

/// Of hulls as given: is the nearest point that of some of these corners?  For certain, by all of them or fewer; nothing
/// where none of them are, or where a number is none.
std::optional<QuickNearest> certainly_proved(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners);

/// Of hulls as given: has a plane that three such corners span, which hold the origin, either hull on a side of its own?
bool are_parted(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners);
/// The search from these corners on, in double-doubles: of what all but touches.
std::optional<QuickNearest> finely_nearest(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners);

/// From the corners of a cache, where there is one: a guess, and may be any.
std::optional<QuickNearest> quickly_nearest(const QuickHull& a, const QuickHull& b, const GjkCache* cache);

/// Of hulls that do not meet, by corners that are proved.
std::optional<double> quick_distance(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners);
/// Of hulls that meet, by corners that hold the origin: a point that they have in common.
std::optional<Closest> quick_common(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners);
/// Both points and the distance; no features.
std::optional<Closest> quick_points(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners);

}  // namespace plumb::query
