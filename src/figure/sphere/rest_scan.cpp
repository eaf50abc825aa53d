#include "figure/sphere/rest_scan.hpp"

#include <algorithm>

#include "certify/fused_lanes.hpp"
#include "plumb/arith/interval.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "figure/sphere/rest_scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "certify/many_lanes.hpp"
#include "certify/many_twofolds.hpp"
#include "figure/sphere/stays_inside.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::sphere::rest_scan::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace lanes = certify::many_lanes::HWY_NAMESPACE;
using lanes::Many, lanes::Lanes;
#if HWY_TARGET == HWY_AVX2
using lanes::Twofolds;
#endif
using stays_inside::HWY_NAMESPACE::StaysInside;

HWY_INLINE std::array<Many, 2> load(const Point2* p) {
  std::array<Many, 2> axes;
  hn::LoadInterleaved2(Lanes(), &p->x, axes[0].v, axes[1].v);
  return axes;
}
HWY_INLINE std::array<Many, 3> load(const Point3* p) {
  std::array<Many, 3> axes;
  hn::LoadInterleaved3(Lanes(), &p->x, axes[0].v, axes[1].v, axes[2].v);
  return axes;
}

/// How many from the first on were looked at.
template <class Point, std::size_t axes>
HWY_INLINE std::size_t name_open(const std::array<double, axes>& base, const std::array<double, axes>& by, double lead,
                                 std::span<const Point> points, const double* rest, std::size_t first,
                                 std::vector<std::size_t>& into) {
  constexpr std::size_t step = hn::MaxLanes(Lanes());
  std::array<Many, axes> of_base, of_by;
  for (std::size_t a = 0; a < axes; ++a) of_base[a] = lanes::of_all(base[a]), of_by[a] = lanes::of_all(by[a]);
  const Many of_lead = lanes::of_all(lead);
  std::size_t i = 0;
  for (; i + step <= points.size(); i += step) {
    lanes::Floats<Many, highest_power<StaysInside>, scales_of<StaysInside>> world;
    const lanes::Truth inside =
        StaysInside()(world, load(points.data() + i), Many{hn::LoadU(Lanes(), rest + i)}, of_base, of_by, of_lead) &
        world.in_range();
    if (lanes::all(inside)) continue;
    for (unsigned open = ~lanes::bits_of(inside) & ((1u << step) - 1); open != 0; open &= open - 1)
      into.push_back(first + i + static_cast<std::size_t>(__builtin_ctz(open)));
  }
  return i;
}

/// Of how many from the first on the rests were computed; `off` grows to what they are off.
#if HWY_TARGET == HWY_AVX2

template <class Point, std::size_t axes>
HWY_INLINE std::size_t fill(const std::array<double, axes>& base, double square, std::span<const Point> points,
                            double* rest, double& off) {
  constexpr std::size_t step = hn::MaxLanes(Lanes());
  std::array<Many, axes> center;
  for (std::size_t a = 0; a < axes; ++a) center[a] = lanes::of_all(base[a]);
  Many most = lanes::of_all(off), unknown = lanes::of_all(0);
  std::size_t i = 0;
  for (; i + step <= points.size(); i += step) {
    const auto p = load(points.data() + i);
    const auto square_along = [&](std::size_t a) HWY_ATTR {
      const Twofolds d = Twofolds::difference(p[a], center[a]);
      return d * d;
    };
    Twofolds left = Twofolds::exact(lanes::of_all(square)) - square_along(0) - square_along(1);
    if constexpr (axes == 3) left = left - square_along(2);
    const auto told = Twofolds::two_sum(left.high, left.low);
    const Many reach = size(told.error) + left.reach();
    hn::StoreU(told.value.v, Lanes(), rest + i);
    most = larger(most, reach), unknown = unknown + (reach - reach);
  }
  off = hn::GetLane(hn::MaxOfLanes(Lanes(), most.v)) + hn::GetLane(hn::SumOfLanes(Lanes(), unknown.v));
  return i;
}

#else

template <class Point, std::size_t axes>
std::size_t fill(const std::array<double, axes>&, double, std::span<const Point>, double*, double&) {
  return 0;
}

#endif

// One for each dimension.
[[maybe_unused]] std::size_t open_of(const std::array<double, 2>& base, const std::array<double, 2>& by, double lead,
                                     std::span<const Point2> points, const double* rest, std::size_t first,
                                     std::vector<std::size_t>& into) {
  return name_open(base, by, lead, points, rest, first, into);
}
[[maybe_unused]] std::size_t open_of(const std::array<double, 3>& base, const std::array<double, 3>& by, double lead,
                                     std::span<const Point3> points, const double* rest, std::size_t first,
                                     std::vector<std::size_t>& into) {
  return name_open(base, by, lead, points, rest, first, into);
}
[[maybe_unused]] std::size_t filled(const std::array<double, 2>& base, double square, std::span<const Point2> points,
                                    double* rest, double& off) {
  return fill(base, square, points, rest, off);
}
[[maybe_unused]] std::size_t filled(const std::array<double, 3>& base, double square, std::span<const Point3> points,
                                    double* rest, double& off) {
  return fill(base, square, points, rest, off);
}

}  // namespace
}  // namespace plumb::figure::sphere::rest_scan::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::figure::sphere {
namespace {

using stays_inside::HWY_NAMESPACE::StaysInside;

double high_of(const Ball& x) { return x.high; }
Interval size_of_rest(const Ball& x) { return Interval(Ball::size(x.low)) + Interval(x.radius); }

}  // namespace

template <class Spanned>
void RestScan<Spanned>::move_base(const FineBall<Spanned>& ball) {
  std::ranges::transform(ball.center, base_.begin(), high_of);
  square_ = ball.square.high;
  of_block_.clear();
  of_block_.resize((points_.size() + block - 1) / block);
}

template <class Spanned>
void RestScan<Spanned>::aim(const FineBall<Spanned>& ball) {
  // Guesses: where doubles left many open, the ball has moved too far.
  constexpr std::size_t some = 64, one_of = 64;
  if (of_block_.empty() || named_ > some + points_.size() / one_of) move_base(ball);
  named_ = 0;
  Ball middle = ball.square - Ball(square_);
  Interval off(0);
  const auto least = coordinates(extent_.min), most = coordinates(extent_.max);
  for (std::size_t a = 0; a < base_.size(); ++a) {
    const Ball moved = ball.center[a] - Ball(base_[a]);
    middle = middle - squared(moved);
    by_[a] = 2 * moved.high;
    const Interval base(base_[a]);
    const double reach = std::max((Interval(most[a]) - base).upper, (base - Interval(least[a])).upper);
    off = off + Interval(2) * size_of_rest(moved) * Interval(reach);
  }
  lead_ = (Interval(middle.high) - size_of_rest(middle) - off).lower;
}

template <class Spanned>
auto RestScan<Spanned>::rests_of(std::size_t first) -> const Rests& {
  std::unique_ptr<Rests>& known = of_block_[first / block];
  if (known != nullptr) return *known;
  known = std::make_unique<Rests>();
  Rests& rests = *known;
  const auto points = block_from(first);
  double off = 0;
  std::size_t i = PLUMB_BY_LANES(rest_scan, filled(base_, square_, points, rests.rest.data(), off));
  for (; i < points.size(); ++i) {
    Ball rest(square_);
    const auto p = coordinates(points[i]);
    for (std::size_t a = 0; a < p.size(); ++a) rest = rest - squared(difference(p[a], Ball(base_[a])));
    rests.rest[i] = rest.high;
    off = std::max(off, Ball::size(rest.low) + rest.radius);
  }
  rests.off = off + Interval::step(off);
  return rests;
}

template <class Spanned>
void RestScan<Spanned>::not_certainly_inside(std::size_t first, std::vector<std::size_t>& into) {
  const Rests& rests = rests_of(first);
  const auto points = block_from(first);
  const double lead = (Interval(lead_) - Interval(rests.off)).lower;
  const std::size_t before = into.size();
  std::size_t i = PLUMB_BY_LANES(rest_scan, open_of(base_, by_, lead, points, rests.rest.data(), first, into));
  for (; i < points.size(); ++i) {
    FloatWorld<StaysInside> world;
    if (!StaysInside()(world, coordinates(points[i]), rests.rest[i], base_, by_, lead) || !world.in_range())
      into.push_back(first + i);
  }
  named_ += into.size() - before;
}

template class RestScan<SpannedCircle2>;
template class RestScan<SpannedSphere3>;

}  // namespace plumb::figure::sphere
#endif
