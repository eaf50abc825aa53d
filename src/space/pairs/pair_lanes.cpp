#include "space/pairs/pair_lanes.hpp"

#include <algorithm>

#include "certify/batch/instruction_sets.hpp"
#include "query/overlap/filters.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/pairs/pair_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using F = hn::CappedTag<float, 8>;

template <class Tag>
HWY_INLINE unsigned bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  return bits[0];
}

HWY_INLINE std::uint8_t child_met(const WideNode<8>& a, std::size_t child, const WideNode<8>& b) {
  const F tag;
  constexpr std::size_t lanes = hn::MaxLanes(F());
  unsigned met = 0;
  for (std::size_t k = 0; k < 8; k += lanes) {
    const auto on = [&](std::size_t axis) {
      return hn::And(hn::Le(hn::Set(tag, a.planes[axis][child]), hn::LoadU(tag, b.planes[3 + axis].data() + k)),
                     hn::Le(hn::LoadU(tag, b.planes[axis].data() + k), hn::Set(tag, a.planes[3 + axis][child])));
    };
    met |= bits_of(tag, hn::And(hn::And(on(0), on(1)), on(2))) << k;
  }
  return static_cast<std::uint8_t>(met);
}
void all_children_met(const WideNode<8>& a, const WideNode<8>& b, ChildrenMet& met) {
  for (std::size_t i = 0; i < 8; ++i) met[i] = child_met(a, i, b);
}
void one_child_met(const WideNode<8>& a, std::size_t child, const WideNode<8>& b, std::uint8_t& met) {
  met = child_met(a, child, b);
}

struct Three {
  V x, y, z;
};
HWY_INLINE V dot(const Three& u, const Three& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
HWY_INLINE Three cross(const Three& u, const Three& v) {
  return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
}
HWY_INLINE Three difference(const Three& from, const Three& to) {
  return {hn::Sub(to.x, from.x), hn::Sub(to.y, from.y), hn::Sub(to.z, from.z)};
}
/// Of the lanes from k on, three of the numbers from `first` on; or those of lane k in all.
template <std::size_t N>
HWY_INLINE Three loaded(const std::array<std::array<double, 8>, N>& of, std::size_t first, std::size_t k) {
  const auto at = [&](std::size_t i) { return hn::LoadU(D(), of[first + i].data() + k); };
  return {at(0), at(1), at(2)};
}
template <std::size_t N>
HWY_INLINE Three one(const std::array<std::array<double, 8>, N>& of, std::size_t first, std::size_t k) {
  const auto at = [&](std::size_t i) { return hn::Set(D(), of[first + i][k]); };
  return {at(0), at(1), at(2)};
}

void complete_lanes(TriangleLanes& t) {
  const D tag;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  for (std::size_t k = 0; k < 8; k += lanes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = [&](std::size_t corner) { return hn::LoadU(tag, t.corners[3 * corner + axis].data() + k); };
      hn::StoreU(hn::Min(hn::Min(at(0), at(1)), at(2)), tag, t.boxes[axis].data() + k);
      hn::StoreU(hn::Max(hn::Max(at(0), at(1)), at(2)), tag, t.boxes[3 + axis].data() + k);
    }
    const Three a = loaded(t.corners, 0, k);
    const Three n = cross(difference(a, loaded(t.corners, 3, k)), difference(a, loaded(t.corners, 6, k)));
    hn::StoreU(n.x, tag, t.normals[0].data() + k);
    hn::StoreU(n.y, tag, t.normals[1].data() + k);
    hn::StoreU(n.z, tag, t.normals[2].data() + k);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    V least = hn::LoadU(tag, t.boxes[axis].data()), most = hn::LoadU(tag, t.boxes[3 + axis].data());
    for (std::size_t k = lanes; k < 8; k += lanes) {
      least = hn::Min(least, hn::LoadU(tag, t.boxes[axis].data() + k));
      most = hn::Max(most, hn::LoadU(tag, t.boxes[3 + axis].data() + k));
    }
    t.around[axis] = hn::GetLane(hn::MinOfLanes(tag, least));
    t.around[3 + axis] = hn::GetLane(hn::MaxOfLanes(tag, most));
  }
}

/// Are corners with these heights all above a plane, or all below?
HWY_INLINE hn::Mask<D> on_one_side(V p, V q, V r, V error) {
  return hn::Or(hn::Gt(hn::Min(hn::Min(p, q), r), error), hn::Lt(hn::Max(hn::Max(p, q), r), hn::Neg(error)));
}

void near_lanes(const TriangleLanes& a, const TriangleLanes& b, double error, MayMeet& may) {
  const D tag;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  const V doubt = hn::Set(tag, error);
  unsigned rows = 0;  // the triangles of a whose boxes meet that of all of b
  for (std::size_t k = 0; k < a.n; k += lanes) {
    const auto on = [&](std::size_t axis) {
      return hn::And(hn::Le(hn::LoadU(tag, a.boxes[axis].data() + k), hn::Set(tag, b.around[3 + axis])),
                     hn::Le(hn::Set(tag, b.around[axis]), hn::LoadU(tag, a.boxes[3 + axis].data() + k)));
    };
    rows |= bits_of(tag, hn::And(hn::And(on(0), on(1)), on(2))) << k;
  }
  may = {};
  for (rows &= (1u << a.n) - 1; rows != 0; rows &= rows - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(rows));
    const Three low = one(a.boxes, 0, i), high = one(a.boxes, 3, i), normal = one(a.normals, 0, i);
    const Three corners[] = {one(a.corners, 0, i), one(a.corners, 3, i), one(a.corners, 6, i)};
    unsigned near = 0;
    for (std::size_t k = 0; k < b.n; k += lanes) {
      const Three from = loaded(b.boxes, 0, k), to = loaded(b.boxes, 3, k);
      const auto met = hn::And(hn::And(hn::And(hn::Le(from.x, high.x), hn::Le(low.x, to.x)),
                                       hn::And(hn::Le(from.y, high.y), hn::Le(low.y, to.y))),
                               hn::And(hn::Le(from.z, high.z), hn::Le(low.z, to.z)));
      if (hn::AllFalse(tag, met)) continue;
      const Three origin = loaded(b.corners, 0, k), of_b = loaded(b.normals, 0, k);
      const auto over_a = [&](const Three& p) { return dot(difference(corners[0], p), normal); };
      const auto over_b = [&](const Three& p) { return dot(difference(origin, p), of_b); };
      const auto apart =
          hn::Or(on_one_side(over_a(origin), over_a(loaded(b.corners, 3, k)), over_a(loaded(b.corners, 6, k)), doubt),
                 on_one_side(over_b(corners[0]), over_b(corners[1]), over_b(corners[2]), doubt));
      near |= bits_of(tag, hn::AndNot(apart, met)) << k;
    }
    may[i] = static_cast<std::uint8_t>(near & ((1u << b.n) - 1));
  }
}

}  // namespace
}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::space {
namespace {

PLUMB_EXPORT(all_children_met);
PLUMB_EXPORT(one_child_met);
PLUMB_EXPORT(complete_lanes);
PLUMB_EXPORT(near_lanes);

/// Bounds volumes of any three differences between triangles of both; infinite or not a number where an intermediate
/// number may not be finite: the magnitude is no less than any of them.
double volume_error(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  using query::Volume;
  const auto extent = [&](std::size_t k) {
    return (std::max(a[3 + k], b[3 + k]) - std::min(a[k], b[k])) + largest_floor<Volume>;
  };
  const Largest<Volume> most{extent(0), extent(1), extent(2)};
  const double magnitude = magnitude_over<Volume>(most);
  return largest_threshold<Volume>(most) + (magnitude - magnitude);
}

}  // namespace

ChildrenMet children_met(const WideNode<8>& a, const WideNode<8>& b) {
  ChildrenMet met;
  PLUMB_DISPATCH(all_children_met)(a, b, met);
  return met;
}
std::uint8_t children_met(const WideNode<8>& a, std::size_t child, const WideNode<8>& b) {
  std::uint8_t met = 0;
  PLUMB_DISPATCH(one_child_met)(a, child, b, met);
  return met;
}
void complete(TriangleLanes& lanes) { PLUMB_DISPATCH(complete_lanes)(lanes); }
void find_near(const TriangleLanes& a, const TriangleLanes& b, MayMeet& may) {
  PLUMB_DISPATCH(near_lanes)(a, b, volume_error(a.around, b.around), may);
}

}  // namespace plumb::space
#endif
