#include "query/certificate/evidence.hpp"

#include <algorithm>

#include "arith/rational_lp.hpp"
#include "query/certificate/number.hpp"
#include "query/certificate/span.hpp"
#include "query/convex/integer_difference.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query {
namespace {

using Pairs = std::vector<WeightedPair>;

Exact3 in_rationals(const arith::Vec<mpq_class>& v) { return {v.x, v.y, v.z}; }

std::vector<Exact3> points_of(const CoreCorners& c) {
  std::vector<Exact3> points;
  points.reserve(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) points.push_back(in_rationals(c.at<mpq_class>(i)));
  return points;
}

/// By the search that doubles begin and integers end.
Pairs nearest_pairs(const std::vector<Exact3>& a, const std::vector<Exact3>& b) {
  const IntegerDifference sets = in_integers({a, {}, {}}, {b, {}, {}});
  arith::DifferenceSearch<mpz_class> search(sets.difference, guessed_corners(sets.difference));
  while (search.step()) {
  }
  Pairs pairs;
  for (std::size_t i = 0; i < search.corners().size(); ++i) {
    const arith::DifferenceCorner& c = search.corners()[i];
    pairs.push_back({static_cast<std::uint32_t>(c.first), static_cast<std::uint32_t>(c.second),
                     rational(mpq_class(search.weights()[i], search.whole()))});
  }
  return pairs;
}

/// The weights of corners that are known to be those of the nearest point.
Pairs weights_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic>(a, b, corners, ask);
  const mpq_class whole = big_rational(n.whole).value;
  Pairs pairs;
  for (std::size_t i = 0; i < corners.size; ++i)
    pairs.push_back({corners.ends[i][0], corners.ends[i][1], rational(big_rational(n.weight[i]).value / whole)});
  return pairs;
}

/// One set of weights and another that add up to the same point, each taken half.
Pairs joined(const Pairs& one, const Pairs& other) {
  Pairs all = one;
  for (const WeightedPair& pair : other) {
    const auto same =
        std::ranges::find_if(all, [&](const WeightedPair& p) { return p.of_a == pair.of_a && p.of_b == pair.of_b; });
    if (same == all.end()) {
      all.push_back(pair);
    } else {
      same->weight = same->weight + pair.weight;
    }
  }
  for (WeightedPair& pair : all) pair.weight = pair.weight / Rational(2);
  return all;
}

class Spanning {
 public:
  Spanning(const CoreCorners& a, const CoreCorners& b) : a_(points_of(a)), b_(points_of(b)) {}

  /// A pair that the others do not span, of a vertex of theirs.
  [[nodiscard]] std::optional<WeightedPair> beyond(const Pairs& pairs) const {
    Span span;
    const auto in_span = [&span](const Exact3& v) { return span.holds({v[0], v[1], v[2]}); };
    for (const WeightedPair& p : pairs) {
      const Exact3 d = difference(p);
      span.add({d[0], d[1], d[2]});
    }
    WeightedPair found = pairs[0];
    for (found.of_a = 0; found.of_a < a_.size(); ++found.of_a) {
      if (!in_span(difference(found))) return found;
    }
    found = pairs[0];
    for (found.of_b = 0; found.of_b < b_.size(); ++found.of_b) {
      if (!in_span(difference(found))) return found;
    }
    return {};
  }

  [[nodiscard]] Exact3 difference(const WeightedPair& p) const { return a_[p.of_a] - b_[p.of_b]; }

  /// How far the difference goes from the origin against `way`, which is one of its points: the greatest t for which it has
  /// -t way.  By the linear program of the plane that ends it there: the greatest s + t with n.u + s <= 0, t <= n.v and
  /// n.way <= -1.
  struct Reach {
    mpq_class times;
    Exact3 normal;
  };
  [[nodiscard]] Reach reach_against(const Exact3& way) const {
    arith::Constraints all;
    for (const Exact3& u : a_) all.add({u[0], u[1], u[2], 1, 0}, 0);
    for (const Exact3& v : b_) all.add({-v[0], -v[1], -v[2], 0, 1}, 0);
    all.add({way[0], way[1], way[2], 0, 0}, -1);
    const arith::RationalVector at = arith::maximize({0, 0, 0, 1, 1}, all).at;
    return {-at[3] - at[4], {at[0], at[1], at[2]}};
  }

  /// Weights of the origin to which `pair` contributes: it times t, and what makes -t times it.
  [[nodiscard]] Pairs around(const WeightedPair& pair, const Reach& reach) const {
    std::vector<Exact3> moved = a_;
    const Exact3 by = reach.times * difference(pair);
    for (Exact3& u : moved) u = u + by;
    Pairs all = nearest_pairs(moved, b_);
    all.push_back(pair);
    all.back().weight = rational(reach.times);
    const Rational whole = Rational(1) + all.back().weight;
    for (WeightedPair& p : all) p.weight = p.weight / whole;
    return all;
  }

 private:
  std::vector<Exact3> a_, b_;
};

}  // namespace

NearestDifference nearest_difference(const CoreCorners& a, const CoreCorners& b) {
  const auto proved = proved_nearest(a, b);
  NearestDifference nearest{
      proved ? weights_of(a, b, proved->corners) : nearest_pairs(points_of(a), points_of(b)), {}, 0};
  for (const WeightedPair& p : nearest.pairs) {
    const Exact3 d = in_rationals(difference_of<mpq_class>(a, b, {p.of_a, p.of_b}));
    nearest.at = nearest.at + number(p.weight) * d;
  }
  nearest.square = dot(nearest.at, nearest.at);
  return nearest;
}

// Each turn adds a way to what the pairs span, so that there are three at most.
SpanOrPlane span_or_plane(const CoreCorners& a, const CoreCorners& b, std::vector<WeightedPair> pairs) {
  if (pairs.size() == 4) return {std::move(pairs), {}};  // independent and around the origin: all of space
  const Spanning spanning(a, b);
  while (const auto beyond = spanning.beyond(pairs)) {
    const auto reach = spanning.reach_against(spanning.difference(*beyond));
    if (sgn(reach.times) == 0) return {{}, reach.normal};
    pairs = joined(pairs, spanning.around(*beyond, reach));
  }
  return {std::move(pairs), {}};
}

}  // namespace plumb::query
