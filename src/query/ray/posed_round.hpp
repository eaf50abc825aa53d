// When does an exact line first come within a radius of a point, a segment or a parallelogram?
//
// The figure is balls about its corners, cylinders about its edges, and what lies between its plates; where a line enters
// one of these through its ends, it is in another already.
// Laws: exact, whatever is flat, equal or parallel.
// Source: RTCD 5.3.2, 5.3.7.
// Cost: GMP; some 10 us a part.
#pragma once

#include <optional>

#include "plumb/certify/ray_parameter.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// All from + t along with t in the span.
struct ExactShot {
  Exact3 from, along;
  std::optional<mpq_class> least, most;
};

/// Which part of the surface of a ball or a capsule is met at t, and the way to there from the center or the axis: still +
/// t moving.  The part is 0 of a ball, and of a capsule the side, 1 and 2 about its ends; none where t is inside.
struct RoundMeeting {
  std::optional<std::uint32_t> part;
  Exact3 still, moving;
};
RoundMeeting round_meeting(const ExactShot& shot, const FlatSet& core, const mpq_class& radius, const RayParameter& t);

/// base + share * root of t's square, of the sign that t has: rounded once.
double rounded_at(const mpq_class& base, const mpq_class& share, const RayParameter& t);

/// The core has one, two or four points: of a parallelogram the corner, those beside it, the opposite one.  The radius is
/// above zero.
std::optional<RayParameter> first_in_fat(const ExactShot& shot, const FlatSet& core, const mpq_class& radius);

}  // namespace plumb::query
