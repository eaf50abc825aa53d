// Ray cast: what do lanes of doubles say of one ray against as many triangles?  The one statement of that test.
//
// What it proves is said in query/ray/filters.hpp.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_TRIANGLE_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_TRIANGLE_LANES
#undef PLUMB_TRIANGLE_LANES
#else
#define PLUMB_TRIANGLE_LANES
#endif

#include <hwy/highway.h>

#include <limits>

#include "query/ray/batch_lanes.hpp"
#include "query/ray/filters.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
inline constexpr std::size_t lanes = hn::MaxLanes(D());

struct Lanes3 {
  V x, y, z;
};
HWY_INLINE V dot(const Lanes3& u, const Lanes3& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
HWY_INLINE Lanes3 cross(const Lanes3& u, const Lanes3& v) {
  return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
}
HWY_INLINE Lanes3 difference(const Lanes3& u, const Lanes3& v) {
  return {hn::Sub(u.x, v.x), hn::Sub(u.y, v.y), hn::Sub(u.z, v.z)};
}
HWY_INLINE V largest(V a, V b, V c) { return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c)); }

struct RayLanes {
  Lanes3 origin, direction;
  RayDoubts doubts;
  bool begins, ends;

  explicit RayLanes(const BatchRay& ray, const RayDoubts& in_doubt = {})
      : origin{hn::Set(D(), ray.origin[0]), hn::Set(D(), ray.origin[1]), hn::Set(D(), ray.origin[2])},
        direction{hn::Set(D(), ray.direction[0]), hn::Set(D(), ray.direction[1]), hn::Set(D(), ray.direction[2])},
        doubts(in_doubt),
        begins(ray.begins),
        ends(ray.ends) {}

  /// What is given, else what the magnitudes say.
  [[nodiscard]] HWY_INLINE V doubt(double given, V by_magnitude) const {
    return doubts.are_given ? hn::Set(D(), given) : by_magnitude;
  }
};

/// Bit i is the triangle of lane i: hit it is not, it is, else nothing is told; and between which parameters it is hit
/// where it is, infinities where nothing is known of that.
struct TrianglesTold {
  unsigned no, yes;
  V least, most;
};

HWY_INLINE unsigned bits_of(hn::Mask<D> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0];
}

HWY_INLINE TrianglesTold tell(const RayLanes& ray, const Lanes3& p, const Lanes3& q, const Lanes3& r) {
  const D tag;
  const auto all = [&](double x) { return hn::Set(tag, x); };
  const Lanes3 a = difference(p, ray.origin), b = difference(q, ray.origin), c = difference(r, ray.origin);
  const Lanes3& d = ray.direction;
  const V zero = hn::Zero(tag), outside = all(guard), inside = all(guard_inside), slack = all(magnitude_slack);
  const Lanes3 of_bc = cross(c, b);
  const V ab = dot(d, cross(b, a)), bc = dot(d, of_bc), ca = dot(d, cross(a, c));
  const V x = largest(a.x, b.x, c.x), y = largest(a.y, b.y, c.y), z = largest(a.z, b.z, c.z);
  const V yz = hn::Add(hn::Mul(y, z), inside), zx = hn::Add(hn::Mul(z, x), inside), xy = hn::Add(hn::Mul(x, y), inside);
  const V magnitude = dot({hn::Abs(d.x), hn::Abs(d.y), hn::Abs(d.z)}, {yz, zx, xy});
  const V sum = hn::Add(hn::Add(ab, bc), ca);
  const V doubt =
      ray.doubt(ray.doubts.edge,
                hn::Add(hn::Mul(all(edge_constant), hn::Add(hn::Mul(slack, magnitude), outside)), hn::Sub(sum, sum)));
  const V least = hn::Min(hn::Min(ab, bc), ca), most = hn::Max(hn::Max(ab, bc), ca);
  auto no = hn::And(hn::Gt(most, doubt), hn::Lt(least, hn::Neg(doubt)));
  if (hn::AllTrue(tag, no)) return {~0u, 0, zero, zero};  // most often so
  auto yes = hn::Or(hn::Gt(least, doubt), hn::Lt(most, hn::Neg(doubt)));
  // Toward the plane: both with the sign of D, where that is known.
  const V value = dot(a, of_bc), way = hn::IfThenElse(hn::Gt(sum, zero), value, hn::Neg(value));
  const V volume = hn::Add(hn::Add(hn::Mul(x, yz), hn::Mul(y, zx)), hn::Mul(z, xy));
  const V off = ray.doubt(ray.doubts.plane,
                          hn::Add(hn::Mul(all(filter_constant<PlaneAhead>()), hn::Add(hn::Mul(slack, volume), outside)),
                                  hn::Sub(value, value)));
  const V speed = hn::Abs(sum);
  if (ray.begins) {
    no = hn::Or(no, hn::And(yes, hn::Lt(way, hn::Neg(off))));
    auto sure = hn::Gt(way, off);
    if (ray.ends) {
      const V rest = hn::Sub(way, speed);
      const V far =
          ray.doubt(ray.doubts.end,
                    hn::Add(hn::Mul(all(filter_constant<PlaneBehindEnd>()),
                                    hn::Add(hn::Mul(slack, hn::Add(hn::Mul(all(3), magnitude), volume)), outside)),
                            hn::Sub(rest, rest)));
      no = hn::Or(no, hn::And(yes, hn::Gt(rest, far)));
      sure = hn::And(sure, hn::Lt(rest, hn::Neg(far)));
    }
    yes = hn::And(yes, sure);
  }
  // D is the sum of three that are each off by `doubt`, rounded twice; quotients by once more.
  const V blur = ray.doubt(ray.doubts.sum, hn::Mul(all(4), doubt)), slow = hn::Sub(speed, blur),
          fast = hn::Add(speed, blur);
  const V near = hn::Sub(way, off), away = hn::Add(way, off);
  const V infinity = all(std::numeric_limits<double>::infinity());
  const auto ahead = hn::Ge(near, zero), behind = hn::Le(away, zero);
  const V low = hn::Div(near, hn::IfThenElse(ahead, fast, slow)),
          high = hn::Div(away, hn::IfThenElse(behind, fast, slow));
  const auto known = hn::Gt(slow, zero);
  const V room = all(0x1p-50), room_below = hn::Mul(hn::Abs(low), room), room_above = hn::Mul(hn::Abs(high), room);
  const V tiny = all(0x1p-1070);
  return {bits_of(no), bits_of(yes), hn::IfThenElse(known, hn::Sub(hn::Sub(low, room_below), tiny), hn::Neg(infinity)),
          hn::IfThenElse(known, hn::Add(hn::Add(high, room_above), tiny), infinity)};
}

}  // namespace plumb::query::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
