#include <array>

#include "plumb/figure/basic/box.hpp"
#include "query/time_of_impact/quick_motion.hpp"

namespace plumb::query::quick {
namespace {

// Along an axis the boxes meet from gap / speed to way / speed, quotients of differences of two numbers: each is off by
// less than 3 units of 2^-53 of itself, and by underflow.
constexpr double slack = 0x1p-50, underflow = 0x1p-1060;

constexpr double low(double x) { return x - magnitude_of(x) * slack - underflow; }
constexpr double high(double x) { return x + magnitude_of(x) * slack + underflow; }

/// Along one axis, the motion mirrored so that it goes upward.
struct AxisMotion {
  std::array<double, 2> a, b;  // mirrored; from lower to upper
  std::array<double, 2> by;
  double speed;
  bool mirrored;
};

AxisMotion axis_of(double a0, double a1, double b0, double b1, double of_a, double of_b) {
  if (of_a >= of_b) return {{a0, a1}, {b0, b1}, {of_a, of_b}, of_a - of_b, false};
  return {{-a1, -a0}, {-b1, -b0}, {-of_a, -of_b}, of_b - of_a, true};
}

/// How the ends of a lie to those of b at a time, where that is certain.
struct EndOrder {
  bool certain = true;
  std::array<bool, 2> of_a_in_b{}, of_b_in_a{};
};

EndOrder ends_at(const AxisMotion& x, double time) {
  EndOrder e;
  std::array<std::array<bool, 2>, 2> after{};  // a's end i is after b's end j
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const double apart = x.b[j] - x.a[i], gone = time * x.speed;
      const double off = (magnitude_of(apart) + gone) * slack + underflow;
      after[i][j] = gone > apart;
      e.certain &= magnitude_of(gone - apart) > off;
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
std::optional<Contact> features(const std::array<AxisMotion, 3>& axes, std::size_t first, double time) {
  std::array<unsigned, 3> of_a{2, 2, 2}, of_b{2, 2, 2};
  of_a[first] = axes[first].mirrored ? 0 : 1, of_b[first] = 1 - of_a[first];
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == first) continue;
    const EndOrder e = ends_at(axes[k], time);
    if (!e.certain) return {};
    if (e.of_a_in_b[0] || e.of_a_in_b[1]) {
      of_a[k] = e.of_a_in_b[0] ? 0 : 1;
    } else {
      of_b[k] = e.of_b_in_a[0] ? 0 : 1;
    }
  }
  return Contact{0, box_feature(of_a), box_feature(of_b)};
}

/// gap / speed, rounded down.
Answer entering(const AxisMotion& x, const Contact& contact) {
  const Rounded gap = two_sum(x.b[0], -x.a[1]), speed = two_sum(x.by[0], -x.by[1]);
  const double q = gap.value / speed.value;
  if (gap.error == 0 && speed.error == 0 && q > 0x1p-400 && speed.value > 0x1p-400 && speed.value < 0x1p400) {
    const Rounded p = two_product(q, speed.value);
    const double left = (gap.value - p.value) - p.error;  // its sign is right: the first difference is exact
    return {MotionVerdict::yes, {left < 0 ? Ball::next(q, -1) : q, contact.feature_a, contact.feature_b}};
  }
  return at(quotient(Pairs::difference(x.b[0], x.a[1]), Pairs::difference(x.by[0], x.by[1])), contact.feature_a,
            contact.feature_b);
}

}  // namespace

template <ContactWanted asked>
Answer contact(const Translating<Aabb3>& a, const Translating<Aabb3>& b) {
  const auto& [p, q] = a.shape;
  const auto& [r, s] = b.shape;
  double from = 0, second = 0, to = 1, all_speeds = 0;
  std::size_t first = 3;
  bool together = true, within = true;  // at the start
  // False: they never meet.
  const auto narrow = [&](std::size_t k, double a0, double a1, double b0, double b1, double of_a, double of_b) {
    // Which way it goes cannot be predicted, so nothing branches on it.  The signs of differences are exact.
    const double signed_speed = of_a - of_b, ahead = b0 - a1, behind = a0 - b1, speed = magnitude_of(signed_speed);
    const double gap = signed_speed < 0 ? behind : ahead, way = signed_speed < 0 ? -ahead : -behind;
    if (way < 0 || low(gap) > high(speed)) return false;
    all_speeds += speed;
    together = together && gap <= 0;
    within = within && gap < 0 && way > 0;
    const double enters = gap / speed, leaves = way / speed;  // NaN, where it touches and rests
    if (enters > from) {
      second = from, from = enters, first = k;
    } else if (enters > second) {
      second = enters;
    }
    if (leaves < to) to = leaves;
    return true;
  };
  if (!narrow(0, p.x, q.x, r.x, s.x, a.by.x, b.by.x)) return no;
  if (!narrow(1, p.y, q.y, r.y, s.y, a.by.y, b.by.y)) return no;
  if (!narrow(2, p.z, q.z, r.z, s.z, a.by.z, b.by.z)) return no;
  if (!(all_speeds < Ball::infinity)) return unsure;
  if (low(from) > high(to)) return no;
  if (first == 3) {
    if (!together) return unsure;  // a time has vanished
    if constexpr (asked == ContactWanted::whether) return overlap;
  } else {
    if (!(high(from) <= low(to))) return unsure;
    if constexpr (asked == ContactWanted::whether) return {MotionVerdict::yes};
  }
  if (!(p.x < q.x && p.y < q.y && p.z < q.z && r.x < s.x && r.y < s.y && r.z < s.z)) return unsure;
  if (first == 3) return within ? overlap : unsure;
  if (!(low(from) > high(second))) return unsure;
  const std::array<AxisMotion, 3> axes{axis_of(p.x, q.x, r.x, s.x, a.by.x, b.by.x),
                                       axis_of(p.y, q.y, r.y, s.y, a.by.y, b.by.y),
                                       axis_of(p.z, q.z, r.z, s.z, a.by.z, b.by.z)};
  const std::optional<Contact> meeting = features(axes, first, from);
  return meeting ? entering(axes[first], *meeting) : unsure;
}
PLUMB_QUICK_PAIR(Aabb3, Aabb3)

}  // namespace plumb::query::quick
