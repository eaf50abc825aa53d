// A ball against what its nearest point is soon found on: lines, rays, segments, axis-aligned boxes.
#include <algorithm>

#include "plumb/predicates/distance.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/straight_and_ball.hpp"

namespace plumb {
namespace query {
namespace {

Sign gap(const Point3& p, const Sphere3& b) { return sign_of(predicates::DistanceAgainst3d{}, p, b.center, b.radius); }
/// Of a box that is not empty.
Sign gap(const Aabb3& a, const Sphere3& b) {
  const auto& [x, y, z] = b.center;
  return gap(Point3{std::clamp(x, a.min.x, a.max.x), std::clamp(y, a.min.y, a.max.y), std::clamp(z, a.min.z, a.max.z)},
             b);
}

// The statement, by each kind.
auto in_words(const Line3& a, const Sphere3& b, const auto& ask) {
  return ask(StraightAndBall<false, false>{}, a.point, a.direction, b);
}
auto in_words(const Ray3& a, const Sphere3& b, const auto& ask) {
  return ask(StraightAndBall<true, false>{}, a.origin, a.direction, b);
}
auto in_words(const Segment3& a, const Sphere3& b, const auto& ask) {
  return ask(StraightAndBall<true, true>{}, a.a, a.b, b);
}

template <class Flat>
Relation relate_nearest(const Flat& flat, const Sphere3& ball, Question question) {
  assert_sound_thread();
  require_figures(question, flat, ball);
  if (is_nothing(flat)) return Relation::disjoint;
  const Sign s = gap(flat, ball);
  if (s == Sign::zero && ball.radius == 0) return relate_swept(core_of(ball), 0, flat_set(flat));
  return static_cast<Relation>(-s);
}

template <class Straight>
[[gnu::noinline]] Relation relate_precisely(const Straight& straight, const Sphere3& ball, Question question) {
  require_figures(question, straight, ball);
  const Relation r = in_words(straight, ball, []<class Statement>(const Statement& statement, const auto&... input) {
    return certainly<CloserWorlds<Statement>>(statement, input...);
  });
  if (r == Relation::touching && ball.radius == 0) return relate_swept(core_of(ball), 0, flat_set(straight));
  return r;
}

template <class Straight>
Relation relate_straight_and_ball(const Straight& straight, const Sphere3& ball, Question question) {
  assert_sound_thread();
  if (ball.radius >= 0) [[likely]] {
    const auto told = in_words(straight, ball, []<class Statement>(const Statement& statement, const auto&... input) {
      return certify::one_lane::told_by_worlds<FloatWorld<Statement>>(NoWorldRecorder{}, statement, input...);
    });
    if (told) [[likely]]
      return *told;
  }
  return relate_precisely(straight, ball, question);
}

}  // namespace

PLUMB_PAIR_ANSWER(Point3, Sphere3, relate_nearest)
PLUMB_PAIR_ANSWERS_TO(Sphere3, relate_straight_and_ball, Line3, Ray3, Segment3)
Relation relate_pair(PairFunction<Sphere3, Aabb3>, const Sphere3& a, const Aabb3& b, Question question) {
  return relate_nearest(b, a, question);
}

}  // namespace query
}  // namespace plumb
