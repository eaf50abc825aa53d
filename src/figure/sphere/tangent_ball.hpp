// Minimum enclosing ball (Apollonius): which ball touches some balls from within itself?  In numbers a + b sqrt(d),
// exactly.
//
// With y the center and rho the radius, both less those of the first ball, touching ball i is |y - e_i| = rho - s_i for
// the differences e_i of centers and s_i of radii.  Less the first one's square these are linear: y = u + v rho, and
// then |y| = rho is a quadratic equation.
// Source: Fischer and Gaertner 2003.
// Cost: some 20 us, all of it rational.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plumb/arith/big.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::figure::sphere {

using Rationals = std::vector<mpq_class>;

struct RationalBall {
  Rationals center;
  mpq_class radius;
};

class TangentBall {
 public:
  /// The smallest ball around these balls where it touches all of them and none could be left out: its center is within
  /// the simplex of theirs.  Nothing otherwise.
  static std::optional<TangentBall> around(std::span<const RationalBall> balls);

  /// Positive where the ball is inside without touching, zero where it touches from within, negative otherwise.
  [[nodiscard]] Sign side(const RationalBall& ball) const;

  /// A coordinate of the center, rounded to nearest once; never -0.
  [[nodiscard]] double center(std::size_t axis) const;

 private:
  /// The sign of a + b rho.
  [[nodiscard]] Sign sign(const mpq_class& a, const mpq_class& b) const;

  RationalBall first_;
  Rationals u_, v_;
  mpq_class p_, q_, d_;  // rho = p + q sqrt(d)
};

}  // namespace plumb::figure::sphere
