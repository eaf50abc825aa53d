#include <array>

#include "plumb/figure/basic/box.hpp"
#include "query/time_of_impact/quick_motion.hpp"

namespace plumb::query::quick {
namespace {

using T = Approximate;

/// Of two numbers as given.
T difference(double rounded) { return {rounded, magnitude_of(rounded), T::difference(1, 0).error}; }
/// Certainly; without looking for the other sign.
bool is_positive(const T& x) { return x.value > x.reach(); }

/// Along one axis, the motion mirrored so that it goes upward.
struct AxisMotion {
  std::array<double, 2> a, b;  // mirrored; from lower to upper
  std::array<double, 2> by;
  bool mirrored;

  [[nodiscard]] T gap(std::size_t i, std::size_t j) const { return T::difference(b[j], a[i]); }
  [[nodiscard]] T gap() const { return gap(1, 0); }
  [[nodiscard]] T speed() const { return T::difference(by[0], by[1]); }
};

AxisMotion axis_of(double a0, double a1, double b0, double b1, double of_a, double of_b) {
  if (of_a >= of_b) return {{a0, a1}, {b0, b1}, {of_a, of_b}, false};
  return {{-a1, -a0}, {-b1, -b0}, {-of_a, -of_b}, true};
}

/// How the ends of a lie to those of b when the boxes meet along the first axis, where that is certain.
struct EndOrder {
  bool certain = true;
  std::array<bool, 2> of_a_in_b{}, of_b_in_a{};
};

EndOrder ends_at(const AxisMotion& x, const AxisMotion& first) {
  EndOrder e;
  std::array<std::array<bool, 2>, 2> after{};  // a's end i is after b's end j
  const T gap = first.gap(), speed = first.speed(), own_speed = x.speed();
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const int side = certain_sign(own_speed * gap - x.gap(i, j) * speed);
      after[i][j] = side > 0;
      e.certain &= side != 0;
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t k = x.mirrored ? 1 - i : i;  // as the box has them
    e.of_a_in_b[k] = after[i][0] && !after[i][1];
    e.of_b_in_a[k] = !after[0][i] && after[1][i];
  }
  return e;
}

/// Of what a box has at one end of some axes (0 or 1) and the whole of the others (2).
Feature box_feature(const std::array<unsigned, 3>& part) {
  std::uint32_t bits = 0, wholes = 0, axis = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (part[k] == 2) {
      ++wholes, axis = k;
    } else {
      bits |= part[k] << k;
    }
  }
  if (wholes == 0) return {FeatureKind::vertex, bits};
  if (wholes == 1) {
    const std::uint32_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    return {FeatureKind::edge, 4 * axis + part[u] + 2 * part[v]};
  }
  const std::uint32_t across = part[0] != 2 ? 0 : part[1] != 2 ? 1 : 2;
  return {FeatureKind::face, 2 * across + part[across]};
}

/// The first features of two boxes that meet along one axis, and whose parts along the others are told.
std::optional<Contact> features(const std::array<AxisMotion, 3>& axes, std::size_t first) {
  std::array<unsigned, 3> of_a{2, 2, 2}, of_b{2, 2, 2};
  of_a[first] = axes[first].mirrored ? 0 : 1, of_b[first] = 1 - of_a[first];
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == first) continue;
    const EndOrder e = ends_at(axes[k], axes[first]);
    if (!e.certain) return {};
    if (e.of_a_in_b[0] || e.of_a_in_b[1]) {
      of_a[k] = e.of_a_in_b[0] ? 0 : 1;
    } else {
      of_b[k] = e.of_b_in_a[0] ? 0 : 1;
    }
  }
  return Contact{0, box_feature(of_a), box_feature(of_b)};
}

/// gap / speed, rounded down: of doubles a guess and the sign of what it leaves.
Answer entering(const AxisMotion& x, const Contact& contact) {
  const Rounded gap = two_sum(x.b[0], -x.a[1]), speed = two_sum(x.by[0], -x.by[1]);
  if (gap.error == 0 && speed.error == 0) {
    const double q = gap.value / speed.value;
    const Unsure<Sign> left = (Ball(gap.value) - Ball(q) * Ball(speed.value)).sign();
    if (left.certain()) {
      const double down = left.value() == Sign::negative ? Ball::next(q, -1) : q;
      return {MotionVerdict::yes, {down, contact.feature_a, contact.feature_b}};
    }
  }
  return at(quotient(Pairs::difference(x.b[0], x.a[1]), Pairs::difference(x.by[0], x.by[1])), contact.feature_a,
            contact.feature_b);
}

/// Along one axis the boxes meet from gap / speed to way / speed.
struct Along {
  double gap, way, speed;

  // The signs of differences are exact.
  Along(double a0, double a1, double b0, double b1, double of_a, double of_b) {
    const double signed_speed = of_a - of_b, ahead = b0 - a1, behind = a0 - b1;
    gap = signed_speed < 0 ? behind : ahead, way = signed_speed < 0 ? -ahead : -behind;
    speed = magnitude_of(signed_speed);
  }
  [[nodiscard]] bool never_meet() const { return way < 0 || is_positive(difference(gap) - difference(speed)); }
};

/// Of boxes that meet along each axis; by itself, so that others pay nothing for it.
template <ContactWanted asked>
[[gnu::noinline]] Answer contact_along(const Translating<Aabb3>& a, const Translating<Aabb3>& b) {
  const auto& [p, q] = a.shape;
  const auto& [r, s] = b.shape;
  const std::array<Along, 3> along{Along(p.x, q.x, r.x, s.x, a.by.x, b.by.x), Along(p.y, q.y, r.y, s.y, a.by.y, b.by.y),
                                   Along(p.z, q.z, r.z, s.z, a.by.z, b.by.z)};
  double from = 0, to = 1, all_speeds = 0;  // guesses
  std::size_t first = 3;
  bool together = true, within = true;  // at the start
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [gap, way, speed] = along[k];
    all_speeds += speed;
    together = together && gap <= 0;
    within = within && gap < 0 && way > 0;
    const double enters = gap / speed, leaves = way / speed;  // NaN, where it touches and rests
    if (enters > from) from = enters, first = k;
    if (leaves < to) to = leaves;
  }
  if (!(all_speeds < Ball::infinity)) return unsure;
  if (first == 3) {
    if (!together) return unsure;  // a time has vanished
    if constexpr (asked == ContactWanted::whether) return overlap;
  } else {
    // At a time between: do they overlap, or has one axis not come yet and another gone by?
    const T time(0.5 * (from + to));
    bool early = false, late = false, meet = time.value <= 1;
    for (const auto& [gap, way, speed] : along) {
      const T gone = time * difference(speed);
      const int enters = certain_sign(gone - difference(gap)), leaves = certain_sign(gone - difference(way));
      early |= enters < 0;
      late |= leaves > 0;
      meet &= enters > 0 && leaves < 0;
    }
    if (early && late) return no;
    if (!meet) return unsure;
    if constexpr (asked == ContactWanted::whether) return {MotionVerdict::yes};
  }
  if (!(p.x < q.x && p.y < q.y && p.z < q.z && r.x < s.x && r.y < s.y && r.z < s.z)) return unsure;
  if (first == 3) return within ? overlap : unsure;
  for (std::size_t k = 0; k < 3; ++k) {
    const Along &enter = along[first], &other = along[k];
    if (k != first &&
        !is_positive(difference(enter.gap) * difference(other.speed) - difference(other.gap) * difference(enter.speed)))
      return unsure;
  }
  const std::array<AxisMotion, 3> axes{axis_of(p.x, q.x, r.x, s.x, a.by.x, b.by.x),
                                       axis_of(p.y, q.y, r.y, s.y, a.by.y, b.by.y),
                                       axis_of(p.z, q.z, r.z, s.z, a.by.z, b.by.z)};
  const std::optional<Contact> meeting = features(axes, first);
  return meeting ? entering(axes[first], *meeting) : unsure;
}

}  // namespace

template <ContactWanted asked>
Answer contact(const Translating<Aabb3>& a, const Translating<Aabb3>& b) {
  const auto& [p, q] = a.shape;
  const auto& [r, s] = b.shape;
  if (Along(p.x, q.x, r.x, s.x, a.by.x, b.by.x).never_meet()) return no;
  if (Along(p.y, q.y, r.y, s.y, a.by.y, b.by.y).never_meet()) return no;
  if (Along(p.z, q.z, r.z, s.z, a.by.z, b.by.z).never_meet()) return no;
  return contact_along<asked>(a, b);
}
PLUMB_QUICK_PAIR(Aabb3, Aabb3)

}  // namespace plumb::query::quick
