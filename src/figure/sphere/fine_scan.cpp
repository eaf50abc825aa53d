#include "figure/sphere/fine_scan.hpp"

#include "certify/fused_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "figure/sphere/fine_scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "arith/four_balls.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::sphere::fine_scan::HWY_NAMESPACE {
namespace {

// How many points from the first on were looked at.
#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;
using arith::HWY_NAMESPACE::Four, arith::HWY_NAMESPACE::FourBalls;
using D = hn::FixedTag<double, 4>;

HWY_INLINE void load(const Point2* p, std::array<Four, 2>& axes) {
  hn::Vec<D> x, y;
  hn::LoadInterleaved2(D(), &p->x, x, y);
  axes = {Four{x.raw}, Four{y.raw}};
}
HWY_INLINE void load(const Point3* p, std::array<Four, 3>& axes) {
  hn::Vec<D> x, y, z;
  hn::LoadInterleaved3(D(), &p->x, x, y, z);
  axes = {Four{x.raw}, Four{y.raw}, Four{z.raw}};
}

template <class Spanned>
HWY_INLINE std::size_t name_others(const FineBall<Spanned>& ball, std::span<const PointOf<Spanned>> points,
                                   std::size_t first, std::vector<std::size_t>& into) {
  constexpr auto n = static_cast<std::size_t>(dimension<Spanned>);
  const FourBalls square = FourBalls::all(ball.square);
  std::array<FourBalls, n> center;
  for (std::size_t a = 0; a < n; ++a) center[a] = FourBalls::all(ball.center[a]);
  std::size_t i = 0;
  for (; i + 4 <= points.size(); i += 4) {
    std::array<Four, n> p;
    load(points.data() + i, p);
    FourBalls rest = square;
    for (std::size_t a = 0; a < n; ++a) {
      rest = rest - squared(difference(p[a], center[a]));
    }
    for (unsigned others = ~rest.positive() & 15u; others != 0; others &= others - 1)
      into.push_back(first + i + static_cast<std::size_t>(__builtin_ctz(others)));
  }
  return i;
}

#else

template <class Spanned>
std::size_t name_others(const FineBall<Spanned>&, std::span<const PointOf<Spanned>>, std::size_t,
                        std::vector<std::size_t>&) {
  return 0;
}

#endif

// One for each dimension.
[[maybe_unused]] std::size_t others(const FineBall<SpannedCircle2>& ball, std::span<const Point2> points,
                                    std::size_t first, std::vector<std::size_t>& into) {
  return name_others(ball, points, first, into);
}
[[maybe_unused]] std::size_t others(const FineBall<SpannedSphere3>& ball, std::span<const Point3> points,
                                    std::size_t first, std::vector<std::size_t>& into) {
  return name_others(ball, points, first, into);
}

}  // namespace
}  // namespace plumb::figure::sphere::fine_scan::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::figure::sphere {
namespace {

template <class Spanned>
void scan(const FineBall<Spanned>& ball, std::span<const PointOf<Spanned>> points, std::size_t first,
          std::vector<std::size_t>& into) {
  for (std::size_t i = PLUMB_BY_LANES(fine_scan, others(ball, points, first, into)); i < points.size(); ++i)
    into.push_back(first + i);
}

}  // namespace

void not_certainly_inside(const FineBall<SpannedCircle2>& ball, std::span<const Point2> points, std::size_t first,
                          std::vector<std::size_t>& into) {
  scan(ball, points, first, into);
}
void not_certainly_inside(const FineBall<SpannedSphere3>& ball, std::span<const Point3> points, std::size_t first,
                          std::vector<std::size_t>& into) {
  scan(ball, points, first, into);
}

}  // namespace plumb::figure::sphere
#endif
