// What solves two, three or four linear equations, and is it the only solution?  Cramer's rule, with singularity
// exact; determinants and inverses.
//
// Laws: (1) solutions are one, none or many exactly as real arithmetic has it of the doubles given.  (2) A solution
// that is the only one is told by the doubles nearest to its components, each rounded once.  (3) Every entry of an
// inverse is the double nearest to the exact one; a singular matrix has none.  (4) A determinant is the double nearest
// to its value; its sign, where that is nearest to zero, is told by determinant_sign.  (5) Multiplying an equation by a
// power of two, or swapping two, changes nothing.
// A number beyond the doubles throws BeyondDoubles, NaN and infinity NonFinite; both name it. A matrix that moves
// points is a Pose (arith/pose.hpp), which is not rounded; the signs alone are in certify/determinant_sign.hpp.
// Source: RTCD 3.1.4, 3.1.5.
// Cost: N + 1 determinants by pairs of doubles, some 100 ns to 1 us; an inverse N times that.  Nothing is searched.
#pragma once

#include <optional>

#include "plumb/certify/determinant_sign.hpp"

namespace plumb {

enum class Solutions : unsigned char { none, one, many };

template <std::size_t N>
struct SystemSolution {
  Solutions solutions;
  std::size_t rank;         // of the matrix: N where the solution is the only one
  std::array<double, N> x;  // zeros unless it is
  friend bool operator==(const SystemSolution&, const SystemSolution&) = default;
};

/// Equation i says that the sum of rows[i][j] x[j] is right[i].
SystemSolution<2> solve(const Rows<2>& rows, const std::array<double, 2>& right);
SystemSolution<3> solve(const Rows<3>& rows, const std::array<double, 3>& right);
SystemSolution<4> solve(const Rows<4>& rows, const std::array<double, 4>& right);

double determinant(const Rows<2>& rows);
double determinant(const Rows<3>& rows);
double determinant(const Rows<4>& rows);

/// Nothing exactly where the determinant is zero.
std::optional<Rows<2>> inverse(const Rows<2>& rows);
std::optional<Rows<3>> inverse(const Rows<3>& rows);
std::optional<Rows<4>> inverse(const Rows<4>& rows);

}  // namespace plumb
