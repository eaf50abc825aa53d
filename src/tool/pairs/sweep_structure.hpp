// What does the search for pairs divide boxes into?  The columns and the axis of a sweep, for pictures.
//
// Law: the columns are those in which overlapping_pairs sweeps these boxes.  Where in space their walls stand is a
// guess, nearer than a pixel.
// Source: RTCD 7.1, 7.5.
// Cost: some passes over the boxes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tool/pairs/command.hpp"

namespace plumb::tool {

struct SweepStructure {
  std::size_t axis = 0;                      // along which boxes are swept
  std::array<std::vector<double>, 3> walls;  // of the columns, across each other axis
  std::size_t columns = 1, copies = 0;       // and how often boxes stand in them
};

/// The one that was asked for, or what the automatic one is for these boxes.
BroadPhaseMethod method_taken(const PairsReport& report);

/// Nothing where the method that was taken sweeps no boxes.
std::optional<SweepStructure> sweep_structure(const PairsReport& report);

}  // namespace plumb::tool
