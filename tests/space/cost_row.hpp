// What does a question cost, and which header says so?  One row a question.
#pragma once

#include <cmath>

#include "space/cost_clouds.hpp"

namespace plumb::cost {

/// As the header's line of cost says it behind "Bounded by ": `says`, in which n is the number of points.
struct Growth {
  const char* says;
  double power = 0;
  bool has_log = false;
  [[nodiscard]] double of(double n) const { return std::pow(n, power) * (has_log ? std::log2(n) : 1); }
};

inline constexpr Growth fixed{"a fixed number of"}, logarithmic{"log n", 0, true}, linear{"n ", 1},
    sorting{"n log n", 1, true}, quadratic{"n^2 ", 2}, quadratic_log{"n^2 log n", 2, true}, cubic{"n^3 ", 3},
    quartic{"n^4 ", 4};

struct CostRow {
  const char* name;
  const char* header;  // in include/plumb
  Growth growth;
  double most;  // millions of instructions for all `clouds` of nine points, of each kind
  void (*ask)(const Cloud&);
  std::size_t many = 72;     // points, of ordinary exponents, by which growth is measured
  std::uint64_t clouds = 4;  // of each kind
  std::size_t more = 18;     // points of the widest exponents, of which one cloud is asked
  // Callgrind runs fifty times slower than the processor: two clouds are asked, but where they differ much.
  std::uint64_t most_asked = 2;

  [[nodiscard]] std::uint64_t asked() const { return std::min(clouds, most_asked); }
  [[nodiscard]] double most_of(std::uint64_t asked_clouds) const {
    return most * static_cast<double>(asked_clouds) / static_cast<double>(clouds);
  }
};

}  // namespace plumb::cost
