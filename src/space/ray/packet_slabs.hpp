// Slab test: which boxes may any of sixteen rays meet, and which of them does a box?  Of rays that go the same way.
//
// Law: what the one test leaves out, the other leaves out for every ray, and what that leaves out RaySlabs does.
// For all together a plane's parameter is bounded by the ends of `from` and of `rate`: it is (place - from) rate, of
// which each operation, rounded, is monotone in each number while the rates are of one sign.
// Source: Boulos, Wald and Benthin 2008 for intervals of rays; Wald, Boulos and Shirley 2007.
// Cost: for all together that of one ray and six products; for each, a pass of lanes for as many rays as a vector has.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_PACKET_SLABS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_PACKET_SLABS
#undef PLUMB_PACKET_SLABS
#else
#define PLUMB_PACKET_SLABS
#endif

#include <hwy/highway.h>

#include "space/ray/ray_walk.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

class PacketSlabs {
 public:
  explicit PacketSlabs(const PacketTask& task) : planes_(&task.planes) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool down = planes_->down[k];
      // Where they enter the least is looked for, where they leave the greatest.
      enter_[k] = {down ? 3 + k : k, planes_->enter[k], !down};
      leave_[k] = {down ? k : 3 + k, planes_->leave[k], down};
    }
    for (std::size_t i = 0; i < packet_size; ++i) limits_[i] = i < task.size ? task.limits[i] : -infinity;
  }

  [[nodiscard]] double limit(std::size_t ray) const { return limits_[ray]; }
  void set_limit(std::size_t ray, double limit) { limits_[ray] = limit; }
  [[nodiscard]] double most_limit() const { return greatest(limits_); }

  /// As Slabs, of all rays: less than 0 where none meets the box at one of at most the limit.
  HWY_INLINE Floats keys(const WideNode<8>& node, std::size_t i, double limit) const {
    const D tag;
    const V zero = hn::Zero(tag), guard = hn::Set(tag, underflow_guard), most = hn::Set(tag, limit);
    const auto way = [&](const Bounds& plane) HWY_ATTR {
      return hn::Sub(hn::PromoteTo(tag, hn::LoadU(FloatTag(), node.planes[plane.plane].data() + i)),
                     hn::Set(tag, plane.from));
    };
    const auto enters_at = [&](const Bounds& plane) HWY_ATTR {
      const V x = way(plane);
      return hn::Min(hn::Mul(x, hn::Set(tag, plane.least_rate)), hn::Mul(x, hn::Set(tag, plane.most_rate)));
    };
    const auto leaves_at = [&](const Bounds& plane) HWY_ATTR {
      const V x = way(plane);
      return hn::Max(hn::Mul(x, hn::Set(tag, plane.least_rate)), hn::Mul(x, hn::Set(tag, plane.most_rate)));
    };
    const V enters = hn::Max(hn::Max(enters_at(enter_[0]), enters_at(enter_[1])), hn::Max(enters_at(enter_[2]), zero));
    const V leaves = hn::Add(hn::Min(hn::Min(leaves_at(leave_[0]), leaves_at(leave_[1])), leaves_at(leave_[2])), guard);
    const V key = hn::Sub(enters, guard);
    const auto met = hn::Le(key, hn::Min(leaves, most));
    return hn::DemoteTo(FloatTag(), hn::IfThenElse(met, hn::Max(key, zero), hn::Set(tag, -infinity)));
  }

  /// Bit i says that ray i meets the box at one of at most its limit; of planes[0][at], ..., planes[5][at].
  template <class Planes>
  HWY_INLINE unsigned met(const Planes& planes, std::size_t at) const {
    const D tag;
    const V zero = hn::Zero(tag), guard = hn::Set(tag, underflow_guard);
    const auto place = [&](const Bounds& bounds)
                           HWY_ATTR { return hn::Set(tag, static_cast<double>(planes[bounds.plane][at])); };
    const V in_x = place(enter_[0]), in_y = place(enter_[1]), in_z = place(enter_[2]);
    const V out_x = place(leave_[0]), out_y = place(leave_[1]), out_z = place(leave_[2]);
    const auto &in = planes_->enter, &out = planes_->leave;
    unsigned all = 0;
    for (std::size_t i = 0; i < packet_size; i += lanes) {
      const auto parameter = [&](V x, const PacketPlanes::Plane& plane) HWY_ATTR {
        return hn::Mul(hn::Sub(x, hn::Load(tag, plane.from.data() + i)), hn::Load(tag, plane.rate.data() + i));
      };
      const V enters =
          hn::Max(hn::Max(parameter(in_x, in[0]), parameter(in_y, in[1])), hn::Max(parameter(in_z, in[2]), zero));
      const V leaves = hn::Add(
          hn::Min(hn::Min(parameter(out_x, out[0]), parameter(out_y, out[1])), parameter(out_z, out[2])), guard);
      const auto is_met = hn::Le(hn::Sub(enters, guard), hn::Min(leaves, hn::Load(tag, limits_ + i)));
      all |= in_lanes::many::bits_of({is_met}) << i;
    }
    return all;
  }

 private:
  /// Of all rays' parameters at a plane of a box.
  struct Bounds {
    std::size_t plane;
    double from, least_rate, most_rate;

    Bounds() = default;
    Bounds(std::size_t of, const PacketPlanes::Plane& p, bool greatest_from)
        : plane(of),
          from(greatest_from ? greatest(p.from.data()) : least(p.from.data())),
          least_rate(least(p.rate.data())),
          most_rate(greatest(p.rate.data())) {}
  };
  HWY_INLINE static double least(const double* numbers) {
    V v = hn::Load(D(), numbers);
    for (std::size_t i = lanes; i < packet_size; i += lanes) v = hn::Min(v, hn::Load(D(), numbers + i));
    return hn::GetLane(hn::MinOfLanes(D(), v));
  }
  HWY_INLINE static double greatest(const double* numbers) {
    V v = hn::Load(D(), numbers);
    for (std::size_t i = lanes; i < packet_size; i += lanes) v = hn::Max(v, hn::Load(D(), numbers + i));
    return hn::GetLane(hn::MaxOfLanes(D(), v));
  }

  const PacketPlanes* planes_;
  Bounds enter_[3], leave_[3];
  alignas(64) double limits_[packet_size];
};

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
