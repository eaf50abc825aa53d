// What does the search for pairs divide boxes into?  Cells, walls and sorted axes of a spatial index, for pictures.
//
// Laws: (1) what is shown is of the structure that overlapping_pairs makes of these boxes by the method: of two sets,
// grids and trees are of the first.  (2) Each cell and wall once, coarse levels first.  Where in space they stand is a
// guess, nearer than a pixel; those at the border may be infinite.
// Source: RTCD 6.2, 7.1 to 7.5.
// Cost: that of making the structure, and for grids a step for each cell that a box reaches into.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tool/pairs/command.hpp"

namespace plumb::tool {

/// A part of space; a wall is flat on one axis.  Of boxes in the plane all are endless along z.
struct ShownPart {
  static constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 3> min{-far, -far, -far}, max{far, far, far};
  unsigned level = 0;  // coarse ones first
  friend auto operator<=>(const ShownPart&, const ShownPart&) = default;
};

struct ShownStructure {
  std::string says = {};  // what the method makes of the boxes
  std::string line = {};  // what a line is of its cells or walls
  std::vector<ShownPart> cells = {}, walls = {};
  std::vector<std::size_t> sorted_axes = {};  // along which starts and ends of boxes are sorted
  std::optional<std::size_t> along = {};      // what is swept along this axis has columns
};

/// The one that was asked for, or what the automatic one is for these boxes.
BroadPhaseMethod method_taken(const PairsReport& report);

ShownStructure shown_structure(const PairsReport& report);

}  // namespace plumb::tool
