// Signed volumes, on a lattice: on which side of a plane does a corner lie, and do all lie on one line?  Over the
// integers that the corners are, of which the shortest that tell all are taken.
//
//   certainly<LatticeWorlds<TriangleSigns, 6>>([&](const auto& signs) { return relate_by(a, b, signs); }, corners,
//                                              [&] { return relate_by(a, b, PointSigns(...)); });
//
// Laws: exact.  What is on no lattice of 125 bits is asked the last argument.
// Source: RTCD 5.2.10, 11.5.
// Cost: that of the lattice, and 20 to 60 operations a volume; three times that beyond 61 bits.
#pragma once

#include <optional>

#include "plumb/certify/world.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/wide_points.hpp"

namespace plumb::query {

/// By how much volumes are off whose points differ by less than 1.
inline constexpr double volume_error = largest_threshold<Volume>({1, 1, 1});

/// Volumes of short integers take two words.
using ShortStep = WideInt<30>;
using LongStep = WideInt<LatticeIntegers<6>::most_bits + 1>;

/// Signs of volumes of some points of a lattice; their differences are Steps.
template <class Points, class Step>
class VolumeSigns {
 public:
  /// Short integers make exact doubles of areas.
  static constexpr bool doubles_first = !std::is_same_v<Step, ShortStep>;

  explicit VolumeSigns(const Points& points)
      : points_(points), error_(volume_error * power_of_two(points.bits(0) + points.bits(1) + points.bits(2))) {}

  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return arith::settled_sign(predicates::triple(step(l, i), step(l, j), step(l, k)), error_);
  }
  /// Of points j, j + 1, ... over the plane of i, i + 1, i + 2.
  template <std::size_t Count>
  [[nodiscard]] [[gnu::flatten]] std::array<Sign, Count> over(std::size_t i, std::size_t j) const {
    const auto normal = predicates::cross(step(i, i + 1), step(i, i + 2));
    std::array<Sign, Count> sides{};
    for (std::size_t k = 0; k < Count; ++k)
      sides[k] = arith::settled_sign(predicates::dot(step(i, j + k), normal), error_);
    return sides;
  }
  /// First that in which the points extend least: a plane across an axis is seen along it alone.
  [[nodiscard]] std::array<std::size_t, 3> axes() const {
    std::array<std::size_t, 3> axes{0, 1, 2};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_level(points_, axis)) std::swap(axes[0], axes[axis]);
    }
    return axes;
  }
  /// Where all points lie on one line: an axis along which it runs.
  [[nodiscard]] std::optional<std::size_t> running_axis() const {
    if (!is_straight(points_, 0, 1) || !is_straight(points_, 1, 2) || !is_straight(points_, 2, 0)) return {};
    return !is_level(points_, 0) ? 0 : !is_level(points_, 1) ? 1 : 2;
  }

 protected:
  const Points& points_;

 private:
  [[nodiscard]] predicates::Triple<Step> step(std::size_t i, std::size_t j) const {
    const auto along = [&](std::size_t axis) { return Step(points_.difference(i, j, axis)); };
    return {along(0), along(1), along(2)};
  }
  double error_;
};

/// The worlds of N points.
template <template <class Points, class Step> class Signs, std::size_t N>
struct LatticeWorlds {
  template <class Recorder, class Statement, class Beyond>
  static auto answer(Recorder&& recorder, const Statement& statement, const std::array<double, 3 * N>& coordinates,
                     const Beyond& beyond) {
    if (const LatticePoints<N, 3> points(coordinates); points.is_lattice()) {
      recorder.answered(WorldKind::integers);
      const int x = points.bits(0), y = points.bits(1), z = points.bits(2);
      if (x <= ShortStep::bits && y <= ShortStep::bits && z <= ShortStep::bits)
        return statement(Signs<LatticePoints<N, 3>, ShortStep>(points));
      if (volume_error * power_of_two(x + y + z) < arith::most_error)
        return statement(Signs<LatticePoints<N, 3>, arith::LatticeStep>(points));
      return statement(Signs<LatticePoints<N, 3>, LongStep>(points));
    }
    if (const WidePoints<N> points(coordinates); points.is_lattice()) {
      recorder.answered(WorldKind::integers);
      return statement(Signs<WidePoints<N>, typename WidePoints<N>::Step>(points));
    }
    recorder.answered(WorldKind::rationals);
    return beyond();
  }
};

}  // namespace plumb::query
