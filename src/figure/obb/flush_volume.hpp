// Minimum bounding box: is every box smaller than this excluded, whose first face holds one edge and whose second
// another, while the first one's normal turns from here to there?
//
// With n1 = a0 + s (a1 - a0) and n2 = e x n1 for the second edge's direction e, the widths of fixed pairs of vertices
// d1, d2, d3 give a volume that is a quotient of quartics in s: (d1.n1) (d2.n2) (d3.(n1 x n2)) / (n1.n1 n2.n2).  It is
// at least `limit` where no Bernstein coefficient of numerator - limit * denominator is negative, nor any of a factor.
// The coefficients' distance from the curve falls with the square of the turn.
// Laws: (1) `excluded` is certain.  (2) `unsure` is said where no coefficient is certainly negative: numbers that are
// better known may exclude.
// Source: O'Rourke 1985 for the curve; Farin, "Curves and Surfaces for CAGD", 5.
// Cost: some 0.5 us over doubles that carry their errors, 5 us over pairs of them.
#pragma once

#include <array>
#include <utility>

#include "arith/vec.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::figure::frame {

template <class N>
struct FlushTurn {
  arith::Vec<N> a0, a1, edge, d1, d2, d3;
};
template <class N, class... Others>
FlushTurn(arith::Vec<N>, Others...) -> FlushTurn<N>;

enum class FlushVerdict : unsigned char { excluded, unsure, open };

namespace flush {

// Bernstein coefficients, each times its binomial, so that a product is that of polynomials.
template <class N, std::size_t I, std::size_t J>
std::array<N, I + J - 1> product(const std::array<N, I>& a, const std::array<N, J>& b) {
  const auto coefficient = [&](std::size_t k) {
    std::size_t i = k < J ? 0 : k - (J - 1);
    N sum = a[i] * b[k - i];
    while (++i < I && i <= k) sum = sum + a[i] * b[k - i];
    return sum;
  };
  return [&]<std::size_t... k>(std::index_sequence<k...>) { return std::array<N, sizeof...(k)>{coefficient(k)...}; }
  (std::make_index_sequence<I + J - 1>{});
}

/// Are all coefficients zero or beyond it?
template <class N, std::size_t I>
FlushVerdict none_negative(const std::array<N, I>& a) {
  FlushVerdict verdict = FlushVerdict::excluded;
  for (const N& x : a) {
    const Unsure<Sign> sign = x.sign();
    if (!sign.certain()) {
      verdict = FlushVerdict::unsure;
    } else if (sign.value() == Sign::negative) {
      return FlushVerdict::open;
    }
  }
  return verdict;
}

/// The same whichever way the vertices of a width were taken, which is turned so that it is positive.
template <class N, std::size_t I>
FlushVerdict of_one_sign(std::array<N, I>& a) {
  for (const std::size_t end : {std::size_t{0}, I - 1}) {
    const Unsure<Sign> sign = a[end].sign();
    if (!sign.certain() || sign.value() == Sign::zero) continue;
    if (sign.value() == Sign::negative) {
      for (N& x : a) x = N(0.0) - x;
    }
    break;
  }
  return none_negative(a);
}

}  // namespace flush

template <class N>
FlushVerdict no_smaller_flush(const FlushTurn<N>& t, double limit) {
  using arith::cross, arith::dot;
  std::array along1{dot(t.d1, t.a0), dot(t.d1, t.a1)};
  FlushVerdict verdict = flush::of_one_sign(along1);
  if (verdict != FlushVerdict::excluded) return verdict;
  const arith::Vec<N> b0 = cross(t.edge, t.a0), b1 = cross(t.edge, t.a1);
  std::array along2{dot(t.d2, b0), dot(t.d2, b1)};
  verdict = flush::of_one_sign(along2);
  if (verdict != FlushVerdict::excluded) return verdict;
  std::array along3{dot(t.d3, cross(t.a0, b0)), dot(t.d3, cross(t.a0, b1)) + dot(t.d3, cross(t.a1, b0)),
                    dot(t.d3, cross(t.a1, b1))};
  verdict = flush::of_one_sign(along3);
  if (verdict != FlushVerdict::excluded) return verdict;
  const auto square = [](const arith::Vec<N>& u, const arith::Vec<N>& v) {
    const N mixed = dot(u, v);
    return std::array{dot(u, u), mixed + mixed, dot(v, v)};
  };
  const auto volume = flush::product(flush::product(along1, along2), along3);
  const auto unit = flush::product(square(t.a0, t.a1), square(b0, b1));
  std::array<N, 5> left = volume;
  for (std::size_t k = 0; k < volume.size(); ++k) {
    // Where the unit may be zero, n1 along e, n2 is free and this says nothing.
    if (unit[k].sign() != Unsure{Sign::positive}) return FlushVerdict::open;
    left[k] = volume[k] - N(limit) * unit[k];
  }
  return flush::none_negative(left);
}

}  // namespace plumb::figure::frame
