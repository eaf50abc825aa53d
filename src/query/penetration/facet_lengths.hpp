// Penetration depth: how far does a body move, to leave through the plane of a facet of the Minkowski difference?  The
// direction, the square of its length, and their product with the way, in pairs of doubles.
//
// Laws: what is told is certain to within its radius, and of numbers of few bits it is exact: zero is seen to be zero.
// Nothing where the corners are not doubles as given, or too large.
// Source: arith/track.hpp; RTCD 9.3.8.
// Cost: some 700 operations, a third of what balls take.
#pragma once

#include "plumb/arith/ball.hpp"
#include "query/penetration/difference.hpp"
#include "query/penetration/triangle_plane.hpp"

namespace plumb::query::parting {

/// A statement that tells numbers, over any world: of n = (r - p) x (q - p), which leads in, n n and -n p.
struct FacetLengths {
  static constexpr int highest = 4;
  static constexpr Scales scales{.count = 1, .maxima = 1};

  template <class W, class Tell>
  void operator()(W& w, const TrianglePairs& of, const Tell& tell) const {
    const auto &a = of.a, &b = of.b;
    const auto edge = [&](std::size_t i, auto axis) {  // of what both corners have in common nothing is left
      return w.difference(a[i].*axis, a[0].*axis) + w.difference(b[0].*axis, b[i].*axis);
    };
    constexpr auto x = &Point3::x, y = &Point3::y, z = &Point3::z;
    const auto ux = edge(2, x), uy = edge(2, y), uz = edge(2, z);
    const auto vx = edge(1, x), vy = edge(1, y), vz = edge(1, z);
    const auto nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const auto from = [&](auto axis) { return w.difference(b[0].*axis, a[0].*axis); };
    tell(nx, ny, nz, nx * nx + ny * ny + nz * nz, nx * from(x) + ny * from(y) + nz * from(z));
  }
};

struct FacetLengthsTold {
  Vec<Ball> way;
  Ball square, overlap;
};
std::optional<FacetLengthsTold> facet_lengths(const Difference& d, const std::array<Ends, 3>& facet);

}  // namespace plumb::query::parting
