// Time of impact: when do a polygon in space, convex or not, and a body or another polygon first meet that move along
// lines?
//
// Laws: those of query/time_of_impact/posed.hpp.  What relate does not find disjoint at the start meets at time 0, by
// features of the boundary where two meet there, else by an edge of the polygon that goes through a face, or by a vertex of it inside.
// Source: RTCD 5.5.6.
// Cost: that of a segment and the body for each edge; rationals for the inside.
#pragma once

#include <optional>
#include <string_view>

#include "plumb/query/time_of_impact/posed.hpp"
#include "query/time_of_impact/body_meeting.hpp"

namespace plumb::query {

/// Of figures whose numbers and poses have been looked at, one of which is a polygon.
std::optional<Root> polygon_meeting_time(std::string_view function, const PosedMotion& a, const PosedMotion& b);
std::optional<FirstMeeting> polygon_meeting(std::string_view function, const PosedMotion& a, const PosedMotion& b);

}  // namespace plumb::query
