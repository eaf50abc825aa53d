// Which number of the input is refused, and in which words?
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// The name of a coordinate among arguments of so many: "b.y", "b" for an argument of one,
/// with its own name where there is one; else "coordinate 4".
std::string place_of(std::size_t coordinate, std::span<const int> arguments, std::string_view axes = "xyz",
                     std::span<const std::string_view> names = {});

/// Throws NonFinite: "PLACE is nan, not a real number; give a finite double".
[[noreturn]] void throw_not_a_number(const std::string& place, double x);

}  // namespace plumb
