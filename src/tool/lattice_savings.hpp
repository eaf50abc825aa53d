// What does a mesh's lattice let the kernel skip?  The cheapest arithmetic that is exact for every input of the
// lattice.
//
// Law: the answer follows from the derived bit growth of the formula alone (arith/degree.hpp).
#pragma once

#include <string>
#include <vector>

#include "plumb/arith/lattice.hpp"

namespace plumb::tool {

struct Saving {
  std::string predicate;
  int value_bits;        // of the exact value, at most
  std::string suffices;  // "plain double", "64-bit integers", ..., "GMP"
  std::string skips;     // what is then never needed; empty when nothing
};

std::vector<Saving> lattice_savings(const Lattice& lattice);

}  // namespace plumb::tool
