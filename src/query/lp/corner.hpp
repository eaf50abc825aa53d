// Cramer's rule, homogeneous coordinates: where do two lines or three planes meet, over any number type, and on which
// side of the next constraint is that?  Planes may be infinitely far away.
//
// A plane is normal . x = limit + far M, where M is larger than any number.  The point of D of them is (at + far M) /
// weight with a weight above zero; a value there is compared by its part with M first.
// Laws: signs are exact.  Doubles tell them, with a bound that they carry along; then what is zero by zeros alone; then
// integers of as many limbs as they need, on the stack, then GMP's.  What the numbers of a point are is computed once
// in each.
// Source: RTCD 3.1.4, 5.4.5; docs/proof.md, "Tracked errors".
// Cost: 3 ns a side where doubles tell, some 50 ns where integers on the stack do.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "certify/carried_errors.hpp"
#include "plumb/arith/structural_zero.hpp"
#include "plumb/query/lp/linear_program.hpp"

namespace plumb::query {

template <std::size_t D>
using Numbers = std::array<double, D>;

inline Numbers<2> numbers_of(const Vector2& v) { return {v.x, v.y}; }
inline Numbers<3> numbers_of(const Vector3& v) { return {v.x, v.y, v.z}; }

template <std::size_t D>
struct LpOf;
template <>
struct LpOf<2> {
  using Named = NamedHalfspace2;
  using Halfspace = Halfspace2;
  using Vector = Vector2;
  using Answer = LinearAnswer2;
};
template <>
struct LpOf<3> {
  using Named = NamedHalfspace3;
  using Halfspace = Halfspace3;
  using Vector = Vector3;
  using Answer = LinearAnswer3;
};

/// No number of a constraint is larger.
template <std::size_t D>
struct LargestNumbers {
  Numbers<D> normal{};
  double limit = 0;

  template <class Halfspace>
  void take(const Halfspace& h) {
    const Numbers<D> n = numbers_of(h.normal);
    for (std::size_t k = 0; k < D; ++k) normal[k] = std::max(normal[k], magnitude_of(n[k]));
    limit = std::max(limit, magnitude_of(h.offset));
  }
};

/// normal . x = limit + far M.
template <std::size_t D>
struct LpPlane {
  Numbers<D> normal{};
  double limit = 0, far = 0;
  std::uint32_t number = no_constraint;
};

/// The sign that a formula over any number type has: `formula(maker)`, where maker(x) is a double as such a number.
template <class Formula>
Sign sign_over_all(const Formula& formula) {
  const int quick = formula([](double x) { return Approximate(x); }).certain_sign();
  if (quick != 0) [[likely]]
    return static_cast<Sign>(quick);
  if (formula([](double x) { return StructuralZero(x == 0); }).certain) return Sign::zero;
  return sign_in<SignWorlds<StackDyadic, BigDyadic>>([&]<class T>() { return formula([](double x) { return T(x); }); });
}

template <class T>
[[gnu::always_inline]] inline T cross2(const std::array<T, 2>& a, const std::array<T, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}
template <class T>
[[gnu::always_inline]] inline std::array<T, 3> cross3(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T, std::size_t D>
[[gnu::always_inline]] inline T dot_of(const std::array<T, D>& a, const std::array<T, D>& b) {
  if constexpr (D == 2) {
    return a[0] * b[0] + a[1] * b[1];
  } else {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
template <std::size_t D, class Maker>
[[gnu::always_inline]] inline auto made(const Maker& maker, const Numbers<D>& a) {
  if constexpr (D == 2) {
    return std::array{maker(a[0]), maker(a[1])};
  } else {
    return std::array{maker(a[0]), maker(a[1]), maker(a[2])};
  }
}

/// det(rows).
template <class T, std::size_t D>
[[gnu::always_inline]] inline T determinant_of(const std::array<std::array<T, D>, D>& rows) {
  if constexpr (D == 2) {
    return cross2(rows[0], rows[1]);
  } else {
    return dot_of(rows[0], cross3(rows[1], rows[2]));
  }
}
template <std::size_t D, class Maker>
[[gnu::always_inline]] inline auto rows_made(const Maker& maker, const std::array<Numbers<D>, D>& rows) {
  if constexpr (D == 2) {
    return std::array{made<2>(maker, rows[0]), made<2>(maker, rows[1])};
  } else {
    return std::array{made<3>(maker, rows[0]), made<3>(maker, rows[1]), made<3>(maker, rows[2])};
  }
}
template <std::size_t D>
Sign determinant_sign_of(const std::array<Numbers<D>, D>& rows) {
  return sign_over_all([&](const auto& maker) { return determinant_of(rows_made<D>(maker, rows)); });
}

/// The point of D planes over numbers of kind T, times their determinant.
template <class T, std::size_t D>
struct CornerNumbers {
  std::array<T, D> at, far;
  T weight;
};
/// The point of rows with these limits, times the determinant.
template <class T, std::size_t D>
[[gnu::always_inline]] inline std::array<T, D> meeting_of(const std::array<std::array<T, D>, D>& minors,
                                                          const std::array<T, D>& limits) {
  if constexpr (D == 2) {
    return {minors[0][0] * limits[0] + minors[1][0] * limits[1], minors[0][1] * limits[0] + minors[1][1] * limits[1]};
  } else {
    return {minors[0][0] * limits[0] + minors[1][0] * limits[1] + minors[2][0] * limits[2],
            minors[0][1] * limits[0] + minors[1][1] * limits[1] + minors[2][1] * limits[2],
            minors[0][2] * limits[0] + minors[1][2] * limits[1] + minors[2][2] * limits[2]};
  }
}
/// What each row's limit is multiplied with: cross products of the others.
template <class T, std::size_t D>
[[gnu::always_inline]] inline std::array<std::array<T, D>, D> minors_of(const std::array<std::array<T, D>, D>& n,
                                                                        const T& zero) {
  if constexpr (D == 2) {
    return {std::array{n[1][1], zero - n[1][0]}, std::array{zero - n[0][1], n[0][0]}};
  } else {
    return {cross3(n[1], n[2]), cross3(n[2], n[0]), cross3(n[0], n[1])};
  }
}
template <std::size_t D, class Maker>
[[gnu::always_inline]] inline auto corner_numbers(const std::array<LpPlane<D>, D>& p, bool has_far,
                                                  const Maker& maker) {
  using T = decltype(maker(0.0));
  std::array<Numbers<D>, D> normals;
  Numbers<D> limits, far;
  for (std::size_t k = 0; k < D; ++k) normals[k] = p[k].normal, limits[k] = p[k].limit, far[k] = p[k].far;
  const auto n = rows_made<D>(maker, normals);
  const auto minors = minors_of(n, maker(0));
  CornerNumbers<T, D> r{meeting_of(minors, made<D>(maker, limits)), made<D>(maker, Numbers<D>{}),
                        dot_of(n[0], minors[0])};
  if (has_far) r.far = meeting_of(minors, made<D>(maker, far));
  return r;
}

template <std::size_t D>
class Corner {
 public:
  Corner() = default;

  /// The point of these, whose normals are independent.
  void set(const std::array<LpPlane<D>, D>& planes) {
    planes_ = planes;
    has_far_ = false;
    for (const LpPlane<D>& p : planes) has_far_ = has_far_ || p.far != 0;
    quick_ = corner_numbers<D>(planes_, has_far_, [](double x) { return Approximate(x); });
    stack_ = Kept::no, has_big_ = false;
    int turn = quick_.weight.certain_sign();
    if (turn == 0) {
      std::array<Numbers<D>, D> rows;
      for (std::size_t k = 0; k < D; ++k) rows[k] = planes[k].normal;
      turn = static_cast<int>(determinant_sign_of<D>(rows));
    }
    if (turn > 0) return;
    std::swap(planes_[0], planes_[1]);  // which turns all exact numbers round, and so those in doubles may be
    const auto turned = [](Approximate& x) { x.value = -x.value; };
    for (std::size_t k = 0; k < D; ++k) turned(quick_.at[k]), turned(quick_.far[k]);
    turned(quick_.weight);
  }

  [[nodiscard]] const std::array<LpPlane<D>, D>& planes() const { return planes_; }
  [[nodiscard]] bool has_far() const { return has_far_; }
  [[nodiscard]] const CornerNumbers<Approximate, D>& quick() const { return quick_; }

  /// normal . x - limit here over numbers of any kind.
  template <class T, class Maker>
  [[gnu::always_inline]] static T value(const CornerNumbers<T, D>& c, const Numbers<D>& normal, double limit,
                                        const Maker& maker) {
    return dot_of(made<D>(maker, normal), c.at) - maker(limit) * c.weight;
  }

  /// Is the point beyond the plane (positive), in it, or on its inner side?
  [[nodiscard]] Sign side(const LpPlane<D>& p) {
    for (const LpPlane<D>& own : planes_) {  // it is in those that make it
      if (own.number == p.number && (p.number != no_constraint || own.normal == p.normal)) return Sign::zero;
    }
    if (has_far_ || p.far != 0) {
      const Sign far = sign([&](const auto& c, const auto& maker) {
        return dot_of(made<D>(maker, p.normal), c.far) - maker(p.far) * c.weight;
      });
      if (far != Sign::zero) return far;
    }
    return sign([&](const auto& c, const auto& maker) { return value(c, p.normal, p.limit, maker); });
  }

  /// Of direction . x: its part with M.
  [[nodiscard]] Sign far_along(const Numbers<D>& direction) {
    if (!has_far_) return Sign::zero;
    return sign([&](const auto& c, const auto& maker) { return dot_of(made<D>(maker, direction), c.far); });
  }

 private:
  enum class Kept : unsigned char { no, yes, beyond };

  /// Of a formula over the numbers of the point.
  template <class Formula>
  Sign sign(const Formula& formula) {
    const int quick = formula(quick_, [](double x) { return Approximate(x); }).certain_sign();
    if (quick != 0) return static_cast<Sign>(quick);
    return exact_sign(formula);
  }
  template <class Formula>
  [[gnu::noinline]] Sign exact_sign(const Formula& formula) {
    const auto to_stack = [](double x) { return StackDyadic(x); };
    const auto to_big = [](double x) { return BigDyadic(x); };
    const auto to_zero = [](double x) { return StructuralZero(x == 0); };
    if (formula(corner_numbers<D>(planes_, has_far_, to_zero), to_zero).certain) return Sign::zero;
    StackDyadic::clear_range();
    if (stack_ == Kept::no) {
      on_stack_ = corner_numbers<D>(planes_, has_far_, to_stack);
      stack_ = StackDyadic::left_range() ? Kept::beyond : Kept::yes;
    }
    if (stack_ == Kept::yes) {
      const Sign s = formula(on_stack_, to_stack).sign();
      if (!StackDyadic::left_range()) return s;
    }
    if (!has_big_) big_ = corner_numbers<D>(planes_, has_far_, to_big), has_big_ = true;
    return formula(*big_, to_big).sign();
  }

  std::array<LpPlane<D>, D> planes_{};
  bool has_far_ = false, has_big_ = false;
  Kept stack_ = Kept::no;
  CornerNumbers<Approximate, D> quick_ = corner_numbers<D>(planes_, false, [](double x) { return Approximate(x); });
  CornerNumbers<StackDyadic, D> on_stack_;
  std::optional<CornerNumbers<BigDyadic, D>> big_;
};

template <class Named>
auto lp_plane(const Named& n) {
  const auto normal = numbers_of(n.halfspace.normal);
  return LpPlane<normal.size()>{normal, n.halfspace.offset, 0, n.number};
}
inline const Halfspace2& halfspace_of(const Halfspace2& h) { return h; }
inline const Halfspace3& halfspace_of(const Halfspace3& h) { return h; }
inline const Halfspace2& halfspace_of(const NamedHalfspace2& n) { return n.halfspace; }
inline const Halfspace3& halfspace_of(const NamedHalfspace3& n) { return n.halfspace; }

/// The first of constraints [from, to) that a corner violates; `to` where it violates none.  Their numbers are theirs,
/// or their places.
template <std::size_t D, class Constraint>
std::size_t first_violated(Corner<D>& corner, const LargestNumbers<D>& largest, std::span<const Constraint> constraints,
                           std::size_t from, std::size_t to) {
  const auto is_violated = [&](std::size_t i) {
    LpPlane<D> p{numbers_of(halfspace_of(constraints[i]).normal), halfspace_of(constraints[i]).offset, 0,
                 static_cast<std::uint32_t>(i)};
    if constexpr (requires { constraints[i].number; }) p.number = constraints[i].number;
    return corner.side(p) == Sign::positive;
  };
  if (corner.has_far()) {
    for (std::size_t i = from; i < to; ++i) {
      if (is_violated(i)) return i;
    }
    return to;
  }
  // No number of a constraint is larger than the largest, so no bound of a constraint's value is larger than theirs.
  const double inside =
      -Corner<D>::value(corner.quick(), largest.normal, largest.limit, [](double x) { return Approximate(x); }).reach();
  CornerNumbers<double, D> c{};
  for (std::size_t k = 0; k < D; ++k) c.at[k] = corner.quick().at[k].value;
  c.weight = corner.quick().weight.value;
  for (std::size_t i = from; i < to; ++i) {
    const auto& h = halfspace_of(constraints[i]);
    const double value = Corner<D>::value(c, numbers_of(h.normal), h.offset, [](double x) { return x; });
    if (value < inside) continue;
    if (is_violated(i)) return i;
  }
  return to;
}

}  // namespace plumb::query
