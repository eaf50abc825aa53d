// Which function was called?  The text of an exception begins with its name, whichever function found the fault.
//
// Cost: none.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "plumb/predicates/standard.hpp"

namespace plumb::query {

enum class Question : unsigned char {
  relate,
  intersects,
  hits,
  distance,
  exact_distance,
  squared_distance_exact,
  compare_distance,
  compare_second_distance
};
constexpr std::string_view name_of(Question question) {
  constexpr std::array<std::string_view, 8> names{"relate",
                                                  "intersects",
                                                  "hits",
                                                  "distance",
                                                  "exact_distance",
                                                  "squared_distance_exact",
                                                  "compare_distance",
                                                  "compare_distance, second pair"};
  return names[static_cast<std::size_t>(question)];
}

}  // namespace plumb::query
