// Linear feasibility: is there a point inside all slabs of two k-DOPs of the same directions?  Guessed by projections,
// and proved by signs.
//
// From a middle of the first slabs the guess steps over the side that it is farthest beyond, again and again (the
// relaxation method); most k-DOPs whose intervals overlap have such a point, and most guesses find it in two steps.
// Laws: true only of k-DOPs that have a common point inside both; false says nothing.
// Source: Agmon 1954; Motzkin and Schoenberg 1954; RTCD 4.6.2.
// Cost: 1 to 2 ns a slab and step, and as much for the proof of each.
#pragma once

#include <algorithm>
#include <array>

#include "plumb/certify/certainly.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb::figure {

/// Does the point lie between the sides of the slab, on neither?
struct InsideSlab {
  static constexpr Scales scales{.count = 2, .weights = 1u << 1};

  template <class W, std::size_t axes>
  [[gnu::always_inline]] bool operator()(W& w, const std::array<double, axes>& direction, double min, double max,
                                         const std::array<double, axes>& p) const {
    const auto term = [&](std::size_t k) { return w.template weight<1>({direction[k]}) * w.template number<1>(p[k]); };
    const auto beyond = [&](const auto& along) {
      const auto above = along - w.number(max), below = w.number(min) - along;
      return w.sign(larger(above, below)) == Sign::negative;
    };
    if constexpr (axes == 2) {
      return beyond(term(0) + term(1));
    } else {
      return beyond(term(0) + term(1) + term(2));
    }
  }
};

template <class Vector>
class CommonSlabs {
 public:
  static constexpr std::size_t axes = std::tuple_size_v<decltype(coordinates(Vector()))>;
  using Place = std::array<double, axes>;

  /// Of one form.
  CommonSlabs(const KDop<Vector>& a, const KDop<Vector>& b) : directions_(a.directions.all()), a_(a), b_(b) {}

  [[nodiscard]] bool have_inner_point() const {
    constexpr int most_steps = 8;
    Place p = middle();
    for (int step = 0; step < most_steps; ++step) {
      const double most = most_beyond(p);
      if (most < 0) return are_around(p);
      if (!step_over(most, p)) return false;
    }
    return false;
  }

 private:
  [[nodiscard]] std::size_t size() const { return directions_.size(); }
  [[nodiscard]] double min(std::size_t i) const { return std::max(a_.min[i], b_.min[i]); }
  [[nodiscard]] double max(std::size_t i) const { return std::min(a_.max[i], b_.max[i]); }

  // What follows guesses, in plain doubles.
  [[nodiscard]] static double along(const Place& d, const Place& p) {
    double sum = d[0] * p[0];
    for (std::size_t k = 1; k < axes; ++k) sum += d[k] * p[k];
    return sum;
  }
  static void move(Place& p, const Place& d, double by) {
    const double part = by / along(d, d);
    for (std::size_t k = 0; k < axes; ++k) p[k] += part * d[k];
  }
  /// Of as many slabs as there are axes; where these are not perpendicular, somewhere near.
  [[nodiscard]] Place middle() const {
    Place p{};
    for (std::size_t i = 0; i < std::min(axes, size()); ++i) {
      const Place d = coordinates(directions_[i]);
      move(p, d, (min(i) + max(i)) * 0.5 - along(d, p));
    }
    return p;
  }
  [[nodiscard]] double beyond(std::size_t i, const Place& p) const {
    const double at = along(coordinates(directions_[i]), p), above = at - max(i), below = min(i) - at;
    return above > below ? above : below;
  }
  [[nodiscard]] double most_beyond(const Place& p) const {
    double most = -1;
    for (std::size_t i = 0; i < size(); ++i) {
      const double x = beyond(i, p);
      most = x > most ? x : most;
    }
    return most;
  }
  /// Over the side that p is farthest beyond, and somewhat on; false where its slab is flat.
  bool step_over(double most, Place& p) const {
    constexpr double of_step = 0.5, of_half_width = 0.1;
    for (std::size_t i = 0; i < size(); ++i) {
      if (beyond(i, p) != most) continue;
      const Place d = coordinates(directions_[i]);
      const double half = (max(i) - min(i)) * 0.5;
      if (!(half > 0)) return false;
      const double by = most + std::min(half, of_step * most + of_half_width * half);
      move(p, d, along(d, p) > max(i) ? -by : by);
      return true;
    }
    return false;
  }

  [[nodiscard]] bool are_around(const Place& p) const {
    for (std::size_t i = 0; i < size(); ++i) {
      const auto inside = certify::one_lane::told_by_worlds<FloatWorld<InsideSlab>>(
          NoWorldRecorder{}, InsideSlab{}, coordinates(directions_[i]), min(i), max(i), p);
      if (!inside || !*inside) return false;
    }
    return true;
  }

  std::span<const Vector> directions_;
  const KDop<Vector>&a_, &b_;
};

}  // namespace plumb::figure
