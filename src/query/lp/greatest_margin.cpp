#include "plumb/query/lp/greatest_margin.hpp"

#include <map>
#include <string>

#include "arith/exact_number.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "query/convex/integer_difference.hpp"
#include "query/lp/system_rows.hpp"

namespace plumb {
namespace query {
namespace {

FlatSet hull_set(std::string_view name, std::span<const Point3> points) {
  if (points.empty())
    throw InvalidShape(std::string("greatest_margin: ").append(name).append(" has no points; give one at least"));
  FlatSet r;
  for (std::size_t i = 0; i < points.size(); ++i) {
    figure::require_sound("greatest_margin", std::string(name) + "[" + std::to_string(i) + "]", points[i]);
    r.points.push_back({points[i].x, points[i].y, points[i].z});
  }
  return r;
}

std::vector<SupportingPoint> supporting(const std::map<std::size_t, mpz_class>& weights, const mpz_class& whole) {
  std::vector<SupportingPoint> r;
  for (const auto& [i, weight] : weights) {
    mpq_class w(weight, whole);
    w.canonicalize();
    r.push_back({i, exact_number(w)});
  }
  return r;
}

Exact3 nearest_of_hull(const std::vector<SupportingPoint>& points, const FlatSet& set) {
  Exact3 r{0, 0, 0};
  for (const SupportingPoint& p : points) r = r + gmp_number(p.weight) * set.points[p.point];
  return r;
}

}  // namespace
}  // namespace query

std::optional<GreatestMargin3> greatest_margin(std::span<const Point3> first, std::span<const Point3> second) {
  using namespace query;
  const FlatSet a = hull_set("first", first), b = hull_set("second", second);
  const IntegerDifference sets = in_integers(a, b);
  arith::DifferenceSearch<mpz_class> search(sets.difference, guessed_corners(sets.difference));
  while (search.step()) {
  }
  if (search.square() == 0) return {};
  std::array<std::map<std::size_t, mpz_class>, 2> weights;
  for (std::size_t i = 0; i < search.corners().size(); ++i) {
    const arith::DifferenceCorner& c = search.corners()[i];
    weights[0][c.first] += search.weights()[i];
    weights[1][c.second] += search.weights()[i];
  }
  GreatestMargin3 m;
  m.of_first = supporting(weights[0], search.whole()), m.of_second = supporting(weights[1], search.whole());
  const Exact3 on_a = nearest_of_hull(m.of_first, a), on_b = nearest_of_hull(m.of_second, b), way = on_b - on_a;
  for (std::size_t k = 0; k < 3; ++k) m.direction[k] = exact_number(way[k]);
  m.square = exact_number(dot(way, way));
  m.margin = rounded_root(Rounding::nearest, m.square);
  m.first_end = exact_number(dot(way, on_a)), m.second_end = exact_number(dot(way, on_b));
  return m;
}

}  // namespace plumb
