// What does a sweep lose?  The segments, and the crossings of pairs that were lost.
//
// Source: none.
// Cost: a millisecond.
#pragma once

#include <span>
#include <string>

#include "lab/stability/sweep.hpp"
#include "plumb/figure/basic/linear.hpp"

namespace plumb::lab::stability {

/// Each lost pair is marked where its segments meet, or where they begin to.
std::string sweep_picture(const std::string& title, const std::string& subtitle, std::span<const Segment2> segments,
                          const Pairs& lost);

}  // namespace plumb::lab::stability
