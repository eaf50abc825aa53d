// How does a case look?  The points of its figures, and the edges and faces that name them.
//
// Laws: (1) points of the plane have z = 0; (2) what is rounded, the corners of oriented boxes and the tips of
// directions, is finite; (3) every point of at most three coordinates is there once, as the figures have it.  A
// direction leads from the point before it in its argument; by itself it has no place, nor have lengths.
// Source: none.
// Cost: linear, and that of the exact answer where that is triangles.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

/// Of one argument; indices are those of its own points.
struct WireFigure {
  std::string name;
  std::vector<std::array<double, 3>> points = {};
  std::vector<std::size_t> dots = {};
  std::vector<std::array<std::size_t, 2>> edges = {};
  std::vector<std::vector<std::size_t>> faces = {};
  std::vector<std::array<std::size_t, 2>> arrows = {};  // from a point as far as its direction; the tip is no point
};

std::vector<WireFigure> wire_model(const Kind& kind, std::span<const double> numbers);

}  // namespace plumb::degenerate
