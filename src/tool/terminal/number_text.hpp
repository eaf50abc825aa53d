// How are counts, shares and times written for readers?  With as many digits as they need.
//
// Source: none; cost: none.
#pragma once

#include <cstdint>
#include <string>

#include "arith/number_words.hpp"

namespace plumb::tool {

using arith::grouped, arith::plural;
/// "0.13%", "2.0e-04%", "0".
std::string percent(std::uint64_t part, std::uint64_t whole);
/// Three digits that count: "0.0123", "8.3", "317", "1,150", "2,340,000".  `x` is not negative.
std::string three_digits(double x);

}  // namespace plumb::tool
