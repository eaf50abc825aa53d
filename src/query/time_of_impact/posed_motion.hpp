// Continuous collision detection: when do posed points meet first, that move linearly from one pose's image to another's?
// Vertex against triangle, edge against edge.
//
// Laws: those of query/time_of_impact/continuous_contact.hpp, of the exact images: the poses may differ from time to time
// and from figure to figure, be singular, and lead beyond the largest double.
// Source: RTCD 3.2, 5.5.
// Cost: some 300 ns where images, rounded, stay farther apart than rounding moves them; tens of microseconds else, ten
// times as many with a separation.
#pragma once

#include <optional>

#include "plumb/figure/basic/pose_view.hpp"
#include "query/time_of_impact/contact_filter.hpp"
#include "query/time_of_impact/exact_contact.hpp"

namespace plumb::query::moving {

/// Each figure at each end of the motion under a pose of space, or as given.
struct PosedQuestion {
  ContactQuestion given;
  std::array<AnyPoseView, 2> of_a, of_b;

  [[nodiscard]] const AnyPoseView& pose(std::size_t point, std::size_t end) const {
    return point < (given.kind == MovingKind::edge_edge ? 2U : 1U) ? of_a[end] : of_b[end];
  }
  [[nodiscard]] const Point3& place(std::size_t point, std::size_t end) const {
    return (end == 0 ? given.at_0 : given.at_1)[point];
  }
};

/// Of finite numbers, the separation not negative.
std::optional<TimedContact> posed_first_contact(const PosedQuestion& question, double separation);

}  // namespace plumb::query::moving
