// How do tests and benchmarks go through all instruction sets in one run?
//
// Changes what all batches take from now on, of a process in which nothing else runs: everyone else sets the
// environment (plumb/certify/instruction_set.hpp).
#pragma once

#include <string_view>

namespace plumb::certify::batch {

/// One of batch_instruction_sets(); empty: as the environment says.
void take_instruction_set(std::string_view name);

}  // namespace plumb::certify::batch
