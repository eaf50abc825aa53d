// What is thrown where a formula outgrows its bound; apart, because the header needs no more than the name.
#include "plumb/arith/bound.hpp"

#include <stdexcept>

#include "plumb/arith/track.hpp"

namespace plumb {

void throw_bound_too_large() { throw std::overflow_error("formula too long for a bound in units of 2^-85"); }
void throw_unequal_powers() { throw std::logic_error("a statement adds numbers of unequal powers of their scales"); }
void throw_powers_too_high() { throw std::logic_error("a statement's powers are beyond the highest that it names"); }

}  // namespace plumb
