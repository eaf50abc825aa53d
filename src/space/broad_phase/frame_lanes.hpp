// Sweep of two frames at once: of which boxes may it be that they overlapped before and do not now, or the other way
// round?
//
// An entry is a box before and now, either of which may be missing, and stands for the interval that both take along
// axis 0.  Each is held against those that start within it, in the lanes of vectors.
// Laws: (1) every two entries that have no mark in common and whose boxes overlap in one of both frames only are told;
// so are those that have equal ordinals where they ought to be told apart, and no others.  (2) Entries come by the
// earlier one, then by the later one, on every instruction set.
// Source: RTCD 7.5.2.
// Cost: some 3 ns for 16 entries with AVX-512.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "space/sort_and_sweep/ordinal_box.hpp"

namespace plumb::space {

struct OrdinalSpan {
  std::array<std::int32_t, 3> low, high;
};
/// Overlaps nothing.
inline constexpr std::int32_t past_ordinals = (1 << ordinal_bits) + 1;
inline constexpr OrdinalSpan no_span{{past_ordinals, past_ordinals, past_ordinals}, {-1, -1, -1}};

/// Strips of columns on both axes, from and up to; none where the first is above the second.
struct StripReach {
  std::uint16_t from1 = 1, to1 = 0, from2 = 1, to2 = 0;
  [[nodiscard]] bool has(std::uint32_t s, std::uint32_t t) const {
    return (from1 <= s) & (s <= to1) & (from2 <= t) & (t <= to2);
  }
  friend bool operator==(const StripReach&, const StripReach&) = default;
};

struct alignas(64) FrameEntry {
  OrdinalSpan now = no_span, before = no_span;
  std::uint32_t slot = 0;
  std::uint32_t moved_in = 0;  // the frame in which before counts; in others it is what now is
  StripReach reach;

  [[nodiscard]] const OrdinalSpan& was(std::uint32_t frame) const { return moved_in == frame ? before : now; }
};
static_assert(sizeof(FrameEntry) == 64);

/// Coordinate by coordinate, sixteen entries at a time.
class SweptEntries {
 public:
  static constexpr std::size_t at_once = 16;
  struct alignas(64) Block {
    // 0 to 11: as in an entry; then its number, marks, and where it starts and ends along axis 0.
    std::int32_t of[16][at_once];
  };

  /// Of these numbers, shifted by 2 above their marks, ascending by where they start, in this frame.
  void assign(std::span<const FrameEntry> entries, std::uint32_t frame, std::span<const std::uint64_t> keys);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<const Block> blocks() const { return {blocks_.data(), (size_ + at_once - 1) / at_once}; }

 private:
  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

struct EntryPairTaker {
  void* to;
  void (*take)(void* to, std::uint32_t a, std::uint32_t b);
};

void sweep_frames(const SweptEntries& entries, const EntryPairTaker& to);

}  // namespace plumb::space
