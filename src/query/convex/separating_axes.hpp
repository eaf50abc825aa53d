// Separating axis test (SAT): does a plane part two small figures, and do they touch along it?  The separating-axis
// test for convex pairs, general.
//
// The difference of two convex sets contains the origin where they meet, and its faces are spanned by edges of the two:
// two of one face, or one of each.  So they are disjoint where a cross product of such edges has all of one beyond all
// of the other, and touch where one has them level and none has them apart.
// Laws: (1) what is answered is the relation of real arithmetic.  (2) Nothing is answered where the difference is flat:
// segments in one plane, a triangle and a segment in its plane.  (3) Infinite figures are apart only along axes along
// which they do not go on.
// Method: each axis over doubles with a running bound of their errors, that axis alone in integers where they leave a
// doubt.
// Source: RTCD 5.2.1, 5.2.1.1.
// Cost: about a microsecond, some 100 ns where the first axes separate; some microseconds for each axis that is left to
// integers.
#pragma once

#include <optional>

#include "plumb/query/body/posed.hpp"
#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// Has it the points and edges that the test needs?
bool has_axes(const FlatView& v);

/// Posed or not.
std::optional<Relation> relate_by_axes(const PosedView& a, const PosedView& b);

}  // namespace plumb::query
