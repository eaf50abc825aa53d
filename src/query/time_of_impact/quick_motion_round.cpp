#include "plumb/figure/basic/round.hpp"
#include "query/time_of_impact/quick_motion.hpp"

namespace plumb::query::quick {
namespace {

/// When is |d + v t|^2 <= reach^2?  Where c + 2 h t + e t^2 <= 0.
template <ContactWanted asked>
[[gnu::always_inline]] inline Answer balls(const Point3& a, const Point3& b, double of_a, double of_b,
                                           const Vector3& by_a, const Vector3& by_b, Feature feature_b) {
  // Every number is off by a unit of 2^-53, a sum of squares by 5, a dot product by 5 of the sizes of its terms: by
  // Cauchy's inequality of the root of `all` e, which is less than half their sum; a product of two by twice as much.
  const Vec3<double> d = between<double>(b, a), v = velocity<double>(by_a, by_b);
  const double reach = of_a + of_b, square = reach * reach, far = dot(d, d), h = dot(d, v), e = dot(v, v);
  constexpr double unit = 0x1p-49, least = 0x1p-1000;
  const double c = far - square, all = far + square, doubt = (all + e) * unit + least;
  if (c < -doubt) return overlap;
  if (!(c > doubt)) return unsure;
  if (h > doubt) return no;
  const double at_end = (c + h) + (h + e), way_at_end = h + e;
  if (at_end > 4 * doubt && way_at_end < -2 * doubt) return no;
  bool meets = at_end < -4 * doubt;
  if (!meets || asked == ContactWanted::when) {
    const double rest = h * h - e * c, off = 4 * unit * (e * all + least * (all + e + 1));
    if (rest < -off) return no;
    // Of h * h alone rest may be infinite where e * all is not.
    meets = meets || (rest > off && rest < Ball::infinity && h < -doubt && way_at_end > 2 * doubt);
  }
  if (!meets) return v.x == 0 && v.y == 0 && v.z == 0 ? no : unsure;
  if constexpr (asked == ContactWanted::whether) return {MotionVerdict::yes};
  const Vec3<Pairs> from = between<Pairs>(b, a), way = velocity<Pairs>(by_a, by_b);
  const Pairs radii = Pairs(of_a) + Pairs(of_b), left = dot(from, from) - radii * radii, half = dot(from, way);
  return at(quotient(left, root(half * half - dot(way, way) * left) - half), {FeatureKind::face, 0}, feature_b);
}

}  // namespace

template <ContactWanted asked>
Answer contact(const Translating<Sphere3>& a, const Translating<Sphere3>& b) {
  return balls<asked>(a.shape.center, b.shape.center, a.shape.radius, b.shape.radius, a.by, b.by,
                      {FeatureKind::face, 0});
}
template <ContactWanted asked>
Answer contact(const Translating<Sphere3>& a, const Translating<Point3>& b) {
  return balls<asked>(a.shape.center, b.shape, a.shape.radius, 0, a.by, b.by, {FeatureKind::vertex, 0});
}
PLUMB_QUICK_PAIR(Sphere3, Sphere3)
PLUMB_QUICK_PAIR(Sphere3, Point3)

}  // namespace plumb::query::quick
