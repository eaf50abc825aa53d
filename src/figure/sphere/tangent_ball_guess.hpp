// Minimum enclosing ball of balls: which balls does the smallest ball around all touch, as far as plain doubles tell?
// A guess: its exact proof is not here.
//
// Method: the farthest ball is taken in again and again, and of the old ones those that the smallest ball of them
// needs.
// Laws: none; the answer names some of the balls.
// Source: Fischer and Gaertner 2003; RTCD 4.3.4.
// Cost: ten to thirty passes over the balls, 1 to 2 ns a ball each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/round.hpp"

namespace plumb::figure::sphere {

/// At least one of the balls, of which there is one.
std::vector<std::uint32_t> guess_touched(std::span<const Circle2> balls);
std::vector<std::uint32_t> guess_touched(std::span<const Sphere3> balls);

}  // namespace plumb::figure::sphere
