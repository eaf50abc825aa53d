// Which vertices are given to be welded?  Clouds of 24, special in some way, and a tolerance of 2^-10.
//
// Law: groups that short steps connect are as far from one another as clouds in a unit cube are.
// Source: RTCD 12.1.1.
// Cost: some microseconds a cloud.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::lab::trial {

inline constexpr double weld_tolerance = 0x1p-10;
inline constexpr std::size_t weld_vertices = 24;

using WeldCloud = std::vector<Point3>;

struct WeldFamily {
  std::string name, about;
  void (*fill)(WeldCloud& cloud, Entropy& entropy);
};

/// The first is the harmless one.
std::span<const WeldFamily> weld_families();

}  // namespace plumb::lab::trial
