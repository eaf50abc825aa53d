// Minkowski sum, edge merging: to which side does one edge turn from another, where edges of two shapes are compared?
#pragma once

#include "plumb/certify/sign_of.hpp"

namespace plumb::figure::minkowski {

/// Positive when the edge from c to d points to the left of that from a to b.
struct EdgesTurn {
  static constexpr std::string_view name = "minkowski_sum";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return predicates::det2(p[2] - p[0], p[3] - p[1], p[6] - p[4], p[7] - p[5]);
  }
};

}  // namespace plumb::figure::minkowski
