// Of which points, balls and disks is a figure the hull, and what holds these?  In rationals.
//
// Laws: exact; the hull of the parts and of what goes on forever is the figure, for a convex one, and its hull for a
// polygon, which has its corners in it.  A cylinder or cone whose ends are one point is a ball.  Touching from inside is
// held.  A part that a similarity has moved has its radius times the root of the squared scale, which need not be rational.
// Cost: GMP.
#pragma once

#include "plumb/query/body/pairs.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

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
bool ball_holds(const Exact3& center, const mpq_class& radius, const RoundPart& part,
                const mpq_class& squared_scale = 1);
/// What is near to a line; of a point or a ball.
bool tube_holds(const Exact3& from, const Exact3& axis, const mpq_class& radius, const RoundPart& part,
                const mpq_class& squared_scale = 1);
/// What is near to a place of which this is the square of the part's distance; of a point or a ball.
bool core_holds(const mpq_class& square, const mpq_class& radius, const RoundPart& part,
                const mpq_class& squared_scale = 1);

/// Throws where the figure is a polygon that is not convex.
void require_convex_outer(const FigureView& outer);

}  // namespace plumb::query
