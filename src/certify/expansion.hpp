// What is the largest term of a formula's expansion in infinitesimals?
//
// Laws: exact, for any formula and any finite coordinates.  Coordinate moved[0] is moved by the largest infinitesimal,
// moved[1] by the next, and so on; coordinates that are not named stay where they are.
// Cost: 0.2 to 2 us for one or two infinitesimals, tens of microseconds for ten.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/certify/perturbed.hpp"

namespace plumb::certify::perturbation {

/// No term at all: the sign is zero.
struct LargestTerm {
  Sign sign = Sign::zero;  // of its coefficient
  int last_power = 0;      // how often it holds the last infinitesimal
  bool simple = false;     // it holds every infinitesimal, each once
};

/// One coordinate is moved at the least.
LargestTerm largest_term(certify::tape::Program program, bool homogeneous, std::span<const double> coordinates,
                         std::span<const std::uint16_t> moved);

}  // namespace plumb::certify::perturbation
