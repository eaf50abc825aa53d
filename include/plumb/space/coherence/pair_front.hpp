// Front tracking: where did the descent of two trees end in the last frame?  It ends near there in this one.
//
//   PairFront front;                                          // one for each two meshes that go on being asked
//   for (;;) for (const TrianglePair& p : front.intersecting_pairs({a, pose_a}, {b, pose_b})) ...
//
// The pairs of nodes at which a descent ends, because their boxes are apart or both are leaves, are its front.  It is
// looked through instead of the descent: pairs whose boxes have met since are replaced by what is below them, and two
// whose parents' boxes have parted by the pair of their parents.
// Laws: (1) the answers are those of intersecting_pairs, of one mesh too, exactly and in their order, of any
// meshes in any frame: refitted, posed, built anew or others.  Where a tree no longer divides as it did above the
// front, the descent begins at the roots again.  (2) So it does where the front has become the longer way: where it is
// three times what a descent left it at, or the parents of half of it are apart.  (3) The front depends on what it
// was asked, not on execution or threads.  (4) Where progress has cancelled a query, the next is answered
// all the same.
// Each query changes it: two threads need two.
// Errors are those of the functions without a front.
// Source: RTCD 6.7.2; Li and Chen 1998; for fronts in parts Tang, Manocha and Tong 2010.
// Cost: a comparison of boxes for each pair of the front, some two thirds of what a descent compares, and one for each
// two in four frames to see whether their parents' are apart.  Of posed meshes boxes are posed for the nodes of the
// front alone, not for all.  Memory: memory() says it; 8 bytes a pair of the front, as many again while the next one is
// made, and 4 for each node of both trees, of posed meshes 53.  Bounded by n^2 tests of pairs, on integers as long as
// the exponents' span.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/coherence/visit_stamps.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb {

/// What a query took.
struct FrontWork {
  std::size_t comparisons = 0;  // of two nodes' boxes
  bool from_roots = false;      // was there no front to begin at?
  friend bool operator==(const FrontWork&, const FrontWork&) = default;
};

namespace space {

/// The nodes of a tree that are divided above a front, and how: where the second child of each node is, 0 where it is
/// not divided.
struct DividedNodes {
  std::vector<std::uint32_t> nodes, links;
};
/// Boxes of a moved mesh's nodes, those that are needed.
struct NeededBoxes {
  std::vector<Aabb3> boxes;
  VisitStamps posed;
};

struct Front {
  std::vector<NodePair> pairs;  // each pair of leaves is below exactly one; in the order of a descent
  DividedNodes divided_a, divided_b;
  NeededBoxes boxes_a, boxes_b;
  bool is_own = false, is_stale = true;
  std::uint32_t frame = 0;
  std::size_t size_at_first = 0;
};

}  // namespace space

class PairFront {
 public:
  std::vector<TrianglePair> intersecting_pairs(const BvhView& a, const BvhView& b, const PairOptions& options = {},
                                               std::vector<TrianglePair> rows = {});
  /// These are the pairs that one mesh has with itself.
  std::vector<TrianglePair> intersecting_pairs(const BvhView& mesh, const PairOptions& options = {},
                                               std::vector<TrianglePair> rows = {});

  /// Pairs of nodes in it.
  [[nodiscard]] std::size_t size() const { return front_.pairs.size(); }
  /// Bytes that it keeps.
  [[nodiscard]] std::size_t memory() const;
  /// Of the last query.
  [[nodiscard]] const FrontWork& work() const { return work_; }
  /// The next query begins at the roots.  Gives the memory back.
  void forget() { *this = PairFront(); }

 private:
  space::Front front_;
  FrontWork work_;
};

}  // namespace plumb
