// Which tree for these items?  The builders, and what they can be told.
//
//   BoxTree tree = build_box_tree(boxes);                                       // binned surface-area heuristic
//   BoxTree quick = build_box_tree(boxes, {.method = BvhMethod::linear});       // by Morton codes: fastest to build
//
// Laws: (1) those of box_tree.hpp.  (2) The tree depends on the boxes and on shape-giving options alone: not on
//       execution, the number of threads, or the machine.  (3) Any number of equal items builds, and as fast.
// A coordinate that is NaN or infinite throws NonFinite ("build_box_tree: boxes[17].min.y is nan, ..."), an empty box,
// more than 2^31 items or options out of range InvalidShape.
// Source: RTCD 6.2.1, 6.2.2, 6.2.3; Goldsmith and Salmon 1987 and MacDonald and Booth 1990 for the heuristic, Wald 2007
// for bins, Lauterbach et al. 2009 for Morton codes, Meister and Bittner 2018 for agglomeration, Stich,
// Friedrich and Dietrich 2009 for spatial splits, Karras and Aila 2013 for their budget.
// Cost: n log n; n for Morton codes and agglomeration, n^2 for nearest pairs.  Bounded by n^2 operations where each
// level parts off one item alone; 60 levels and more are parted in the middle.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "plumb/certify/batch.hpp"
#include "plumb/space/bvh/box_tree.hpp"

namespace plumb {

enum class BvhMethod : unsigned char {
  binned,          // surface-area heuristic over bins: the default
  sweep,           // the same over all cuts: the best of those from the top down
  object_median,   // as many items on each side of a cut across the longest axis
  object_mean,     // cut at the mean of the middles
  spatial_median,  // cut half way
  linear,          // by Morton codes of the middles: fastest to build
  agglomerative,   // from the items up: pairs that are each other's nearest, all at once
  nearest_pairs,   // from the items up: always the pair of the least box; quadratic, for some ten thousand items
  insertion,       // one item after the other, each where it costs least; see insertion_tree.hpp
};
inline constexpr std::array bvh_methods = {
    BvhMethod::binned,        BvhMethod::sweep,          BvhMethod::object_median,
    BvhMethod::object_mean,   BvhMethod::spatial_median, BvhMethod::linear,
    BvhMethod::agglomerative, BvhMethod::nearest_pairs,  BvhMethod::insertion};

std::string_view name_of(BvhMethod method);  // "binned"

struct BvhOptions {
  BvhMethod method = BvhMethod::binned;
  /// The most items in a leaf, 1 to 255.  Fewer are put there where it pays; by the methods that look at no areas (the
  /// medians, the mean, Morton codes) at most 4.
  std::uint32_t most_in_leaf = 8;
  /// What it costs to test an item, where a node costs 1; positive.  0.5 makes leaves of three triangles as a rule.
  float item_cost = 0.5F;
  /// Spatial splits, for long triangles: how many parts more than triangles a mesh's tree may have, as a share of the
  /// triangles, 0 to 16.  A triangle then lies in several leaves, each with a box of what is there of it; every answer
  /// is the same.  0.2 is much where few triangles are long.  Boxes alone are not split.
  float split_share = 0;
  Execution execution = Execution::parallel;
};

BoxTree build_box_tree(std::span<const Aabb3> boxes, const BvhOptions& options = {});

}  // namespace plumb
