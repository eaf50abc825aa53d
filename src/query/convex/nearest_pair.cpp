#include "query/convex/nearest_pair.hpp"

#include <array>

#include "arith/rational_lp.hpp"
#include "query/convex/integer_difference.hpp"

namespace plumb::query {
namespace {

using Integers3 = arith::Triplet<mpz_class>;

void add_times(Integers3& sum, const mpz_class& weight, const Integers3& v) {
  for (std::size_t k = 0; k < 3; ++k) mpz_addmul(sum[k].get_mpz_t(), weight.get_mpz_t(), v[k].get_mpz_t());
}

/// Integers over a whole and the scale of the sets.
Exact3 place(const Integers3& at, const mpz_class& whole, const IntegerDifference& sets) {
  Exact3 r;
  const mpz_class all = whole * sets.scale;
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = mpq_class(at[k], all);
    r[k].canonicalize();
  }
  return r + sets.origin;
}

/// Of a pair, integers over `whole`.
struct NearPair {
  Integers3 on_a{0, 0, 0}, on_b{0, 0, 0};
  mpz_class whole, square;
};

NearPair any_pair(const IntegerDifference& sets) {
  arith::DifferenceSearch<mpz_class> search(sets.difference, guessed_corners(sets.difference));
  while (search.step()) {
  }
  NearPair pair;
  for (std::size_t i = 0; i < search.corners().size(); ++i) {
    const arith::DifferenceCorner& c = search.corners()[i];
    const mpz_class& weight = search.weights()[i];
    if (c.is_point) {
      add_times(pair.on_a, weight, sets.difference.points[0][c.first]);
      add_times(pair.on_b, weight, sets.difference.points[1][c.second]);
    } else if (c.first < sets.directions_of_a) {
      add_times(pair.on_a, weight, sets.difference.directions[c.first]);
    } else {
      add_times(pair.on_b, -weight, sets.difference.directions[c.first]);
    }
  }
  pair.whole = search.whole(), pair.square = search.square();
  return pair;
}

/// Those points and directions of either set that a nearest pair can be sums of: the farthest ones towards the other.
class NearFaces {
 public:
  NearFaces(const IntegerDifference& sets, const NearPair& pair)
      : sets_(sets), whole_(pair.whole), apart_(arith::minus(pair.on_a, pair.on_b)) {
    for (std::size_t s = 0; s < 2; ++s) {
      const auto& points = sets.difference.points[s];
      const mpz_class most = arith::dot(apart_, s == 0 ? pair.on_a : pair.on_b);  // over the whole
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (arith::dot(apart_, points[i]) * whole_ == most) points_[s].push_back(i);
      }
    }
    for (std::size_t i = 0; i < sets.difference.directions.size(); ++i) {
      if (arith::dot(apart_, sets.difference.directions[i]) == 0)
        directions_[i < sets.directions_of_a ? 0 : 1].push_back(i);
    }
  }

  [[nodiscard]] bool is_one_pair() const {
    const auto is_point = [&](std::size_t s) { return points_[s].size() == 1 && directions_[s].empty(); };
    return is_point(0) || is_point(1);
  }

  /// The first point of `a` that has a nearest one.  Nothing where none comes first.
  [[nodiscard]] std::optional<Exact3> first_point() const {
    // Weights: of the points of each set one in all, and what they span of a, less that of b, is what is apart.
    std::vector<arith::RationalVector> rows;
    std::array<arith::RationalVector, 3> coordinates;
    for (std::size_t s = 0; s < 2; ++s) {
      const auto add = [&](const Integers3& v, int way, bool is_point) {
        arith::RationalVector row(5);
        for (std::size_t k = 0; k < 3; ++k) {
          row[k] = way * v[k];
          coordinates[k].push_back(s == 0 ? mpq_class(v[k]) : mpq_class(0));
        }
        if (is_point) row[3 + s] = 1;
        rows.push_back(std::move(row));
      };
      for (const std::size_t i : points_[s]) add(sets_.difference.points[s][i], s == 0 ? 1 : -1, true);
      for (const std::size_t i : directions_[s]) add(sets_.difference.directions[i], 1, false);
    }
    const arith::RationalVector sums{apart_[0], apart_[1], apart_[2], whole_, whole_};
    const auto least = arith::least_in_turn(sums, rows, coordinates);
    if (!least) return {};
    Exact3 first;
    for (std::size_t k = 0; k < 3; ++k) first[k] = (*least)[k] / (whole_ * sets_.scale) + sets_.origin[k];
    return first;
  }

 private:
  const IntegerDifference& sets_;
  mpz_class whole_;
  Integers3 apart_;  // over the whole
  std::array<std::vector<std::size_t>, 2> points_, directions_;
};

}  // namespace

std::optional<NearestPair> nearest_pair(const FlatSet& a, const FlatSet& b, WhichPair which) {
  if (a.points.empty() || b.points.empty()) return {};
  const IntegerDifference sets = in_integers(a, b);
  const NearPair any = any_pair(sets);
  const mpz_class all = any.whole * sets.scale;
  NearestPair pair{place(any.on_a, any.whole, sets), place(any.on_b, any.whole, sets), {any.square, all * all}};
  pair.square.canonicalize();
  if (which == WhichPair::any) return pair;
  const NearFaces faces(sets, any);
  if (faces.is_one_pair()) return pair;
  auto first = faces.first_point();
  if (!first) {
    pair.is_first = false;
    return pair;
  }
  pair.on_b = *first - (pair.on_a - pair.on_b);
  pair.on_a = std::move(*first);
  return pair;
}

}  // namespace plumb::query
