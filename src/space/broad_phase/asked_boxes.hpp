// Dynamic bounding-volume tree: which of boxes that come, go and move are in a box, and which does a ray hit first?
//
// A tree of fat boxes, made when it is asked and not before: boxes that have left their fat ones, or came since, are
// asked one by one.  When that has cost as much as a tree of all costs, one is made, so that both together cost about
// twice the cheaper at most.  While boxes move within their fat ones the tree is that of before.
// Laws: (1) the answers are those of asking each box as it is now, whatever has been noted of it in between.  (2) Any
// number of threads may ask, none while boxes are changed.
// Source: RTCD 6.3.1, 6.3.2, 6.6; the dynamic trees of physics engines enlarge boxes likewise.
// Cost: a note is a comparison with the fat box; a question the descent, and some ns for each box beside the tree.
#pragma once

#include <atomic>
#include <functional>
#include <shared_mutex>
#include <span>
#include <vector>

#include "plumb/query/ray/ray.hpp"
#include "plumb/space/bvh/box_tree.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb::space {

/// The boxes of all slots; those of slots that are not alive are none.
struct SlotBoxes {
  std::span<const Aabb3> boxes;
  std::span<const std::uint8_t> alive;
};

class AskedBoxes {
 public:
  struct SlotHit {
    std::uint32_t slot;
    Hit hit;
  };

  explicit AskedBoxes(double margin) : margin_(margin) {}

  /// The box of a slot is another, is new, or is gone.
  void note_moved(std::uint32_t slot, const Aabb3& box) {
    if (is_made_ && is_in_tree(slot) && !is_within(box, fat_[slot])) put_beside(slot);
  }
  void note_inserted(std::uint32_t slot) {
    if (is_made_) put_beside(slot);
  }
  void note_removed(std::uint32_t slot) {
    if (is_made_) put_beside(slot);
  }

  /// Slots, ascending.
  [[nodiscard]] std::vector<std::uint32_t> in_box(const SlotBoxes& all, const Aabb3& box, bool touching) const;
  /// It has the least parameter, exactly, and of equal ones the lowest slot.
  [[nodiscard]] std::optional<SlotHit> first_hit(const SlotBoxes& all, const AnyRay& ray) const;
  /// show(slot) of each box that may be hit, at a parameter no larger than what it returned last; as a rule the nearer
  /// first.
  void along(const SlotBoxes& all, const AnyRay& ray, const std::function<double(std::uint32_t)>& show) const;
  /// show(slot) of each box that may be within a distance of another box, which is what it returned last, and at first
  /// `within`; a distance that rounds to it counts.
  void near(const SlotBoxes& all, const Aabb3& box, double within,
            const std::function<double(std::uint32_t)>& show) const;

 private:
  static bool is_within(const Aabb3& box, const Aabb3& fat) {
    return (fat.min.x <= box.min.x) & (fat.min.y <= box.min.y) & (fat.min.z <= box.min.z) & (box.max.x <= fat.max.x) &
           (box.max.y <= fat.max.y) & (box.max.z <= fat.max.z);
  }
  [[nodiscard]] bool is_in_tree(std::uint32_t slot) const { return slot < is_beside_.size() && is_beside_[slot] == 0; }
  void put_beside(std::uint32_t slot);
  void make(const SlotBoxes& all) const;
  /// ask() while nobody makes a tree, which is made before that where it is due; each box beside it costs so many ns.
  template <class Ask>
  auto asked(const SlotBoxes& all, double of_each_beside, const Ask& ask) const;
  /// work(slot) of each box that the tree does not have.
  template <class Work>
  void for_each_beside(const SlotBoxes& all, const Work& work) const;

  double margin_;
  // A tree is made by whoever asks, alone.
  mutable std::shared_mutex made_by_one_;
  mutable std::atomic<double> paid_beside_ = 0;  // ns, since the tree was made
  mutable bool is_made_ = false;
  mutable BoxTree tree_;
  mutable std::vector<std::uint32_t> slot_of_;  // of each item
  // Of each slot:
  mutable std::vector<Aabb3> fat_;
  mutable std::vector<std::uint8_t> is_beside_;
  mutable std::vector<std::uint32_t> beside_;
};

}  // namespace plumb::space
