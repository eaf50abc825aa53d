// Sweep and prune of short lists: which boxes overlap, of one list or of two, whose boxes ascend by their start along an axis?
//
// Laws: (1) each pair of boxes_meet.hpp is told once: two of one list, or one of each.  (2) They come in an order that
// depends on the lists alone.
// Source: RTCD 7.5.2.
// Cost: some ns for each box that starts within another along that axis.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "space/bvh/radix_sort.hpp"
#include "space/pairs/boxes_meet.hpp"

namespace plumb::space {

template <class Box>
struct SweptBox {
  Box box;
  std::uint32_t number;
};

template <std::size_t axis, class Point>
[[gnu::always_inline]] constexpr double along(const Point& p) {
  if constexpr (axis == 0) {
    return p.x;
  } else if constexpr (axis == 1) {
    return p.y;
  } else {
    return p.z;
  }
}

template <std::size_t axis, class Box>
bool starts_before(const SweptBox<Box>& a, const SweptBox<Box>& b) {
  const double x = along<axis>(a.box.min), y = along<axis>(b.box.min);
  return x < y || (x == y && a.number < b.number);
}

/// Places of the boxes in the order of their starts along x, then of their places.
template <class Box>
std::vector<std::uint32_t> order_of_starts(Execution execution, std::span<const SweptBox<Box>> boxes) {
  struct Start {
    std::uint64_t ordinal;
    std::uint32_t number;
  };
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  std::vector<Start> starts(boxes.size()), room(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(boxes[i].box.min.x + 0.0);  // no -0
    starts[i] = {(bits & sign) != 0 ? ~bits : bits | sign, static_cast<std::uint32_t>(i)};
  }
  radix_sort(execution, starts.size(), 6, starts, room, [](const Start& s) { return s.ordinal; });
  std::vector<std::uint32_t> order(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = starts[i].number;
  return order;
}

/// On one axis, without a branch.
template <std::size_t axis, class Box>
[[gnu::always_inline]] inline bool meet_along(const Box& a, const Box& b) {
  const double a_min = along<axis>(a.min), a_max = along<axis>(a.max), b_min = along<axis>(b.min),
               b_max = along<axis>(b.max);
  return (a_min <= b_max) & (b_min <= a_max);
}

/// One box against those of a list from here on, none of which starts before it.
template <bool touching, std::size_t axis, class Box, class Take>
[[gnu::always_inline]] inline void sweep_one(const SweptBox<Box>& a, const SweptBox<Box>* b, const SweptBox<Box>* end,
                                             const Take& take) {
  constexpr std::size_t n = axes_of<Box>;
  const double last = along<axis>(a.box.max);
  for (; b != end && along<axis>(b->box.min) <= last; ++b) {
    bool meets = meet_along<(axis + 1) % n>(a.box, b->box);
    if constexpr (n == 3) meets &= meet_along<(axis + 2) % n>(a.box, b->box);
    if (meets && (touching || boxes_meet(a.box, b->box, false))) take(a.number, b->number);
  }
}

/// take(number, number) of each pair in the list, which ascends along the axis.
template <bool touching, std::size_t axis, class Box, class Take>
void sweep_within(std::span<const SweptBox<Box>> list, const Take& take) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    sweep_one<touching, axis>(list[i], list.data() + i + 1, list.data() + list.size(), take);
  }
}

/// take(number, number) of each pair of a box of a and one of b.
template <bool touching, std::size_t axis, class Box, class Take>
void sweep_between(std::span<const SweptBox<Box>> a, std::span<const SweptBox<Box>> b, const Take& take) {
  const SweptBox<Box>*i = a.data(), *j = b.data(), *const end_a = i + a.size(), *const end_b = j + b.size();
  while (i != end_a && j != end_b) {
    if (along<axis>(i->box.min) <= along<axis>(j->box.min)) {
      sweep_one<touching, axis>(*i++, j, end_b, take);
    } else {
      sweep_one<touching, axis>(*j++, i, end_a, take);
    }
  }
}

}  // namespace plumb::space
