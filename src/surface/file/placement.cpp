#include "surface/file/placement.hpp"

#include <cmath>

#include "arith/big_rounding.hpp"
#include "certify/rounded.hpp"

namespace plumb::surface {
namespace {

constexpr auto image = [](auto m0, auto x0, auto m1, auto x1, auto m2, auto x2, auto t) {
  return t + (m0 * x0 + m1 * x1 + m2 * x2);
};

// The double that this number is, if it is one.
std::optional<double> as_double(const BigDyadic& x) {
  const double nearest = rounded(Rounding::nearest, x);
  if (!std::isfinite(nearest) || (x - BigDyadic(nearest)).sign() != Sign::zero) return std::nullopt;
  return nearest;
}

}  // namespace

Placement::Placement() : Placement(Rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}) {}

Placement::Placement(const Rows& rows) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) exact_[i][j] = BigDyadic(rows[i][j]);
  look();
}

Placement::Placement(const std::array<double, 3>& move, const std::array<double, 4>& turn,
                     const std::array<double, 3>& scale) {
  const BigDyadic x(turn[0]), y(turn[1]), z(turn[2]), w(turn[3]), one(1.0);
  const auto twice = [](const BigDyadic& a) { return a + a; };
  const std::array<std::array<BigDyadic, 3>, 3> r{
      {{one - twice(y * y + z * z), twice(x * y - z * w), twice(x * z + y * w)},
       {twice(x * y + z * w), one - twice(x * x + z * z), twice(y * z - x * w)},
       {twice(x * z - y * w), twice(y * z + x * w), one - twice(x * x + y * y)}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) exact_[i][j] = r[i][j] * BigDyadic(scale[j]);
    exact_[i][3] = BigDyadic(move[i]);
  }
  look();
}

void Placement::look() {
  Rows rows{};
  doubles_.reset();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto x = as_double(exact_[i][j]);
      if (!x) return;
      rows[i][j] = *x;
    }
  }
  doubles_ = rows;
  identity_ = rows == Rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
}

Placement operator*(const Placement& outer, const Placement& inner) {
  if (outer.identity_) return inner;
  if (inner.identity_) return outer;
  Placement both;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = outer.exact_[i];
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& m = inner.exact_;
      both.exact_[i][j] = row[0] * m[0][j] + row[1] * m[1][j] + row[2] * m[2][j];
    }
    both.exact_[i][3] = both.exact_[i][3] + row[3];
  }
  both.identity_ = false;
  both.look();
  return both;
}

bool Placement::mirrors() const {
  const auto& m = exact_;
  const auto minor = [&](std::size_t j, std::size_t k) { return m[1][j] * m[2][k] - m[1][k] * m[2][j]; };
  return (m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1)).sign() == Sign::negative;
}

std::optional<Point3> Placement::operator()(const Point3& p, Placed& placed) const {
  if (identity_) return p;
  placed.coordinates += 3;
  std::array<double, 3> to{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (doubles_) {
      const auto& row = (*doubles_)[i];
      const auto by = [&](Rounding rounding) {
        return rounded_value(rounding, image, row[0], p.x, row[1], p.y, row[2], p.z, row[3]);
      };
      const double up = by(Rounding::up);
      const bool exact = up == by(Rounding::down);
      to[i] = exact ? up : by(Rounding::nearest);
      placed.inexact += !exact;
    } else {
      const auto& row = exact_[i];
      const BigDyadic x = row[0] * BigDyadic(p.x) + row[1] * BigDyadic(p.y) + row[2] * BigDyadic(p.z) + row[3];
      to[i] = rounded(Rounding::nearest, x);
      placed.inexact += !std::isfinite(to[i]) || (x - BigDyadic(to[i])).sign() != Sign::zero;
    }
    if (!std::isfinite(to[i])) return std::nullopt;
  }
  return Point3{to[0], to[1], to[2]};
}

}  // namespace plumb::surface
