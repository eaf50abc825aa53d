// Of which boxes and points are the tasks on many things asked?  Generated ones, each set named by one number, so that
// a question of plain numbers can name it.
//
// A name says how they are spread, and by which throw of dice.  Beside it go three numbers, 0, 1 and 2 in some order:
// which coordinate stands on each axis; so a crowd's key is a mesh's (mesh_scenes.hpp).
// Laws: (1) the same name is the same crowd everywhere. (2) Coordinates of points are multiples of 2^-50. (3) Sides of
// boxes that are said to touch are the same double.
// Source: none.
// Cost: tens of microseconds a crowd.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/trial/mesh_questions.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb::lab::trial {

enum class Spread : std::uint8_t {
  uniform,     // all over a unit cube: boxes of like sizes that meet some eight others, points
  clustered,   // in eight clusters
  sizes,       // boxes of lengths from 1 to 1,000
  touching,    // boxes side by side in a lattice; points on one
  nudged,      // the same boxes, each side an ulp up, down, or where it was
  sphere,      // points nearly as far from the origin
  degenerate,  // of small integers: boxes that are rectangles, segments and points, and equal ones; equal points
  far          // as uniform, 2^20 along each axis
};

inline constexpr std::size_t crowd_size = 512;  // of boxes; of points twice as many

double crowd_name(Spread spread, std::uint64_t dice = 0);
std::vector<Aabb3> box_crowd(const MeshKey& key);
std::vector<Point3> point_crowd(const MeshKey& key);

inline constexpr std::size_t box_crowd_numbers = 4;

/// Finds all pairs of the boxes that it was made of: the lower number first.
using FindPairs = std::function<Pairs()>;
/// A method of all pairs of boxes: what `make` makes of the boxes is made before the clock runs.
Method of_box_crowds(std::string name, std::string about, std::function<FindPairs(const std::vector<Aabb3>&)> make);

/// The number of the nearest of the points that it was made of.
using FindNearest = std::function<std::uint32_t(const Point3&)>;
/// A method of points, asked of name, axes and place (mesh_questions.hpp): made of each crowd once, before the clock runs.
Method of_point_crowds(std::string name, std::string about,
                       std::function<FindNearest(const std::vector<Point3>&)> make);

/// Pairs, or cells written as pairs: how many are in `from` and not in `without`.
std::uint64_t count_lacking(Pairs from, Pairs without);

}  // namespace plumb::lab::trial
