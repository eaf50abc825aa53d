// What do numbers of points stand for, and how do these points lie?  Points as given first, then such as no doubles hold.
//
// Laws: a sign is that of the points, whichever of them are given.
// Source: plumb/certify/exact_point.hpp.
// Cost: that of the sign; nothing is copied but what is given.
#pragma once

#include <array>
#include <span>

#include "plumb/certify/exact_point.hpp"

namespace plumb::surface {

/// Refers to a point that is held elsewhere, or is one as given.
class HeldPoint {
 public:
  explicit HeldPoint(const Point3& given) : given_(given) {}
  explicit HeldPoint(const ExactPoint3* held) : held_(held) {}
  operator const ExactPoint3&() const { return held_ != nullptr ? *held_ : given_; }  // NOLINT: it stands for the point

 private:
  ExactPoint3 given_;
  const ExactPoint3* held_ = nullptr;
};

/// Points as given ascend; both outlive this.
struct NumberedPoints {
  std::span<const Point3> given;
  std::span<const ExactPoint3> held;

  [[nodiscard]] std::size_t size() const { return given.size() + held.size(); }
  [[nodiscard]] bool is_given(std::uint32_t number) const { return number < given.size(); }
  [[nodiscard]] HeldPoint at(std::uint32_t number) const {
    return is_given(number) ? HeldPoint(given[number]) : HeldPoint(&held[number - given.size()]);
  }
  [[nodiscard]] Point3 nearest(std::uint32_t number) const {
    return is_given(number) ? given[number] : approximate(held[number - given.size()]);
  }

  /// As far as it is known: of a point that is held in its plain form it is.
  [[nodiscard]] double nearest_along(std::uint32_t number, std::size_t axis) const {
    if (!is_given(number)) return held[number - given.size()].cache().nearest(axis);
    const Point3& p = given[number];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  /// Is that the coordinate?
  [[nodiscard]] bool is_double_along(std::uint32_t number, std::size_t axis) const {
    return is_given(number) || held[number - given.size()].cache().is_exact(axis);
  }

  /// Decide as predicates.hpp does, about the points with these numbers.
  [[nodiscard]] Sign order(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Sign orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  [[nodiscard]] bool is_straight(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  /// Tells how the shadows along the axis turn.
  [[nodiscard]] Sign turn_along(int axis, std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
};

/// The point's shadow along the axis: (x, y), (y, z) or (z, x).
Point2 shadow(const Point3& p, int axis);
ExactPoint2 shadow(const ExactPoint3& p, int axis);

/// Three axes, first the one along which doubles tell the largest area.
std::array<int, 3> guessed_axes(const std::array<Point3, 3>& points);

}  // namespace plumb::surface
