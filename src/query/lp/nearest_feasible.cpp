#include "plumb/query/lp/nearest_feasible.hpp"

#include <string>

#include "arith/exact_number.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/certify/checked.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/query/lp/linear_program.hpp"
#include "query/lp/corner.hpp"
#include "query/lp/shuffle.hpp"
#include "query/lp/system_rows.hpp"

namespace plumb {
namespace query {
namespace {

inline Numbers<2> numbers_of_point(const Point2& p) { return {p.x, p.y}; }
inline Numbers<3> numbers_of_point(const Point3& p) { return {p.x, p.y, p.z}; }

/// The number, as far as a pair of doubles has it.
Ball ball_of(const mpq_class& x) {
  const Rational r = exact_number(x);
  const double low = r.rounded(Rounding::down), high = r.rounded(Rounding::up);
  return {high, 0, low == high ? 0 : high - low};
}

template <std::size_t D>
class NearestSearch {
 public:
  using Halfspace = typename LpOf<D>::Halfspace;
  using Active = std::vector<std::size_t>;  // numbers of constraints, whose normals are independent

  NearestSearch(const Numbers<D>& from, std::span<const Halfspace> constraints)
      : from_(from.begin(), from.end()), constraints_(constraints) {
    for (std::size_t i = 0; i < constraints.size(); ++i) order_.push_back(i);
    shuffle(std::span(order_), 0);
  }

  /// Is there a point that meets all?
  bool solve() { return solve_within({}, order_.size()); }

  [[nodiscard]] const arith::RationalVector& at() const { return at_; }
  [[nodiscard]] std::vector<LinearWeight> weights() const {
    std::vector<LinearWeight> r;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (sgn(weights_[i]) != 0) r.push_back({active_[i], exact_number(weights_[i])});
    }
    return r;
  }

 private:
  [[nodiscard]] arith::RationalVector normal(std::size_t i) const {
    const Numbers<D> n = numbers_of(constraints_[i].normal);
    return {n.begin(), n.end()};
  }

  /// The nearest point of those that meet the active constraints with equality, and the first `count` of the order.
  bool solve_within(const Active& active, std::size_t count) {
    move(active);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = order_[k];
      if (side(next) != Sign::positive) continue;
      Active more = active;
      more.push_back(next);
      if (!is_independent(more) || !solve_within(more, k)) return false;
    }
    return true;
  }

  [[nodiscard]] Sign side(std::size_t i) const {
    const Numbers<D> n = numbers_of(constraints_[i].normal);
    Ball value = Ball(0.0) - Ball(constraints_[i].offset);
    for (std::size_t k = 0; k < D; ++k) value = value + Ball(n[k]) * near_[k];
    const Unsure<Sign> quick = value.sign();
    if (quick.certain()) return quick.value();
    const mpq_class exact = arith::dot(normal(i), at_) - constraints_[i].offset;
    return sign_of_number(sgn(exact));
  }

  /// The normals' products with one another, which are singular where they are dependent.
  [[nodiscard]] std::vector<arith::RationalVector> products(const Active& active) const {
    std::vector<arith::RationalVector> rows(active.size(), arith::RationalVector(active.size()));
    for (std::size_t i = 0; i < active.size(); ++i) {
      for (std::size_t j = 0; j < active.size(); ++j) rows[i][j] = arith::dot(normal(active[i]), normal(active[j]));
    }
    return rows;
  }
  /// By elimination, in which a Gram matrix of independent vectors needs no pivots but those of the diagonal.
  static bool solve_rows(std::vector<arith::RationalVector>& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const mpq_class pivot = rows[k][k];
      if (sgn(pivot) == 0) return false;
      for (mpq_class& x : rows[k]) x /= pivot;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == k || sgn(rows[i][k]) == 0) continue;
        const mpq_class by = rows[i][k];
        for (std::size_t j = 0; j < rows[i].size(); ++j) rows[i][j] -= by * rows[k][j];
      }
    }
    return true;
  }
  [[nodiscard]] bool is_independent(const Active& active) const {
    std::vector<arith::RationalVector> rows = products(active);
    return active.size() <= D && solve_rows(rows);
  }

  /// To the nearest point of those that meet the active constraints with equality: from less the sum of their normals
  /// with weights.
  void move(const Active& active) {
    active_ = active;
    at_ = from_;
    std::vector<arith::RationalVector> rows = products(active);
    for (std::size_t i = 0; i < active.size(); ++i)
      rows[i].push_back(arith::dot(normal(active[i]), from_) - constraints_[active[i]].offset);
    solve_rows(rows);
    weights_.clear();
    for (std::size_t i = 0; i < active.size(); ++i) {
      weights_.push_back(rows[i].back());
      const arith::RationalVector n = normal(active[i]);
      for (std::size_t k = 0; k < D; ++k) at_[k] -= weights_[i] * n[k];
    }
    near_.clear();
    for (const mpq_class& x : at_) near_.push_back(ball_of(x));
  }

  arith::RationalVector from_;
  std::span<const Halfspace> constraints_;
  std::vector<std::size_t> order_;
  Active active_;
  arith::RationalVector weights_, at_;
  std::vector<Ball> near_;
};

template <std::size_t D, class Answer, class Point>
Answer nearest_feasible(const Point& p, std::span<const typename LpOf<D>::Halfspace> constraints) {
  assert_sound_thread();
  const Numbers<D> from = numbers_of_point(p);
  for (const double x : from) {
    if (!(x - x == 0)) figure::refuse_number("nearest_feasible", "p", from);
  }
  for (std::size_t i = 0; i < constraints.size(); ++i)
    figure::require_sound("nearest_feasible", "constraints[" + std::to_string(i) + "]", constraints[i]);
  NearestSearch<D> search(from, constraints);
  Answer answer;
  if (!search.solve()) {
    answer.kind = LinearKind::infeasible;
    answer.proof = proof_of(maximize(typename LpOf<D>::Vector{}, constraints));
    return answer;
  }
  answer.proof = {LinearKind::optimal, to_rationals(search.at()), search.weights(), {}};
  mpq_class square = 0;
  Numbers<D> at{};
  for (std::size_t k = 0; k < D; ++k) {
    const mpq_class way = search.at()[k] - mpq_class(from[k]);
    square += way * way;
    at[k] = answer.proof.point[k].rounded();
  }
  if constexpr (D == 2) {
    answer.at = {at[0], at[1]};
  } else {
    answer.at = {at[0], at[1], at[2]};
  }
  answer.exact_distance.square = exact_number(square);
  answer.distance = rounded_root(Rounding::nearest, answer.exact_distance.square);
  return answer;
}

}  // namespace
}  // namespace query

NearestFeasible2 nearest_feasible(const Point2& p, std::span<const Halfspace2> constraints) {
  return query::nearest_feasible<2, NearestFeasible2>(p, constraints);
}
NearestFeasible3 nearest_feasible(const Point3& p, std::span<const Halfspace3> constraints) {
  return query::nearest_feasible<3, NearestFeasible3>(p, constraints);
}

}  // namespace plumb
