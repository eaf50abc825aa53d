// Broad phase, frame coherence: which of boxes that come, go and move overlap, and what has changed since the last frame?
//
//   MovingBoxes world;
//   const std::vector<BoxHandle> handles = world.insert(boxes);
//   world.move(handles, moved);
//   const BoxPairChanges& now = world.changes();   // now.added and now.lost, since the last call
//   world.overlapping_pairs()                                  // all, as of the last call of changes()
//   world.in_box(region);   world.first_hit(ray);  // of the boxes as they are now
//
// Boxes stand in columns, sorted along them, and stay there from frame to frame.  Where few have moved, each of these is
// held against those that are near it; where a model of measured costs says that it is cheaper, as where most move, all
// columns are swept, by the boxes as they were and as they are.  Columns are planned anew once much has moved far, or
// out of the space that they fill.  MovingWork says what was done, and what each way was to cost.
// Regions and rays are asked of a tree of fat boxes, which is made when enough has been asked to pay for it; boxes that
// have left theirs since are asked one by one, until that has cost as much as another tree.
//
// Laws: (1) pairs() are those of brute_force_pairs of the boxes there are.  (2) changes() tells exactly what those of
// this call and of the last differ by; pairs of a box that was removed are lost.  (3) Nothing depends on which way was
// taken, nor on threads or instruction set; lists ascend.  (4) A handle names one box for ever: its slot is used again
// with another generation.  (5) in_box tells the boxes that have a point in the closed one, first_hit the hit of the
// least parameter, exactly, and of equal ones that of the lowest handle: as asking each box says.  An inverted box holds
// nothing.  Any number of threads may ask.
// A handle that names no box, or one that was removed, throws InvalidShape; so do two boxes for one handle in a call of
// update; NonFinite and InvalidShape refuse bad boxes, NonFinite regions and rays; spans of different lengths throw
// UnequalLengths.  Then all is as it was before the call.
// Source: RTCD 2.4.1, 6.3.1, 6.3.2, 7.5; the dynamic trees of physics engines enlarge boxes likewise.
// Cost: a us or two for each box that moves; where most move about what overlapping_pairs takes, as pairs() does.  Memory
// for all boxes three times, and 8 bytes for each column that a box stands in; none for pairs.  Bounded by n^2
// comparisons for n boxes that come or move, n for in_box and first_hit.
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "plumb/query/ray/ray.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

struct MovingBoxesOptions {
  bool touching = true;  // false: only the pairs that overlap
  // Of the fat boxes that regions and rays are asked of, on each side, in mean lengths of a box; from 0 to 100, any
  // answers alike.
  double margin = 0.1;
};

/// What a call of changes() did.
struct MovingWork {
  bool made_anew = false;     // the columns
  bool from_scratch = false;  // all boxes were swept, as they must be where columns are made anew
  std::size_t moved = 0;      // boxes that were updated or inserted
  // Predicted, in ns on the machine of docs/measurements.md, for what has moved one by one, and for all boxes.
  double cost_to_keep = 0, cost_from_scratch = 0;
};

struct BoxPairChanges {
  std::vector<HandlePair> added, lost;
  MovingWork work;
};

struct HandleHit {
  BoxHandle box;
  Hit hit;
  friend bool operator==(const HandleHit&, const HandleHit&) = default;
};

/// What visit_along and visit_near ask of each box, for the length of the call: any function of a handle that returns a
/// double.
class AskEachBox {
 public:
  template <class F>
  requires(!std::same_as<F, AskEachBox> && std::is_invocable_r_v<double, const F&, const BoxHandle&>)
      AskEachBox(const F& most)  // NOLINT: a lambda is one
      : called_(&most), call_([](const void* called, const BoxHandle& box) -> double {
          return (*static_cast<const F*>(called))(box);
        }) {}
  double operator()(const BoxHandle& box) const { return call_(called_, box); }

 private:
  const void* called_;
  double (*call_)(const void* called, const BoxHandle& box);
};

class MovingBoxes {
 public:
  explicit MovingBoxes(const MovingBoxesOptions& options = {});
  MovingBoxes(MovingBoxes&&) noexcept;
  MovingBoxes& operator=(MovingBoxes&&) noexcept;
  ~MovingBoxes();

  BoxHandle insert(const Aabb3& box);
  std::vector<BoxHandle> insert(std::span<const Aabb3> boxes);
  void remove(const BoxHandle& handle);
  void move(const BoxHandle& handle, const Aabb3& box);
  void move(std::span<const BoxHandle> handles, std::span<const Aabb3> boxes);

  [[nodiscard]] bool contains(const BoxHandle& handle) const;
  [[nodiscard]] const Aabb3& box(const BoxHandle& handle) const;
  [[nodiscard]] std::size_t size() const;

  /// Valid until the next call.
  const BoxPairChanges& changes();

  [[nodiscard]] std::vector<HandlePair> overlapping_pairs(std::vector<HandlePair> rows = {}) const;

  /// Ascending.
  [[nodiscard]] std::vector<BoxHandle> in_box(const Aabb3& box, const InBoxOptions& options = {},
                                              std::vector<BoxHandle> rows = {}) const;
  /// Of a ray, a segment or a line.
  [[nodiscard]] std::optional<HandleHit> first_hit(const AnyRay& ray) const;

  // For questions about what the boxes hold.
  /// most(handle) of each box that a ray, a segment or a line may hit, at a parameter not above the least that it has
  /// returned so far; it returns infinity to see all.
  void visit_along(const AnyRay& ray, const AskEachBox& most) const;
  /// most(handle) of each box that may come as near to another as the least distance that it has returned so far, and as
  /// `within`; what rounds to that counts.
  void visit_near(const Aabb3& box, double within, const AskEachBox& most) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
