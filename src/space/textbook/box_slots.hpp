// Which numbers have the boxes of a set that changes?  A number is given again, with another generation, when its box
// has been removed.
#pragma once

#include <cstddef>
#include <vector>

#include "plumb/space/pairs/box_pair.hpp"

namespace plumb::space {

template <class Box>
class BoxSlots {
 public:
  /// Puts the box into next().slot.
  void add(const Box& box) {
    if (free_.empty()) {
      boxes_.push_back(box);
      generations_.push_back(0);
      used_.push_back(1);
      return;
    }
    boxes_[free_.back()] = box, used_[free_.back()] = 1;
    free_.pop_back();
  }
  void release(std::uint32_t number) {
    used_[number] = 0, ++generations_[number];
    free_.push_back(number);
  }
  /// That add will give.
  [[nodiscard]] BoxHandle next() const {
    return free_.empty() ? BoxHandle{static_cast<std::uint32_t>(boxes_.size()), 0} : handle(free_.back());
  }
  [[nodiscard]] BoxHandle handle(std::uint32_t number) const { return {number, generations_[number]}; }
  [[nodiscard]] bool contains(std::uint32_t number) const { return number < used_.size() && used_[number] != 0; }
  [[nodiscard]] bool contains(const BoxHandle& h) const {
    return contains(h.slot) && generations_[h.slot] == h.generation;
  }
  /// Was it given once?
  [[nodiscard]] bool was_given(const BoxHandle& h) const {
    return h.slot < used_.size() && h.generation < generations_[h.slot];
  }
  [[nodiscard]] std::size_t size() const { return boxes_.size() - free_.size(); }
  [[nodiscard]] std::size_t numbers() const { return boxes_.size(); }
  [[nodiscard]] const Box& operator[](std::uint32_t number) const { return boxes_[number]; }
  [[nodiscard]] Box& operator[](std::uint32_t number) { return boxes_[number]; }
  [[nodiscard]] std::size_t memory() const {
    return boxes_.capacity() * sizeof(Box) + used_.capacity() +
           (generations_.capacity() + free_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> generations_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> free_;  // given again from the back
};

}  // namespace plumb::space
