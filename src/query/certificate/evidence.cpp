#include "query/certificate/evidence.hpp"

#include <algorithm>

#include "arith/exact_number.hpp"
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

using Integers = arith::Difference<mpz_class>;
using Search = arith::DifferenceSearch<mpz_class>;

/// The search that doubles begin and integers end, at its end.
Search searched(const Integers& sets) {
  Search search(sets, guessed_corners(sets));
  while (search.step()) {
  }
  return search;
}

Pairs pairs_of(const Search& search) {
  Pairs pairs;
  for (std::size_t i = 0; i < search.corners().size(); ++i) {
    const arith::DifferenceCorner& c = search.corners()[i];
    pairs.push_back({static_cast<std::uint32_t>(c.first), static_cast<std::uint32_t>(c.second),
                     exact_number(mpq_class(search.weights()[i], search.whole()))});
  }
  return pairs;
}

IntegerDifference integers_of(const CoreCorners& a, const CoreCorners& b) {
  return in_integers({points_of(a), {}, {}}, {points_of(b), {}, {}});
}

/// The weights of corners that are known to be those of the nearest point.
Pairs weights_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic>(a, b, corners, ask);
  const mpq_class whole = gmp_number(n.whole);
  Pairs pairs;
  for (std::size_t i = 0; i < corners.size; ++i)
    pairs.push_back({corners.ends[i][0], corners.ends[i][1], exact_number(gmp_number(n.weight[i]) / whole)});
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

/// The difference as it is around the origin, which it holds.
class AroundOrigin {
 public:
  AroundOrigin(const CoreCorners& a, const CoreCorners& b) : sets_(integers_of(a, b).difference) {}

  /// A pair that the others do not span, of a vertex of theirs.
  [[nodiscard]] std::optional<WeightedPair> beyond(const Pairs& pairs) const {
    Span<mpz_class> span;
    for (const WeightedPair& p : pairs) span.add(difference(p));
    WeightedPair found = pairs[0];
    for (found.of_a = 0; found.of_a < sets_.points[0].size(); ++found.of_a) {
      if (!span.holds(difference(found))) return found;
    }
    found = pairs[0];
    for (found.of_b = 0; found.of_b < sets_.points[1].size(); ++found.of_b) {
      if (!span.holds(difference(found))) return found;
    }
    return {};
  }

  /// Weights of the origin to which `pair` contributes; or, where the difference ends at the origin on the way against
  /// the pair's own, a plane that ends it.  Either is found by what is nearest to a point so little on that way that
  /// nothing but the faces at the origin counts: less and less is tried, until it is little enough.
  [[nodiscard]] SpanOrPlane against(const WeightedPair& pair) const {
    const auto way = difference(pair);
    for (mp_bitcnt_t bits = 0;; bits = 2 * bits + 2) {
      const Integers seen = seen_from(way, bits);
      const Search search = searched(seen);
      if (search.square() == 0) return {around(pair, pairs_of(search), bits), {}};
      const arith::Vec<mpz_class> normal = normal_of(search, way, bits);
      if (ends_at_origin(normal)) return {{}, Exact3{normal.x, normal.y, normal.z}};
    }
  }

 private:
  using Vector = arith::Vec<mpz_class>;
  static Vector vector(const arith::Triplet<mpz_class>& v) { return {v[0], v[1], v[2]}; }
  [[nodiscard]] Vector difference(std::size_t i, std::size_t j) const {
    return vector(sets_.points[0][i]) - vector(sets_.points[1][j]);
  }
  [[nodiscard]] Vector difference(const WeightedPair& p) const { return difference(p.of_a, p.of_b); }

  /// Times 2^bits, and moved by `way`: seen from -way / 2^bits.
  [[nodiscard]] Integers seen_from(const Vector& way, mp_bitcnt_t bits) const {
    Integers seen = sets_;
    const arith::Triplet<mpz_class> by{way.x, way.y, way.z};
    for (std::size_t s = 0; s < 2; ++s) {
      for (arith::Triplet<mpz_class>& p : seen.points[s]) {
        for (std::size_t k = 0; k < 3; ++k) {
          p[k] <<= bits;
          if (s == 0) p[k] += by[k];
        }
      }
    }
    return seen;
  }

  /// From a to b, at right angles to what is nearest.
  [[nodiscard]] Vector normal_of(const Search& search, const Vector& way, mp_bitcnt_t bits) const {
    Vector sum{0, 0, 0};
    for (std::size_t i = 0; i < search.corners().size(); ++i) {
      const arith::DifferenceCorner& c = search.corners()[i];
      const Vector d = difference(c.first, c.second) * (mpz_class(1) << bits) + way;
      sum = sum - d * search.weights()[i];
    }
    return sum;
  }

  [[nodiscard]] bool ends_at_origin(const Vector& normal) const {
    std::array<mpz_class, 2> end;
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t i = 0; i < sets_.points[s].size(); ++i) {
        mpz_class along = dot(normal, vector(sets_.points[s][i]));
        if (i == 0 || (s == 0 ? along > end[s] : along < end[s])) end[s] = std::move(along);
      }
    }
    return end[0] == end[1];
  }

  /// The weights make -1 / 2^bits times the pair; with that much of it they make the origin.
  static Pairs around(const WeightedPair& pair, Pairs pairs, mp_bitcnt_t bits) {
    pairs.push_back(pair);
    pairs.back().weight = exact_number(mpq_class(1, mpz_class(1) << bits));
    const Rational whole = Rational(1) + pairs.back().weight;
    for (WeightedPair& p : pairs) p.weight = p.weight / whole;
    return pairs;
  }

  Integers sets_;
};

}  // namespace

NearestDifference nearest_difference(const CoreCorners& a, const CoreCorners& b) {
  NearestDifference nearest;
  if (const auto proved = proved_nearest(a, b)) {
    nearest.pairs = weights_of(a, b, proved->corners);
  } else {
    const IntegerDifference sets = integers_of(a, b);
    nearest.pairs = pairs_of(searched(sets.difference));
  }
  for (const WeightedPair& p : nearest.pairs) {
    const Exact3 d = in_rationals(difference_of<mpq_class>(a, b, {p.of_a, p.of_b}));
    nearest.at = nearest.at + gmp_number(p.weight) * d;
  }
  nearest.square = dot(nearest.at, nearest.at);
  return nearest;
}

// Each turn adds a way to what the pairs span, so that there are three at most.
SpanOrPlane span_or_plane(const CoreCorners& a, const CoreCorners& b, std::vector<WeightedPair> pairs) {
  if (pairs.size() == 4) return {std::move(pairs), {}};  // independent and around the origin: all of space
  const AroundOrigin around(a, b);
  while (const auto beyond = around.beyond(pairs)) {
    SpanOrPlane found = around.against(*beyond);
    if (found.normal) return found;
    pairs = joined(pairs, found.pairs);
  }
  return {std::move(pairs), {}};
}

}  // namespace plumb::query
