#include "plumb/certify/ray_order.hpp"

#include <algorithm>

#include "plumb/certify/decide.hpp"
#include "plumb/predicates/line_triangle.hpp"
#include "plumb/predicates/ray_order.hpp"

namespace plumb {
namespace {

using Plane = std::array<Point3, 3>;
using Numbers3 = std::array<double, 3>;

template <class P>
Numbers3 numbers(const P& p) {
  return {p.x, p.y, p.z};
}

/// The line's two arguments and the planes' three each, then t.
template <Formula F, class... Planes>
Coordinates<F> gathered(const Numbers3& first, const Numbers3& second, double t, const Planes&... planes) {
  Coordinates<F> all{};
  auto to = all.begin();
  for (const Numbers3& n : {first, second}) to = std::ranges::copy(n, to).out;
  for (const Plane& plane : {planes...}) {
    for (const Point3& p : plane) to = std::ranges::copy(numbers(p), to).out;
  }
  if (to != all.end()) *to = t;
  return all;
}

// The sign of the denominator of a plane's parameter.
Sign facing(const Numbers3& direction, const Plane& s) {
  const auto& [a, b, c] = s;
  return decide<predicates::OrientSeenFrom>({direction[0], direction[1], direction[2],  //
                                             a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
}

Sign facing(const Point3& p, const Point3& q, const Plane& s) {
  const auto& [a, b, c] = s;
  return decide<predicates::OrientSeenAlong>(
      {p.x, p.y, p.z, q.x, q.y, q.z, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
}

// The sign of a difference of quotients from that of its numerator and those of the denominators.
template <Formula F>
std::optional<Sign> sign_of_difference(const Coordinates<F>& p, Sign denominators) {
  if (denominators != Sign::zero) return decide<F>(p) * denominators;
  require_finite<F>(p);
  return std::nullopt;
}

}  // namespace

std::optional<Sign> compare_ray_parameters(const Point3& origin, const Vector3& direction, const Plane& first,
                                           const Plane& second) {
  const Numbers3 d = numbers(direction);
  return sign_of_difference<predicates::RayOrder>(gathered<predicates::RayOrder>(numbers(origin), d, 0, first, second),
                                                  facing(d, first) * facing(d, second));
}

std::optional<Sign> compare_segment_parameters(const Point3& p, const Point3& q, const Plane& first,
                                               const Plane& second) {
  return sign_of_difference<predicates::SegmentOrder>(
      gathered<predicates::SegmentOrder>(numbers(p), numbers(q), 0, first, second),
      facing(p, q, first) * facing(p, q, second));
}

std::optional<Sign> compare_ray_parameter(const Point3& origin, const Vector3& direction, const Plane& plane,
                                          double t) {
  const Numbers3 d = numbers(direction);
  return sign_of_difference<predicates::RayAgainst>(gathered<predicates::RayAgainst>(numbers(origin), d, t, plane),
                                                    facing(d, plane));
}

std::optional<Sign> compare_segment_parameter(const Point3& p, const Point3& q, const Plane& plane, double t) {
  return sign_of_difference<predicates::SegmentAgainst>(
      gathered<predicates::SegmentAgainst>(numbers(p), numbers(q), t, plane), facing(p, q, plane));
}

}  // namespace plumb
