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

template <Asked asked, class T = Approximate>
[[gnu::always_inline]] inline Answer balls(const Point3& a, const Point3& b, double of_a, double of_b,
                                           const Vector3& by_a, const Vector3& by_b, Feature feature_b) {
  const auto closing = [&]<class N>(N reach) { return Closing<N>(a, b, reach + N(of_b), velocity<N>(by_a, by_b)); };
  const Closing<T> q = closing(T(of_a));
  const int at_start = certain(q.c), way = certain(q.h);
  if (at_start < 0) return overlap;
  if (at_start == 0) return unsure;
  if (way > 0) return no;
  const int at_end = certain(q.c + q.h + q.h + q.e), way_at_end = certain(q.h + q.e);
  if (at_end > 0 && way_at_end < 0) return no;
  bool meets = at_end < 0;
  if (!meets || asked == Asked::when) {
    const int roots = certain(q.h * q.h - q.e * q.c);
    if (roots < 0) return no;
    meets = meets || (roots > 0 && way < 0 && way_at_end > 0);
  }
  if (!meets) return unsure;
  if constexpr (asked == Asked::whether) return {Told::yes};
  const Closing<Pairs> p = closing(Pairs(of_a));
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
