// Separating axis test: do plain doubles prove how a box lies to a triangle, a ball, or to what is straight?
//
// Laws: an answer is that of real arithmetic; what is near to zero but not exactly known, not finite, or too large for
// the products gets none, nor does an empty box.  Touching is told where it is along a face of a solid box with the
// axes of space, and nothing else is near.
// Source: Akenine-Moller 2001; RTCD 5.2.9, 5.3.3.
// Cost: 4 to 20 ns, an axis a lane where the machine has four lanes; twice that elsewhere.
#pragma once

#include <optional>

#include "plumb/figure/basic/round.hpp"
#include "query/overlap/linear3.hpp"

namespace plumb::query {

std::optional<Relation> quick_relation(const Segment3& a, const Aabb3& b);
std::optional<Relation> quick_relation(const Ray3& a, const Aabb3& b);
std::optional<Relation> quick_relation(const Line3& a, const Aabb3& b);
std::optional<Relation> quick_relation(const Triangle3& a, const Aabb3& b);
std::optional<Relation> quick_relation(const Segment3& a, const Obb3& b);
std::optional<Relation> quick_relation(const Ray3& a, const Obb3& b);
std::optional<Relation> quick_relation(const Line3& a, const Obb3& b);
std::optional<Relation> quick_relation(const Triangle3& a, const Obb3& b);
std::optional<Relation> quick_relation(const Sphere3& a, const Obb3& b);
std::optional<Relation> quick_relation(const Segment2& a, const Aabb2& b);
std::optional<Relation> quick_relation(const Triangle2& a, const Aabb2& b);

/// For what that leaves: pairs of doubles, then integers on the stack, then those of GMP.  Nothing is told of a box without
/// an inside that touches, of axes that lie in a plane, and of a direction that is zero.
std::optional<Relation> near_relation(const Segment3& a, const Obb3& b);
std::optional<Relation> near_relation(const Ray3& a, const Obb3& b);
std::optional<Relation> near_relation(const Line3& a, const Obb3& b);
std::optional<Relation> near_relation(const Triangle3& a, const Obb3& b);

}  // namespace plumb::query
