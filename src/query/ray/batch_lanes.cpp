#include "query/ray/batch_lanes.hpp"

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/ray/batch_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "query/ray/triangle_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::HWY_NAMESPACE {
namespace {

void ask(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out) {
  const D tag;
  const RayLanes in_lanes(ray);
  for (std::size_t i = 0; i < n; i += lanes) {
    const auto corner = [&](std::size_t k) {
      return Lanes3{hn::LoadU(tag, at[k] + i), hn::LoadU(tag, at[k + 1] + i), hn::LoadU(tag, at[k + 2] + i)};
    };
    const TrianglesTold told = tell(in_lanes, corner(0), corner(3), corner(6));
    for (std::size_t k = 0; k < lanes; ++k)
      out.told[i + k] = static_cast<std::uint8_t>((told.no >> k & 1u) != 0 ? 0 : (told.yes >> k & 1u) != 0 ? 1 : 2);
    hn::StoreU(told.least, tag, out.least + i);
    hn::StoreU(told.most, tag, out.most + i);
  }
}

}  // namespace
}  // namespace plumb::query::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::query {
namespace {

PLUMB_EXPORT(ask);

}  // namespace

void ask_lanes(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out) {
  PLUMB_DISPATCH(ask)(ray, at, n, out);
}

}  // namespace plumb::query
#endif
