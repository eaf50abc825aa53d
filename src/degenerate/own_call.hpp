// How is a C function of any argument list called?  Pointers to doubles, some with a count after them.
//
// Law: the type is that of the function which the call asks.
// Source: none.
// Cost: an indirect call.
#pragma once

#include <vector>

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

struct OwnCall {
  Answer (*call)(ForeignFunction function, std::span<const Passed> arguments);
  std::type_index type;
};

inline constexpr std::size_t most_arguments = 12, most_with_counts = 5;

/// `counted` says of each argument whether a count follows it; `yes_no` returns int, anything else double.  Throws
/// Error beyond the most.
OwnCall own_call(const std::vector<bool>& counted, bool yes_no);

}  // namespace plumb::degenerate
