#include "plumb/query/gjk/support_mapping.hpp"

#include "arith/rounded_radical.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "query/gjk/body_pair.hpp"
#include "query/gjk/mapping_hull.hpp"

namespace plumb::query {
namespace {

using BigVec = arith::Vec<BigDyadic>;

/// root(square / whole) + extra.
double rounded_bound(Rounding rounding, const BigDyadic& square, const BigDyadic& whole, const BigDyadic& extra) {
  return rounded_radical(rounding, extra * whole, BigDyadic(1.0), square * whole, whole);
}

/// The corner of the difference that was told last, beside those of a guess.
void add_last(DifferenceCorners& guess, std::uint32_t steps) {
  if (guess.size == 4) guess.size = 3;
  guess.add({steps - 1, steps - 1});
}

/// Do the bodies meet for certain, of which the points are off by `rounding`?  Where the hulls of what is told meet also
/// after one is moved by `deep` either way along each axis, their difference has a ball of `deep` / root(3) around the
/// origin; four times the rounding is more than root(3) times what both are off.  The hulls grow as long as that helps.
bool meet_deeply(MappingHull& of_a, MappingHull& of_b, double rounding, GjkBounds& r) {
  const double deep = 4 * rounding;
  if (!figure::is_real(deep)) return false;
  for (const Vector3 by : {Vector3{deep, 0, 0}, Vector3{-deep, 0, 0}, Vector3{0, deep, 0}, Vector3{0, -deep, 0},
                           Vector3{0, 0, deep}, Vector3{0, 0, -deep}}) {
    std::optional<mpq_class> last;
    for (DifferenceCorners guess;;) {  // ends as the loop below does
      auto corners_a = CoreCorners::of(BodyView{.vertices = of_a.points()});
      const auto corners_b = CoreCorners::of(BodyView{.vertices = of_b.points()});
      corners_a->move(by, 1);
      add_last(guess, r.steps);
      const ProvedCorners proved = certainly_nearest(*corners_a, *corners_b, guess);
      if (proved.meets) break;
      guess = proved.corners;
      const mpq_class square = QuickPair(*corners_a, *corners_b, 0, 0, proved).square();
      if (last && square >= *last) return false;
      last = square;
      const Vector3 n = told_direction(*corners_a, *corners_b, guess);
      ++r.steps;
      const Point3 p = of_a.ask({-n.x, -n.y, -n.z}), q = of_b.ask(n);
      const BigVec way = arith::vec<BigDyadic>(p) + arith::vec<BigDyadic>(by) - arith::vec<BigDyadic>(q);
      if (dot(arith::vec<BigDyadic>(n), way).sign() == Sign::positive) return false;
    }
  }
  return true;
}

}  // namespace

GjkBounds bounds_of(const SupportCall& a, const SupportCall& b, const GjkBoundsOptions& options) {
  require_length("gjk_bounds", "rounding", options.rounding), require_length("gjk_bounds", "within", options.within);
  const BigDyadic both_off = BigDyadic(options.rounding) + BigDyadic(options.rounding), none(0.0);
  MappingHull of_a("gjk_bounds", "a", a, options.rounding), of_b("gjk_bounds", "b", b, options.rounding);
  GjkBounds r;
  r.upper = Ball::infinity;
  Vector3 n{1, 0, 0};
  std::optional<mpq_class> last;
  DifferenceCorners guess;
  for (;;) {  // ends, for the square falls each time, and mappings tell finitely many points of doubles
    ++r.steps;
    const Point3 p = of_a.ask({-n.x, -n.y, -n.z}), q = of_b.ask(n);
    const BigVec way = arith::vec<BigDyadic>(p) - arith::vec<BigDyadic>(q);
    const BigDyadic gap = dot(arith::vec<BigDyadic>(n), way), whole = square_of(n);
    if (gap.sign() == Sign::positive) {
      const double lower = rounded_bound(Rounding::down, gap * gap, whole, none - both_off);
      if (lower > r.lower) r.lower = lower, r.direction = n;
      if ((gap * gap - both_off * both_off * whole).sign() == Sign::positive) r.told = GjkTold::disjoint;
    }
    const auto corners_a = CoreCorners::of(BodyView{.vertices = of_a.points()}),
               corners_b = CoreCorners::of(BodyView{.vertices = of_b.points()});
    add_last(guess, r.steps);
    const ProvedCorners proved = certainly_nearest(*corners_a, *corners_b, guess);
    guess = proved.corners;
    const mpq_class square = QuickPair(*corners_a, *corners_b, 0, 0, proved).square();
    const double upper = rounded_bound(Rounding::up, BigDyadic(mpz_class(square.get_num())),
                                       BigDyadic(mpz_class(square.get_den())), both_off);
    r.upper = upper < r.upper ? upper : r.upper;
    if (proved.meets) {
      if (options.rounding == 0 || meet_deeply(of_a, of_b, options.rounding, r)) r.told = GjkTold::meeting, r.upper = 0;
      return r;
    }
    if (last && square >= *last) return r;
    if (r.upper - r.lower <= options.within) return r;
    last = square;
    n = told_direction(*corners_a, *corners_b, proved.corners);
  }
}

}  // namespace plumb::query
