// Separating axis test: does a cross product of two boxes' edges separate them, and do they touch along it?
//
// A box has `center`, `axes` (three vectors, of any length and at any angle) and `half` (extents, of which the
// magnitude counts): all points center + sum of s_i axes_i with |s_i| <= half_i.  It is the parallelepiped that its
// numbers say, so its face normals are cross products of its axes, not the axes themselves.  Two boxes with independent
// axes are disjoint exactly when one of fifteen axes separates them: three face_gap of each, nine edge_gap.
// Laws: (1) swapping the boxes changes nothing (edge_gap: the axes swapped as well).  (2) Scaling the factors of the
// cross product, or reversing any axis, changes nothing.  (3) Nothing is answered exactly when the cross product is the
// zero vector, which separates nothing and says nothing of touching.
// A coordinate that is NaN or infinite throws NonFinite.
// Source: RTCD 4.4.1, table 4.1; 4.4.2, 5.2.1.1 for the zero vector.
// Cost: 24 products where floating point suffices; otherwise the five signs that resolve the absolute values, and one
// of degree 4.
#pragma once

#include <optional>

#include "plumb/arith/point.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/detail/gap_filter.hpp"
#include "plumb/predicates/separating_axis.hpp"

namespace plumb {

namespace certify::separating_axis {

using Input = Coordinates<predicates::BoxGap>;

/// For what the filter leaves undecided.
std::optional<Sign> decide_exactly(Input p);

}  // namespace certify::separating_axis

/// Sign of |(cb - ca) . L| - (reach of a + reach of b) for L = u x v, where both boxes reach |half_i (w_i . L)| along L
/// with axes w_i that are not multiples of u or v: positive when L separates the boxes, zero when they touch in their
/// projections on L, negative when these overlap.  Nothing when L is the zero vector.
template <int = 0>
inline std::optional<Sign> axis_gap(const Point3& ca, const Point3& cb, const Vector3& u, const Vector3& v,
                                    const std::array<Vector3, 4>& w, const std::array<double, 4>& half) {
  const certify::separating_axis::Input p{ca.x,
                                          ca.y,
                                          ca.z,
                                          cb.x,
                                          cb.y,
                                          cb.z,
                                          u.x,
                                          u.y,
                                          u.z,
                                          v.x,
                                          v.y,
                                          v.z,
                                          w[0].x,
                                          w[0].y,
                                          w[0].z,
                                          w[1].x,
                                          w[1].y,
                                          w[1].z,
                                          w[2].x,
                                          w[2].y,
                                          w[2].z,
                                          w[3].x,
                                          w[3].y,
                                          w[3].z,
                                          magnitude_of(half[0]),
                                          magnitude_of(half[1]),
                                          magnitude_of(half[2]),
                                          magnitude_of(half[3])};
  if (const int s = gap_filter<predicates::BoxGap>(p); s != 0) [[likely]]
    return static_cast<Sign>(s);
  return certify::separating_axis::decide_exactly(p);
}

/// Along the normal of the face of a that axis i (0, 1 or 2) points through: L = a.axes[i + 1] x a.axes[i + 2].
template <class Box>
std::optional<Sign> face_gap(const Box& a, const Box& b, std::size_t i) {
  const std::array half{a.half.x, a.half.y, a.half.z};
  return axis_gap(a.center, b.center, a.axes[(i + 1) % 3], a.axes[(i + 2) % 3],
                  {a.axes[i], b.axes[0], b.axes[1], b.axes[2]}, {half[i], b.half.x, b.half.y, b.half.z});
}

/// Along L = a.axes[i] x b.axes[j].
template <class Box>
std::optional<Sign> edge_gap(const Box& a, const Box& b, std::size_t i, std::size_t j) {
  const std::array half_a{a.half.x, a.half.y, a.half.z}, half_b{b.half.x, b.half.y, b.half.z};
  const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  return axis_gap(a.center, b.center, a.axes[i], b.axes[j], {a.axes[i1], a.axes[i2], b.axes[j1], b.axes[j2]},
                  {half_a[i1], half_a[i2], half_b[j1], half_b[j2]});
}

}  // namespace plumb
