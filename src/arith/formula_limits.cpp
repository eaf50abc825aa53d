// What is thrown where a formula outgrows its tape or its bound; apart, because headers need no more than the names.
#include <stdexcept>

#include "plumb/arith/bound.hpp"
#include "plumb/arith/tape.hpp"

namespace plumb {

void tape::throw_formula_too_long() { throw std::length_error("formula too long for its tape"); }

void throw_bound_too_large() { throw std::overflow_error("formula too long for a bound in units of 2^-85"); }

}  // namespace plumb
