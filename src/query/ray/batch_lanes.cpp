#include "query/ray/batch_lanes.hpp"

#include <limits>

#include "certify/batch/instruction_sets.hpp"
#include "query/ray/filters.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/ray/batch_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::query::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

struct Lanes3 {
  V x, y, z;
};
inline V dot(const Lanes3& u, const Lanes3& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
inline Lanes3 cross(const Lanes3& u, const Lanes3& v) {
  return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
}
inline V largest(V a, V b, V c) { return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c)); }

template <bool begins, bool ends>
void ask(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out) {
  const D tag;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  const auto all = [&](double x) { return hn::Set(tag, x); };
  const Lanes3 o{all(ray.origin[0]), all(ray.origin[1]), all(ray.origin[2])};
  const Lanes3 d{all(ray.direction[0]), all(ray.direction[1]), all(ray.direction[2])};
  const Lanes3 size{hn::Abs(d.x), hn::Abs(d.y), hn::Abs(d.z)};
  const V inside = all(guard_inside), outside = all(guard), slack = all(magnitude_slack), zero = hn::Zero(tag);
  for (std::size_t i = 0; i < n; i += lanes) {
    const auto corner = [&](std::size_t k) {
      return Lanes3{hn::Sub(hn::LoadU(tag, at[k] + i), o.x), hn::Sub(hn::LoadU(tag, at[k + 1] + i), o.y),
                    hn::Sub(hn::LoadU(tag, at[k + 2] + i), o.z)};
    };
    const Lanes3 a = corner(0), b = corner(3), c = corner(6);
    const Lanes3 of_bc = cross(c, b);
    const V ab = dot(d, cross(b, a)), bc = dot(d, of_bc), ca = dot(d, cross(a, c));
    const V x = largest(a.x, b.x, c.x), y = largest(a.y, b.y, c.y), z = largest(a.z, b.z, c.z);
    const V yz = hn::Add(hn::Mul(y, z), inside), zx = hn::Add(hn::Mul(z, x), inside),
            xy = hn::Add(hn::Mul(x, y), inside);
    const V magnitude = dot(size, {yz, zx, xy});
    const V sum = hn::Add(hn::Add(ab, bc), ca);
    const V doubt =
        hn::Add(hn::Mul(all(edge_constant), hn::Add(hn::Mul(slack, magnitude), outside)), hn::Sub(sum, sum));
    const V least = hn::Min(hn::Min(ab, bc), ca), most = hn::Max(hn::Max(ab, bc), ca);
    const auto left = hn::Gt(most, doubt), right = hn::Lt(least, hn::Neg(doubt));
    if (hn::AllTrue(tag, hn::And(left, right))) {  // most often so
      for (std::size_t k = 0; k < lanes; ++k) out.told[i + k] = 0;
      continue;
    }
    const auto all_left = hn::Gt(least, doubt), all_right = hn::Lt(most, hn::Neg(doubt));
    auto no = hn::And(left, right), yes = hn::Or(all_left, all_right);
    // Toward the plane: both with the sign of D, where that is known.
    const V value = dot(a, of_bc), way = hn::IfThenElse(hn::Gt(sum, zero), value, hn::Neg(value));
    const V volume = hn::Add(hn::Add(hn::Mul(x, yz), hn::Mul(y, zx)), hn::Mul(z, xy));
    const V off = hn::Add(hn::Mul(all(filter_constant<PlaneAhead>()), hn::Add(hn::Mul(slack, volume), outside)),
                          hn::Sub(value, value));
    const V speed = hn::Abs(sum);
    if constexpr (begins) {
      no = hn::Or(no, hn::And(yes, hn::Lt(way, hn::Neg(off))));
      auto sure = hn::Gt(way, off);
      if constexpr (ends) {
        const V rest = hn::Sub(way, speed);
        const V far = hn::Add(hn::Mul(all(filter_constant<PlaneBehindEnd>()),
                                      hn::Add(hn::Mul(slack, hn::Add(hn::Mul(all(3), magnitude), volume)), outside)),
                              hn::Sub(rest, rest));
        no = hn::Or(no, hn::And(yes, hn::Gt(rest, far)));
        sure = hn::And(sure, hn::Lt(rest, hn::Neg(far)));
      }
      yes = hn::And(yes, sure);
    }
    // D is the sum of three that are each off by `doubt`, rounded twice; quotients by once more.
    const V blur = hn::Mul(all(4), doubt), slow = hn::Sub(speed, blur), fast = hn::Add(speed, blur);
    const V near = hn::Sub(way, off), away = hn::Add(way, off);
    const V infinity = all(std::numeric_limits<double>::infinity());
    const auto ahead = hn::Ge(near, zero), behind = hn::Le(away, zero);
    const V low = hn::Div(near, hn::IfThenElse(ahead, fast, slow)),
            high = hn::Div(away, hn::IfThenElse(behind, fast, slow));
    const auto known = hn::Gt(slow, zero);
    const V room = all(0x1p-50), room_below = hn::Mul(hn::Abs(low), room), room_above = hn::Mul(hn::Abs(high), room);
    const V tiny = all(0x1p-1070);
    hn::StoreU(hn::IfThenElse(known, hn::Sub(hn::Sub(low, room_below), tiny), hn::Neg(infinity)), tag, out.least + i);
    hn::StoreU(hn::IfThenElse(known, hn::Add(hn::Add(high, room_above), tiny), infinity), tag, out.most + i);
    std::uint8_t bits_no[8] = {}, bits_yes[8] = {};
    hn::StoreMaskBits(tag, no, bits_no);
    hn::StoreMaskBits(tag, yes, bits_yes);
    for (std::size_t k = 0; k < lanes; ++k) {
      const unsigned is_no = bits_no[0] >> k & 1u, is_yes = bits_yes[0] >> k & 1u;
      out.told[i + k] = static_cast<std::uint8_t>(is_no != 0 ? 0 : is_yes != 0 ? 1 : 2);
    }
  }
}

void ask_ray(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out) {
  ask<true, false>(ray, at, n, out);
}
void ask_segment(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out) {
  ask<true, true>(ray, at, n, out);
}
void ask_line(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out) {
  ask<false, false>(ray, at, n, out);
}

}  // namespace
}  // namespace plumb::query::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::query {
namespace {

HWY_EXPORT(ask_ray);
HWY_EXPORT(ask_segment);
HWY_EXPORT(ask_line);

}  // namespace

void ask_lanes(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out) {
  if (ray.ends) return PLUMB_DISPATCH(ask_segment)(ray, at, n, out);
  if (ray.begins) return PLUMB_DISPATCH(ask_ray)(ray, at, n, out);
  PLUMB_DISPATCH(ask_line)(ray, at, n, out);
}

}  // namespace plumb::query
#endif
