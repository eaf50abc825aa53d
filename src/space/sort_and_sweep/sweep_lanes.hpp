// Sweep: which of boxes that ascend by their start along axis 0 overlap?  Each is held against those that start within
// it, in the lanes of vectors.
//
// Laws: (1) pairs come by their earlier box, then by the later one, on every instruction set.  (2) Where ordinals are
// equal, `decide` is asked of the boxes themselves; elsewhere ordinals decide.  (3) What has a mark in common is no
// pair.
// Source: RTCD 7.5.2; Cohen, Lin, Manocha and Ponamgi 1995.
// Cost: about 2 ns for 16 boxes with AVX-512, and as much again where a pair is among them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "plumb/space/pairs/box_pair.hpp"
#include "space/sort_and_sweep/ordinal_box.hpp"

namespace plumb::space {

/// Coordinate by coordinate, with room behind for whole vectors.
class SweptBoxes {
 public:
  static constexpr std::size_t lanes_behind = 16;

  void assign(std::span<const OrdinalBox> boxes);  // ascending by low[0]
  /// Whose places, the lower halves of these, are so ordered.
  void assign(std::span<const OrdinalBox> boxes, std::span<const std::uint64_t> order);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const std::int32_t* low(std::size_t axis) const { return numbers_.get() + axis * stride_; }
  [[nodiscard]] const std::int32_t* high(std::size_t axis) const { return numbers_.get() + (3 + axis) * stride_; }
  /// From the numbers of one coordinate to those of the next: low 0 to 2, high 0 to 2.
  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] const std::int32_t* number() const { return numbers_.get() + 6 * stride_; }
  [[nodiscard]] const std::int32_t* marks() const { return numbers_.get() + 7 * stride_; }

 private:
  template <class PlaceOf>
  void fill(std::span<const OrdinalBox> boxes, const PlaceOf& place_of);

  std::unique_ptr<std::int32_t[]> numbers_;
  std::size_t size_ = 0, stride_ = 0;
};

/// Are the boxes of these numbers a pair?  Asked where ordinals do not tell.
struct DecidePair {
  const void* boxes;
  bool (*decide)(const void* boxes, std::int32_t a, std::int32_t b);
  bool operator()(std::int32_t a, std::int32_t b) const { return decide(boxes, a, b); }
};

/// Where pairs are collected before somebody takes them.
class PairBlock {
 public:
  static constexpr std::size_t capacity = 1024;
  PairBlock(void* to, void (*take)(void* to, std::span<const BoxPair> block)) : to_(to), take_(take) {}

  /// Room for 16 more.
  BoxPair* room() {
    if (size_ + 16 > capacity) flush();
    return pairs_ + size_;
  }
  void added(std::size_t n) { size_ += n; }
  void flush() {
    if (size_ != 0) take_(to_, {pairs_, size_});
    size_ = 0;
  }

 private:
  void* to_;
  void (*take_)(void* to, std::span<const BoxPair> block);
  std::size_t size_ = 0;
  BoxPair pairs_[capacity];
};

/// Pairs of numbers, the smaller first, whose earlier box is one of those from and up to these.
void sweep(const SweptBoxes& boxes, std::size_t from, std::size_t to, const DecidePair& decide, PairBlock& pairs);

}  // namespace plumb::space
