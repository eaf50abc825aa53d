// Where does a ray first meet a triangle, do two triangles meet, how far are they apart?  In GMP's integers, from
// definitions, degenerate triangles included.
//
// Laws: exact.  A triangle of three points on a line is the segment that holds them, or the point.  Not a line is
// shared with the library's answers.
// Source: none.
// Cost: microseconds a pair, some hundred for distances of triangles.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "lab/trial/rational_judge.hpp"
#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

using IntegerVec = Vec<mpz_class>;
using IntegerTriangle = std::array<IntegerVec, 3>;

/// above / below, with below > 0.
struct Quotient {
  mpz_class above, below;
  friend bool operator<(const Quotient& a, const Quotient& b) { return a.above * b.below < b.above * a.below; }
  friend bool operator==(const Quotient& a, const Quotient& b) { return a.above * b.below == b.above * a.below; }
};

/// The least parameter, at least 0, at which the ray from `o` along `d` (not zero) meets it.
std::optional<Quotient> first_meeting(const IntegerVec& o, const IntegerVec& d, const IntegerTriangle& triangle);

bool triangles_meet(const IntegerTriangle& a, const IntegerTriangle& b);

mpq_class square_distance(const IntegerVec& p, const IntegerTriangle& triangle);
mpq_class square_distance(const IntegerTriangle& a, const IntegerTriangle& b);

}  // namespace plumb::lab::trial
