// How are vertices commonly welded?  Rounded to a grid, hashed, sorted, or each to the first that is near.
//
// Laws: none; they are on trial, and decide nothing of ours.
// Source: RTCD 12.1.1.
// Cost: n log n, of `by_first_come` and `by_each_pair` n^2.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "lab/crowd/weld_clouds.hpp"

namespace plumb::lab::trial {

/// Each vertex becomes the one of this number.
using WeldInto = std::vector<std::uint32_t>;

/// Cells as wide as the tolerance: what rounds to the same one is one.
WeldInto by_grid(const WeldCloud& cloud);

/// Equal bits are one vertex; a tolerance it has none.
WeldInto by_hashing(const WeldCloud& cloud);

/// Each in the order of the file becomes the first that is near.
WeldInto by_first_come(const WeldCloud& cloud);

/// Sorted by x, compared as floats with those before until x is too far.
WeldInto by_sorting(const WeldCloud& cloud);

/// The answer is that of differences as T computes them.
template <class T>
bool are_near(const Point3& p, const Point3& q) {
  const T x = T(p.x) - T(q.x), y = T(p.y) - T(q.y), z = T(p.z) - T(q.z);
  return x * x + y * y + z * z <= T(weld_tolerance) * T(weld_tolerance);
}

/// All that steps connect, pair by pair; over rationals it is what is true.
template <class T>
WeldInto by_each_pair(const WeldCloud& cloud) {
  WeldInto group(cloud.size());
  std::iota(group.begin(), group.end(), 0U);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (group[i] == group[k] || !are_near<T>(cloud[i], cloud[k])) continue;
      const std::uint32_t from = std::max(group[i], group[k]), to = std::min(group[i], group[k]);
      std::ranges::replace(group, from, to);
    }
  }
  return group;
}

inline WeldInto connected_in_truth(const WeldCloud& cloud) { return by_each_pair<mpq_class>(cloud); }

}  // namespace plumb::lab::trial
