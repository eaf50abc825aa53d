// Sort and sweep (sweep and prune) by linked lists: the starts and ends of all boxes stand in a list along each of one,
// two or three axes.  Where a start passes an end, the two boxes begin or cease to overlap along the axis; pairs are
// looked at there and nowhere else, and kept.
//
// Laws: (1) the pairs that are kept are those that have a point in common along each of the axes, touching included.
// (2) Of what is equal along an axis starts come before ends.
// Source: RTCD 7.5.1; Baraff 1992.
// Cost: a step for each start or end that a box passes along each of the axes; n steps for a box that is new, and a
// look at each pair for one that goes.
#pragma once

#include <algorithm>
#include <unordered_set>

#include "space/textbook/scheme.hpp"

namespace plumb::space {

template <class Box>
class SortedEnds {
 public:
  static constexpr std::size_t n = axes_of<Box>;
  using Place = Box;
  using Stored = StoredBoxes<Box, Place>;

  SortedEnds(const AskedFunction& asked, const BoxStoreOptions<Box>& options)
      : first_axis_(static_cast<std::size_t>(options.first_axis)) {
    if (options.lists < 1 || options.lists > 3) {
      throw InvalidShape(asked.text() + ": options.lists is " + std::to_string(options.lists) +
                         ", but it must lie from 1 to 3");
    }
    if (options.first_axis == SweepAxis::greatest_variance) {
      throw InvalidShape(asked.text() +
                         ": options.first_axis is greatest_variance, which nobody knows before there are "
                         "boxes");
    }
    lists_ = std::min<std::size_t>(static_cast<std::size_t>(options.lists), n);
  }

  [[nodiscard]] Place place_of(const Box& box) const { return box; }
  void make_room(const AskedFunction&, std::uint32_t handle, const Place& box) {
    if (handle < boxes_.size()) return;
    boxes_.resize(std::size_t{handle} + 1, box);
    for (auto& links : links_) links.resize(2 * boxes_.size());
  }
  void put(std::uint32_t handle, const Place& box) {
    boxes_[handle] = box;
    for (std::size_t list = 0; list < lists_; ++list) {
      const std::size_t k = axis(list);
      link_between(k, 2 * handle, last_[k], no_end);
      link_between(k, 2 * handle + 1, last_[k], no_end);
      move_back(k, 2 * handle);
      move_back(k, 2 * handle + 1);
    }
  }
  void take(std::uint32_t handle, const Place&) {
    std::erase_if(overlapping_,
                  [&](std::uint64_t key) { return key >> 32 == handle || static_cast<std::uint32_t>(key) == handle; });
    for (std::size_t list = 0; list < lists_; ++list)
      unlink(axis(list), 2 * handle), unlink(axis(list), 2 * handle + 1);
  }
  /// The end is moved first where the box moves on, so that its start does not pass it; else the start.
  void move(std::uint32_t handle, const Place& box) {
    boxes_[handle] = box;
    for (std::size_t list = 0; list < lists_; ++list) {
      const std::size_t k = axis(list);
      move_on(k, 2 * handle + 1);
      move_back(k, 2 * handle);
      move_on(k, 2 * handle);
      move_back(k, 2 * handle + 1);
    }
  }

  template <class Visit>
  void visit_near(const Box&, bool, const Stored& stored, const Visit& visit) const {
    for (std::uint32_t i = 0; i < stored.boxes.numbers(); ++i) {
      if (stored.boxes.contains(i)) visit(i);
    }
  }
  std::vector<BoxPair> pairs(const BoxPairOptions& options, const Stored&) const {
    std::vector<BoxPair> rows;
    for (const std::uint64_t key : overlapping_) {
      const auto a = static_cast<std::uint32_t>(key >> 32), b = static_cast<std::uint32_t>(key);
      if (is_pair(boxes_[a], boxes_[b], options.touching)) rows.push_back({a, b});
    }
    std::sort(rows.begin(), rows.end());
    return rows;
  }

  static std::size_t parts() { return 1; }
  [[nodiscard]] std::size_t memory() const {
    return boxes_.capacity() * sizeof(Box) + links_[0].capacity() * sizeof(Links) * n +
           overlapping_.size() * 3 * sizeof(std::uint64_t) + overlapping_.bucket_count() * sizeof(void*);
  }

 private:
  /// Of box e / 2 the start where e is even, the end where it is odd.
  using End = std::uint32_t;
  static constexpr End no_end = 0xffffffff;
  struct Links {
    End before, after;
  };

  [[nodiscard]] std::size_t axis(std::size_t list) const { return (first_axis_ + list) % n; }
  [[nodiscard]] double value(std::size_t k, End e) const {
    const auto& p = e % 2 == 0 ? boxes_[e / 2].min : boxes_[e / 2].max;
    if constexpr (n == 3) {
      if (k == 2) return p.z;
    }
    return k == 0 ? p.x : p.y;
  }
  /// Must x stand behind y?
  [[nodiscard]] bool is_behind(std::size_t k, End x, End y) const {
    const double vx = value(k, x), vy = value(k, y);
    return vx > vy || (vx == vy && x % 2 > y % 2);
  }

  /// A start and an end have changed places.
  void passed(End x, End y) {
    if (x % 2 == y % 2 || x / 2 == y / 2) return;
    const std::uint32_t a = std::min(x, y) / 2, b = std::max(x, y) / 2;
    bool overlap = true;
    for (std::size_t list = 0; list < lists_ && overlap; ++list) {
      const std::size_t k = axis(list);
      overlap = value(k, 2 * a) <= value(k, 2 * b + 1) && value(k, 2 * b) <= value(k, 2 * a + 1);
    }
    const std::uint64_t key = std::uint64_t{a} << 32 | b;
    if (overlap) {
      overlapping_.insert(key);
    } else {
      overlapping_.erase(key);
    }
  }

  void unlink(std::size_t k, End e) {
    const auto [before, after] = links_[k][e];
    if (before != no_end) links_[k][before].after = after;
    (after != no_end ? links_[k][after].before : last_[k]) = before;
  }
  void link_between(std::size_t k, End e, End before, End after) {
    links_[k][e] = {before, after};
    if (before != no_end) links_[k][before].after = e;
    (after != no_end ? links_[k][after].before : last_[k]) = e;
  }
  void move_back(std::size_t k, End e) {
    End before = links_[k][e].before, after = e;
    for (; before != no_end && is_behind(k, before, e); before = links_[k][before].before) {
      passed(e, before);
      after = before;
    }
    if (after == e) return;
    unlink(k, e);
    link_between(k, e, before, after);
  }
  void move_on(std::size_t k, End e) {
    End before = e, after = links_[k][e].after;
    for (; after != no_end && is_behind(k, e, after); after = links_[k][after].after) {
      passed(e, after);
      before = after;
    }
    if (before == e) return;
    unlink(k, e);
    link_between(k, e, before, after);
  }

  std::size_t first_axis_, lists_ = n;
  std::vector<Box> boxes_;  // of each handle
  std::array<std::vector<Links>, n> links_;
  std::array<End, 3> last_{no_end, no_end, no_end};
  std::unordered_set<std::uint64_t> overlapping_;  // along the axes that have lists
};

}  // namespace plumb::space
