// Time-critical collision: do two surfaces meet, and how far are they apart, as far as their sphere trees can say?
//
//   spheres_meet(a, 2, b, 3)                       // a sphere of level 2 of a and one of level 3 of b?
//   meeting_spheres(a, 2, b, 3)                    // which: numbers in these levels
//   check_collision(a, b, {.most_tests = 500})     // level by level, until the surfaces are apart or time is up
//   distance_bounds(a, b, {.relative = 0.1})       // between these doubles, certainly
//
// Laws: (1) spheres_meet and meeting_spheres are those of every sphere of one level against each of the other, by
// intersects.  (2) Where they do not meet, the surfaces are apart; finer levels meet only where coarser ones do.
// (3) check_collision says apart only of such levels; the pairs that it returns are those of the last level that it has
// finished.  (4) The distance of the surfaces, in real arithmetic, is at least `least` and at most `most`; with more
// tests the interval is no wider.  (5) An empty tree meets nothing, and its distance is infinite.
// A level that a tree does not have stands for its last.  Options out of range throw InvalidShape.
// Source: RTCD 6.4.3, 6.4.4; Hubbard 1995, Quinlan 1994.
// Cost: some ns for each pair of spheres that is compared, 50 for each whose distance is bounded.  Bounded by n^2 log
// n operations for n spheres of both, the order by distance, and by most_tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/space/bvh/sphere_tree.hpp"

namespace plumb {

/// Numbers in the two levels.
struct SpherePair {
  std::uint32_t a, b;
  friend bool operator==(const SpherePair&, const SpherePair&) = default;
};

bool spheres_meet(const SphereTree& a, std::uint32_t level_a, const SphereTree& b, std::uint32_t level_b);

/// Ascending by a, then b.
std::vector<SpherePair> meeting_spheres(const SphereTree& a, std::uint32_t level_a, const SphereTree& b,
                                        std::uint32_t level_b, std::vector<SpherePair> rows = {});

struct CollisionCheckOptions {
  std::size_t most_tests = ~std::size_t{0};  // of two spheres; a level that needs more is not begun
};

struct CollisionCheck {
  bool apart = false;             // certainly
  std::uint32_t level = 0;        // the last that is finished: the same of both trees, or the last that one has
  bool is_last = false;           // no finer one is left
  std::vector<SpherePair> pairs;  // of this level, that meet; as of meeting_spheres
  std::size_t tests = 0;
};

CollisionCheck check_collision(const SphereTree& a, const SphereTree& b, const CollisionCheckOptions& options = {});

struct DistanceBoundsOptions {
  double absolute = 0, relative = 0;         // an interval no wider than one of these ends the search
  std::size_t most_tests = ~std::size_t{0};  // of two spheres
};

struct DistanceBounds {
  double least, most;
  std::size_t tests = 0;
};

DistanceBounds distance_bounds(const SphereTree& a, const SphereTree& b, const DistanceBoundsOptions& options = {});

}  // namespace plumb
