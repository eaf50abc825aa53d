#include "arith/rational_lp.hpp"

#include <limits>

namespace plumb::arith {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr int steep_pivots = 64;  // by the largest violation; then by the smallest index

// min limits . y with sum of y_j rows_j = objective, y >= 0: a basis of `dimension` columns, some of them artificial.
class Dual {
 public:
  Dual(const RationalVector& objective, const Constraints& constraints)
      : constraints_(constraints), size_(objective.size()), basis_(size_, none), value_(size_), inverse_(size_) {
    for (std::size_t i = 0; i < size_; ++i) {
      inverse_[i].resize(size_);
      inverse_[i][i] = sgn(objective[i]) < 0 ? -1 : 1;
      value_[i] = abs(objective[i]);
    }
  }

  Optimum solve() {
    phase_ = 1;
    run();
    for (std::size_t k = 0; k < size_; ++k) {
      if (basis_[k] == none && sgn(value_[k]) != 0)
        return {
            Optimum::Kind::unbounded, {}, {}, {}, multipliers()};  // at most zero on rows, above it on the objective
    }
    phase_ = 2;
    if (!run()) return {Optimum::Kind::infeasible, {}, std::move(refuting_), std::move(refutation_)};
    Optimum result{Optimum::Kind::optimal, multipliers(), {}};
    for (std::size_t k = 0; k < size_; ++k) {
      if (basis_[k] == none || sgn(value_[k]) <= 0) continue;
      result.deciding.push_back(basis_[k]);
      result.weights.push_back(value_[k]);
    }
    return result;
  }

 private:
  [[nodiscard]] mpq_class cost(std::size_t column) const {
    if (column == none) return phase_ == 1 ? 1 : 0;
    return phase_ == 1 ? mpq_class(0) : constraints_.limits[column];
  }

  [[nodiscard]] RationalVector multipliers() const {
    RationalVector x(size_);
    for (std::size_t k = 0; k < size_; ++k) {
      const mpq_class c = cost(basis_[k]);
      if (sgn(c) == 0) continue;
      for (std::size_t i = 0; i < size_; ++i) x[i] += c * inverse_[k][i];
    }
    return x;
  }

  // A column of negative reduced cost: a constraint that the multipliers violate.
  [[nodiscard]] std::size_t entering(const RationalVector& x, bool steep) const {
    std::size_t best = none;
    double most = 0;
    for (std::size_t j = 0; j < constraints_.rows.size(); ++j) {
      const mpq_class violation = dot(x, constraints_.rows[j]) - cost(j);
      if (sgn(violation) <= 0) continue;
      if (!steep) return j;
      const double size = violation.get_d();
      if (best == none || size > most) best = j, most = size;
    }
    return best;
  }

  // An artificial column at zero leaves before all others, so that it stays there.
  [[nodiscard]] std::size_t leaving(const RationalVector& step) const {
    std::size_t best = none;
    mpq_class least;
    for (std::size_t k = 0; k < size_; ++k) {
      if (phase_ == 2 && basis_[k] == none && sgn(step[k]) != 0) return k;
      if (sgn(step[k]) <= 0) continue;
      mpq_class ratio = value_[k] / step[k];
      const int order = best == none ? -1 : cmp(ratio, least);
      if (order < 0 || (order == 0 && basis_[k] < basis_[best])) {
        best = k;
        least = std::move(ratio);
      }
    }
    return best;
  }

  // Ends, for after the steep pivots they follow Bland's rule, with which no basis comes twice (Bland 1977); artificial
  // columns never come back.
  bool run() {
    for (int pivots = 0;; ++pivots) {
      const std::size_t in = entering(multipliers(), pivots < steep_pivots);
      if (in == none) return true;
      RationalVector step(size_);
      for (std::size_t k = 0; k < size_; ++k) step[k] = dot(inverse_[k], constraints_.rows[in]);
      const std::size_t out = leaving(step);
      if (out == none) {
        refute(in, step);
        return false;
      }
      value_[out] /= step[out];
      for (mpq_class& x : inverse_[out]) x /= step[out];
      for (std::size_t k = 0; k < size_; ++k) {
        if (k == out || sgn(step[k]) == 0) continue;
        value_[k] -= step[k] * value_[out];
        for (std::size_t i = 0; i < size_; ++i) inverse_[k][i] -= step[k] * inverse_[out][i];
      }
      basis_[out] = in;
    }
  }

  // The row that came in is a sum of those in the basis with weights at most zero, its limit less than theirs.
  void refute(std::size_t in, const RationalVector& step) {
    refuting_ = {in};
    refutation_ = {1};
    for (std::size_t k = 0; k < size_; ++k) {
      if (sgn(step[k]) == 0) continue;
      refuting_.push_back(basis_[k]);
      refutation_.push_back(-step[k]);
    }
  }

  const Constraints& constraints_;
  std::size_t size_;
  std::vector<std::size_t> refuting_;
  RationalVector refutation_;
  std::vector<std::size_t> basis_;
  RationalVector value_;
  std::vector<RationalVector> inverse_;
  int phase_ = 1;
};

}  // namespace

mpq_class dot(const RationalVector& a, const RationalVector& b) {
  mpq_class sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (sgn(a[i]) != 0 && sgn(b[i]) != 0) sum += a[i] * b[i];
  }
  return sum;
}

Optimum maximize(const RationalVector& objective, const Constraints& constraints) {
  return Dual(objective, constraints).solve();
}

// The greatest slack up to 1 that those of `strictly` can have at once, as one more variable.
Feasible feasible(const Constraints& constraints, const std::vector<bool>& strictly) {
  const std::size_t dimension = constraints.rows.empty() ? 0 : constraints.rows[0].size();
  Constraints with_slack;
  for (std::size_t i = 0; i < constraints.rows.size(); ++i) {
    RationalVector row = constraints.rows[i];
    row.emplace_back(strictly[i] ? 1 : 0);
    with_slack.add(std::move(row), constraints.limits[i]);
  }
  RationalVector slack(dimension + 1);
  slack.back() = 1;
  with_slack.add(slack, 1);
  Optimum best = maximize(slack, with_slack);
  if (best.kind != Optimum::Kind::optimal) return {-1, {}, {}};
  const int sign = sgn(best.at.back());
  best.at.pop_back();
  std::erase_if(best.deciding, [&](std::size_t i) { return i >= strictly.size() || !strictly[i]; });
  return {sign, std::move(best.at), std::move(best.deciding)};
}

}  // namespace plumb::arith
