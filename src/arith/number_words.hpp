// How are counts written for readers?
//
// Source: none; cost: none.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plumb::arith {

/// 1,234,567
std::string grouped(std::uint64_t n);
/// "1 vertex", "2 vertices".
std::string plural(std::uint64_t n, std::string_view one, std::string_view many);

}  // namespace plumb::arith
