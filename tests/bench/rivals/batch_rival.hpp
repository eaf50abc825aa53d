// What does a compiler make of the same loop?  The bare double formula, and the filter alone, over arrays of
// coordinates, vectorized by the compiler for each instruction set: no certified sign where the filter fails, no look
// at bad input.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace plumb::bench {

/// Writes the signs of n cases whose coordinates have an array each; `filtered` writes 0 where it is unsure.
struct Loop {
  std::string_view predicate, instruction_set;
  void (*bare)(const double* const* coordinates, std::size_t n, signed char* out);
  void (*filtered)(const double* const* coordinates, std::size_t n, signed char* out);
};

/// Those that this processor can run.
std::vector<Loop> compiled_loops();

}  // namespace plumb::bench
