#include "figure/sphere/block_reach.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "certify/fused_lanes.hpp"
#include "plumb/certify/accepted.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "figure/sphere/block_reach.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::sphere::block_reach::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 4>;
using Many = hn::Vec<Lanes>;

HWY_INLINE std::array<Many, 2> load(const Point2* p) {
  std::array<Many, 2> axes;
  hn::LoadInterleaved2(Lanes(), &p->x, axes[0], axes[1]);
  return axes;
}
HWY_INLINE std::array<Many, 3> load(const Point3* p) {
  std::array<Many, 3> axes;
  hn::LoadInterleaved3(Lanes(), &p->x, axes[0], axes[1], axes[2]);
  return axes;
}

/// The largest of as many points as fill lanes; how many these are.  A number that is none is not larger.
template <bool scaled, class Point, std::size_t axes>
HWY_INLINE std::size_t largest_of(const std::array<double, axes>& c, std::span<const Point> points, double power,
                                  double& most) {
  constexpr std::size_t step = hn::MaxLanes(Lanes());
  std::array<Many, axes> center;
  for (std::size_t a = 0; a < axes; ++a) center[a] = hn::Set(Lanes(), c[a]);
  const Many times = hn::Set(Lanes(), power);
  const auto square = [&](const Many& to, const Many& from) HWY_ATTR {
    const Many d = hn::Sub(to, from), e = scaled ? hn::Mul(d, times) : d;
    return hn::Mul(e, e);
  };
  const auto of = [&](std::size_t i) HWY_ATTR {
    const auto p = load(points.data() + i);
    const Many sum = hn::Add(square(p[0], center[0]), square(p[1], center[1]));
    if constexpr (axes == 3) return hn::Add(sum, square(p[2], center[2]));
    return sum;
  };
  Many first = hn::Set(Lanes(), most), second = first;
  std::size_t i = 0;
  for (; i + 2 * step <= points.size(); i += 2 * step) {
    first = hn::Max(of(i), first);
    second = hn::Max(of(i + step), second);
  }
  most = hn::GetLane(hn::MaxOfLanes(Lanes(), hn::Max(first, second)));
  return i;
}

/// Of as many points as fill lanes, at least one: their least and greatest numbers, and 0, or what is no number, of each
/// axis.
template <class Point, std::size_t axes>
HWY_INLINE std::size_t ends_of(std::span<const Point> points, std::array<double, axes>& least,
                               std::array<double, axes>& most, double& zero) {
  constexpr std::size_t step = hn::MaxLanes(Lanes());
  std::array<Many, axes> min, max, none;
  for (std::size_t a = 0; a < axes; ++a) {
    min[a] = hn::Set(Lanes(), least[a]), max[a] = hn::Set(Lanes(), most[a]), none[a] = hn::Zero(Lanes());
  }
  std::size_t i = 0;
  for (; i + step <= points.size(); i += step) {
    const auto p = load(points.data() + i);
    for (std::size_t a = 0; a < axes; ++a) {
      min[a] = hn::Min(p[a], min[a]), max[a] = hn::Max(p[a], max[a]);
      none[a] = hn::Add(none[a], hn::Sub(p[a], p[a]));
    }
  }
  for (std::size_t a = 0; a < axes; ++a) {
    least[a] = hn::GetLane(hn::MinOfLanes(Lanes(), min[a])), most[a] = hn::GetLane(hn::MaxOfLanes(Lanes(), max[a]));
    zero += hn::GetLane(hn::SumOfLanes(Lanes(), none[a]));
  }
  return i;
}

// One for each dimension.
[[maybe_unused]] std::size_t ends(std::span<const Point2> points, std::array<double, 2>& least,
                                  std::array<double, 2>& most, double& zero) {
  return ends_of(points, least, most, zero);
}
[[maybe_unused]] std::size_t ends(std::span<const Point3> points, std::array<double, 3>& least,
                                  std::array<double, 3>& most, double& zero) {
  return ends_of(points, least, most, zero);
}
[[maybe_unused]] std::size_t largest(const std::array<double, 2>& c, std::span<const Point2> points, double power,
                                     double& most) {
  return power == 1 ? largest_of<false>(c, points, power, most) : largest_of<true>(c, points, power, most);
}
[[maybe_unused]] std::size_t largest(const std::array<double, 3>& c, std::span<const Point3> points, double power,
                                     double& most) {
  return power == 1 ? largest_of<false>(c, points, power, most) : largest_of<true>(c, points, power, most);
}

}  // namespace
}  // namespace plumb::figure::sphere::block_reach::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::figure::sphere {
namespace {

template <class Point>
double farthest_of(const Point& c, std::span<const Point> points, double power) {
  double most = 0;
  std::size_t i = PLUMB_BY_LANES(block_reach, largest(coordinates(c), points, power, most));
  for (; i < points.size(); ++i) most = std::max(most, square_of_distance(c, points[i], power).value);
  return most;
}

template <class Point>
bool extent_of(std::span<const Point> points, Extent<Point>& extent) {
  auto least = coordinates(points[0]), most = least;
  double zero = 0;
  for (std::size_t i = PLUMB_BY_LANES(block_reach, ends(points, least, most, zero)); i < points.size(); ++i) {
    const auto p = coordinates(points[i]);
    for (std::size_t a = 0; a < p.size(); ++a) {
      least[a] = std::min(least[a], p[a]), most[a] = std::max(most[a], p[a]);
      zero += p[a] - p[a];
    }
  }
  const auto point = [](auto... x) { return Point{x...}; };
  extent = {std::apply(point, least), std::apply(point, most)};
  return zero == 0;
}

}  // namespace

bool find_extent(std::span<const Point2> points, Extent<Point2>& extent) { return extent_of(points, extent); }
bool find_extent(std::span<const Point3> points, Extent<Point3>& extent) { return extent_of(points, extent); }

double farthest_square(const Point2& c, std::span<const Point2> points, double power) {
  return farthest_of(c, points, power);
}
double farthest_square(const Point3& c, std::span<const Point3> points, double power) {
  return farthest_of(c, points, power);
}

}  // namespace plumb::figure::sphere
#endif
