// Broad phase: which of many boxes overlap?  All pairs of one set, or of two, by the fastest method for them.
//
//   for (const BoxPair& p : overlapping_pairs(boxes)) use(p.a, p.b);      // Aabb2, Aabb3, FloatBox2, FloatBox3
//   overlapping_pairs(a, b, {.touching = false});                          // of two sets, without mere touching
//   overlapping_pairs(boxes, BoxPairSink(to), {.method = BroadPhaseMethod::sort_and_sweep});
//
// Laws: (1) the pairs are those of brute_force_pairs, whatever the method: each once, a < b within one set.  (2) Their
// order depends on the boxes, the options' touching and the method, not on execution, threads or instruction set.
// (3) An empty set has no pairs.
// A number that is NaN or infinite throws NonFinite, a box that is empty InvalidShape, before any pair is told.  A
// structure that would take more than 2^30 bytes throws Error.
// Of two sets, grids, octrees and trees are made of a and asked with each of b; lists hold both.  float32 boxes are
// widened for them, which is exact.
// Source: RTCD 2.4.1, 7.5; the headers of the structures name theirs.
// Cost: for boxes of like sizes some 60 to 100 ns a box and some ns a pair (docs/broad_phase.md).  swept_columns makes
// at most 4 n + 4096 copies of boxes, 32 bytes each, and n^2 / 2 comparisons, sixteen by one operation: boxes that are
// long in all directions at once are the worst case.  The other methods are slower as a rule; choose_index.hpp says by
// how much.  Quadratic whatever the boxes are brute_force, implicit_grid and row_column_grid (a 64th of an operation
// for each box and row) and lists along two or three axes; sort_and_sweep and lists along one where many boxes overlap
// along it; every method where most boxes overlap.  Bounded by n^2 comparisons by every method.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "plumb/space/pairs/float_boxes.hpp"
#include "plumb/space/pairs/pair_sink.hpp"

namespace plumb {

enum class BroadPhaseMethod : std::uint8_t {
  automatic,          // the fastest, as measured
  swept_columns,      // boxes in the columns of a grid, swept along these
  sort_and_sweep,     // along the axis of greatest variance
  brute_force,        // each pair
  static_grid,        // cells as slices of one array
  linked_grid,        // an array of cells, a list in each
  hashed_grid,        // a table of cells, a list in each
  implicit_grid,      // bits of rows, columns and layers
  hierarchical_grid,  // levels of hashed cells, each twice as large
  row_column_grid,    // levels of rows, columns and layers
  octree,             // or quadtree: each box in the smallest cell that holds it
  octree_of_leaves,   // each box in all leaves that it meets
  loose_octree,       // cells that reach over their borders
  box_tree,           // a bounding volume hierarchy, descended with itself
  lists_along_one,    // sorted lists of starts and ends along one axis, each new box passing what is before it
  lists_along_two,
  lists_along_three,  // in the plane two
  kd_tree,            // space divided by planes; each box in all leaves that it meets
};
inline constexpr std::array broad_phase_methods = {
    BroadPhaseMethod::automatic,
    BroadPhaseMethod::swept_columns,
    BroadPhaseMethod::sort_and_sweep,
    BroadPhaseMethod::brute_force,
    BroadPhaseMethod::static_grid,
    BroadPhaseMethod::linked_grid,
    BroadPhaseMethod::hashed_grid,
    BroadPhaseMethod::implicit_grid,
    BroadPhaseMethod::hierarchical_grid,
    BroadPhaseMethod::row_column_grid,
    BroadPhaseMethod::octree,
    BroadPhaseMethod::octree_of_leaves,
    BroadPhaseMethod::loose_octree,
    BroadPhaseMethod::box_tree,
    BroadPhaseMethod::lists_along_one,
    BroadPhaseMethod::lists_along_two,
    BroadPhaseMethod::lists_along_three,
    BroadPhaseMethod::kd_tree,
};

std::string_view name_of(BroadPhaseMethod method);  // "swept_columns"

struct BroadPhaseOptions {
  bool touching = true;  // false: only the pairs that overlap
  Execution execution = Execution::parallel;
  BroadPhaseMethod method = BroadPhaseMethod::automatic;
};

std::vector<BoxPair> overlapping_pairs(std::span<const Aabb2> boxes, const BroadPhaseOptions& options = {},
                                       std::vector<BoxPair> rows = {});
std::vector<BoxPair> overlapping_pairs(std::span<const Aabb3> boxes, const BroadPhaseOptions& options = {},
                                       std::vector<BoxPair> rows = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox2> boxes, const BroadPhaseOptions& options = {},
                                       std::vector<BoxPair> rows = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox3> boxes, const BroadPhaseOptions& options = {},
                                       std::vector<BoxPair> rows = {});

std::vector<BoxPair> overlapping_pairs(std::span<const Aabb2> a, std::span<const Aabb2> b,
                                       const BroadPhaseOptions& options = {}, std::vector<BoxPair> rows = {});
std::vector<BoxPair> overlapping_pairs(std::span<const Aabb3> a, std::span<const Aabb3> b,
                                       const BroadPhaseOptions& options = {}, std::vector<BoxPair> rows = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox2> a, std::span<const FloatBox2> b,
                                       const BroadPhaseOptions& options = {}, std::vector<BoxPair> rows = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox3> a, std::span<const FloatBox3> b,
                                       const BroadPhaseOptions& options = {}, std::vector<BoxPair> rows = {});

/// Told instead of returned.
void overlapping_pairs(std::span<const Aabb2> boxes, const BoxPairSink& to, const BroadPhaseOptions& options = {});
void overlapping_pairs(std::span<const Aabb3> boxes, const BoxPairSink& to, const BroadPhaseOptions& options = {});
void overlapping_pairs(std::span<const FloatBox2> boxes, const BoxPairSink& to, const BroadPhaseOptions& options = {});
void overlapping_pairs(std::span<const FloatBox3> boxes, const BoxPairSink& to, const BroadPhaseOptions& options = {});
void overlapping_pairs(std::span<const Aabb2> a, std::span<const Aabb2> b, const BoxPairSink& to,
                       const BroadPhaseOptions& options = {});
void overlapping_pairs(std::span<const Aabb3> a, std::span<const Aabb3> b, const BoxPairSink& to,
                       const BroadPhaseOptions& options = {});
void overlapping_pairs(std::span<const FloatBox2> a, std::span<const FloatBox2> b, const BoxPairSink& to,
                       const BroadPhaseOptions& options = {});
void overlapping_pairs(std::span<const FloatBox3> a, std::span<const FloatBox3> b, const BoxPairSink& to,
                       const BroadPhaseOptions& options = {});

}  // namespace plumb
