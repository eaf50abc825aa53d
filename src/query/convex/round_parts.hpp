// Of which points, balls and disks is a figure the hull?  In rationals.
//
// Laws: exact; the hull of the parts and of what goes on forever is the figure, for a convex one, and its hull for a
// polygon, which has its corners in it.  A cylinder or cone whose ends are one point is a ball.
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

}  // namespace plumb::query
