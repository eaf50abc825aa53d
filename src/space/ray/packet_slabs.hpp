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

#include <algorithm>
#include <cmath>
#include <span>

#include "space/ray/ray_walk.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

class PacketSlabs {
 public:
  /// Do they go the same way along each axis?  And so that no bound is 0 times infinity.
  static bool fit(std::span<const RayTask> tasks) {
    const RaySlabs::Planes& first = tasks[0].planes;
    return std::ranges::all_of(tasks, [&](const RayTask& task) {
      const RaySlabs::Planes& p = task.planes;
      bool same = !p.all_met;
      for (std::size_t k = 0; k < 3; ++k) {
        same = same && (p.low_rate[k] < 0) == (first.low_rate[k] < 0) &&
               std::isinf(p.low_rate[k]) == std::isinf(first.low_rate[k]) &&
               std::isinf(p.high_rate[k]) == std::isinf(first.high_rate[k]);
      }
      return same;
    });
  }

  /// Of so many as fit, at most packet_size.
  explicit PacketSlabs(std::span<const RayTask> tasks) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool down = tasks[0].planes.low_rate[k] < 0;
      near_[k].plane = down ? 3 + k : k;
      far_[k].plane = down ? k : 3 + k;
      const auto fill = [&](Plane& plane, const auto& from, const auto& rate, bool greatest_from) {
        for (std::size_t i = 0; i < packet_size; ++i) {
          const RaySlabs::Planes& p = tasks[std::min(i, tasks.size() - 1)].planes;
          plane.from[i] = from(p)[k];
          plane.rate[i] = rate(p)[k];
        }
        const auto froms = std::minmax_element(plane.from, plane.from + packet_size);
        const auto rates = std::minmax_element(plane.rate, plane.rate + packet_size);
        plane.bound = greatest_from ? *froms.second : *froms.first;
        plane.least = *rates.first, plane.most = *rates.second;
      };
      const auto low_from = [](const RaySlabs::Planes& p) -> auto& { return p.low_from; };
      const auto low_rate = [](const RaySlabs::Planes& p) -> auto& { return p.low_rate; };
      const auto high_from = [](const RaySlabs::Planes& p) -> auto& { return p.high_from; };
      const auto high_rate = [](const RaySlabs::Planes& p) -> auto& { return p.high_rate; };
      // Where they enter the least is looked for, where they leave the greatest.
      fill(down ? far_[k] : near_[k], low_from, low_rate, true);
      fill(down ? near_[k] : far_[k], high_from, high_rate, false);
    }
    for (std::size_t i = 0; i < packet_size; ++i) limits_[i] = i < tasks.size() ? tasks[i].limit : -infinity;
  }

  [[nodiscard]] double limit(std::size_t ray) const { return limits_[ray]; }
  void set_limit(std::size_t ray, double limit) { limits_[ray] = limit; }
  [[nodiscard]] double most_limit() const { return *std::max_element(limits_, limits_ + packet_size); }

  /// As Slabs, of all rays: less than 0 where none meets the box at one of at most the limit.
  HWY_INLINE Floats keys(const WideNode<8>& node, std::size_t i, double limit) const {
    const D tag;
    const V zero = hn::Zero(tag), guard = hn::Set(tag, underflow_guard), most = hn::Set(tag, limit);
    const auto way = [&](const Plane& plane) HWY_ATTR {
      return hn::Sub(hn::PromoteTo(tag, hn::LoadU(FloatTag(), node.planes[plane.plane].data() + i)),
                     hn::Set(tag, plane.bound));
    };
    const auto enters_at = [&](const Plane& plane) HWY_ATTR {
      const V x = way(plane);
      return hn::Min(hn::Mul(x, hn::Set(tag, plane.least)), hn::Mul(x, hn::Set(tag, plane.most)));
    };
    const auto leaves_at = [&](const Plane& plane) HWY_ATTR {
      const V x = way(plane);
      return hn::Max(hn::Mul(x, hn::Set(tag, plane.least)), hn::Mul(x, hn::Set(tag, plane.most)));
    };
    const V enters = hn::Max(hn::Max(enters_at(near_[0]), enters_at(near_[1])), hn::Max(enters_at(near_[2]), zero));
    const V leaves = hn::Add(hn::Min(hn::Min(leaves_at(far_[0]), leaves_at(far_[1])), leaves_at(far_[2])), guard);
    const V key = hn::Sub(enters, guard);
    const auto met = hn::Le(key, hn::Min(leaves, most));
    return hn::DemoteTo(FloatTag(), hn::IfThenElse(met, hn::Max(key, zero), hn::Set(tag, -infinity)));
  }

  /// Bit i says that ray i meets the box at one of at most its limit; of planes[0][at], ..., planes[5][at].
  template <class Planes>
  HWY_INLINE unsigned met(const Planes& planes, std::size_t at) const {
    const D tag;
    const V zero = hn::Zero(tag), guard = hn::Set(tag, underflow_guard);
    const auto place = [&](const Plane& plane)
                           HWY_ATTR { return hn::Set(tag, static_cast<double>(planes[plane.plane][at])); };
    const V in_x = place(near_[0]), in_y = place(near_[1]), in_z = place(near_[2]);
    const V out_x = place(far_[0]), out_y = place(far_[1]), out_z = place(far_[2]);
    unsigned all = 0;
    for (std::size_t i = 0; i < packet_size; i += lanes) {
      const auto parameter = [&](V x, const Plane& plane) HWY_ATTR {
        return hn::Mul(hn::Sub(x, hn::Load(tag, plane.from + i)), hn::Load(tag, plane.rate + i));
      };
      const V enters = hn::Max(hn::Max(parameter(in_x, near_[0]), parameter(in_y, near_[1])),
                               hn::Max(parameter(in_z, near_[2]), zero));
      const V leaves = hn::Add(
          hn::Min(hn::Min(parameter(out_x, far_[0]), parameter(out_y, far_[1])), parameter(out_z, far_[2])), guard);
      const auto is_met = hn::Le(hn::Sub(enters, guard), hn::Min(leaves, hn::Load(tag, limits_ + i)));
      all |= in_lanes::bits_of(is_met) << i;
    }
    return all;
  }

 private:
  /// Of a plane, for each ray what its parameter is computed of, and for all.
  struct Plane {
    alignas(64) double from[packet_size];
    alignas(64) double rate[packet_size];
    double bound, least, most;
    std::size_t plane;
  };
  Plane near_[3], far_[3];
  alignas(64) double limits_[packet_size];
};

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
