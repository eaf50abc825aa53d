// All pairs of boxes that overlap, as others find them: each from boxes of doubles, on one thread, counting the pairs, or
// telling them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/figure/basic/box.hpp"

namespace plumb::bench {

/// Embree's rtcCollide of a scene of boxes with itself; boxes become floats, rounded outward.
std::size_t embree_box_pairs(std::span<const Aabb3> boxes);
/// CGAL's box_self_intersection_d with its default cutoff.
std::size_t cgal_box_pairs(std::span<const Aabb3> boxes);
/// Bullet's btDbvtBroadphase of a dynamic tree, in doubles: made, and its overlapping pairs counted.
std::size_t bullet_box_pairs(std::span<const Aabb3> boxes);
/// FCL's dynamic tree of boxes (DynamicAABBTreeCollisionManager).
std::size_t fcl_box_pairs(std::span<const Aabb3> boxes);
/// Boost.Geometry's R-tree, packed, asked for each box.
std::size_t boost_box_pairs(std::span<const Aabb3> boxes);

/// The same pairs, told: the lower number first, in no order.
using ToldPairs = std::vector<std::array<std::uint32_t, 2>>;
ToldPairs embree_told_pairs(std::span<const Aabb3> boxes);
ToldPairs cgal_told_pairs(std::span<const Aabb3> boxes);
ToldPairs bullet_told_pairs(std::span<const Aabb3> boxes);
ToldPairs fcl_told_pairs(std::span<const Aabb3> boxes);
ToldPairs boost_told_pairs(std::span<const Aabb3> boxes);

/// To count them, or to keep them.
struct PairCount {
  std::size_t count = 0;
  void operator()(std::size_t, std::size_t) { ++count; }
};
struct PairKeeper {
  ToldPairs pairs;
  void operator()(std::size_t a, std::size_t b) {
    const auto i = static_cast<std::uint32_t>(a), k = static_cast<std::uint32_t>(b);
    pairs.push_back({i < k ? i : k, i < k ? k : i});
  }
};

/// Bullet's btAxisSweep3, whose order is kept from frame to frame.
class BulletSweep {
 public:
  explicit BulletSweep(std::span<const Aabb3> boxes);
  ~BulletSweep();
  BulletSweep(const BulletSweep&) = delete;
  BulletSweep& operator=(const BulletSweep&) = delete;
  std::size_t move(std::span<const Aabb3> boxes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Bullet's btDbvtBroadphase, kept from frame to frame.
class BulletTree {
 public:
  explicit BulletTree(std::span<const Aabb3> boxes);
  ~BulletTree();
  BulletTree(const BulletTree&) = delete;
  BulletTree& operator=(const BulletTree&) = delete;
  std::size_t move(std::span<const Aabb3> boxes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb::bench
