// GJK: do two hulls meet, and how, as far as doubles and signs at few corners tell it?
//
// Laws: what is told is so.  `meet` is told where they may touch or overlap, by corners that hold the origin; `unsure`
// leaves the best corners found in `found`, from which exact numbers go on.  Of bodies with a radius all is told but where a
// number is none.  Of a polyhedron the numbers are what convex_polyhedron made, and are not looked through where doubles
// decide.
// Source: query/gjk/quick_meeting.hpp; of what touches or all but touches query/gjk/quick_nearest.hpp.
// Cost: 20 to 50 ns a corner; some 200 to 500 ns more where doubles do not tell; no allocation.
#pragma once

#include "query/gjk/quick_meeting.hpp"

namespace plumb::query {

enum class MetAtOnce : unsigned char { unsure, apart, touch, meet, overlap };

MetAtOnce met_at_once(const QuickBody& a, const QuickBody& b, GjkCache& found);

}  // namespace plumb::query
