#include "plumb/figure/round.hpp"
#include "query/quick_motion.hpp"

namespace plumb::query::quick {
namespace {

/// When is |from + velocity t|^2 <= reach^2?  Where c + 2 h t + e t^2 <= 0.
template <class T>
struct Closing {
  T c, h, e;

  [[gnu::always_inline]] Closing(const Point3& a, const Point3& b, const T& reach, const Vec3<T>& velocity)
      : c(T(0.0)), h(T(0.0)), e(dot(velocity, velocity)) {
    const Vec3<T> d = between<T>(b, a);
    c = dot(d, d) - reach * reach;
    h = dot(d, velocity);
  }
};

template <Asked asked>
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
  if (!meets || asked == Asked::when) {
    const double rest = h * h - e * c, off = 4 * unit * (e * all + least * (all + e + 1));
    if (rest < -off) return no;
    meets = meets || (rest > off && h < -doubt && way_at_end > 2 * doubt);
  }
  if (!meets) return v.x == 0 && v.y == 0 && v.z == 0 ? no : unsure;
  if constexpr (asked == Asked::whether) return {Told::yes};
  const Closing<Pairs> p(a, b, Pairs(of_a) + Pairs(of_b), velocity<Pairs>(by_a, by_b));
  return at(quotient(p.c, root(p.h * p.h - p.e * p.c) - p.h), {FeatureKind::face, 0}, feature_b);
}

}  // namespace

template <Asked asked>
Answer contact(const Translating<Sphere3>& a, const Translating<Sphere3>& b) {
  return balls<asked>(a.shape.center, b.shape.center, a.shape.radius, b.shape.radius, a.by, b.by,
                      {FeatureKind::face, 0});
}
template <Asked asked>
Answer contact(const Translating<Sphere3>& a, const Translating<Point3>& b) {
  return balls<asked>(a.shape.center, b.shape, a.shape.radius, 0, a.by, b.by, {FeatureKind::vertex, 0});
}
template Answer contact<Asked::whether>(const Translating<Sphere3>&, const Translating<Sphere3>&);
template Answer contact<Asked::when>(const Translating<Sphere3>&, const Translating<Sphere3>&);
template Answer contact<Asked::whether>(const Translating<Sphere3>&, const Translating<Point3>&);
template Answer contact<Asked::when>(const Translating<Sphere3>&, const Translating<Point3>&);

}  // namespace plumb::query::quick
