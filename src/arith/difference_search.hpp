// GJK, Minkowski difference: which point of the difference of two convex sets is nearest to the origin?  One search, in
// doubles and in integers.
//
// A corner of the difference is a point of one set minus a point of the other, or a direction of either.  The corners
// held are independent, and the point is a sum of them whose weights, over a common whole, are positive.
// Laws: (1) in integers each step is exact and ends nearer than the one before, so the search ends, and `square` over
// the square of `whole` is the square of the distance.  (2) In doubles it is a guess of corners, which proves nothing.
// Source: Wolfe 1976, "Finding the nearest point in a polytope"; Bareiss 1968 (elimination without fractions).
// Cost: a step some 100 products, and one with every point.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace plumb::arith {

template <class T>
using Triplet = std::array<T, 3>;

inline mpz_class dot(const Triplet<mpz_class>& u, const Triplet<mpz_class>& v) {
  mpz_class sum = u[0] * v[0];
  for (std::size_t k = 1; k < 3; ++k) mpz_addmul(sum.get_mpz_t(), u[k].get_mpz_t(), v[k].get_mpz_t());
  return sum;
}
inline double dot(const Triplet<double>& u, const Triplet<double>& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <class T>
Triplet<T> minus(const Triplet<T>& u, const Triplet<T>& v) {
  return {T(u[0] - v[0]), T(u[1] - v[1]), T(u[2] - v[2])};
}

/// (a b - c d) / e, which leaves no rest.
inline mpz_class crossed(const mpz_class& a, const mpz_class& b, const mpz_class& c, const mpz_class& d,
                         const mpz_class& e) {
  mpz_class r = a * b;
  mpz_submul(r.get_mpz_t(), c.get_mpz_t(), d.get_mpz_t());
  mpz_divexact(r.get_mpz_t(), r.get_mpz_t(), e.get_mpz_t());
  return r;
}
inline double crossed(double a, double b, double c, double d, double e) { return (a * b - c * d) / e; }

/// The weights and their whole in smaller numbers.
inline void reduce(std::vector<mpz_class>& weights, mpz_class& whole) {
  mpz_class all = whole;
  for (const mpz_class& w : weights) all = gcd(all, w);
  if (all == 1) return;
  for (mpz_class& w : weights) mpz_divexact(w.get_mpz_t(), w.get_mpz_t(), all.get_mpz_t());
  mpz_divexact(whole.get_mpz_t(), whole.get_mpz_t(), all.get_mpz_t());
}
inline void reduce(std::vector<double>& weights, double& whole) {
  for (double& w : weights) w /= whole;
  whole = 1;
}

/// Points of either set, and the directions of the first with those of the second turned round.
template <class T>
struct Difference {
  std::array<std::vector<Triplet<T>>, 2> points;
  std::vector<Triplet<T>> directions;
};

/// The difference of two points by their numbers, or a direction by its number.
struct DifferenceCorner {
  bool is_point;
  std::size_t first, second;
  friend bool operator==(const DifferenceCorner&, const DifferenceCorner&) = default;
};

template <class T>
class DifferenceSearch {
 public:
  /// From any corners; those that are dependent, or of which none is a point, serve no better than none.
  DifferenceSearch(const Difference<T>& sets, const std::vector<DifferenceCorner>& start) : sets_(sets) {
    begin(start);
    if (whole_ == 0 || (start.size() > 1 && !approach())) begin({{true, 0, 0}});
  }

  /// Is there a nearer point, to which it has moved?
  bool step() {
    Triplet<T> x{T(0), T(0), T(0)};
    for (std::size_t i = 0; i < at_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) x[k] += weights_[i] * at_[i][k];
    }
    square_ = dot(x, x);
    if (square_ == 0) return false;
    const std::optional<DifferenceCorner> next = nearer(x);
    if (!next || std::ranges::find(corners_, *next) != corners_.end()) return false;
    add(*next);
    return approach();
  }

  [[nodiscard]] const std::vector<DifferenceCorner>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<T>& weights() const { return weights_; }
  [[nodiscard]] const T& square() const { return square_; }  // as the last step found it
  [[nodiscard]] const T& whole() const { return whole_; }

 private:
  void begin(const std::vector<DifferenceCorner>& start) {
    corners_.clear(), at_.clear(), weights_.clear();
    whole_ = 0;
    for (const DifferenceCorner& c : start) {
      add(c);
      weights_.back() = 1;
      if (c.is_point) whole_ += 1;
    }
  }

  void add(const DifferenceCorner& c) {
    corners_.push_back(c);
    at_.push_back(c.is_point ? minus(sets_.points[0][c.first], sets_.points[1][c.second]) : sets_.directions[c.first]);
    weights_.emplace_back(0);
  }

  /// The direction that leads nearer than x / whole, or the point least along it where that does.
  std::optional<DifferenceCorner> nearer(const Triplet<T>& x) const {
    for (std::size_t i = 0; i < sets_.directions.size(); ++i) {
      if (dot(x, sets_.directions[i]) < 0) return DifferenceCorner{false, i, 0};
    }
    std::array<std::size_t, 2> best{};
    std::array<T, 2> end{};
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t i = 0; i < sets_.points[s].size(); ++i) {
        T along = dot(x, sets_.points[s][i]);
        if (i > 0 && (s == 0 ? along >= end[s] : along <= end[s])) continue;
        best[s] = i;
        end[s] = std::move(along);
      }
    }
    if (T(end[0] - end[1]) * whole_ >= square_) return {};
    return DifferenceCorner{true, best[0], best[1]};
  }

  /// The weights, of any sign, of the point nearest to the origin in the affine hull of the corners: with d_i from the
  /// first point f to the other points, and the directions, the sum of c_j d_i . d_j is -d_i . f.  False where the
  /// corners are dependent.
  bool affine_weights(std::vector<T>& goal, T& whole) const {
    std::size_t first = 0;
    while (first < corners_.size() && !corners_[first].is_point) ++first;
    if (first == corners_.size()) return false;
    std::vector<Triplet<T>> d;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      if (i != first) d.push_back(corners_[i].is_point ? minus(at_[i], at_[first]) : at_[i]);
    }
    const std::size_t n = d.size();
    std::vector<std::vector<T>> rows(n, std::vector<T>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < n; ++j) rows[i][j] = rows[j][i] = dot(d[i], d[j]);
      rows[i][n] = -dot(d[i], at_[first]);
    }
    whole = 1;
    for (std::size_t k = 0; k < n; ++k) {  // a Gram matrix of independent vectors needs no other pivots
      const T pivot = rows[k][k];
      if (!(pivot > 0)) return false;
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k) continue;
        for (std::size_t j = k + 1; j <= n; ++j) rows[i][j] = crossed(pivot, rows[i][j], rows[i][k], rows[k][j], whole);
      }
      whole = pivot;
    }
    goal.assign(at_.size(), T(0));
    goal[first] = whole;
    for (std::size_t i = 0, k = 0; i < at_.size(); ++i) {
      if (i == first) continue;
      goal[i] = rows[k++][n];
      if (corners_[i].is_point) goal[first] -= goal[i];
    }
    return true;
  }

  /// Moves to the nearest point of the corners' hull, and drops the corners that it does without: at least one a turn
  /// but for the last, so that it ends, also in doubles.
  bool approach() {
    for (;;) {
      std::vector<T> goal;
      T goal_whole{};
      if (!affine_weights(goal, goal_whole)) return false;
      // As far as the first weight to vanish lets it, which is numerator / denominator of the way.
      std::size_t vanishing = goal.size();
      T numerator{}, denominator{};
      for (std::size_t i = 0; i < goal.size(); ++i) {
        if (!(goal[i] < 0)) continue;
        T from = weights_[i] * goal_whole, way = from - goal[i] * whole_;
        if (vanishing != goal.size() && !(from * denominator < numerator * way)) continue;
        vanishing = i;
        numerator = std::move(from);
        denominator = std::move(way);
      }
      const bool arrives = vanishing == goal.size();
      if (arrives) {
        weights_ = std::move(goal);
        whole_ = std::move(goal_whole);
      } else {
        for (std::size_t i = 0; i < goal.size(); ++i) {
          const T from = weights_[i] * goal_whole;
          weights_[i] = from * denominator - numerator * T(from - goal[i] * whole_);
        }
        weights_[vanishing] = 0;
        whole_ *= goal_whole * denominator;
      }
      drop_weightless();
      if (corners_.empty()) return false;
      reduce(weights_, whole_);
      if (arrives) return true;
    }
  }

  void drop_weightless() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!(weights_[i] > 0)) continue;
      if (kept != i) {
        corners_[kept] = corners_[i];
        at_[kept] = std::move(at_[i]);
        weights_[kept] = std::move(weights_[i]);
      }
      ++kept;
    }
    corners_.resize(kept);
    at_.resize(kept);
    weights_.resize(kept);
  }

  const Difference<T>& sets_;
  std::vector<DifferenceCorner> corners_;
  std::vector<Triplet<T>> at_;
  std::vector<T> weights_;
  T whole_{}, square_{};
};

}  // namespace plumb::arith
