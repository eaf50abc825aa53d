// Broad phase: which of many boxes overlap?  All pairs of one set, or of two, by the fastest method for them.
//
//   for (const BoxPair& p : overlapping_pairs(boxes)) use(p.a, p.b);      // Aabb2, Aabb3, FloatBox2, FloatBox3
//   overlapping_pairs(a, b, {.touching = false});                          // of two sets, without mere touching
//   overlapping_pairs(boxes, BoxPairSink(to), {.method = BroadPhaseMethod::sort_and_sweep});
//
// Laws: (1) the pairs are those of brute_force_pairs, whatever the method: each once, a < b within one set.  (2) Their
// order depends on the boxes, the options' touching and the method, not on execution, threads or instruction set.
// (3) An empty set has no pairs.
// A number that is NaN or infinite throws NonFinite, a box that is empty InvalidShape, before any pair is told.
// Source: RTCD 2.4.1, 7.5.
// Cost: for boxes of like sizes some 60 to 100 ns a box and some ns a pair (docs/broad_phase.md); memory for some copies
// of the boxes.  Long boxes in all directions at once are the worst case: then every box is compared with a good part of all.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/pairs/float_boxes.hpp"
#include "plumb/space/pairs/pair_sink.hpp"

namespace plumb {

enum class BroadPhaseMethod : std::uint8_t {
  automatic,       // the fastest, as measured
  swept_columns,   // boxes in the columns of a grid, swept along these
  sort_and_sweep,  // along one axis
  brute_force,     // each pair
};

struct BroadPhaseOptions {
  bool touching = true;  // false: only the pairs that overlap
  Execution execution = Execution::parallel;
  BroadPhaseMethod method = BroadPhaseMethod::automatic;
};

std::vector<BoxPair> overlapping_pairs(std::span<const Aabb2> boxes, const BroadPhaseOptions& options = {});
std::vector<BoxPair> overlapping_pairs(std::span<const Aabb3> boxes, const BroadPhaseOptions& options = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox2> boxes, const BroadPhaseOptions& options = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox3> boxes, const BroadPhaseOptions& options = {});

std::vector<BoxPair> overlapping_pairs(std::span<const Aabb2> a, std::span<const Aabb2> b,
                                       const BroadPhaseOptions& options = {});
std::vector<BoxPair> overlapping_pairs(std::span<const Aabb3> a, std::span<const Aabb3> b,
                                       const BroadPhaseOptions& options = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox2> a, std::span<const FloatBox2> b,
                                       const BroadPhaseOptions& options = {});
std::vector<BoxPair> overlapping_pairs(std::span<const FloatBox3> a, std::span<const FloatBox3> b,
                                       const BroadPhaseOptions& options = {});

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
