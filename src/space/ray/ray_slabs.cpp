#include "plumb/space/ray/ray_slabs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "plumb/arith/ball.hpp"
#include "plumb/arith/bound.hpp"
#include "plumb/arith/interval.hpp"
#include "query/ray/numbers.hpp"
#include "space/ray/packet_task.hpp"

namespace plumb {
namespace {

/// |computed - exact| <= error (|computed| + guard), of a plane's parameter.
constexpr double slab_error = static_cast<double>(RaySlabs::parameter<Bound>(Bound::Input{}, {}, {}).e) * Bound::unit;
constexpr double slab_narrowed = Interval::sum_down(1, -slab_error), slab_widened = Interval::sum_up(1, slab_error);

/// The same where the rate is a reciprocal, times what narrows or widens it: of a direction, or of the rounded difference
/// of a segment's ends.  A quotient errs as a product does.
constexpr Bound rounded_once{Bound::eps, 0};
constexpr double quick_error =
    static_cast<double>(RaySlabs::parameter<Bound>(Bound{Bound::Input{}}, Bound{Bound::Input{}},
                                                   rounded_once* rounded_once* rounded_once)
                            .e) *
    Bound::unit;
constexpr double quick_narrowed = Interval::sum_down(1, -quick_error), quick_widened = Interval::sum_up(1, quick_error);

// Beyond it differences with boxes might overflow.
constexpr double most_slab_size = 0x1p1000;

/// From such a multiple of the way through the root's box on, a ray is one from far away, whose keys floats would not
/// tell apart: a guess.
constexpr double far_away = 0x1p10;

// Within these no difference, quotient or product below overflows, so that numbers need no scaling: a guess of what is
// worth a path of its own, which decides nothing.
constexpr double least_moderate = 0x1p-100, most_moderate = 0x1p100;
bool is_moderate(double x) { return x == 0 || (std::abs(x) > least_moderate && std::abs(x) < most_moderate); }

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

/// The next double outward that no box has, so that differences with boxes are not zero.
double beyond_floats(double x, double outward) {
  do {
    x = std::nextafter(x, outward);
  } while (is_float(x));
  return x;
}

/// x 2^n.
Ball scaled_number(double x, int n) {
  const double y = std::ldexp(x, n);
  if (std::ldexp(y, -n) == x) return Ball{y};
  return {y, 0, std::abs(y) < 1 ? std::numeric_limits<double>::denorm_min() : Ball::infinity};
}
Ball scaled_number(const Ball& x, int n) {
  const Ball high = scaled_number(x.high, n), low = scaled_number(x.low, n);
  const double radius = std::ldexp(x.radius, n);
  return {high.high, low.high,
          Interval::sum_up(Interval::sum_up(high.radius, low.radius),
                           std::ldexp(radius, -n) == x.radius ? radius : std::nextafter(radius, Ball::infinity))};
}

double scaled_up(double x, int n) {
  const double y = std::ldexp(x, n);
  return std::ldexp(y, -n) == x ? y : std::nextafter(y, Ball::infinity);
}

Interval around(const Ball& x) { return Interval{x.high} + Interval{x.low} + Interval{-x.radius, x.radius}; }
bool is_finite(const Interval& x) { return x.lower > -most_slab_size && x.upper < most_slab_size; }

bool is_finite(const FloatBox3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(std::abs(box.min[k]) < Ball::infinity && std::abs(box.max[k]) < Ball::infinity)) return false;
  }
  return true;
}

/// What the parameter of a plane at a box's end is computed of.
struct SlabPlane {
  double from, rate;
};

/// Of both ends, for a ray from such a place and of such a direction along the axis: never later at the plane where it
/// enters, never earlier where it leaves.  Which of the two is which is told by their order.
struct AxisPlanes {
  SlabPlane low, high;

  /// From a place that is given, at a rate that is rounded as quick_error says.
  AxisPlanes(double from, double rate) {
    const double narrow = rate * quick_narrowed, wide = rate * quick_widened;
    low = {from, rate < 0 ? wide : narrow};
    high = {from, rate < 0 ? narrow : wide};
  }

  AxisPlanes(const Interval& f, const Interval& w) : low{0, 0}, high{-Ball::infinity, Ball::infinity} {
    if (w.lower < 0 && w.upper > 0) return;  // which way is not known: any box is met from 0 to infinity
    const bool down = w.lower < 0;
    const double least = down ? -w.upper : w.lower, most = down ? -w.lower : w.upper;
    SlabPlane enter{down ? f.lower : f.upper, Ball::infinity}, leave{down ? f.upper : f.lower, Ball::infinity};
    if (most > 0) enter.rate = Interval::product_down(std::max(Interval::quotient_down(1, most), 0.0), slab_narrowed);
    if (least > 0) leave.rate = Interval::product_up(-Interval::quotient_down(-1, least), slab_widened);
    const double outward = down ? -Ball::infinity : Ball::infinity;
    if (enter.rate == Ball::infinity) enter.from = beyond_floats(enter.from, outward);
    if (leave.rate == Ball::infinity) leave.from = beyond_floats(leave.from, -outward);
    low = down ? SlabPlane{leave.from, -leave.rate} : enter;
    high = down ? SlabPlane{enter.from, -enter.rate} : leave;
  }
};

}  // namespace

/// The ray in the tree's numbers, axis by axis.
struct SlabSetting {
  std::array<Ball, 3> from{Ball{0}, Ball{0}, Ball{0}}, way{Ball{0}, Ball{0}, Ball{0}};
  int exponent;  // t = key 2^exponent

  SlabSetting(const AnyRay& ray, int frame) : exponent(0) {
    const std::array origin{ray.origin.x, ray.origin.y, ray.origin.z}, end{ray.end.x, ray.end.y, ray.end.z},
        direction{ray.direction.x, ray.direction.y, ray.direction.z};
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = scaled_number(origin[k], -frame);
      way[k] = query::ends(ray) ? scaled_number(end[k], -frame) - from[k] : Ball{direction[k]};
      largest = std::max(largest, std::abs(way[k].high));
    }
    const int scale = largest > 0 && largest < Ball::infinity ? -std::ilogb(largest) : 0;
    for (Ball& w : way) w = scaled_number(w, scale);
    exponent = query::ends(ray) ? scale : scale + frame;
  }

  [[nodiscard]] bool is_finite() const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!plumb::is_finite(around(from[k])) || !plumb::is_finite(around(way[k]))) return false;
    }
    return true;
  }

  SlabSetting(const std::array<Ball, 3>& place, const std::array<Ball, 3>& direction, int frame) : exponent(0) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = scaled_number(place[k], -frame);
      largest = std::max(largest, std::abs(direction[k].high));
    }
    const int scale = largest > 0 && largest < Ball::infinity ? -std::ilogb(largest) : 0;
    for (std::size_t k = 0; k < 3; ++k) way[k] = scaled_number(direction[k], scale);
    exponent = scale + frame;
  }

  /// A key before the line comes to the box, and one about when it leaves.
  [[nodiscard]] Interval span_of(const FloatBox3& box) const {
    double enters = -Ball::infinity, leaves = Ball::infinity;
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval w = around(way[k]), f = around(from[k]);
      if (w.lower <= 0 && w.upper >= 0) continue;
      const bool down = w.upper < 0;
      const double in = down ? box.max[k] : box.min[k], out = down ? box.min[k] : box.max[k];
      enters = std::max(enters, quotient(Interval{in} - f, w).lower);
      leaves = std::min(leaves, quotient(Interval{out} - f, w).upper);
    }
    return {enters, leaves};
  }

  /// Where keys begin at `start`.
  [[nodiscard]] SlabSetting moved(double start) const {
    SlabSetting other = *this;
    for (std::size_t k = 0; k < 3; ++k) other.from[k] = from[k] + Ball{start} * way[k];
    return other;
  }

  void fill(RaySlabs& slabs) const {
    for (std::size_t k = 0; k < 3; ++k) put(slabs, k, AxisPlanes(around(from[k]), around(way[k])));
  }

  static void put(RaySlabs& slabs, std::size_t k, const AxisPlanes& planes) {
    if (k == 2) {
      slabs.z_from_ = RaySlabs::Pair{planes.low.from, planes.high.from};
      slabs.z_rate_ = RaySlabs::Pair{planes.low.rate, planes.high.rate};
    } else {
      slabs.low_from_[k] = planes.low.from;
      slabs.low_rate_[k] = planes.low.rate;
      slabs.high_from_[k] = planes.high.from;
      slabs.high_rate_[k] = planes.high.rate;
    }
  }

  /// Of most rays: with moderate numbers, from not far away, in a tree without a frame.  Keys are their parameters.
  static bool fill_plainly(RaySlabs& slabs, const AnyRay& ray, const BoxFrame& frame, const FloatBox3& all) {
    if (frame.exponent() != 0 || !query::begins(ray)) return false;
    const std::array origin{ray.origin.x, ray.origin.y, ray.origin.z}, end{ray.end.x, ray.end.y, ray.end.z},
        direction{ray.direction.x, ray.direction.y, ray.direction.z};
    std::array<double, 3> way;
    double distance = 0, extent = 0;
    bool plain = true;
    for (std::size_t k = 0; k < 3; ++k) {
      way[k] = query::ends(ray) ? end[k] - origin[k] : direction[k];
      plain &= is_moderate(way[k]) && std::abs(origin[k]) < most_moderate;
      const double low = all.min[k], high = all.max[k];
      plain &= std::abs(low) < most_moderate && std::abs(high) < most_moderate;
      distance = std::max({distance, low - origin[k], origin[k] - high});
      extent = std::max(extent, high - low);
    }
    if (!plain || distance > far_away * extent) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      put(slabs, k, way[k] == 0 ? AxisPlanes(Interval{origin[k]}, Interval{0}) : AxisPlanes(origin[k], 1 / way[k]));
    }
    return true;
  }
};

RaySlabs::RaySlabs(const AnyRay& ray, const BoxFrame& frame, const FloatBox3& all) {
  if (!query::is_sound(ray)) query::require_ray("RaySlabs", ray);
  if (SlabSetting::fill_plainly(*this, ray, frame, all)) {
    if (query::ends(ray)) keys_.limit = 1;
    return;
  }
  set(SlabSetting(ray, frame.exponent()), query::begins(ray) || query::has_no_direction(ray), query::ends(ray), all);
}

RaySlabs::RaySlabs(AnyRay::Kind kind, const std::array<Ball, 3>& from, const std::array<Ball, 3>& way,
                   const BoxFrame& frame, const FloatBox3& all) {
  set(SlabSetting(from, way, frame.exponent()), kind != AnyRay::Kind::line, kind == AnyRay::Kind::segment, all);
}

void RaySlabs::set(SlabSetting setting, bool begins, bool ends, const FloatBox3& all) {
  keys_.exponent = setting.exponent;
  all_met_ = !setting.is_finite() || !plumb::is_finite(all);
  for (double& start : keys_.starts) {
    if (all_met_) break;
    const Interval span = setting.span_of(all);
    const bool far = span.lower > 0 && span.lower > far_away * (span.upper - span.lower);
    if ((begins && !far) || !is_finite(span)) break;
    start = span.lower;
    setting = setting.moved(start);
    begins = true;
    all_met_ = !setting.is_finite();
  }
  all_met_ = all_met_ || !begins;  // keys of a line have no least one yet
  if (!all_met_) setting.fill(*this);
  if (ends) keys_.limit = limit_at(1);
}

// Two rays at once.
bool space::put_plainly(std::span<const AnyRay* const> rays, const BoxFrame& frame, const FloatBox3& all,
                        PacketPlanes& planes) {
  using Pair = double __attribute__((vector_size(16)));
  using Mask = std::int64_t __attribute__((vector_size(16)));
  if (frame.exponent() != 0) return false;
  alignas(64) double from[3][packet_size], way[3][packet_size];
  for (std::size_t i = 0; i < packet_size; ++i) {
    const AnyRay& r = *rays[std::min(i, rays.size() - 1)];
    if (!query::begins(r)) return false;
    const bool ends = query::ends(r);
    from[0][i] = r.origin.x, from[1][i] = r.origin.y, from[2][i] = r.origin.z;
    way[0][i] = ends ? r.end.x - r.origin.x : r.direction.x;
    way[1][i] = ends ? r.end.y - r.origin.y : r.direction.y;
    way[2][i] = ends ? r.end.z - r.origin.z : r.direction.z;
    for (std::size_t k = 0; i == 1 && k < 3; ++k) {  // most often seen here where they do not fit
      if ((way[k][1] < 0) != (way[k][0] < 0)) return false;
    }
  }
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = all.min[k], high = all.max[k];
    if (!(std::abs(low) < most_moderate && std::abs(high) < most_moderate)) return false;
    extent = std::max(extent, high - low);
  }
  const auto two = [](const double* numbers) {
    Pair both;
    std::memcpy(&both, numbers, sizeof both);
    return both;
  };
  const double near = far_away * extent;
  Mask plain{-1, -1};
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = all.min[k], high = all.max[k];
    const bool down = way[k][0]<0, up = way[k][0]> 0;
    for (std::size_t i = 0; i < packet_size; i += 2) {
      const Pair w = two(way[k] + i), f = two(from[k] + i), size = w < 0 ? -w : w;
      if (down || up) {
        plain &= (down ? w < 0 : w > 0) & (size > least_moderate) & (size < most_moderate);
      } else {
        plain &= w == 0;
      }
      plain &= (f < most_moderate) & (f > -most_moderate) & (low - f <= near) & (f - high <= near);
    }
  }
  if ((plain[0] & plain[1]) == 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    planes.down[k] = way[k][0] < 0;
    auto &enter = planes.enter[k], &leave = planes.leave[k];
    for (std::size_t i = 0; i < packet_size; ++i) {
      const double rate = 1 / way[k][i];
      enter.from[i] = leave.from[i] = from[k][i];
      enter.rate[i] = rate * quick_narrowed;
      leave.rate[i] = rate * quick_widened;
    }
    for (std::size_t i = 0; i < packet_size && way[k][0] == 0; ++i) {
      const AxisPlanes a(Interval{from[k][i]}, Interval{0});
      planes.put(k, i, a.low.from, a.low.rate, a.high.from, a.high.rate);
    }
  }
  return true;
}

double RaySlabs::Keys::moved_limit_at(double t) const {
  const double key = Interval::sum_up(Interval::sum_up(scaled_up(t, -exponent), -starts[0]), -starts[1]);
  return std::min(key, std::numeric_limits<double>::max());
}

}  // namespace plumb
