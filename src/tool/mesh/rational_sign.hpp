// What does rational arithmetic say?  The judge's judge: the formula over GMP's rationals, sharing no stage with the
// exact method.
//
// Cost: tens of microseconds.
#pragma once

#include <span>
#include <string_view>

#include "plumb/arith/sign.hpp"

namespace plumb::tool {

/// The predicate must be one of the four classics, the coordinates finite and as many as it takes.
Sign rational_sign(std::string_view predicate, std::span<const double> coordinates);

}  // namespace plumb::tool
