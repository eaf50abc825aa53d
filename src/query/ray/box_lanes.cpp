#include "query/ray/box_lanes.hpp"

#include "certify/batch/instruction_sets.hpp"
#include "query/ray/filters.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/ray/box_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::query::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

constexpr double constant = 2 * filter_constant<PassesCorner>();

void ask(const BoxBatchRay& ray, const double* const* at, std::size_t n, std::uint8_t* told) {
  const D tag;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  const auto all = [&](double x) { return hn::Set(tag, x); };
  const auto beyond = [&](V value, V one, V other) {
    const V size = hn::Add(hn::Add(hn::Abs(one), hn::Abs(other)), all(guard));
    return hn::Add(hn::Mul(all(constant), size), hn::Sub(value, value));
  };
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) {
    const V min[3] = {hn::LoadU(tag, at[0] + i), hn::LoadU(tag, at[1] + i), hn::LoadU(tag, at[2] + i)};
    const V max[3] = {hn::LoadU(tag, at[3] + i), hn::LoadU(tag, at[4] + i), hn::LoadU(tag, at[5] + i)};
    auto no = hn::Or(hn::Or(hn::Gt(min[0], max[0]), hn::Gt(min[1], max[1])), hn::Gt(min[2], max[2]));
    V low[3] = {min[0], min[1], min[2]}, high[3] = {max[0], max[1], max[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      const double o = ray.origin[k], d = ray.direction[k];
      if (ray.ends) {
        no = hn::Or(no, hn::Or(hn::Lt(max[k], all(ray.low[k])), hn::Gt(min[k], all(ray.high[k]))));
      } else if (ray.begins) {
        if (d >= 0) no = hn::Or(no, hn::Lt(max[k], all(o)));
        if (d <= 0) no = hn::Or(no, hn::Gt(min[k], all(o)));
      }
      low[k] = hn::Sub(min[k], all(o));
      high[k] = hn::Sub(max[k], all(o));
    }
    auto yes = hn::Eq(min[0], min[0]);  // all
    for (std::size_t w = 0; w < 3; ++w) {
      const std::size_t j = (w + 1) % 3, k = (w + 2) % 3;
      const double u = ray.direction[j], v = ray.direction[k];
      if (u == 0 && v == 0) continue;
      const V a = hn::Mul(all(u), u >= 0 ? high[k] : low[k]), b = hn::Mul(all(v), v >= 0 ? low[j] : high[j]);
      const V c = hn::Mul(all(u), u >= 0 ? low[k] : high[k]), d = hn::Mul(all(v), v >= 0 ? high[j] : low[j]);
      const V most = hn::Sub(a, b), least = hn::Sub(c, d);
      const V of_most = beyond(most, a, b), of_least = beyond(least, c, d);
      no = hn::Or(no, hn::Or(hn::Lt(most, hn::Neg(of_most)), hn::Gt(least, of_least)));
      yes = hn::And(yes, hn::And(hn::Gt(most, of_most), hn::Lt(least, hn::Neg(of_least))));
    }
    std::uint8_t bits_no[8] = {}, bits_yes[8] = {};
    hn::StoreMaskBits(tag, no, bits_no);
    hn::StoreMaskBits(tag, yes, bits_yes);
    for (std::size_t k = 0; k < lanes; ++k) {
      const unsigned is_no = bits_no[0] >> k & 1u, is_yes = bits_yes[0] >> k & 1u;
      told[i + k] = static_cast<std::uint8_t>((1 - is_no) * (2 - is_yes));
    }
  }
  for (; i < n; ++i) told[i] = 2;
}

}  // namespace
}  // namespace plumb::query::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::query {
namespace {

HWY_EXPORT(ask);

}  // namespace

void ask_box_lanes(const BoxBatchRay& ray, const double* const* at, std::size_t n, std::uint8_t* told) {
  PLUMB_DISPATCH(ask)(ray, at, n, told);
}

}  // namespace plumb::query
#endif
