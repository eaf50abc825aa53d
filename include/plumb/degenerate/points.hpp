// Which points make geometric code fail?  Sets of points of every family, from one stream of choices.
//
// Laws: (1) every coordinate is finite; (2) the same choices give the same points, bit for bit, everywhere;
// (3) degenerate_short and degenerate_long are degenerate as asked in real arithmetic; (4) grid, uniform,
// float32 and near_half take no notice of the degeneracy asked for; a repeated set holds two equal points at least.
// Source: RTCD 11 and its figures of failing tests; exactness by integer constructions (degenerate/exact.hpp).
// Cost: below 1 us for the points of one predicate, without allocation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/family.hpp"

namespace plumb {

/// Fills points of 2 or 3 coordinates each, one after the other (x y x y ... or x y z ...).
void fill_points(Family family, Degeneracy degeneracy, int dimension, std::span<double> coordinates, Entropy& entropy);

std::vector<Point2> points2(Family family, Degeneracy degeneracy, std::size_t count, Entropy& entropy);
std::vector<Point3> points3(Family family, Degeneracy degeneracy, std::size_t count, Entropy& entropy);

/// The coordinates of `count` points in an array: the form that predicates and case lines take.
template <std::size_t count>
std::array<double, 2 * count> coordinates2(Family family, Degeneracy degeneracy, Entropy& entropy) {
  std::array<double, 2 * count> coordinates;
  fill_points(family, degeneracy, 2, coordinates, entropy);
  return coordinates;
}

template <std::size_t count>
std::array<double, 3 * count> coordinates3(Family family, Degeneracy degeneracy, Entropy& entropy) {
  std::array<double, 3 * count> coordinates;
  fill_points(family, degeneracy, 3, coordinates, entropy);
  return coordinates;
}

}  // namespace plumb
