#include "tool/trial/rational_judge.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "plumb/arith/big.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb::tool::trial {
namespace {

constexpr std::size_t rows = 5;
using Column = std::array<mpq_class, rows>;

/// Has the system of these columns and this right side, which is not negative, a solution that is not negative?  The
/// first phase of the simplex method, of which the artificial columns need not be kept: none comes back.
bool solvable(std::vector<Column> columns, Column right) {
  std::array<bool, rows> artificial{true, true, true, true, true};
  std::array<std::size_t, rows> basis{};
  for (;;) {
    std::size_t enter = columns.size();
    for (std::size_t j = 0; j < columns.size() && enter == columns.size(); ++j) {
      mpq_class gain = 0;
      for (std::size_t r = 0; r < rows; ++r) {
        if (artificial[r]) gain += columns[j][r];
      }
      if (gain > 0) enter = j;
    }
    mpq_class left = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      if (artificial[r]) left += right[r];
    }
    if (left == 0) return true;
    if (enter == columns.size()) return false;
    // Bland's rule: of equal ratios the row of the smallest variable leaves; artificial ones come first.
    std::size_t leave = rows;
    mpq_class least;
    for (std::size_t r = 0; r < rows; ++r) {
      if (columns[enter][r] <= 0) continue;
      const mpq_class ratio = right[r] / columns[enter][r];
      const auto place = [&](std::size_t row) {
        return artificial[row] ? std::pair(0, row) : std::pair(1, basis[row]);
      };
      if (leave == rows || ratio < least || (ratio == least && place(r) < place(leave))) {
        leave = r;
        least = ratio;
      }
    }
    const mpq_class pivot = columns[enter][leave];
    const Column by = columns[enter];
    const auto eliminate = [&](Column& column) {
      column[leave] /= pivot;
      for (std::size_t r = 0; r < rows; ++r) {
        if (r != leave) column[r] -= by[r] * column[leave];
      }
    };
    for (Column& column : columns) eliminate(column);
    eliminate(right);
    artificial[leave] = false;
    basis[leave] = enter;
  }
}

mpq_class square(const RationalVec& v) { return dot(v, v); }

mpq_class within_unit(const mpq_class& x) { return x < 0 ? mpq_class(0) : x > 1 ? mpq_class(1) : x; }

}  // namespace

RationalVec rational_vec(std::span<const double> q, std::size_t i) {
  return {mpq_class(q[3 * i]), mpq_class(q[3 * i + 1]), mpq_class(q[3 * i + 2])};
}

bool meet(const Generated& a, const Generated& b) {
  std::vector<Column> columns;
  for (const RationalVec& p : a.points) columns.push_back({p.x, p.y, p.z, 1, 0});
  for (const RationalVec& d : a.directions) columns.push_back({d.x, d.y, d.z, 0, 0});
  for (const RationalVec& p : b.points) columns.push_back({-p.x, -p.y, -p.z, 0, 1});
  for (const RationalVec& d : b.directions) columns.push_back({-d.x, -d.y, -d.z, 0, 0});
  return solvable(std::move(columns), {0, 0, 0, 1, 1});
}

mpq_class square_distance(const RationalVec& p, const RationalVec& a, const RationalVec& b) {
  const RationalVec d = b - a;
  const mpq_class whole = square(d);
  if (whole == 0) return square(p - a);
  return square(p - (a + d * within_unit(dot(p - a, d) / whole)));
}

mpq_class square_distance(const RationalVec& p, const RationalVec& a, const RationalVec& b, const RationalVec& c) {
  const RationalVec u = b - a, v = c - a, w = p - a, n = cross(u, v);
  const mpq_class whole = square(n);
  if (whole != 0) {
    const mpq_class s = dot(cross(w, v), n), t = dot(cross(u, w), n), height = dot(w, n);
    if (s >= 0 && t >= 0 && s + t <= whole) return height * height / whole;
  }
  return std::min({square_distance(p, a, b), square_distance(p, b, c), square_distance(p, c, a)});
}

mpq_class square_distance_of_segments(const RationalVec& a, const RationalVec& b, const RationalVec& c,
                                      const RationalVec& d) {
  const RationalVec u = b - a, v = d - c, w = c - a, n = cross(u, v);
  const mpq_class whole = square(n);
  if (whole != 0) {
    const mpq_class s = dot(cross(w, v), n), t = dot(cross(w, u), n), height = dot(w, n);
    if (s >= 0 && s <= whole && t >= 0 && t <= whole) return height * height / whole;
  }
  return std::min(
      {square_distance(a, c, d), square_distance(b, c, d), square_distance(c, a, b), square_distance(d, a, b)});
}

double nearest_root(const mpq_class& square) { return rounded_root(Rounding::nearest, Rational(BigRational{square})); }

}  // namespace plumb::tool::trial
