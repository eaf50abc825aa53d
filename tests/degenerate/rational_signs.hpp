// Is it exactly degenerate?  Determinants of doubles in GMP rationals, written from their definition and independent of
// the library's formulas.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <span>
#include <vector>

namespace plumb_test {

using Matrix = std::vector<std::vector<mpq_class>>;

inline int sign_of_determinant(Matrix m) {
  int sign = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < m.size() && m[pivot][k] == 0) ++pivot;
    if (pivot == m.size()) return 0;
    if (pivot != k) {
      std::swap(m[pivot], m[k]);
      sign = -sign;
    }
    sign *= sgn(m[k][k]);
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      if (m[i][k] == 0) continue;
      const mpq_class factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return sign;
}

// Points with coordinates one after the other; `which` names dimension + 1 of them: 0 when they lie on one line (2D)
// or plane (3D).
inline int sign_of_flat(std::span<const double> c, std::size_t dimension, std::span<const std::size_t> which) {
  Matrix m;
  for (const std::size_t point : which) {
    m.emplace_back(1, 1);
    for (std::size_t axis = 0; axis < dimension; ++axis) m.back().emplace_back(c[point * dimension + axis]);
  }
  return sign_of_determinant(std::move(m));
}

// The same for dimension + 2 points and one circle or sphere (or line or plane).
inline int sign_of_round(std::span<const double> c, std::size_t dimension, std::span<const std::size_t> which) {
  Matrix m;
  for (const std::size_t point : which) {
    m.emplace_back(1, 1);
    mpq_class square = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      const mpq_class x(c[point * dimension + axis]);
      m.back().push_back(x);
      square += x * x;
    }
    m.back().push_back(square);
  }
  return sign_of_determinant(std::move(m));
}

// Whether three points of space lie on one line: on one line in each of the three projections.
inline bool collinear_in_space(std::span<const double> c, std::span<const std::size_t> which) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> flat;
    for (const std::size_t point : which) {
      flat.push_back(c[3 * point + (axis + 1) % 3]);
      flat.push_back(c[3 * point + (axis + 2) % 3]);
    }
    const std::size_t all[] = {0, 1, 2};
    if (sign_of_flat(flat, 2, all) != 0) return false;
  }
  return true;
}

// Calls visit(subset) for every subset of `size` of the numbers below `count`.
template <class Visit>
void for_each_subset(std::size_t count, std::size_t size, const Visit& visit) {
  std::vector<std::size_t> subset;
  const auto extend = [&](const auto& self, std::size_t next) -> void {
    if (subset.size() == size) return visit(std::span<const std::size_t>(subset));
    for (std::size_t i = next; i < count; ++i) {
      subset.push_back(i);
      self(self, i + 1);
      subset.pop_back();
    }
  };
  extend(extend, 0);
}

}  // namespace plumb_test
