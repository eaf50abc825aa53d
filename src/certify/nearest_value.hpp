// What is a formula's value, rounded once?  For those who want more than a sign.
//
// Laws: the double nearest to the exact value, ties to even, for all finite coordinates; infinite where the value is
// beyond all doubles; the least subnormal of its sign, not zero, where it is nearer to zero than to any other double.
// So the sign is always that of the exact value.
// Source: docs/proof.md, "Integers".
// Cost: that of the last stage, some hundred nanoseconds.
#pragma once

#include <span>

#include "plumb/certify/detail/tape.hpp"

namespace plumb {

/// `certify::tape::program<F>()` (certify/formula.hpp) at these coordinates, which must be finite and as many as it takes.
double nearest_value(certify::tape::Program program, std::span<const double> coordinates);

}  // namespace plumb
