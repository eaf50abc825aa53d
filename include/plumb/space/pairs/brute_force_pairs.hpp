// Brute force, all-pairs test: which boxes overlap, by asking each pair?  What the methods of the broad phase must agree
// with.
//
// Laws: (1) those of box_pair.hpp.  (2) The pairs ascend by a, then b.  (3) Naming the sets the other way round turns
// the pairs round.
// A number that is NaN or infinite throws NonFinite, a box that is empty InvalidShape; both name the box.
// Source: RTCD 2.4.1.
// Cost: n^2 / 2 tests of two boxes, a * b for two sets; always on the caller's thread.  Bounded by n^2 comparisons.
#pragma once

#include <span>
#include <vector>

#include "plumb/space/pairs/box_pair.hpp"
#include "plumb/space/pairs/float_boxes.hpp"

namespace plumb {

std::vector<BoxPair> brute_force_pairs(std::span<const Aabb2> boxes, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});
std::vector<BoxPair> brute_force_pairs(std::span<const Aabb3> boxes, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});
std::vector<BoxPair> brute_force_pairs(std::span<const FloatBox2> boxes, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});
std::vector<BoxPair> brute_force_pairs(std::span<const FloatBox3> boxes, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});

/// Of two sets.
std::vector<BoxPair> brute_force_pairs(std::span<const Aabb2> a, std::span<const Aabb2> b,
                                       const BoxPairOptions& options = {}, std::vector<BoxPair> rows = {});
std::vector<BoxPair> brute_force_pairs(std::span<const Aabb3> a, std::span<const Aabb3> b,
                                       const BoxPairOptions& options = {}, std::vector<BoxPair> rows = {});
std::vector<BoxPair> brute_force_pairs(std::span<const FloatBox2> a, std::span<const FloatBox2> b,
                                       const BoxPairOptions& options = {}, std::vector<BoxPair> rows = {});
std::vector<BoxPair> brute_force_pairs(std::span<const FloatBox3> a, std::span<const FloatBox3> b,
                                       const BoxPairOptions& options = {}, std::vector<BoxPair> rows = {});

}  // namespace plumb
