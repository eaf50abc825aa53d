// Determinants of small matrices by cofactor expansion, over any number type with + - *.
//
// Laws: swapping two rows or columns flips the sign; homogeneous of degree n in the entries.
// Rows are given one after another.
// Source: RTCD 3.1.3 (of four and five rows by Laplace's expansion, whose minors are computed once).
// Cost: det2 2 products, det3 9 products, four rows 30 products, five rows 90 products.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "plumb/predicates/standard.hpp"

namespace plumb::predicates {

template <class T>
constexpr auto det2(const T& a, const T& b,  //
                    const T& c, const T& d) {
  return a * d - b * c;
}

template <class T>
constexpr auto det3(const T& a, const T& b, const T& c,  //
                    const T& d, const T& e, const T& f,  //
                    const T& g, const T& h, const T& i) {
  return a * det2(e, f, h, i) - b * det2(d, f, g, i) + c * det2(d, e, g, h);
}

/// The minors of two rows, by the columns i < j, in the order 01 02 ... 12 13 ...
template <std::size_t N, class T, std::size_t Size>
constexpr auto minors_of_rows(const std::array<T, Size>& p, std::size_t first, std::size_t second) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return det2(p[N * first + i], p[N * first + j], p[N * second + i], p[N * second + j]);
  };
  if constexpr (N == 4) {
    return std::array{minor(0, 1), minor(0, 2), minor(0, 3), minor(1, 2), minor(1, 3), minor(2, 3)};
  } else {
    return std::array{minor(0, 1), minor(0, 2), minor(0, 3), minor(0, 4), minor(1, 2),
                      minor(1, 3), minor(1, 4), minor(2, 3), minor(2, 4), minor(3, 4)};
  }
}

struct Determinant2 {
  static constexpr std::string_view name = "determinant2";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return det2(p[0], p[1], p[2], p[3]);
  }
};

struct Determinant3 {
  static constexpr std::string_view name = "determinant3";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return det3(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]);
  }
};

struct Determinant4 {
  static constexpr std::string_view name = "determinant4";
  static constexpr int points = 4, dimension = 4;
  template <class T>
  constexpr auto operator()(const std::array<T, 16>& p) const {
    const auto u = minors_of_rows<4>(p, 0, 1), v = minors_of_rows<4>(p, 2, 3);
    return (u[0] * v[5] - u[1] * v[4] + u[2] * v[3]) + (u[3] * v[2] - u[4] * v[1] + u[5] * v[0]);
  }
};

struct Determinant5 {
  static constexpr std::string_view name = "determinant5";
  static constexpr int points = 5, dimension = 5;
  template <class T>
  constexpr auto operator()(const std::array<T, 25>& p) const {
    const auto u = minors_of_rows<5>(p, 0, 1), v = minors_of_rows<5>(p, 3, 4);
    const auto row = [&](std::size_t i) { return p[10 + i]; };
    // The minors of the last three rows by the columns i < j < k, from those of the last two.
    const auto minor3 = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t jk, std::size_t ik,
                            std::size_t ij) { return row(i) * v[jk] - row(j) * v[ik] + row(k) * v[ij]; };
    const auto m012 = minor3(0, 1, 2, 4, 1, 0), m013 = minor3(0, 1, 3, 5, 2, 0), m014 = minor3(0, 1, 4, 6, 3, 0);
    const auto m023 = minor3(0, 2, 3, 7, 2, 1), m024 = minor3(0, 2, 4, 8, 3, 1), m034 = minor3(0, 3, 4, 9, 3, 2);
    const auto m123 = minor3(1, 2, 3, 7, 5, 4), m124 = minor3(1, 2, 4, 8, 6, 4), m134 = minor3(1, 3, 4, 9, 6, 5);
    const auto m234 = minor3(2, 3, 4, 9, 8, 7);
    // The sign of columns i, j of the first two rows is that of (-1)^(i + j + 1).
    return (u[0] * m234 - u[1] * m134 + u[2] * m124 - u[3] * m123) + (u[4] * m034 - u[5] * m024 + u[6] * m023) +
           (u[7] * m014 - u[8] * m013 + u[9] * m012);
  }
};

}  // namespace plumb::predicates
