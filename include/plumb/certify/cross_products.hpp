// What sign has a product of cross products?  The building blocks of angles between planes and of separating axes.
//
// Laws: (1) swapping the two factors of a cross product flips the sign.  (2) A cross product that is the zero vector
// (its factors are parallel, or one is zero) gives zero, exactly.  (3) Positive multiples of vectors change nothing.
// A coordinate that is NaN or infinite throws NonFinite.
// Source: RTCD 3.3.6, 4.4.2, 5.2.1.1.
// Cost: one sign of degree 3 or 4.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/predicates/cross_products.hpp"

namespace plumb {

/// (a x b) . (c x d): whether the planes that the two pairs span turn about an acute, right (zero) or obtuse angle.
template <int = 0>
inline Sign dot_of_crosses(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return decide<predicates::DotOfCrosses>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z});
}

/// (a x (b x c)) . d, which is (d x a) . (b x c).
template <int = 0>
inline Sign dot_of_triple_cross(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return dot_of_crosses(d, a, b, c);
}

/// (u x v) . (q - p): positive when q lies further than p along u x v.
template <int = 0>
inline Sign order_along_cross(const Vector3& u, const Vector3& v, const Point3& p, const Point3& q) {
  return decide<predicates::OrderAlongCross>({u.x, u.y, u.z, v.x, v.y, v.z, p.x, p.y, p.z, q.x, q.y, q.z});
}

}  // namespace plumb
