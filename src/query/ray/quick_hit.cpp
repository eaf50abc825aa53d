// Compiled twice, for processors that multiply and add at once and for others; both answer the same.
#include "query/ray/quick_hit.hpp"

#include "arith/twofold.hpp"
#include "certify/fused.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {
namespace {

template <class T>
[[gnu::always_inline]] inline Vec3<T> gap_of(const Point3& from, const Point3& to) {
  return {T::difference(to.x, from.x), T::difference(to.y, from.y), T::difference(to.z, from.z)};
}

template <class T>
[[gnu::always_inline]] inline void hit_numbers(const AnyRay& ray, const Triangle3& triangle, QuickHit& out) {
  const auto& [a, b, c] = triangle;
  const Point3& o = ray.origin;
  const Vec3<T> n = cross(gap_of<T>(a, b), gap_of<T>(a, c));
  const bool segment = ray.kind == AnyRay::Kind::segment;
  const Vec3<T> ends = gap_of<T>(o, segment ? ray.end : o);
  const Vec3<T> d = segment ? ends : Vec3<T>{T(ray.direction.x), T(ray.direction.y), T(ray.direction.z)};
  const T t = quotient(dot(gap_of<T>(o, a), n), dot(d, n));
  out = {t.nearest(),
         (T(o.x) + d.x * t).nearest(),
         (T(o.y) + d.y * t).nearest(),
         (T(o.z) + d.z * t).nearest(),
         n.x.nearest(),
         n.y.nearest(),
         n.z.nearest()};
}

PLUMB_WITH_FMA void hit_with_fma(const AnyRay& ray, const Triangle3& triangle, QuickHit& out) {
  hit_numbers<Twofold<true>>(ray, triangle, out);
}
PLUMB_WITHOUT void hit_without(const AnyRay& ray, const Triangle3& triangle, QuickHit& out) {
  hit_numbers<Twofold<false>>(ray, triangle, out);
}

}  // namespace

QuickHit quick_hit(const AnyRay& ray, const Triangle3& triangle) {
  QuickHit out;
  if (has_fma) {
    hit_with_fma(ray, triangle, out);
  } else {
    hit_without(ray, triangle, out);
  }
  return out;
}

}  // namespace plumb::query
