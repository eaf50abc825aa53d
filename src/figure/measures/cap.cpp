// How much of a ball does a plane leave?  With s the signed distance of the plane beyond the center and h = radius + s
// the height of what it leaves: pi h^2 (2 radius - s) / 3, and pi (2 radius h + radius^2 - s^2) around it.
//
// The numbers are multiplied by the normal's length n, of which s n is the depth.  Where s is negative h is taken as
// (radius^2 - s^2) / (radius - s), so that nothing cancels.
#include "arith/root_bounds.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/measures/measures.hpp"

namespace plumb {
namespace {

using figure::signed_sums::dot;
using figure::signed_sums::vector;

struct PlaneOfCap {
  const SphericalCap3& cap;

  auto depth(const auto& number) const {
    return number(cap.halfspace.offset) - dot(vector(number, cap.halfspace.normal), vector(number, cap.sphere.center));
  }
  auto square(const auto& number) const {
    const auto n = vector(number, cap.halfspace.normal);
    return dot(n, n);
  }
  /// radius^2 n^2 - depth^2: of the square of the circle's radius.
  auto circle(const auto& number) const {
    const auto r = number(cap.sphere.radius), k = depth(number);
    return r * r * square(number) - k * k;
  }
};

/// What the plane leaves of the ball: nothing or a point, all of it, or by the two formulas for a cut.
template <class Beyond, class Before>
double measured(const SphericalCap3& cap, double (*of_ball)(const Sphere3&), const Beyond& beyond,
                const Before& before) {
  const PlaneOfCap plane{cap};
  const Sign depth = arith::exact_sum::sign([&](const auto& number) { return plane.depth(number); });
  const Sign circle = arith::exact_sum::sign([&](const auto& number) { return plane.circle(number); });
  if (circle != Sign::positive) return depth == Sign::negative ? 0 : of_ball(cap.sphere);
  return depth == Sign::negative ? before(plane) : beyond(plane);
}

}  // namespace

double volume(const SphericalCap3& cap) {
  figure::require_sound("volume", cap);
  const auto square = [&](const auto& number) { return PlaneOfCap{cap}.square(number); };
  const auto beyond = [&](const PlaneOfCap& plane) {
    return arith::exact_sum::nearly_nearest_quotient(
        [&](const auto& number, const auto& pi, const auto& n) {
          const auto k = plane.depth(number), r = number(cap.sphere.radius) * n, h = r + k;
          return pi * (h * h * (r + r - k));
        },
        [](const auto& number, const auto& n) { return number(3.0) * (n * n * n); }, square);
  };
  const auto before = [&](const PlaneOfCap& plane) {
    return arith::exact_sum::nearly_nearest_quotient(
        [&](const auto& number, const auto& pi, const auto& n) {
          const auto k = number(0.0) - plane.depth(number), r = number(cap.sphere.radius) * n;
          const auto circle = plane.circle(number);
          return pi * (circle * circle * (r + r + k));
        },
        [&](const auto& number, const auto& n) {
          const auto h = number(cap.sphere.radius) * n - plane.depth(number);
          return number(3.0) * (n * n * n * (h * h));
        },
        square);
  };
  return measured(
      cap, [](const Sphere3& s) { return volume(s); }, beyond, before);
}

double surface_area(const SphericalCap3& cap) {
  figure::require_sound("surface_area", cap);
  const auto square = [&](const auto& number) { return PlaneOfCap{cap}.square(number); };
  const auto beyond = [&](const PlaneOfCap& plane) {
    return arith::exact_sum::nearly_nearest_quotient(
        [&](const auto& number, const auto& pi, const auto& n) {
          const auto r = number(cap.sphere.radius) * n;
          return pi * ((r + r) * (r + plane.depth(number)) + plane.circle(number));
        },
        [](const auto&, const auto& n) { return n * n; }, square);
  };
  const auto before = [&](const PlaneOfCap& plane) {
    return arith::exact_sum::nearly_nearest_quotient(
        [&](const auto& number, const auto& pi, const auto& n) {
          const auto r = number(cap.sphere.radius) * n;
          return pi * (plane.circle(number) * (r + r + r - plane.depth(number)));
        },
        [&](const auto& number, const auto& n) {
          return n * n * (number(cap.sphere.radius) * n - plane.depth(number));
        },
        square);
  };
  return measured(
      cap, [](const Sphere3& s) { return surface_area(s); }, beyond, before);
}

}  // namespace plumb
