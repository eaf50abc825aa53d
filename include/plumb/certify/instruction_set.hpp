// Which vectors do batches take here, and how does one force others?
//
//   PLUMB_INSTRUCTION_SET=avx2 ./program       avx512, avx2, ssse3, neon, or none: one case after the other
//                                              (signs_of: by what every processor of the kind has)
//
// For tests, measurements and reports of bugs.  What forces is the environment variable alone, read once, before the
// first batch; the answers of a single pair that come from four lanes follow it too.
// Laws: no answer depends on it.  A name that is none, or of a set that this processor has not, throws Error at the
// first batch, and at batch_instruction_set(): it lists those there are.
// Source: RTCD 13.7; docs/batches.md.
// Cost: none.
// These functions are in the library plumb::batch.
#pragma once

#include <string_view>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// Those that batches are compiled for and this processor has, the best first; the last is "none".
std::vector<std::string_view> batch_instruction_sets();

/// The one that batches take.
std::string_view batch_instruction_set();

}  // namespace plumb
