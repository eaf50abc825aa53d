// Broad phase: what is told of boxes of which two overlap, and what is asked of them?
//
// Laws: every method of the broad phase (grids, trees, sort and sweep) tells the same pairs: those of two different
// boxes whose relate is not disjoint, or, where touching is left out, is overlapping; each once, a < b within one set.
// Their order depends on the boxes and on the method, not on the number of threads.
// Source: RTCD 2.4.1.
// Cost: none.
#pragma once

#include <compare>
#include <cstdint>

#include "plumb/certify/batch.hpp"

namespace plumb {

/// The numbers of two boxes; of two sets, a in the first and b in the second.
struct BoxPair {
  std::uint32_t a, b;
  friend auto operator<=>(const BoxPair&, const BoxPair&) = default;
};

/// Names one box of an index that boxes come to and go from, for ever: its slot is used again with another generation.
struct BoxHandle {
  std::uint32_t slot = 0xffffffff, generation = 0;
  friend auto operator<=>(const BoxHandle&, const BoxHandle&) = default;
};

/// a.slot < b.slot.
struct HandlePair {
  BoxHandle a, b;
  friend auto operator<=>(const HandlePair&, const HandlePair&) = default;
};

struct BoxPairOptions {
  bool touching = true;  // false: only the pairs that overlap
  Execution execution = Execution::parallel;
};

/// Of in_box, where indexes are asked for what has a point in a box.
struct InBoxOptions {
  bool touching = true;  // false: only what overlaps the box, a point taken as the box from it to itself
};

}  // namespace plumb
