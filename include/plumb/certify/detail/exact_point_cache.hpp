// What does an exact point remember?  Its nearest doubles and its exact place, once a question needed them.
//
// Laws: (1) what is kept is true of the point whoever asks and when: threads may ask one point at a time, each finds
// nothing or the same bits, and none waits.  (2) order_by_doubles is the lexicographic order of the points wherever it
// is certain: rounding to nearest is monotone, so doubles that differ stand as the coordinates do.
// Source: Ziv 1991; the idea of numbers that keep an approximation is that of lazy exact arithmetic (Pion and Fabri
// 2011).
// Cost: a load and a comparison a coordinate.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <limits>

#include "plumb/arith/sign.hpp"

namespace plumb::certify {

/// Integers in proportion to the coordinates and 1 (src/certify/exact_place.hpp), shared by copies of a point.
template <std::size_t N>
struct ExactPlace;
template <std::size_t N>
const ExactPlace<N>* shared(const ExactPlace<N>* place);
template <std::size_t N>
void release(const ExactPlace<N>* place);

template <std::size_t N>
class ExactPointCache {
 public:
  ExactPointCache() {
    for (auto& x : nearest_) x.store(unknown, std::memory_order_relaxed);
  }
  /// Of a point as given; if a number is none, all stay unknown, so that whoever asks looks at them.
  explicit ExactPointCache(const std::array<double, N>& given) {
    double zero = 0;
    for (const double x : given) zero += x - x;
    for (std::size_t i = 0; i < N; ++i) nearest_[i].store(zero == 0 ? given[i] : unknown, std::memory_order_relaxed);
    exact_axes_.store(every_axis, std::memory_order_relaxed);
  }
  ExactPointCache(const ExactPointCache& other) : place_(other.place()) {
    if (const auto* p = place_.load(std::memory_order_relaxed); p != nullptr) shared(p);
    take_doubles(other);
  }
  ExactPointCache(ExactPointCache&& other) noexcept
      : place_(other.place_.exchange(nullptr, std::memory_order_relaxed)) {
    take_doubles(other);
  }
  ExactPointCache& operator=(ExactPointCache other) noexcept {
    take_doubles(other);
    place_.store(other.place_.exchange(place(), std::memory_order_relaxed), std::memory_order_relaxed);
    return *this;
  }
  ~ExactPointCache() {
    if (const auto* p = place_.load(std::memory_order_relaxed); p != nullptr) release(p);
  }

  /// The double nearest to the coordinate, infinite beyond all doubles; NaN as long as nobody asked for it.
  [[nodiscard]] double nearest(std::size_t axis) const { return nearest_[axis].load(std::memory_order_relaxed); }
  /// Is the coordinate known to be that double?
  [[nodiscard]] bool is_exact(std::size_t axis) const {
    return (exact_axes_.load(std::memory_order_relaxed) >> axis & 1) != 0;
  }
  /// Are the others known not to be?
  [[nodiscard]] bool are_axes_settled() const { return (exact_axes_.load(std::memory_order_relaxed) & settled) != 0; }
  [[nodiscard]] bool is_known() const {
    bool known = true;
    for (std::size_t i = 0; i < N; ++i) known = known && nearest(i) == nearest(i);
    return known;
  }
  void keep(const std::array<double, N>& nearest, const std::array<bool, N>& exact) const {
    for (std::size_t i = 0; i < N; ++i) nearest_[i].store(nearest[i], std::memory_order_relaxed);
    add_axes(exact, 0);
  }
  /// Each axis was looked at, so that nobody need do it again.
  void keep_exact(const std::array<bool, N>& exact) const { add_axes(exact, settled); }

  [[nodiscard]] const ExactPlace<N>* place() const { return place_.load(std::memory_order_acquire); }
  /// Takes it over, unless another thread was faster.
  const ExactPlace<N>& keep(const ExactPlace<N>* mine) const {
    const ExactPlace<N>* kept = nullptr;
    if (place_.compare_exchange_strong(kept, mine, std::memory_order_acq_rel)) return *mine;
    release(mine);
    return *kept;
  }

 private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  static constexpr unsigned char every_axis = (1u << N) - 1, settled = 0x80;

  void add_axes(const std::array<bool, N>& exact, unsigned axes) const {
    for (std::size_t i = 0; i < N; ++i) axes |= static_cast<unsigned>(exact[i]) << i;
    exact_axes_.fetch_or(static_cast<unsigned char>(axes), std::memory_order_relaxed);
  }
  void take_doubles(const ExactPointCache& other) {
    for (std::size_t i = 0; i < N; ++i) nearest_[i].store(other.nearest(i), std::memory_order_relaxed);
    exact_axes_.store(other.exact_axes_.load(std::memory_order_relaxed), std::memory_order_relaxed);
  }

  mutable std::array<std::atomic<double>, N> nearest_;
  mutable std::atomic<unsigned char> exact_axes_{0};
  mutable std::atomic<const ExactPlace<N>*> place_{nullptr};
};

template <std::size_t N>
Unsure<Sign> order_by_doubles(const ExactPointCache<N>& a, const ExactPointCache<N>& b) {
  for (std::size_t axis = 0; axis < N; ++axis) {
    const double x = a.nearest(axis), y = b.nearest(axis);
    if (x < y) return Unsure(Sign::negative);
    if (x > y) return Unsure(Sign::positive);
    if (!(x == y && a.is_exact(axis) && b.is_exact(axis))) return {};
  }
  return Unsure(Sign::zero);
}

}  // namespace plumb::certify
