// Which inputs are hard for a formula of any shape?  Cases for arguments that differ in kind, and for zeros that no
// family of point sets is aimed at.
//
// Laws: the same choices give the same case everywhere; every coordinate is finite; fill_at_zero makes exact zeros
// of homogeneous formulas from small ones, by scaling, without knowing the formula.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "certify/catalog.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::battery {

/// Coordinates as the family has them, every argument a point of the set or its first coordinates.
inline void fill_arguments(const CatalogEntry& e, Family family, std::span<double> p, Entropy& entropy) {
  const Degeneracy degeneracy = degeneracies[entropy.below(degeneracies.size())];
  const int dimension = e.dimension == 2 || std::ranges::max(e.arguments) < 3 ? 2 : 3;
  if (e.dimension == dimension) return fill_points(family, degeneracy, dimension, p, entropy);
  const auto axes = static_cast<std::size_t>(dimension);
  std::size_t points = 0;
  for (const int count : e.arguments) points += (static_cast<std::size_t>(count) + axes - 1) / axes;
  std::vector<double> drawn(points * axes);
  fill_points(family, degeneracy, dimension, drawn, entropy);
  std::size_t point = 0;
  for (const int count : e.arguments) {
    const auto n = static_cast<std::size_t>(count);
    std::copy_n(drawn.begin() + static_cast<std::ptrdiff_t>(axes * point), count, p.begin());
    p = p.subspan(n);
    point += (n + axes - 1) / axes;
  }
}

/// Integers of magnitude up to `most`: many zeros, whatever the formula.
inline void fill_tiny(std::int64_t most, std::span<double> p, Entropy& entropy) {
  for (double& x : p) x = static_cast<double>(entropy.within(most));
}

/// A zero where one is found in a few draws; not one that equal inputs force, in half of the cases.  Of a homogeneous
/// formula it is scaled, exactly, to coordinates of up to 48 bits at any scale.
inline bool fill_at_zero(const CatalogEntry& e, std::span<double> p, Entropy& entropy) {
  const bool forced = entropy.coin();
  bool found = false;
  for (int draw = 0; draw < 40 && !found; ++draw) {
    fill_tiny(1 + static_cast<std::int64_t>(entropy.below(4)), p, entropy);
    const Decision d = e.decide(p);
    found = d.sign == Sign::zero && (forced || d.stage != Stage::structural_zero);
  }
  if (!e.homogeneous || !found) return found;
  const auto factor = static_cast<double>(1 + entropy.bits(static_cast<int>(entropy.below(46))));
  const auto exponent = static_cast<int>(entropy.coin() ? entropy.within(900) : entropy.within(30));
  for (double& x : p) x = std::ldexp(x * factor, exponent);
  return true;
}

/// As fill_at_zero, then up to three coordinates moved by some ulps.
inline void fill_near_zero(const CatalogEntry& e, std::span<double> p, Entropy& entropy) {
  fill_at_zero(e, p, entropy);
  move_by_ulps(p, 3, 4, entropy);
}

}  // namespace plumb::battery
