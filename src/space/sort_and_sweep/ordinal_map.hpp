// How do the numbers of boxes become ordinals (ordinal_box.hpp)?  In steps of equal length from the least number to
// the greatest, or from one to the next of some numbers between.
//
// Laws: monotone on each axis: multiplications by numbers that are not negative, a subtraction, truncation and a
// minimum are, however they round.  Where the steps lie is a guess: any are right.  Any number has an ordinal: where an
// axis has but one, what is infinitely many steps off has that one as well (infinity times zero is taken for zero).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "space/sort_and_sweep/box_set.hpp"
#include "space/sort_and_sweep/ordinal_box.hpp"

namespace plumb::space {

/// Of each axis; what the plane has not is 0.
struct SetBounds {
  std::array<double, 3> min{}, max{};
};

/// Of boxes that are finite and not empty; false where one is not.
template <class Box>
bool find_bounds(std::span<const Box> boxes, SetBounds& bounds) {
  constexpr std::size_t axes = axes_of<Box>;
  constexpr double most = std::numeric_limits<double>::max();
  std::array<double, axes> least, greatest;
  least.fill(most), greatest.fill(-most);
  bool sound = true;
  for (const Box& box : boxes) {
    const auto x = numbers_of(box);
    for (std::size_t k = 0; k < axes; ++k) {
      const double low = x[k], high = x[k + axes];
      sound &= low <= high;  // no NaN is
      least[k] = low < least[k] ? low : least[k];
      greatest[k] = high > greatest[k] ? high : greatest[k];
    }
  }
  for (std::size_t k = 0; k < axes; ++k) {
    bounds.min[k] = least[k], bounds.max[k] = greatest[k];
    sound &= -most <= least[k] && greatest[k] <= most;
  }
  return sound;
}

class OrdinalMap {
 public:
  OrdinalMap() = default;
  /// Axis order[k] of boxes becomes axis k of ordinals, which are of bits[k] bits, in steps of equal length.
  OrdinalMap(const SetBounds& bounds, const std::array<std::size_t, 3>& order, const std::array<int, 3>& bits);

  /// In steps of equal length between each two of `knots`, numbers within the bounds, and as many steps between any
  /// two: for numbers that lie far apart here and close together there.
  OrdinalMap(const SetBounds& bounds, const std::array<std::size_t, 3>& order, const std::array<int, 3>& bits,
             std::array<std::vector<double>, 3> knots);

  [[nodiscard]] const std::array<std::size_t, 3>& order() const { return order_; }

  /// Of a number on axis order[k]; beyond the bounds the least and the greatest ordinal.
  [[nodiscard]] std::int32_t ordinal(std::size_t k, double x) const {
    const std::vector<Piece>& pieces = axes_[k];
    if (pieces.empty()) return whole_[k](x);
    std::size_t at = 0, count = pieces.size();  // the last that begins at x or before it, or the first
    while (count > 1) {
      const std::size_t half = count / 2;
      at += pieces[at + half].min <= x ? half : 0;
      count -= half;
    }
    return pieces[at](x);
  }

  /// low[0] of its ordinals.
  template <class Box>
  [[nodiscard]] std::uint32_t start(const Box& box) const {
    return static_cast<std::uint32_t>(order_[0] < axes_of<Box> ? ordinal(0, numbers_of(box)[order_[0]]) : 0);
  }

  template <class Box>
  [[nodiscard]] OrdinalBox operator()(const Box& box, std::size_t number, std::int32_t marks) const {
    OrdinalBox made;
    put(box, made.low, made.high);
    made.number = static_cast<std::int32_t>(number);
    made.marks = marks;
    return made;
  }

  /// Its ordinals, written one by one where they belong.
  template <class Box>
  void put(const Box& box, std::array<std::int32_t, 3>& low, std::array<std::int32_t, 3>& high) const {
    constexpr std::size_t axes = axes_of<Box>;
    const auto x = numbers_of(box);
    if constexpr (axes == 3) {
      if (is_even_) [[likely]]
        return put_evenly(x, low, high);
    }
    const auto place = [&](const auto& ordinal_of) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t axis = order_[k];
        if (axes == 3 || axis < axes) {
          low[k] = ordinal_of(k, x[axis]);
          high[k] = ordinal_of(k, x[axis + axes]) + widening_[k];
        } else {
          low[k] = 0, high[k] = 1;
        }
      }
    };
    if (is_even_) [[likely]] {
      place([this](std::size_t k, double of) { return whole_[k](of); });
    } else {
      place([this](std::size_t k, double of) { return ordinal(k, of); });
    }
  }

 private:
  struct Piece {
    Piece() = default;
    Piece(double from, double to, double last_step);
    std::int32_t operator()(double x) const {
      const double step = (x * halved - start) * scale;
      return first + static_cast<std::int32_t>(std::max(0.0, std::min(step, last)));  // of NaN 0
    }
    double min = 0, halved = 1, start = 0, scale = 0, last = 0;
    std::int32_t first = 0;
  };

  /// What whole_ says of each of six numbers, two at a time.
  void put_evenly(const std::array<double, 6>& x, std::array<std::int32_t, 3>& low,
                  std::array<std::int32_t, 3>& high) const {
    using Two = double __attribute__((vector_size(16)));
    using TwoOrdinals = std::int32_t __attribute__((vector_size(8)));
    std::array<std::int32_t, 6> of{};
    for (std::size_t i = 0; i < 6; i += 2) {
      const auto two = [i](const std::array<double, 6>& from) {
        Two made;
        __builtin_memcpy(&made, from.data() + i, sizeof made);
        return made;
      };
      const Two last = two(six_.last), zero{};
      Two step = (two(x) * two(six_.halved) - two(six_.start)) * two(six_.scale);
      step = last < step ? last : step;
      step = step > zero ? step : zero;  // of NaN zero
      const auto ordinals = __builtin_convertvector(step, TwoOrdinals);
      __builtin_memcpy(of.data() + i, &ordinals, sizeof ordinals);
    }
    for (std::size_t k = 0; k < 3; ++k) low[k] = of[order_[k]], high[k] = of[order_[k] + 3] + widening_[k];
  }

  struct Six {
    std::array<double, 6> halved{}, start{}, scale{}, last{};
  };

  std::array<std::size_t, 3> order_{0, 1, 2};
  bool is_even_ = true;
  Six six_;
  std::array<Piece, 3> whole_;
  std::array<std::vector<Piece>, 3> axes_;  // none where steps are of equal length
  // Where all numbers of an axis are equal, all boxes overlap on it whether touching counts or not: nobody need ask.
  std::array<std::int32_t, 3> widening_{};
};

}  // namespace plumb::space
