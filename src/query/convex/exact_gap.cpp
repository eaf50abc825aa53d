#include "query/convex/exact_gap.hpp"

#include "query/convex/integer_difference.hpp"

namespace plumb::query {
namespace {

Relation relation_within(const FlatSet& a, const FlatSet& b, const mpq_class& reach) {
  if (sgn(reach) == 0) return relate(a, b);
  const std::optional<mpq_class> square = squared_distance(a, b);
  if (!square) return Relation::disjoint;
  return static_cast<Relation>(sgn(mpq_class(reach * reach - *square)));
}

}  // namespace

std::optional<mpq_class> squared_distance(const FlatSet& a, const FlatSet& b) {
  if (a.points.empty() || b.points.empty()) return {};
  const IntegerDifference sets = in_integers(a, b);
  arith::DifferenceSearch<mpz_class> search(sets.difference, guessed_corners(sets.difference));
  while (search.step()) {
  }
  const mpz_class root = search.whole() * sets.scale;
  mpq_class square(search.square(), root * root);
  square.canonicalize();
  return square;
}

Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other) {
  return relation_within(core, other, radius);
}
Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other_core, double other_radius) {
  return relation_within(core, other_core, mpq_class(radius) + mpq_class(other_radius));
}

}  // namespace plumb::query
