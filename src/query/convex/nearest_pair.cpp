#include "query/convex/nearest_pair.hpp"

#include <algorithm>

#include "arith/rational_lp.hpp"
#include "query/convex/integer_difference.hpp"

namespace plumb::query {
namespace {

/// The first of weights over their whole, times what they weigh, over the scale.
class Weighted {
 public:
  void add(const mpz_class& weight, const arith::Triplet<mpz_class>& at) {
    for (std::size_t k = 0; k < 3; ++k) mpz_addmul(sum_[k].get_mpz_t(), weight.get_mpz_t(), at[k].get_mpz_t());
  }
  [[nodiscard]] Exact3 over(const mpz_class& whole) const {
    Exact3 r;
    for (std::size_t k = 0; k < 3; ++k) {
      r[k] = mpq_class(sum_[k], whole);
      r[k].canonicalize();
    }
    return r;
  }

 private:
  arith::Triplet<mpz_class> sum_{0, 0, 0};
};

NearestPair any_pair(const FlatSet& a, const FlatSet& b) {
  const IntegerDifference sets = in_integers(a, b);
  arith::DifferenceSearch<mpz_class> search(sets.difference, guessed_corners(sets.difference));
  while (search.step()) {
  }
  Weighted on_a, on_b;
  for (std::size_t i = 0; i < search.corners().size(); ++i) {
    const arith::DifferenceCorner& c = search.corners()[i];
    const mpz_class& weight = search.weights()[i];
    if (c.is_point) {
      on_a.add(weight, sets.difference.points[0][c.first]);
      on_b.add(weight, sets.difference.points[1][c.second]);
    } else if (c.first < sets.directions_of_a) {
      on_a.add(weight, sets.difference.directions[c.first]);
    } else {
      on_b.add(-weight, sets.difference.directions[c.first]);
    }
  }
  const mpz_class whole = search.whole() * sets.scale;
  NearestPair pair{on_a.over(whole) + sets.origin, on_b.over(whole) + sets.origin, {search.square(), whole * whole}};
  pair.square.canonicalize();
  return pair;
}

/// What of a set can be farthest along a way on which this one of its points is.
FlatSet farthest_along(const FlatSet& s, const Exact3& way, const Exact3& point) {
  FlatSet r;
  const mpq_class most = dot(way, point);
  for (const Exact3& p : s.points) {
    if (dot(way, p) == most) r.points.push_back(p);
  }
  for (const Exact3& d : s.directions) {
    if (sgn(dot(way, d)) == 0) r.directions.push_back(d);
  }
  r.lines = s.lines;
  return r;
}

bool is_one_point(const FlatSet& s) { return s.points.size() == 1 && s.directions.empty() && s.lines.empty(); }

/// The least coordinate of a point of `a` that less `apart` is one of `b`: over u, s, t the least s + t + u . apart with
/// (c - u) . p <= s on a and u . p <= t on b, where c is the axis turned round.  Both sets keep what such points can
/// have.  Nothing where there is no least.
std::optional<mpq_class> take_least(FlatSet& a, FlatSet& b, const Exact3& apart, std::size_t axis) {
  arith::Constraints all;
  enum class Of : unsigned char { point, direction, line };
  struct Row {
    FlatSet* set;
    Of of;
    std::size_t index;
  };
  std::vector<Row> names;
  const auto add = [&](FlatSet& set, const Exact3& v, Of of, std::size_t index, int way) {
    const bool first = &set == &a;
    arith::RationalVector row(5);
    for (std::size_t k = 0; k < 3; ++k) row[k] = (first ? -way : way) * v[k];
    if (of == Of::point) row[first ? 3 : 4] = -1;
    all.add(std::move(row), first ? mpq_class(way * v[axis]) : mpq_class(0));
    names.push_back({&set, of, index});
  };
  for (FlatSet* set : {&a, &b}) {
    for (std::size_t i = 0; i < set->points.size(); ++i) add(*set, set->points[i], Of::point, i, 1);
    for (std::size_t i = 0; i < set->directions.size(); ++i) add(*set, set->directions[i], Of::direction, i, 1);
    for (std::size_t i = 0; i < set->lines.size(); ++i) {
      add(*set, set->lines[i], Of::line, i, 1);
      add(*set, set->lines[i], Of::line, i, -1);
    }
  }
  const arith::RationalVector objective{-apart[0], -apart[1], -apart[2], -1, -1};
  const arith::Optimum best = arith::maximize(objective, all);
  if (best.kind != arith::Optimum::Kind::optimal) return {};
  FlatSet kept_a{{}, {}, a.lines}, kept_b{{}, {}, b.lines};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].of == Of::line || arith::dot(best.at, all.rows[i]) != all.limits[i]) continue;
    FlatSet& kept = names[i].set == &a ? kept_a : kept_b;
    if (names[i].of == Of::point) kept.points.push_back(names[i].set->points[names[i].index]);
    if (names[i].of == Of::direction) kept.directions.push_back(names[i].set->directions[names[i].index]);
  }
  a = std::move(kept_a);
  b = std::move(kept_b);
  return arith::dot(objective, best.at);
}

}  // namespace

std::optional<NearestPair> nearest_pair(const FlatSet& a, const FlatSet& b, WhichPair which) {
  if (a.points.empty() || b.points.empty()) return {};
  NearestPair pair = any_pair(a, b);
  if (which == WhichPair::any) return pair;
  const Exact3 apart = pair.on_a - pair.on_b;
  FlatSet near_a = farthest_along(a, mpq_class(-1) * apart, pair.on_a), near_b = farthest_along(b, apart, pair.on_b);
  if (is_one_point(near_a) || is_one_point(near_b)) return pair;
  Exact3 first;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto least = take_least(near_a, near_b, apart, axis);
    if (!least) {
      pair.is_first = false;
      return pair;
    }
    first[axis] = *least;
  }
  pair.on_b = first - apart;
  pair.on_a = std::move(first);
  return pair;
}

}  // namespace plumb::query
