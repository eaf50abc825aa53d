// Fourier-Motzkin elimination: have linear constraints a common solution, and what is their shadow on fewer variables?
//
//   const LinearProof p = solve_by_elimination(system);           // optimal: p.point is a solution; else infeasible
//   const LinearSystem shadow = project(system, 2);               // of the first two variables
//
// A variable goes by adding each row that bounds it from above to each that bounds it from below.
// Laws: (1) exact.  (2) A point of the first variables meets the rows of the projection exactly where others can be
// found with which it meets those of the system.  That of a system without solutions has none either, and is the one
// row 0 <= a negative number where no variable is left.  (3) Of rows whose normals are multiples of one another the
// tightest is kept; `without_redundant` leaves out, after each variable, every row that the others imply.  (4) verify
// with the objective zero is true of the proof.  (5) Of a solution each number is the least that those before it allow,
// in the order of the elimination turned round, else the greatest, else zero.
// Rows of unequal lengths throw InvalidShape; more rows than `most_rows` at once throw Error, which names the variable.
// Source: Fourier 1827; Motzkin 1936; Chvatal, Linear Programming, 1983, chapter 16; RTCD 9.4.
// Cost: the rows may be squared with each variable: it is for few, and for the projections that the simplex method
// lacks.  Bounded by n^2 rows after one variable, n^4 rows after two, and by most_rows after any; a product of each two
// rows that bound it.
#pragma once

#include "plumb/query/lp/linear_proof.hpp"

namespace plumb {

struct EliminationOptions {
  std::size_t most_rows = 10'000;
  bool without_redundant = false;  // a linear program for each row, after each variable
};

/// Of as many variables as the rows have.
LinearProof solve_by_elimination(const LinearSystem& system, const EliminationOptions& = {});

/// On the first `dimension` variables.
LinearSystem project(const LinearSystem& system, std::size_t dimension, const EliminationOptions& = {});

}  // namespace plumb
