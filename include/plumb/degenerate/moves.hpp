// What makes a point set harder?  Small moves on the coordinates of a set, to be combined at will.
//
// Laws: (1) every coordinate stays finite; (2) scaling moves no point by a single bit: it multiplies by powers of two
// and stays where no bit is lost; (3) permutations keep the multiset of coordinates.
// Source: exact zeros and equal points are RTCD 11.3 and 12.1.
// Cost: a few ns a coordinate.
#pragma once

#include <span>

#include "plumb/degenerate/entropy.hpp"

namespace plumb {

/// Moves one to `most_moves` coordinates by 1 to `most_ulps` steps up or down.
void move_by_ulps(std::span<double> coordinates, int most_moves, int most_ulps, Entropy& entropy);

/// Makes one point equal to another, then further points, single coordinates or zeros equal up to their sign.
void repeat_points(std::span<double> coordinates, int dimension, Entropy& entropy);

/// Multiplies the whole set by a power of two: to the bottom or the top of the format, or anywhere between.
void scale_exactly(std::span<double> coordinates, Entropy& entropy);

/// Scales each axis by a power of two of its own: lines stay lines and planes planes, circles do not stay circles.
void scale_axes_exactly(std::span<double> coordinates, int dimension, Entropy& entropy);

/// Permutes the axes, the same way for all points.
void permute_axes(std::span<double> coordinates, int dimension, Entropy& entropy);

/// Permutes the points.
void permute_points(std::span<double> coordinates, int dimension, Entropy& entropy);

}  // namespace plumb
