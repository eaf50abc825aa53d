// Of which points, balls and disks is a figure the hull, and what holds these?  In rationals.
//
// Laws: exact; the hull of the parts and of what goes on forever is the figure, for a convex one, and its hull for a
// polygon, which has its corners in it.  A cylinder or cone whose ends are one point is a ball.  Touching from inside is
// held.  A part that a similarity has moved has its radius times the root of the squared scale, which need not be rational.
// Cost: GMP.
#pragma once

#include <optional>
#include <vector>

#include "plumb/query/body/pairs.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// Of space; what is of the plane lies in z = 0.
template <class Numbers>
Exact3 exact3(const Numbers& p) {
  Exact3 x{mpq_class(p.x), mpq_class(p.y), 0};
  if constexpr (requires { p.z; }) x[2] = p.z;
  return x;
}

struct RoundPart {
  Exact3 at;
  mpq_class radius;
  bool is_disk;  // across the axis, which is not zero then
  Exact3 axis;
};

struct RoundParts {
  std::vector<RoundPart> parts;  // none: nothing
  std::vector<Exact3> directions, lines;
};

RoundParts round_parts(const FigureView& v);

/// The square of the distance from p to the points corner + s e + t f, 0 <= s, t <= 1.
mpq_class squared_distance(const Exact3& p, const Exact3& corner, const Exact3& e, const Exact3& f);

/// All parts, and what goes on forever?
bool halfspace_holds(const ExactHalfspace& h, const RoundParts& inner);
/// All that is near to the points at + s along + t second, 0 <= s, t <= 1; with ends only what lies between the planes
/// across `along` at its ends.
struct RoundBody {
  Exact3 at, along, second;
  mpq_class radius;
  bool has_ends;
};

/// Of a ball, a capsule, a lozenge or a cylinder, without its pose; none of another kind.
std::optional<RoundBody> round_body(const FigureView& v);

/// Does this hold of the halfspaces that its ends bound?  The second is made where it holds of the first.
template <class Holds>
bool all_ends(const RoundBody& round, const Holds& holds) {
  if (!round.has_ends) return true;
  const auto of_end = [&](const Exact3& outward, const Exact3& at) {
    return holds(ExactHalfspace{outward, dot(outward, at)});
  };
  return of_end(round.along, round.at + round.along) && of_end(mpq_class(-1) * round.along, round.at);
}

/// As far as the ends do not matter; a point or a ball, in a ball a disk too.
bool holds_near_core(const RoundBody& round, const RoundPart& part, const mpq_class& squared_scale = 1);

/// Throws where the figure is a polygon that is not convex.
void require_convex_outer(const FigureView& outer);

}  // namespace plumb::query
