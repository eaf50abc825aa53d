// What does a pose do to a point?  Over any number type, without a division: the one place where poses become numbers.
//
//   x  ->  (columns[0] x + columns[1] y + columns[2] z + translation) / weight
//
// Laws: (1) over numbers that are exact the image is exact, over intervals and balls it is enclosed.  (2) The weight is
// positive; of a matrix it is 1.  (3) A pose of the plane is one of space that leaves z alone.  (4) Multiples of a
// quaternion by powers of two give the same numbers, unless digits would be lost.
// Source: RTCD 3.2; Hamilton's product.
// Cost: none of a matrix, some 30 operations of a rigid pose, some 50 more a link of a chain.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "arith/big_rounding.hpp"
#include "arith/vec.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb::figure {

template <class T>
struct PoseNumbers {
  std::array<arith::Vec<T>, 3> columns;
  arith::Vec<T> translation;
  T weight;

  /// weight times the image of a vector, of a point.
  [[nodiscard]] arith::Vec<T> turned(const arith::Vec<T>& v) const {
    return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z;
  }
  [[nodiscard]] arith::Vec<T> image(const arith::Vec<T>& p) const { return turned(p) + translation; }
  /// The same, of one coordinate.
  [[nodiscard]] T turned(const arith::Vec<T>& v, std::size_t axis) const {
    return entry(axis, 0) * v.x + entry(axis, 1) * v.y + entry(axis, 2) * v.z;
  }
  [[nodiscard]] T image(const arith::Vec<T>& p, std::size_t axis) const {
    return turned(p, axis) + coordinate(translation, axis);
  }
  [[nodiscard]] const T& entry(std::size_t row, std::size_t column) const { return coordinate(columns[column], row); }
  [[nodiscard]] static const T& coordinate(const arith::Vec<T>& v, std::size_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  }
};

/// A quaternion, w first.
template <class T>
struct Quaternion {
  T w;
  arith::Vec<T> v;
};

/// First q, then p.
template <class T>
Quaternion<T> product(const Quaternion<T>& p, const Quaternion<T>& q) {
  return {p.w * q.w - dot(p.v, q.v), q.v * p.w + p.v * q.w + cross(p.v, q.v)};
}

/// x 2^exponent, of which bits may be lost among the least doubles.
inline Interval scaled_interval(double x, int exponent) {
  const double y = std::ldexp(x, exponent);
  if (std::ldexp(y, -exponent) == x) return Interval(y);
  return {y - Interval::least_step, y + Interval::least_step};
}

/// The quaternion, or its multiple by a power of two of which the largest part is about 1.
template <class T>
Quaternion<T> quaternion(const Rotation& q) {
  const double largest = std::max({std::fabs(q.w), std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
  // Zeros, and what is no number, are left to whoever refuses them.
  const int logarithm = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  constexpr int near_one = 10;  // a guess: products of such parts are far from what doubles hold
  const int exponent = std::abs(logarithm) < near_one ? 0 : -logarithm;
  if constexpr (std::is_same_v<T, Interval>) {
    const auto part = [&](double x) { return scaled_interval(x, exponent); };
    return {part(q.w), {part(q.x), part(q.y), part(q.z)}};
  } else {
    const auto part = [&](double x) { return std::ldexp(x, exponent); };
    const auto keeps = [&](double x) { return std::ldexp(part(x), -exponent) == x; };
    if (exponent == 0 || !(keeps(q.w) && keeps(q.x) && keeps(q.y) && keeps(q.z)))
      return {T(q.w), {T(q.x), T(q.y), T(q.z)}};
    return {T(part(q.w)), {T(part(q.x)), T(part(q.y)), T(part(q.z))}};
  }
}
template <class T>
Quaternion<T> quaternion(const Rotation2& q) {
  return quaternion<T>(Rotation{q.w, 0, 0, q.z});
}

/// The turn of a quaternion, about the origin.
template <class T>
PoseNumbers<T> turn_of(const Quaternion<T>& q) {
  const auto& [w, v] = q;
  const T ww = w * w, xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z, weight = (ww + xx) + (yy + zz);
  const auto twice = [](const T& x) { return T(x + x); };
  const T xy = twice(v.x * v.y), xz = twice(v.x * v.z), yz = twice(v.y * v.z);
  const T wx = twice(w * v.x), wy = twice(w * v.y), wz = twice(w * v.z);
  const T zero(0.0);
  return {{{{(ww + xx) - (yy + zz), xy + wz, xz - wy},
            {xy - wz, (ww - xx) + (yy - zz), yz + wx},
            {xz + wy, yz - wx, (ww - xx) - (yy - zz)}}},
          {zero, zero, zero},
          weight};
}

/// First the inner pose, then the outer one.
template <class T>
PoseNumbers<T> composition(const PoseNumbers<T>& outer, const PoseNumbers<T>& inner) {
  return {{outer.turned(inner.columns[0]), outer.turned(inner.columns[1]), outer.turned(inner.columns[2])},
          outer.turned(inner.translation) + outer.translation * inner.weight,
          outer.weight * inner.weight};
}

template <class T>
PoseNumbers<T> pose_numbers(const Pose& pose) {
  using arith::vec;
  const auto& [c, t] = pose;
  return {{vec<T>(c[0]), vec<T>(c[1]), vec<T>(c[2])}, vec<T>(t), T(1.0)};
}
template <class T>
PoseNumbers<T> pose_numbers(const Pose2& pose) {
  using arith::vec;
  const auto& [c, t] = pose;
  return {{vec<T>(c[0]), vec<T>(c[1]), {T(0.0), T(0.0), T(1.0)}}, vec<T>(t), T(1.0)};
}
template <class T, class Rigid>
PoseNumbers<T> rigid_numbers(const Rigid& pose) {
  PoseNumbers<T> made = turn_of(quaternion<T>(pose.turn));
  made.translation = arith::vec<T>(pose.translation) * made.weight;
  return made;
}
template <class T>
PoseNumbers<T> pose_numbers(const RigidPose& pose) {
  return rigid_numbers<T>(pose);
}
template <class T>
PoseNumbers<T> pose_numbers(const RigidPose2& pose) {
  return rigid_numbers<T>(pose);
}
template <class T, class Chain>
PoseNumbers<T> chain_numbers(const Chain& chain) {
  PoseNumbers<T> made = pose_numbers<T>(identity_pose);
  for (const auto& link : chain.links) made = composition(made, pose_numbers<T>(link));
  return made;
}
template <class T>
PoseNumbers<T> pose_numbers(const RigidChain& pose) {
  return chain_numbers<T>(pose);
}
template <class T>
PoseNumbers<T> pose_numbers(const RigidChain2& pose) {
  return chain_numbers<T>(pose);
}
template <class T>
PoseNumbers<T> pose_numbers(PoseView pose) {
  return pose.visit([](const auto& is) { return pose_numbers<T>(is); });
}
template <class T>
PoseNumbers<T> pose_numbers(PoseView2 pose) {
  return pose.visit([](const auto& is) { return pose_numbers<T>(is); });
}

inline void require_sound(std::string_view function, PoseView pose) {
  pose.visit([&](const auto& is) { require_sound(function, is); });
}
inline void require_sound(std::string_view function, PoseView2 pose) {
  pose.visit([&](const auto& is) { require_sound(function, is); });
}

/// A pose over pairs of doubles with a radius, and over integers once they are asked.
class CertainPose {
 public:
  template <class View>
  explicit CertainPose(View pose) : balls_(pose_numbers<Ball>(pose)), pose_(pose) {}

  /// The pose in numbers of type T, which is Ball or BigDyadic.
  template <class T>
  [[nodiscard]] const PoseNumbers<T>& in() const {
    if constexpr (std::is_same_v<T, Ball>) {
      return balls_;
    } else {
      if (!integers_) integers_ = std::visit([](auto view) { return pose_numbers<BigDyadic>(view); }, pose_);
      return *integers_;
    }
  }
  [[nodiscard]] bool is_matrix() const {
    return balls_.weight.high == 1 && balls_.weight.low == 0 && balls_.weight.radius == 0;
  }

  /// numerator(numbers) over the weight, rounded.
  template <class F>
  [[nodiscard]] double rounded(Rounding rounding, F numerator) const {
    const Ball top = numerator(balls_);
    if (const auto quick = (is_matrix() ? top : quotient(top, balls_.weight)).rounded(rounding)) return *quick;
    const PoseNumbers<BigDyadic>& exact = in<BigDyadic>();
    return rounded_quotient(rounding, numerator(exact), exact.weight);
  }
  /// The sign of what f makes of the numbers.
  template <class F>
  [[nodiscard]] Sign sign(F f) const {
    const Unsure<Sign> quick = f(balls_).sign();
    return quick.certain() ? quick.value() : f(in<BigDyadic>()).sign();
  }

  /// The columns times the weight, where these are doubles: of every matrix, and of turns of the lattice.
  [[nodiscard]] std::optional<std::array<Vector3, 3>> columns() const {
    std::array<Vector3, 3> made{};
    for (std::size_t j = 0; j < 3; ++j) {
      const auto& [x, y, z] = balls_.columns[j];
      for (const Ball* b : {&x, &y, &z}) {
        if (b->low != 0 || b->radius != 0) return {};
      }
      made[j] = {x.high, y.high, z.high};
    }
    return made;
  }

 private:
  PoseNumbers<Ball> balls_;
  std::variant<PoseView, PoseView2> pose_;
  mutable std::optional<PoseNumbers<BigDyadic>> integers_;
};

}  // namespace plumb::figure
