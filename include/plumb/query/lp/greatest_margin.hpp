// Support vector machine, hard margin: which slab without points parts two sets of points, and is as thick as can be?
//
//   if (const auto m = greatest_margin(first, second)) {
//     m->direction;                 // across the slab, exactly
//     m->first_end; m->second_end;  // dot products with it: at most this of one set, at least that of the other
//     m->square;                    // of the slab's thickness
//   }
//
// The slab lies between the nearest points of the two convex hulls.
// Laws: (1) exact, of any points: repeated, collinear, single ones.  (2) Nothing where the hulls meet, if only in a
// point.
// (3) The direction is the way from the hull of the first to that of the second; its square is that of the thickness.
// (4) Supporting points have weights above zero that add up to one; with them they are the nearest points of the hulls.
// At most four pairs of points are needed; which ones depends on the order where there are several.  (5) verify(first,
// second, m) is true (query/lp/verify.hpp).
// No points throw InvalidShape, NaN and infinity NonFinite, both by name.
// Source: Wolfe 1976; Vapnik 1982; RTCD 9.4.2.
// Cost: integers of GMP; some 10 us and linear in the points.  Bounded by n^2 signs as a rule, on integers as long as
// the exponents' span; ends whatever the points are, for no simplex comes twice.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "plumb/arith/point.hpp"
#include "plumb/query/lp/linear_proof.hpp"

namespace plumb {

/// A point of a set by its number, and how much of the hull's nearest point it is.
struct SupportingPoint {
  std::size_t point;
  Rational weight;
  friend bool operator==(const SupportingPoint&, const SupportingPoint&) = default;
};

struct GreatestMargin3 {
  std::array<Rational, 3> direction;
  Rational square;
  double margin = 0;               // the nearest double of its root
  Rational first_end, second_end;  // of dot products with the direction
  std::vector<SupportingPoint> of_first, of_second;
};

std::optional<GreatestMargin3> greatest_margin(std::span<const Point3> first, std::span<const Point3> second);

}  // namespace plumb
