// Ray cast against a Minkowski difference with a radius: when does the origin, moving straight, leave a body that is
// round?
//
// What is within r of the difference is left for good at a place that is r away from one of its vertices, edges or
// faces: the larger root of a quadratic polynomial.  Corners of a few features are kept, as GJK keeps them; the exit
// from these alone is followed by a look along the way to their nearest point, and a corner of the difference that lies
// before the plane there leads to a later one.
// Laws: (1) the exit that is told is proved by signs over numbers a + b sqrt(c): the nearest point lies within its
// corners, all others behind the plane.  (2) It ends: every turn leaves later, and there are finitely many features.
// A guess in doubles comes first, and nothing rests on it.
// Source: van den Bergen 2004, "Ray casting against general convex objects with application to continuous collision
// detection"; RTCD 5.3.
// Cost: one turn where the guess is right, some 20 us; a turn each where it is not.
#pragma once

#include <memory>

#include "certify/quadratic_number.hpp"
#include "query/penetration/difference.hpp"

namespace plumb::query::parting {

/// Of t: (before + sqrt(radicand)) / whole, whole above zero.
template <class T>
struct ExitTime {
  T before, radicand, whole;
};

struct NormalAtExit {
  Vec<certify::QuadraticNumber> of;  // of any length; refers to the time
};

struct RoundExit {
  DifferenceCorners corners;  // that the place is nearest to; their number is the dimension of the feature and one more
  std::shared_ptr<const ExitTime<BigDyadic>> time;
  NormalAtExit normal;  // outward
};

/// The exit of the origin that moves against a direction, or of the difference that moves along it.  The origin is now
/// strictly within the radius of the hull of `around`; the radius is above zero.
RoundExit round_exit(const Difference& d, const Vector3& direction, const mpq_class& radius,
                     const DifferenceCorners& around);

/// Along such a normal (query/penetration/furthest.hpp).
inline Sign further(const CoreCorners& c, const NormalAtExit& normal, Sign way, std::uint32_t i, std::uint32_t from) {
  using T = certify::QuadraticNumber;
  return way * dot(normal.of, c.at<T>(i) - c.at<T>(from)).sign();
}
inline Sign further_by_way(const CoreCorners& c, const NormalAtExit& normal, Sign way, std::size_t k) {
  return way * dot(normal.of, c.way<certify::QuadraticNumber>(k)).sign();
}

}  // namespace plumb::query::parting
