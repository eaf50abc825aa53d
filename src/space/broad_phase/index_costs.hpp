// What do the methods of the broad phase cost, by what a sample of the boxes counts?
//
// A guess throughout: nothing is decided by it but what is tried first.
// Source: RTCD 7.1.1.
// Cost: a product for each number of a method.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"

namespace plumb::space {

/// What costs are sums of, each for one box.
enum class CountedThing : unsigned char {
  once,           // 1
  doublings,      // the logarithm of how many boxes there are, to base 2
  boxes,          // how many there are, in thousands
  copies,         // cells that it reaches into, of a grid whose size is chosen
  mates,          // boxes in one cell with it, counted in each
  pairs,          // boxes that overlap it and come after it
  windows,        // boxes that overlap it along the axis of greatest variance and come after it
  swept_copies,   // columns that it reaches into
  swept_windows,  // boxes that it is compared with in columns
  moved,          // the share of boxes that move
  moved_windows,  // swept_windows of these
};
inline constexpr std::size_t counted_things = 11;
using Counts = std::array<double, counted_things>;

struct MethodCosts {
  BroadPhaseMethod method;
  bool is_kept;
  Counts nanoseconds;
};

/// Those of every method but the structures of space/textbook, which are never the fastest; where it is there twice, what it takes is the lesser.
std::span<const MethodCosts> method_costs();

/// Nanoseconds for each box.
double predicted_cost(const MethodCosts& costs, const Counts& counts);

}  // namespace plumb::space
