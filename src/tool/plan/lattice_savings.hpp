// What does a mesh's lattice let the kernel skip?  The cheapest arithmetic that is exact for every input of the
// lattice.
//
// Law: the answer follows from the formula's derived degree and bit growth (arith/degree.hpp) and from the widths that
// the exact stages have (certify/detail/exact_stages.hpp): what is said to be skipped never decides on such input.
#pragma once

#include <string>
#include <vector>

#include "plumb/arith/lattice.hpp"

namespace plumb::tool {

struct Saving {
  std::string predicate;
  int value_bits;        // of the exact value, at most
  std::string suffices;  // "plain double", "64-bit integers", ..., "GMP integers"
  std::string skips;     // what is then never needed; empty when nothing
  std::string plan;      // the arithmetic that a plan takes (certify/plan.hpp)
};

std::vector<Saving> lattice_savings(const Lattice& lattice);

}  // namespace plumb::tool
