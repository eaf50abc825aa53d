// Minimum bounding box: is every box smaller than this excluded, whose first face holds one edge and whose second
// another, while the first one's normal turns from here to there?
//
// With n1 = a0 + s (a1 - a0) and n2 = e x n1 for the second edge's direction e, the widths of fixed pairs of vertices
// d1, d2, d3 give a volume that is a quotient of quartics in s: (d1.n1) (d2.n2) (d3.(n1 x n2)) / (n1.n1 n2.n2).  It is
// at least `limit` where no Bernstein coefficient of numerator - limit * denominator is negative, nor any of a factor.
// The coefficients' distance from the curve falls with the square of the turn.
// Laws: true is certain.
// Source: O'Rourke 1985 for the curve; Farin, "Curves and Surfaces for CAGD", 5.
// Cost: some 0.5 us.
#pragma once

#include <array>

#include "arith/running_error.hpp"
#include "arith/vec.hpp"

namespace plumb::figure::frame {

using Turning = arith::Vec<Running>;

struct FlushTurn {
  Turning a0, a1, edge, d1, d2, d3;
};

namespace flush {

// Bernstein coefficients, each times its binomial, so that a product is that of polynomials.
template <std::size_t M, std::size_t N>
std::array<Running, M + N - 1> product(const std::array<Running, M>& a, const std::array<Running, N>& b) {
  std::array<Running, M + N - 1> c{};
  for (std::size_t i = 0; i < M; ++i) {
    for (std::size_t j = 0; j < N; ++j) c[i + j] = c[i + j] + a[i] * b[j];
  }
  return c;
}

// Whichever way it is taken, none is negative.
template <std::size_t N>
bool of_one_sign(std::array<Running, N>& a) {
  if (a[0].value < 0 || (a[0].value == 0 && a[N - 1].value < 0)) {
    for (Running& x : a) x.value = -x.value;
  }
  for (const Running& x : a) {
    if (!(x.lower() >= 0)) return false;
  }
  return true;
}

}  // namespace flush

inline bool no_smaller_flush(const FlushTurn& t, double limit) {
  using arith::cross, arith::dot;
  std::array along1{dot(t.d1, t.a0), dot(t.d1, t.a1)};
  if (!flush::of_one_sign(along1)) return false;
  const Turning b0 = cross(t.edge, t.a0), b1 = cross(t.edge, t.a1);
  std::array along2{dot(t.d2, b0), dot(t.d2, b1)};
  if (!flush::of_one_sign(along2)) return false;
  std::array along3{dot(t.d3, cross(t.a0, b0)), dot(t.d3, cross(t.a0, b1)) + dot(t.d3, cross(t.a1, b0)),
                    dot(t.d3, cross(t.a1, b1))};
  if (!flush::of_one_sign(along3)) return false;
  const auto square = [](const Turning& u, const Turning& v) {
    const Running mixed = dot(u, v);
    return std::array{dot(u, u), mixed + mixed, dot(v, v)};
  };
  const auto volume = flush::product(flush::product(along1, along2), along3);
  const auto unit = flush::product(square(t.a0, t.a1), square(b0, b1));
  for (std::size_t k = 0; k < volume.size(); ++k) {
    // Where the unit may be zero, n1 along e, n2 is free and this says nothing.
    if (!(unit[k].lower() > 0) || !((volume[k] - Running{limit} * unit[k]).lower() >= 0)) return false;
  }
  return true;
}

}  // namespace plumb::figure::frame
