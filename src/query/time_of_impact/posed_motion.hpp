// Continuous collision detection: when do posed points meet first, that move linearly from one pose's image to another's?
// Vertex against triangle, edge against edge.
//
// Laws: those of query/time_of_impact/continuous_contact.hpp, of the exact images: the poses may differ, be singular,
// and lead beyond the largest double.
// Source: RTCD 3.2, 5.5.
// Cost: some 300 ns where images, rounded, stay farther apart than rounding moves them; tens of microseconds else, ten
// times as many with a separation.
#pragma once

#include <optional>

#include "plumb/arith/pose.hpp"
#include "query/time_of_impact/contact_filter.hpp"
#include "query/time_of_impact/exact_contact.hpp"

namespace plumb::query::moving {

/// at_0 under one pose, at_1 under another.
struct PosedQuestion {
  ContactQuestion given;
  Pose pose_0, pose_1;
};

/// Of finite numbers, the separation not negative.
std::optional<TimedContact> posed_first_contact(const PosedQuestion& question, double separation);

}  // namespace plumb::query::moving
