// The last basis of the guess, solved exactly: is its point what it takes to be the optimum?
#include <algorithm>
#include <cmath>
#include <limits>

#include "arith/certain.hpp"
#include "arith/vec.hpp"
#include "figure/k_dop/halfspace_slack.hpp"
#include "plumb/arith/ball.hpp"

namespace plumb::figure {
namespace {

constexpr std::size_t numbers = 5;  // of a place: those of a point, its slack, and w, all times w
using SlackPlanes = std::array<BigDyadic, numbers>;

/// Minors of rows by the columns taken, all columns but one for the last row: row by row, each from those of one less.
SlackPlanes minors(const std::array<SlackPlanes, 4>& rows) {
  std::array<BigDyadic, 1u << numbers> minor;
  minor[0] = BigDyadic(1.0);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (unsigned taken = 0; taken < minor.size(); ++taken) {
      if (static_cast<std::size_t>(__builtin_popcount(taken)) != r + 1) continue;
      BigDyadic sum;
      bool plus = r % 2 == 0;  // for the first of the columns
      for (unsigned k = 0; k < numbers; ++k) {
        if ((taken >> k & 1u) == 0) continue;
        const BigDyadic &entry = rows[r][k], &rest = minor[taken & ~(1u << k)];
        if (!certainly_zero(entry) && !certainly_zero(rest)) sum = plus ? sum + entry * rest : sum - entry * rest;
        plus = !plus;
      }
      minor[taken] = std::move(sum);
    }
  }
  SlackPlanes without;
  for (unsigned k = 0; k < numbers; ++k) without[k] = std::move(minor[((1u << numbers) - 1) & ~(1u << k)]);
  return without;
}

/// In doubles with the errors of their rounding, all times one power of two.
std::array<Running, numbers> near(const SlackPlanes& place) {
  std::array<double, numbers> mantissa{};
  std::array<long, numbers> exponent{};
  long most = std::numeric_limits<long>::min();
  for (std::size_t k = 0; k < numbers; ++k) {
    if (place[k].sign() == Sign::zero) continue;
    mantissa[k] = mpz_get_d_2exp(&exponent[k], place[k].mantissa().get_mpz_t());
    exponent[k] += place[k].exponent();
    most = std::max(most, exponent[k]);
  }
  std::array<Running, numbers> result;
  for (std::size_t k = 0; k < numbers; ++k) {
    if (mantissa[k] == 0) continue;
    const double value = std::ldexp(mantissa[k], static_cast<int>(std::max(exponent[k] - most, -2000L)));
    // Cut off, and rounded where that is subnormal: less than to the next double.
    result[k] = {value, Ball::next(std::fabs(value), 1) - std::fabs(value)};
  }
  return result;
}

/// Certain zeros stay it.
template <class T>
T product(const T& a, const T& b) {
  return certainly_zero(a) || certainly_zero(b) ? T(0.0) : a * b;
}
template <class T>
T determinant(const std::array<arith::Vec<T>, 3>& rows) {
  const auto& [u, v, w] = rows;
  const T x = product(v.y, w.z) - product(v.z, w.y), y = product(v.z, w.x) - product(v.x, w.z),
          z = product(v.x, w.y) - product(v.y, w.x);
  return product(u.x, x) + product(u.y, y) + product(u.z, z);
}

}  // namespace

HalfspaceSlack::ExactRow HalfspaceSlack::exact_row(std::size_t j, std::size_t number) const {
  ExactRow row;
  if (j == held) {
    row[number] = BigDyadic(1.0);
  } else if (j == at_most_one) {
    row[3] = BigDyadic(1.0), row[4] = BigDyadic(-1.0);
  } else {
    Exact exact = exactly_(j);
    for (std::size_t k = 0; k < 3; ++k) row[k] = std::move(exact.normal[k]);
    row[3] = BigDyadic(rows_[j].unit);
    row[4] = BigDyadic() - exact.limit;
  }
  return row;
}

/// By Cramer's rule, times the determinant of all: that of the other normals.
Running HalfspaceSlack::weight(std::size_t k) const {
  std::array<arith::Vec<Running>, 3> others;
  for (std::size_t i = 0, to = 0; i < most; ++i) {
    if (i == k) continue;
    const std::size_t j = basis_[i];
    const auto number = [&](std::size_t n) {
      return j < rows_.size() ? rows_[j].near.normal[n] : Running(j == held && n == i ? 1.0 : 0.0);
    };
    others[to++] = {number(0), number(1), number(2)};
  }
  const Running d = determinant(others);
  return k % 2 == 0 ? Running(0.0) - d : d;
}
Sign HalfspaceSlack::weight_sign(const std::array<ExactRow, most>& rows, std::size_t k) const {
  const Unsure<Sign> sign = weight(k).sign();
  if (sign.certain()) return sign.value();
  std::array<arith::Vec<BigDyadic>, 3> others;
  for (std::size_t i = 0, to = 0; i < most; ++i) {
    if (i != k) others[to++] = {rows[i][0], rows[i][1], rows[i][2]};
  }
  const Sign d = determinant(others).sign();
  return k % 2 == 0 ? -d : d;
}

/// Do the weights, which combine the normals to zero, combine the limits to less?
bool HalfspaceSlack::has_no_point() const {
  Running sum(0.0);
  Sign all = Sign::zero;
  for (std::size_t k = 0; k < most; ++k) {
    const Running w = weight(k);
    const Unsure<Sign> sign = w.sign();
    if (!sign.certain() || basis_[k] == at_most_one) return false;
    if (sign.value() == Sign::zero || basis_[k] == held) {
      if (sign.value() != Sign::zero) return false;
      continue;
    }
    if (all != Sign::zero && sign.value() != all) return false;
    all = sign.value();
    sum = sum + w * rows_[basis_[k]].near.limit;
  }
  const Unsure<Sign> sign = sum.sign();
  return all != Sign::zero && sign.certain() && sign.value() == -all;
}

bool HalfspaceSlack::hold_all(const ExactRow& place) const {
  const auto p = near(place);
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    if (std::ranges::find(basis_, j) != basis_.end()) continue;
    Running above = Running(rows_[j].unit) * p[3] - rows_[j].near.limit * p[4];
    for (std::size_t k = 0; k < 3; ++k) above = above + rows_[j].near.normal[k] * p[k];
    const Unsure<Sign> sign = above.sign();
    if (sign.certain() && sign.value() == Sign::negative) continue;
    if (sign.certain() && sign.value() == Sign::positive) return false;
    const ExactRow row = exact_row(j, 0);
    BigDyadic sum;
    for (std::size_t k = 0; k < numbers; ++k) sum = sum + product(row[k], place[k]);
    if (sum.sign() == Sign::positive) return false;
  }
  // As much as slack may be.
  return std::ranges::find(basis_, at_most_one) != basis_.end() || (place[3] - place[4]).sign() != Sign::positive;
}

std::optional<int> HalfspaceSlack::sign_by_integers() const {
  if (!guessed_) return {};
  std::array<ExactRow, most> rows;
  for (std::size_t k = 0; k < most; ++k) rows[k] = exact_row(basis_[k], k);
  ExactRow place = minors(rows);
  for (std::size_t k = 1; k < numbers; k += 2) place[k] = BigDyadic() - place[k];
  const Sign all = place[4].sign();
  if (all == Sign::zero) return {};
  for (std::size_t k = 0; k < most; ++k) {
    const Sign weight = weight_sign(rows, k) * all;
    if (weight == Sign::negative || (weight == Sign::positive && basis_[k] == held)) return {};
  }
  if (all == Sign::negative) {
    for (BigDyadic& x : place) x = BigDyadic() - x;
  }
  if (!hold_all(place)) return {};
  return static_cast<int>(place[3].sign());
}

}  // namespace plumb::figure
