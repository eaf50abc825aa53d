#include "tool/trial/contestant.hpp"

#include <algorithm>
#include <cmath>

#include "arith/splitmix.hpp"

namespace plumb::tool::trial {

double as_answer(const Pairs& pairs) {
  Pairs sorted = pairs;
  std::ranges::sort(sorted);
  std::uint64_t folded = sorted.size();
  for (const auto& [a, b] : sorted) {
    folded = mixed_bits(folded ^ ((std::uint64_t{a} << 32 | b) + golden_step));
  }
  return static_cast<double>(folded >> 11);
}

Scene scene_of(std::span<const double> coordinates) {
  double largest = 0;
  for (const double x : coordinates) largest = std::max(largest, std::fabs(x));
  return {lattice_of(coordinates), largest};
}

Method prepared_by(std::string_view name, std::string_view about, Prepare* prepare) {
  return {std::string(name), std::string(about), prepare};
}

}  // namespace plumb::tool::trial
