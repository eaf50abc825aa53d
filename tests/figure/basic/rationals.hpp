// What do shapes say in rational numbers?  Vectors of GMP rationals, systems by elimination, and whether a double is
// the nearest one: written from the definitions, independent of the library's formulas.
#pragma once

#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "plumb/certify/sign_of.hpp"

namespace plumb::rationals {

using Vector = std::vector<mpq_class>;

template <class Part>
Vector exact(const Part& part) {
  const auto x = coordinates(part);
  return Vector(x.begin(), x.end());
}

inline Vector operator-(const Vector& a, const Vector& b) {
  Vector d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
  return d;
}
inline Vector operator+(const Vector& a, const Vector& b) {
  Vector d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] + b[i];
  return d;
}
inline Vector operator*(const mpq_class& t, const Vector& a) {
  Vector d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = t * a[i];
  return d;
}
inline mpq_class dot(const Vector& a, const Vector& b) {
  mpq_class sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

struct Reduced {
  std::vector<Vector> rows;  // in reduced echelon form
  std::size_t rank;
};

/// Eliminates the first `width` columns.
inline Reduced reduce(std::vector<Vector> m, std::size_t width) {
  std::size_t rank = 0;
  for (std::size_t j = 0; j < width && rank < m.size(); ++j) {
    std::size_t pivot = rank;
    while (pivot < m.size() && m[pivot][j] == 0) ++pivot;
    if (pivot == m.size()) continue;
    std::swap(m[pivot], m[rank]);
    const mpq_class by = 1 / m[rank][j];
    m[rank] = by * m[rank];
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (i != rank) m[i] = m[i] - m[i][j] * m[rank];
    }
    ++rank;
  }
  return {m, rank};
}

/// The only solution of the rows (each with its right side last), if there is one.
inline std::optional<Vector> only_solution(const std::vector<Vector>& rows) {
  const std::size_t n = rows.size();
  const Reduced r = reduce(rows, n);
  if (r.rank != n) return {};
  Vector x;
  for (const Vector& row : r.rows) x.push_back(row[n]);
  return x;
}

/// The weights at the corners whose sum is one and whose center of gravity is nearest to p: by the normal equations of
/// the edges from the last corner.  Nothing where the corners are affinely dependent.
inline std::optional<Vector> weights_of(const std::vector<Vector>& corners, const Vector& p) {
  const std::size_t n = corners.size() - 1;
  const Vector last = corners[n];
  std::vector<Vector> rows;
  for (std::size_t i = 0; i < n; ++i) {
    rows.emplace_back();
    for (std::size_t j = 0; j < n; ++j) rows[i].push_back(dot(corners[i] - last, corners[j] - last));
    rows[i].push_back(dot(corners[i] - last, p - last));
  }
  auto x = only_solution(rows);
  if (!x) return {};
  mpq_class rest = 1;
  for (const mpq_class& weight : *x) rest -= weight;
  x->push_back(rest);
  return x;
}

/// Where to the nearest double, ties to even, is beyond the doubles.
inline bool overflows(const mpq_class& q) {
  constexpr double largest = std::numeric_limits<double>::max();
  return abs(q) >= mpq_class(largest) + mpq_class(std::ldexp(1.0, 970));
}

/// Is the finite x the double nearest to q, ties to even, zero never negative?
inline bool is_nearest(double x, const mpq_class& q) {
  if (overflows(q) || !std::isfinite(x) || (x == 0 && std::signbit(x))) return false;
  const mpq_class off = abs(mpq_class(x) - q);
  const bool even = (std::bit_cast<std::uint64_t>(x) & 1) == 0;
  for (const double towards : {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
    const double neighbor = std::nextafter(x, towards);
    if (!std::isfinite(neighbor)) continue;
    const mpq_class other = abs(mpq_class(neighbor) - q);
    if (off > other || (off == other && !even)) return false;
  }
  return true;
}

}  // namespace plumb::rationals
