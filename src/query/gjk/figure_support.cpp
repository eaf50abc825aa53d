#include "plumb/query/gjk/figure_support.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "arith/big_rounding.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {
namespace {

/// x times two to the e.
BigDyadic scaled(BigDyadic x, long e) {
  while (e != 0) {
    const long part = std::clamp(e, -1000L, 1000L);
    x = x * BigDyadic(std::ldexp(1.0, static_cast<int>(part)));
    e -= part;
  }
  return x;
}

/// The power of two that is above it, of x other than zero.
long power_above(const BigDyadic& x) {
  return static_cast<long>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2)) + x.exponent();
}

Interval magnitudes(const Vector3& v) {
  return Interval(std::fabs(v.x)) + Interval(std::fabs(v.y)) + Interval(std::fabs(v.z));
}

}  // namespace

Vector3 direction_before(const Pose& pose, const Vector3& direction) {
  const Vec3<BigDyadic> n = vector_of<BigDyadic>(direction);
  std::array<BigDyadic, 3> along;
  for (std::size_t k = 0; k < 3; ++k) along[k] = dot(vector_of<BigDyadic>(pose.columns[k]), n);
  std::optional<long> above;
  for (const BigDyadic& x : along) {
    if (x.sign() != Sign::zero) above = above ? std::max(*above, power_above(x)) : power_above(x);
  }
  if (!above) return {0, 0, 0};
  const auto part = [&](std::size_t k) { return rounded(Rounding::nearest, scaled(along[k], -*above)); };
  return {part(0), part(1), part(2)};
}

Point3 rounded_image(const Pose& pose, const Point3& p) {
  const Vec3<BigDyadic> image = posed<BigDyadic>(p, pose);
  const auto part = [](const BigDyadic& x) { return rounded(Rounding::nearest, x); };
  return {part(image.x), part(image.y), part(image.z)};
}

double rounding_of_image(const Pose& pose, double largest, double off) {
  const auto& [c, by] = pose;
  require_finite_parts("support_point", {"pose.columns[0]", "pose.columns[1]", "pose.columns[2]", "pose.translation"},
                       c[0], c[1], c[2], by);
  // What stretches most: no coordinate of an image is larger than this times that of the point.
  const Interval stretch = magnitudes(pose.columns[0]) + magnitudes(pose.columns[1]) + magnitudes(pose.columns[2]);
  const Interval reach = Interval(largest) + Interval(off);
  // Three coordinates, each of which is the nearest double: together off by less than two of the largest one's steps.
  const double size = (stretch * reach + magnitudes(pose.translation)).upper;
  const Interval step = Interval(std::nextafter(size, HUGE_VAL)) - Interval(size);
  // A direction whose largest coordinate is between a half and one has three that are off by a quarter of the step at
  // one at most: less than that step together, twice as much of the direction, and so of the longest column.  No point of
  // the figure, which is less than four times its reach across, can be farther along than the one that is told by more.
  const Interval grain = Interval(std::nextafter(1.0, 2.0)) - Interval(1.0);
  const Interval turned = stretch * reach * grain * Interval(8.0);
  const double most = (stretch * Interval(off) + step + step + turned).upper;
  if (!is_real(most) || !is_real(size))
    throw BeyondDoubles("support_point: the image of a figure under its pose is beyond all doubles");
  return most;
}

}  // namespace plumb::query
