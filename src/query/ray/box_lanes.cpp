#include "query/ray/box_lanes.hpp"

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/ray/box_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "certify/many_lanes.hpp"
#include "query/ray/box_passed.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::HWY_NAMESPACE {
namespace {

namespace lanes = certify::many_lanes::HWY_NAMESPACE;
using lanes::Many, lanes::Truth, lanes::above, lanes::of_all;
using Passed = box_passed::HWY_NAMESPACE::BoxPassed;

void ask(const BoxBatchRay& ray, const double* const* at, std::size_t n, std::uint8_t* told) {
  constexpr std::size_t count = lanes::hn::MaxLanes(lanes::Lanes());
  const auto load = [&](std::size_t k, std::size_t i) { return Many{lanes::hn::LoadU(lanes::Lanes(), at[k] + i)}; };
  std::size_t i = 0;
  for (; i + count <= n; i += count) {
    const Many min[3] = {load(0, i), load(1, i), load(2, i)}, max[3] = {load(3, i), load(4, i), load(5, i)};
    Truth no = above(min[0], max[0]) | above(min[1], max[1]) | above(min[2], max[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double o = ray.origin[k], d = ray.direction[k];
      if (ray.ends) {
        no = no | above(of_all(ray.low[k]), max[k]) | above(min[k], of_all(ray.high[k]));
      } else if (ray.begins) {
        if (d >= 0) no = no | above(of_all(o), max[k]);
        if (d <= 0) no = no | above(min[k], of_all(o));
      }
    }
    lanes::Floats<Many, Passed::highest, Passed::scales> world;
    Truth apart = above(of_all(0), of_all(0)), meets = above(of_all(1), of_all(0));
    Passed{}(world, ray, min, max, apart, meets);
    const Truth in_range = world.in_range();
    const unsigned bits_no = lanes::bits_of(no | (apart & in_range)), bits_yes = lanes::bits_of(meets & in_range);
    for (std::size_t k = 0; k < count; ++k) {
      const unsigned is_no = bits_no >> k & 1u, is_yes = bits_yes >> k & 1u;
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

PLUMB_EXPORT(ask);

}  // namespace

void ask_box_lanes(const BoxBatchRay& ray, const double* const* at, std::size_t n, std::uint8_t* told) {
  PLUMB_DISPATCH(ask)(ray, at, n, told);
}

}  // namespace plumb::query
#endif
