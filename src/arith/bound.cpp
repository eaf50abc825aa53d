// What is thrown where a formula outgrows its bound; apart, because the header needs no more than the name.
#include "plumb/arith/bound.hpp"

#include <stdexcept>

namespace plumb {

void throw_bound_too_large() { throw std::overflow_error("formula too long for a bound in units of 2^-85"); }

}  // namespace plumb
