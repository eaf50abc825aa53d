// Which method of the broad phase does BroadPhaseMethod::automatic take?
//
// Law: it depends on the number of boxes alone.
// Source: docs/broad_phase.md, as measured.
// Cost: none.
#pragma once

#include <cstddef>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"

namespace plumb::space {

/// For so many boxes, of both sets where there are two.
constexpr BroadPhaseMethod automatic_method(std::size_t boxes) {
  constexpr std::size_t few_boxes = 48;  // of which each pair is compared
  return boxes <= few_boxes ? BroadPhaseMethod::brute_force : BroadPhaseMethod::swept_columns;
}

}  // namespace plumb::space
