// Which polygons are given to be cut into triangles?  Paths of 16 corners that turn left, and special in some way.
//
// Law: a path touches itself at most; two edges cross between their ends nowhere.
// Source: RTCD 12.5.1.
// Cost: some 100 us a polygon, for the crossings that are looked for in rationals.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "plumb/degenerate/entropy.hpp"

namespace plumb::lab::trial {

inline constexpr std::size_t cut_corners = 16;
/// The corners in turn.
using CutPolygon = std::array<double, 2 * cut_corners>;

struct PolygonFamily {
  std::string name, about;
  void (*draw)(CutPolygon& polygon, Entropy& entropy);

  void fill(CutPolygon& polygon, Entropy& entropy) const;
};

/// The first is the harmless one.
std::span<const PolygonFamily> polygon_families();

}  // namespace plumb::lab::trial
