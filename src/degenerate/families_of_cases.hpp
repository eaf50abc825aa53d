// Which cases come from the families of hard points?  Every family, arranged as the arguments of a kind.
//
// Law: an arrangement asks `fill` for the coordinates of some points of one dimension, and makes a valid case of them.
// Source: docs/degeneracies.md.
// Cost: as the families take.
#pragma once

#include <optional>

#include "plumb/degenerate/family.hpp"
#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

/// Of dimension 2 or 3.
using FillOf = std::function<void(int dimension, std::span<double> coordinates, Entropy& entropy)>;
using ArrangeBy = std::function<void(Numbers& numbers, Entropy& entropy, const FillOf& fill)>;

/// Every family, aimed at the degeneracy or, without one, at any, and "touching": integers from -2 to 2.
std::vector<Generator> families_of_cases(std::optional<Degeneracy> aim, const ArrangeBy& arrange);

}  // namespace plumb::degenerate
