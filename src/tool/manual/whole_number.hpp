// Is what stands behind an option a whole number, and in its range?  Asked before it is read, to say so in a sentence.
//
// Source: none; cost: none.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <string>

namespace plumb::tool {

inline CLI::Validator whole_number_from(std::uint64_t least, std::uint64_t most) {
  const auto why_not = [least, most](const std::string& word) -> std::string {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc() && end == word.data() + word.size() && least <= number && number <= most) return "";
    return "'" + word + "' is no whole number from " + std::to_string(least) + " to " + std::to_string(most);
  };
  return CLI::Validator(why_not, "");
}

}  // namespace plumb::tool
