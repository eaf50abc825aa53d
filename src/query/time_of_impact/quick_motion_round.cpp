#include "plumb/figure/basic/round.hpp"
#include "query/time_of_impact/balls_in_motion.hpp"
#include "query/time_of_impact/quick_motion.hpp"

namespace plumb::query::quick {
namespace {

/// When is |d + v t|^2 <= reach^2?  Where c + 2 h t + e t^2 <= 0.
template <ContactWanted asked>
[[gnu::always_inline]] inline Answer balls(const Point3& a, const Point3& b, double of_a, double of_b,
                                           const Vector3& by_a, const Vector3& by_b, Feature feature_b) {
  BallsWorld<> w;
  const BallsInMotion<BallsWorld<>> balls(w, a, b, of_a, of_b, by_a, by_b);
  const auto c = balls.c();
  const auto h = balls.h();
  if (!w.certain()) return unsure;
  if (w.negative(c)) return overlap;
  if (!w.positive(c)) return unsure;
  const auto rest = balls.discriminant();
  const bool leads_away = w.positive(h), passes = w.negative(rest);  // as one: nobody foresees which
  if (leads_away | passes) return no;
  const auto at_end = balls.value_at_end();
  const auto slope = balls.slope_at_end();
  const bool is_apart = w.positive(at_end), falls = w.negative(slope);
  if (is_apart & falls) return no;
  const bool meets = w.negative(at_end) || (w.positive(rest) && w.negative(h) && w.positive(slope));
  if (!meets) return by_a == by_b ? no : unsure;
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
