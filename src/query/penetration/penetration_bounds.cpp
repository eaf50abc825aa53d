#include "plumb/query/penetration/penetration_bounds.hpp"

#include <algorithm>

#include "arith/rounded_radical.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "query/gjk/mapping_hull.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query {
namespace {

/// x / root(whole) + extra.
double rounded_length(Rounding rounding, const BigDyadic& x, const BigDyadic& whole, const BigDyadic& extra) {
  return rounded_radical(rounding, extra * whole, x, whole, whole);
}

bool has_been_told(std::span<const Point3> points) {
  const auto before = points.first(points.size() - 1);
  return std::ranges::find(before, points.back()) != before.end();
}

}  // namespace

PenetrationBounds penetration_bounds_of(const SupportCall& a, const SupportCall& b,
                                        const PenetrationBoundsOptions& options) {
  const char* const function = "penetration_bounds";
  require_length(function, "rounding", options.rounding), require_length(function, "within", options.within);
  if (options.most_steps == 0) {
    throw InvalidShape("penetration_bounds: options.most_steps is zero; a step at least asks along one direction");
  }
  const BigDyadic both_off = BigDyadic(options.rounding) + BigDyadic(options.rounding), none;
  MappingHull of_a(function, "a", a, options.rounding), of_b(function, "b", b, options.rounding);
  // Both bounds give way by what is off of both points: nearer than four times that they never come.
  constexpr double pays = 8;  // a guess
  const double near_enough = std::max(options.within, pays * options.rounding);
  PenetrationBounds r;
  r.upper = Ball::infinity;
  Vector3 n{1, 0, 0};
  for (;;) {  // ends: query/penetration/penetration_bounds.hpp, law (4)
    ++r.steps;
    const Point3 p = of_a.ask({-n.x, -n.y, -n.z}), q = of_b.ask(n);
    const BigDyadic overlap = dot(arith::vec<BigDyadic>(n), arith::vec<BigDyadic>(q) - arith::vec<BigDyadic>(p));
    const BigDyadic whole = square_of(n);
    if (overlap.sign() == Sign::negative &&
        (overlap * overlap - both_off * both_off * whole).sign() == Sign::positive) {
      return {.told = GjkTold::disjoint, .steps = r.steps};
    }
    const double upper = std::max(0.0, rounded_length(Rounding::up, overlap, whole, both_off));
    if (upper < r.upper) r.upper = upper, r.direction = n;

    const VertexHull3 hull_a{of_a.points()}, hull_b{of_b.points()};
    const auto deep = penetration(hull_a, hull_b);
    if (deep) {  // the depth told is the nearest double: the one below it is no more than the exact one
      const double least = deep->depth > 0 ? std::nextafter(deep->depth, 0.0) : 0;
      r.lower = std::max(r.lower, rounded(Rounding::down, BigDyadic(least) - both_off));
      if (options.rounding == 0 || r.lower > 0) r.told = GjkTold::meeting;
    }
    const bool is_new = !has_been_told(of_a.points()) || !has_been_told(of_b.points());
    if (r.upper - r.lower <= near_enough || !is_new || r.steps >= options.most_steps) return r;
    if (deep) {
      n = deep->direction;
    } else {
      const auto corners_a = CoreCorners::of(BodyView{.vertices = of_a.points()}),
                 corners_b = CoreCorners::of(BodyView{.vertices = of_b.points()});
      DifferenceCorners guess;
      guess.add({r.steps - 1, r.steps - 1});
      n = told_direction(*corners_a, *corners_b, certainly_nearest(*corners_a, *corners_b, guess).corners);
    }
  }
}

}  // namespace plumb::query
