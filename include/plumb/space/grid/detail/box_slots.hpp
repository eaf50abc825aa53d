// Which numbers have the boxes of a set that changes?  A number is given again when its box has been removed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb::space {

template <class Box>
class BoxSlots {
 public:
  std::uint32_t add(const Box& box) {
    if (free_.empty()) {
      boxes_.push_back(box);
      used_.push_back(1);
      return static_cast<std::uint32_t>(boxes_.size() - 1);
    }
    const std::uint32_t number = free_.back();
    free_.pop_back();
    boxes_[number] = box;
    used_[number] = 1;
    return number;
  }
  void release(std::uint32_t number) {
    used_[number] = 0;
    free_.push_back(number);
  }
  /// The number that add will give.
  [[nodiscard]] std::uint32_t next() const {
    return free_.empty() ? static_cast<std::uint32_t>(boxes_.size()) : free_.back();
  }
  [[nodiscard]] bool contains(std::uint32_t number) const { return number < used_.size() && used_[number] != 0; }
  [[nodiscard]] std::size_t size() const { return boxes_.size() - free_.size(); }
  [[nodiscard]] std::size_t numbers() const { return boxes_.size(); }
  [[nodiscard]] const Box& operator[](std::uint32_t number) const { return boxes_[number]; }
  [[nodiscard]] Box& operator[](std::uint32_t number) { return boxes_[number]; }
  [[nodiscard]] std::size_t memory() const {
    return boxes_.capacity() * sizeof(Box) + used_.capacity() + free_.capacity() * sizeof(std::uint32_t);
  }

 private:
  std::vector<Box> boxes_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> free_;  // given again from the back
};

}  // namespace plumb::space
