// What is thrown where a formula outgrows its tape; apart, because the header needs no more than the name.
#include "plumb/certify/detail/tape.hpp"

#include <stdexcept>

namespace plumb::certify::tape {

void throw_formula_too_long() { throw std::length_error("formula too long for its tape"); }

}  // namespace plumb::certify::tape
