// Continuous collision detection, coplanarity cubic: can four linearly moving points be in one plane at some time in
// [0, 1]?  Signs of the cubic's Bernstein coefficients.
//
// orient3d of the points at time t is b0 (1-t)^3 + 3 b1 t (1-t)^2 + 3 b2 t^2 (1-t) + b3 t^3.  Vertex against face and
// edge against edge meet only at its roots.
// Laws: (1) swapping two points flips all four signs.  (2) Swapping the two times reverses their order.  (3) The cubic
// has no root in [0, 1] when all four are positive or all negative; in (0, 1) it has as many roots, counted with
// multiplicity, as the signs have variations, or an even number less; b0 or b3 zero means a root at 0 or 1.  (4) All
// zero: the points are in one plane at every time.
// A coordinate that is NaN or infinite throws NonFinite.
// Source: RTCD 5.5; Provot 1997; Descartes' rule in the Bernstein basis.
// Cost: four signs of degree 3.
#pragma once

#include <array>
#include <span>

#include "plumb/arith/point.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/predicates/moving_points.hpp"

namespace plumb {

/// Signs of b0, b1, b2, b3 for four points with these positions at time 0 and at time 1.
template <int = 0>
inline std::array<Sign, 4> coplanarity_signs(std::span<const Point3, 4> at_0, std::span<const Point3, 4> at_1) {
  const auto still = [](std::span<const Point3, 4> p) {
    return decide<predicates::Orient3d>({p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z,  //
                                         p[2].x, p[2].y, p[2].z, p[3].x, p[3].y, p[3].z});
  };
  const auto middle = [](std::span<const Point3, 4> p, std::span<const Point3, 4> q) {
    return decide<predicates::CoplanarityMiddle>({p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z,  //
                                                  p[2].x, p[2].y, p[2].z, p[3].x, p[3].y, p[3].z,  //
                                                  q[0].x, q[0].y, q[0].z, q[1].x, q[1].y, q[1].z,  //
                                                  q[2].x, q[2].y, q[2].z, q[3].x, q[3].y, q[3].z});
  };
  return {still(at_0), middle(at_0, at_1), middle(at_1, at_0), still(at_1)};
}

/// How often the sign changes along the sequence; zeros are passed over.
constexpr int sign_variations(std::span<const Sign> signs) {
  int variations = 0;
  Sign last = Sign::zero;
  for (const Sign s : signs) {
    if (s == Sign::zero) continue;
    if (s == -last) ++variations;
    last = s;
  }
  return variations;
}

}  // namespace plumb
