// Signed volumes: on which side of a plane does a corner lie, and which areas are seen of corners in one plane, on a
// lattice?
//
// Laws: exact.
// Cost: a volume 20 to 60 operations.
#pragma once

#include <optional>

#include "query/overlap/filters.hpp"
#include "query/overlap/lattice_points.hpp"

namespace plumb::query {

/// By how much volumes are off whose points differ by less than 1.
inline constexpr double volume_error = largest_threshold<Volume>({1, 1, 1});

/// Volumes of short integers take two words.
using ShortStep = WideInt<30>;
using LongStep = WideInt<LatticeIntegers<6>::most_bits + 1>;

/// First that in which the points extend least: a plane across an axis is seen along it alone.
template <std::size_t N>
std::array<std::size_t, 3> axes_to_look_along(const LatticePoints<N, 3>& points) {
  std::array<std::size_t, 3> axes{0, 1, 2};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (points.is_level(axis)) std::swap(axes[0], axes[axis]);
  }
  return axes;
}

/// Where all points lie on one line: an axis along which it runs.
template <std::size_t N>
std::optional<std::size_t> running_axis(const LatticePoints<N, 3>& points) {
  if (!points.is_straight(0, 1) || !points.is_straight(1, 2) || !points.is_straight(2, 0)) return {};
  return !points.is_level(0) ? 0 : !points.is_level(1) ? 1 : 2;
}

/// Signs of volumes of N points of a lattice.
template <class Step, std::size_t N>
class LatticeVolumes {
 public:
  /// Short integers make exact doubles of areas.
  static constexpr bool doubles_first = !std::is_same_v<Step, ShortStep>;

  explicit LatticeVolumes(const LatticePoints<N, 3>& points)
      : points_(points), error_(volume_error * power_of_two(points.bits(0) + points.bits(1) + points.bits(2))) {}

  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return arith::settled_sign(predicates::triple(step(l, i), step(l, j), step(l, k)), error_);
  }
  /// Of points j, j + 1, ... over the plane of i, i + 1, i + 2.
  template <std::size_t Count>
  [[nodiscard]] std::array<Sign, Count> over(std::size_t i, std::size_t j) const {
    const auto normal = predicates::cross(step(i, i + 1), step(i, i + 2));
    std::array<Sign, Count> sides{};
    for (std::size_t k = 0; k < Count; ++k)
      sides[k] = arith::settled_sign(predicates::dot(step(i, j + k), normal), error_);
    return sides;
  }
  [[nodiscard]] std::array<std::size_t, 3> axes() const { return axes_to_look_along(points_); }
  template <class Make>
  [[nodiscard]] auto seen_along(std::size_t axis, const Make& made) const {
    return points_.seen((axis + 1) % 3, (axis + 2) % 3, made);
  }

 protected:
  const LatticePoints<N, 3>& points_;

 private:
  [[nodiscard]] predicates::Triple<Step> step(std::size_t i, std::size_t j) const {
    const auto along = [&](std::size_t axis) { return Step(points_.difference(i, j, axis)); };
    return {along(0), along(1), along(2)};
  }
  double error_;
};

/// Calls `ask` with the signs of these points, by the shortest numbers that tell all; nothing where none do.
template <template <class> class Signs, std::size_t N, class Ask, class... More>
auto by_lattice(const LatticePoints<N, 3>& points, const Ask& ask, const More&... more)
    -> decltype(ask(std::declval<Signs<LongStep>>())) {
  if (!points.is_lattice()) return {};
  const int x = points.bits(0), y = points.bits(1), z = points.bits(2);
  if (x <= ShortStep::bits && y <= ShortStep::bits && z <= ShortStep::bits)
    return ask(Signs<ShortStep>(points, more...));
  if (volume_error * power_of_two(x + y + z) < arith::most_error)
    return ask(Signs<arith::LatticeStep>(points, more...));
  return ask(Signs<LongStep>(points, more...));
}

}  // namespace plumb::query
