// Which doubles are exactly collinear, coplanar, cocircular or cospherical?  Sets made by integer constructions,
// without a single rounding.
//
// Laws: (1) the points are degenerate as asked in real arithmetic, not nearly so; (2) every coordinate is finite;
// (3) with `bits`, coordinates are integers of magnitude below 2^bits.
//   line    a + k d              plane   a + i u + j v
//   circle  products of Gaussian integers, each factor conjugated or not: all of one norm
//   sphere  q v q' for an integer vector v and an integer quaternion q with its parts permuted: all of one norm
// Source: RTCD 11 asks for such inputs; norms of Gaussian integers and quaternions (Euler's four-square identity) are
// classical.
// Cost: 5 to 15 ns a point, no allocation.
#pragma once

#include <span>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/family.hpp"

namespace plumb {

inline constexpr int least_exact_bits = 6;

/// Fills points of 2 or 3 coordinates each (x y x y ... or x y z ...) with integers of magnitude below 2^bits, for bits
/// in [least_exact_bits, 53].  At most 128 points of a circle differ (32 of a set of 16 or fewer).
void fill_exact(Degeneracy degeneracy, int dimension, int bits, std::span<double> coordinates, Entropy& entropy);

/// The same with mantissas as long as doubles have, of magnitude about 1, in one of three layouts: all coordinates of
/// exactly 53 bits in one binade; around the origin, so that differences round; through or about the origin, where the
/// points of a line or plane also differ in scale by up to 2^60.
void fill_exact_long(Degeneracy degeneracy, int dimension, std::span<double> coordinates, Entropy& entropy);

/// Whether lines and planes are meant, which stay exact when an axis is scaled, not circles and spheres.
constexpr bool is_flat(Degeneracy degeneracy) {
  return degeneracy == Degeneracy::collinear || degeneracy == Degeneracy::coplanar;
}

}  // namespace plumb
