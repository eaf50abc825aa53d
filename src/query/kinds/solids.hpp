// Which closed meshes are hard?  Of integers, so that midpoints, centers and planes through corners are exact.
//
// Laws: (1) every solid closes: each edge is passed as often in either direction, by the places of its ends; its
// triangles turn counterclockwise seen from outside, but where it is told otherwise.  (2) Coordinates are below 2^18.
// (3) The same choices give the same solid; the choice 0 gives the simplest one.
// Source: RTCD 5.4.3 (figure 5.29: what a ray must not be confused by).
// Cost: some microseconds.
#pragma once

#include <string_view>
#include <vector>

#include "degenerate/body.hpp"

namespace plumb::degenerate {

struct Solid {
  std::vector<Int3> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  void multiply(Int by);
};

struct SolidSort {
  std::string_view name, about;
  Solid (*make)(Entropy& entropy);
};

/// Closed ones.
std::span<const SolidSort> solid_sorts();
/// Open ones: what only a ray is asked about.
std::span<const SolidSort> sheet_sorts();

/// Turned by an integer rotation, its axes in any order; mirrored solids are turned inside out, so that law 1 holds.
void turn(Solid& solid, Entropy& entropy);

}  // namespace plumb::degenerate
