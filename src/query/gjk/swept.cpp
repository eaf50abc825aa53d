#include "plumb/query/gjk/swept.hpp"

#include <string>

#include "figure/basic/finite_parts.hpp"
#include "query/body/figure_input.hpp"
#include "query/gjk/body_pair.hpp"

namespace plumb::query {
namespace {

void require_way(std::string_view function, const std::string& name, const Vector3& by) {
  if (!is_real(sum_of(by))) require_finite_parts(function, {name}, by);
}

/// The first one sweeps as it is seen from the second.
BodyPair swept_pair(std::string_view function, const SweptBody& a, const SweptBody& b) {
  require_way(function, "by_a", a.by), require_way(function, "by_b", b.by);
  BodyPair pair(function, a.body, b.body);
  pair.sweep(a.by, b.by);
  return pair;
}

ProvedCorners nearest_on_way(const BodyPair& pair) {
  const DifferenceCorners guess = guessed_nearest(pair.a(), pair.b());
  if (const auto j = judged<Running>(pair.a(), pair.b(), guess); j && j->holds) return j->proved;
  return certainly_nearest(pair.a(), pair.b(), guess);
}

}  // namespace

bool moving_meet(const SweptBody& a, const SweptBody& b) {
  const BodyPair pair = swept_pair("gjk_intersects_moving", a, b);
  return pair.meets(nearest_on_way(pair));
}

double moving_apart_by(const SweptBody& a, const SweptBody& b) {
  const BodyPair pair = swept_pair("gjk_distance_moving", a, b);
  return pair.distance(nearest_on_way(pair));
}

}  // namespace plumb::query
