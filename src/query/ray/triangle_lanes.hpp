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

/// Triangles seen from an origin: all of the test that the direction has no part in, for who asks several rays from there.
struct TrianglesSeen {
  Lanes3 a, of_ab, of_bc, of_ca;  // a corner, the cross products of corners
  V x, y, z, yz, zx, xy;          // magnitudes

  HWY_INLINE TrianglesSeen(const Lanes3& origin, const Lanes3& p, const Lanes3& q, const Lanes3& r) {
    const Lanes3 b = difference(q, origin), c = difference(r, origin);
    a = difference(p, origin);
    of_ab = cross(b, a), of_bc = cross(c, b), of_ca = cross(a, c);
    const V inside = hn::Set(D(), guard_inside);
    x = largest(a.x, b.x, c.x), y = largest(a.y, b.y, c.y), z = largest(a.z, b.z, c.z);
    yz = hn::Add(hn::Mul(y, z), inside), zx = hn::Add(hn::Mul(z, x), inside), xy = hn::Add(hn::Mul(x, y), inside);
  }
};

/// Of a ray from the origin that they are seen from.
HWY_INLINE TrianglesTold tell(const RayLanes& ray, const TrianglesSeen& seen) {
  const D tag;
  const auto all = [&](double number) { return hn::Set(tag, number); };
  const Lanes3& d = ray.direction;
  const V zero = hn::Zero(tag), outside = all(guard), slack = all(magnitude_slack);
  const V ab = dot(d, seen.of_ab), bc = dot(d, seen.of_bc), ca = dot(d, seen.of_ca);
  const V magnitude = dot({hn::Abs(d.x), hn::Abs(d.y), hn::Abs(d.z)}, {seen.yz, seen.zx, seen.xy});
  const V sum = hn::Add(hn::Add(ab, bc), ca);
  const V doubt =
      ray.doubt(ray.doubts.edge,
                hn::Add(hn::Mul(all(edge_constant), hn::Add(hn::Mul(slack, magnitude), outside)), hn::Sub(sum, sum)));
  const V least = hn::Min(hn::Min(ab, bc), ca), most = hn::Max(hn::Max(ab, bc), ca);
  auto no = hn::And(hn::Gt(most, doubt), hn::Lt(least, hn::Neg(doubt)));
  if (hn::AllTrue(tag, no)) return {~0u, 0, zero, zero};  // most often so
  auto yes = hn::Or(hn::Gt(least, doubt), hn::Lt(most, hn::Neg(doubt)));
  // Toward the plane: both with the sign of D, where that is known.
  const V value = dot(seen.a, seen.of_bc), way = hn::IfThenElse(hn::Gt(sum, zero), value, hn::Neg(value));
  const V volume = hn::Add(hn::Add(hn::Mul(seen.x, seen.yz), hn::Mul(seen.y, seen.zx)), hn::Mul(seen.z, seen.xy));
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

HWY_INLINE TrianglesTold tell(const RayLanes& ray, const Lanes3& p, const Lanes3& q, const Lanes3& r) {
  return tell(ray, TrianglesSeen(ray.origin, p, q, r));
}

}  // namespace plumb::query::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
