// Does one box overlap others as they are now, by their ordinals?  In lanes of four, the fourth of which never tells.
//
// Laws: as the ordinals say (ordinal_box.hpp); where an end is equal to a start, 0 is told, and the boxes say.
// Source: RTCD 4.2, 13.7.
// Cost: some ten instructions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "space/broad_phase/frame_lanes.hpp"

namespace plumb::space {

/// What is held against many: three ordinals each, and a fourth that never tells anything.
class AskedSpan {
 public:
  explicit AskedSpan(const OrdinalSpan& s)
      : low_{s.low[0], s.low[1], s.low[2], -beyond_ordinals}, high_{s.high[0], s.high[1], s.high[2], beyond_ordinals} {}

  [[nodiscard]] bool is_apart(const FrameEntry& other) const {
    return is_any((low_ > high_of(other)) | (low_of(other) > high_));
  }
  /// Below 0 apart, above 0 overlapping, at 0 the boxes say; of what is now.
  [[nodiscard]] int overlap(const FrameEntry& other) const {
    if (is_apart(other)) return -1;
    return is_any((low_ == high_of(other)) | (low_of(other) == high_)) ? 0 : 1;
  }

 private:
  using Four = std::int32_t __attribute__((vector_size(16)));
  static_assert(offsetof(FrameEntry, now) == 0 && sizeof(OrdinalSpan) == 24);
  static Four four_at(const FrameEntry& e, std::size_t number) {
    Four four;
    __builtin_memcpy(&four, reinterpret_cast<const char*>(&e) + number * sizeof(std::int32_t), sizeof four);
    return four;
  }
  static Four low_of(const FrameEntry& e) { return four_at(e, 0); }
  static Four high_of(const FrameEntry& e) { return four_at(e, 3); }
  static bool is_any(const Four& lanes) {
    std::array<std::uint64_t, 2> two;
    __builtin_memcpy(two.data(), &lanes, sizeof two);
    return (two[0] | two[1]) != 0;
  }

  Four low_, high_;
};

}  // namespace plumb::space
