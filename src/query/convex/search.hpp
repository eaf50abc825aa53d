// GJK: do two convex figures meet, and where do they come closest, as far as the one search of convex pairs tells it?
//
// Laws: an answer is that of real arithmetic, rounded once.  A polyhedron is one that convex_polyhedron made, whose numbers
// are not looked through.  No answer where another number is none, of polygons, of what goes on but for lines and rays
// beside a polyhedron where neither has a pose, and of what is round under a pose that is not rigid; none about how bodies
// lie that share a plane and more, and of closest points where there are several pairs.
// src/query/gjk/ answers: rooms after this one hold the search, for it takes poses and points alone as well.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5, 9.5.4, 5.2.1.
// Cost: docs/convex.md.
#pragma once

#include <optional>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/body/posed.hpp"
#include "plumb/query/closest/result.hpp"
#include "plumb/query/closest/which_pair.hpp"

namespace plumb::query {

std::optional<Relation> relate_by_search(const PosedView& a, const PosedView& b);
std::optional<bool> meet_by_search(const PosedView& a, const PosedView& b);
std::optional<double> distance_by_search(const PosedView& a, const PosedView& b);
/// Of those that are apart the first pair; `common`: which point of those that meet.
std::optional<Closest> closest_by_search(const PosedView& a, const PosedView& b, WhichPair common);

}  // namespace plumb::query
