#include "arith/rational_lp.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace plumb::arith {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr int steep_pivots = 64;  // by the largest violation; then by the smallest index

using Integers = std::vector<mpz_class>;

mpz_class dot(const Integers& a, const Integers& b) {
  mpz_class sum;
  for (std::size_t i = 0; i < a.size(); ++i) mpz_addmul(sum.get_mpz_t(), a[i].get_mpz_t(), b[i].get_mpz_t());
  return sum;
}

/// The least number above zero that makes integers of them.
mpz_class denominator_of(const RationalVector& all) {
  mpz_class r = 1;
  for (const mpq_class& x : all) {
    if (x.get_den() != 1) mpz_lcm(r.get_mpz_t(), r.get_mpz_t(), x.get_den_mpz_t());
  }
  return r;
}

/// A number times that, which is a multiple of its denominator.
mpz_class times(const mpq_class& x, const mpz_class& scale) {
  mpz_class r = scale;
  if (x.get_den() != 1) mpz_divexact(r.get_mpz_t(), r.get_mpz_t(), x.get_den_mpz_t());
  return r *= x.get_num();
}
Integers times(const RationalVector& all, const mpz_class& scale) {
  Integers r;
  r.reserve(all.size());
  for (const mpq_class& x : all) r.push_back(times(x, scale));
  return r;
}

/// About a number above zero: for comparisons of any size.
struct Size {
  long exponent;
  double digits;  // of [1/2, 1)

  static Size of(const mpz_class& x) {
    Size s{};
    s.digits = mpz_get_d_2exp(&s.exponent, x.get_mpz_t());
    return s;
  }
  friend Size operator/(const Size& a, const Size& b) {
    int carry = 0;
    const double quotient = std::frexp(a.digits / b.digits, &carry);
    return {a.exponent - b.exponent + carry, quotient};
  }
  friend auto operator<=>(const Size&, const Size&) = default;
};

mpq_class quotient(const mpz_class& a, const mpz_class& b) {
  mpq_class r(a, b);
  r.canonicalize();
  return r;
}

// min limits . y with sum of y_j rows_j = objective, y >= 0: a basis of `dimension` columns, some of them artificial.
// A column is a row times a factor that makes it integers.  Inverse and values are integers over the determinant of the
// basis, which every pivot divides without rest.
class Dual {
 public:
  Dual(const RationalVector& objective, const std::vector<RationalVector>& rows)
      : objective_scale_(denominator_of(objective)),
        size_(objective.size()),
        barred_(rows.size(), false),
        basis_(size_, none),
        inverse_(size_, Integers(size_)) {
    value_ = times(objective, objective_scale_);
    for (std::size_t i = 0; i < size_; ++i) {
      inverse_[i][i] = sgn(value_[i]) < 0 ? -1 : 1;
      value_[i] = abs(value_[i]);
    }
    columns_.reserve(rows.size());
    for (const RationalVector& row : rows) {
      const mpz_class scale = denominator_of(row);
      columns_.push_back({times(row, scale), scale, Size::of(scale)});
    }
  }

  /// Is there any y?
  bool begin() {
    run();
    for (std::size_t k = 0; k < size_; ++k) {
      if (basis_[k] == none && sgn(value_[k]) != 0) return false;
    }
    return true;
  }

  /// Has limits . y a least value?  Takes y there.
  bool lessen(const RationalVector& limits) {
    begun_ = true;
    cost_scale_ = denominator_of(limits);
    costs_ = times(limits, cost_scale_);
    for (std::size_t j = 0; j < costs_.size(); ++j) costs_[j] *= columns_[j].scale;
    return run();
  }

  /// Of y only what leaves limits . y as it is may be above zero from now on.
  void keep() {
    const Integers x = multipliers();
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (!barred_[j] && dot(x, columns_[j].row) != costs_[j] * determinant_) barred_[j] = true;
    }
  }

  [[nodiscard]] RationalVector point() const {
    const mpz_class whole = determinant_ * cost_scale_;
    RationalVector r;
    for (const mpz_class& x : multipliers()) r.push_back(quotient(x, whole));
    return r;
  }

  [[nodiscard]] mpq_class least() const {
    mpz_class sum;
    for (std::size_t k = 0; k < size_; ++k) {
      if (basis_[k] != none) sum += costs_[basis_[k]] * value_[k];
    }
    return quotient(sum, determinant_ * cost_scale_ * objective_scale_);
  }

  /// Where y is above zero, and how much.
  void tell_weights(std::vector<std::size_t>& deciding, RationalVector& weights) const {
    const mpz_class whole = determinant_ * objective_scale_;
    for (std::size_t k = 0; k < size_; ++k) {
      if (basis_[k] == none || sgn(value_[k]) <= 0) continue;
      deciding.push_back(basis_[k]);
      weights.push_back(quotient(value_[k] * columns_[basis_[k]].scale, whole));
    }
  }

  /// After a lessen() without end: the row that came in is a sum of those in the basis with weights at most zero, its
  /// limit less than theirs.
  void tell_refuting(std::vector<std::size_t>& refuting, RationalVector& weights) const {
    const Column& in = columns_[endless_];
    refuting = {endless_}, weights = {1};
    for (std::size_t k = 0; k < size_; ++k) {
      const mpz_class step = dot(inverse_[k], in.row);
      if (sgn(step) == 0) continue;
      refuting.push_back(basis_[k]);
      weights.push_back(quotient(-step * columns_[basis_[k]].scale, determinant_ * in.scale));
    }
  }

 private:
  struct Column {
    Integers row;
    mpz_class scale;
    Size size_of_scale;
  };

  // Over the determinant.
  [[nodiscard]] Integers multipliers() const {
    Integers x(size_);
    for (std::size_t k = 0; k < size_; ++k) {
      const bool artificial = basis_[k] == none;
      if (artificial == begun_) continue;
      for (std::size_t i = 0; i < size_; ++i) {
        if (artificial) {
          x[i] += inverse_[k][i];
        } else {
          mpz_addmul(x[i].get_mpz_t(), costs_[basis_[k]].get_mpz_t(), inverse_[k][i].get_mpz_t());
        }
      }
    }
    return x;
  }

  // A column of negative reduced cost: a constraint that the multipliers violate.
  [[nodiscard]] std::size_t entering(const Integers& x, bool steep) const {
    std::size_t best = none;
    Size most{};
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (barred_[j]) continue;
      mpz_class violation = dot(x, columns_[j].row);
      if (begun_) mpz_submul(violation.get_mpz_t(), costs_[j].get_mpz_t(), determinant_.get_mpz_t());
      if (sgn(violation) <= 0) continue;
      if (!steep) return j;
      const Size size = Size::of(violation) / columns_[j].size_of_scale;
      if (best == none || size > most) best = j, most = size;
    }
    return best;
  }

  // An artificial column at zero leaves before all others, so that it stays there.
  [[nodiscard]] std::size_t leaving(const Integers& step) const {
    std::size_t best = none;
    for (std::size_t k = 0; k < size_; ++k) {
      if (begun_ && basis_[k] == none && sgn(step[k]) != 0) return k;
      if (sgn(step[k]) <= 0) continue;
      const int order = best == none ? -1 : cmp(value_[k] * step[best], value_[best] * step[k]);
      if (order < 0 || (order == 0 && basis_[k] < basis_[best])) best = k;
    }
    return best;
  }

  // Ends, for after the steep pivots they follow Bland's rule, with which no basis comes twice (Bland 1977); artificial
  // columns never come back.
  bool run() {
    for (int pivots = 0;; ++pivots) {
      const std::size_t in = entering(multipliers(), pivots < steep_pivots);
      if (in == none) return true;
      Integers step(size_);
      for (std::size_t k = 0; k < size_; ++k) step[k] = dot(inverse_[k], columns_[in].row);
      const std::size_t out = leaving(step);
      if (out == none) {
        endless_ = in;
        return false;
      }
      pivot(out, step);
      basis_[out] = in;
    }
  }

  void pivot(std::size_t out, const Integers& step) {
    const auto replace = [&](mpz_class& x, const mpz_class& of_out, const mpz_class& share) {
      x *= step[out];
      mpz_submul(x.get_mpz_t(), share.get_mpz_t(), of_out.get_mpz_t());
      mpz_divexact(x.get_mpz_t(), x.get_mpz_t(), determinant_.get_mpz_t());
    };
    for (std::size_t k = 0; k < size_; ++k) {
      if (k == out) continue;
      replace(value_[k], value_[out], step[k]);
      for (std::size_t i = 0; i < size_; ++i) replace(inverse_[k][i], inverse_[out][i], step[k]);
    }
    determinant_ = step[out];
    if (sgn(determinant_) > 0) return;
    determinant_ = -determinant_;
    for (std::size_t k = 0; k < size_; ++k) {
      value_[k] = -value_[k];
      for (mpz_class& x : inverse_[k]) x = -x;
    }
  }

  mpz_class objective_scale_, cost_scale_ = 1;
  std::size_t size_;
  std::vector<Column> columns_;
  Integers costs_;  // over their scale, times those of the columns
  std::vector<bool> barred_;
  std::vector<std::size_t> basis_;
  mpz_class determinant_ = 1;  // above zero
  Integers value_;             // over the determinant and the scale of the objective
  std::vector<Integers> inverse_;
  std::size_t endless_ = none;
  bool begun_ = false;  // until then artificial columns cost one, and afterwards nothing
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
  Dual dual(objective, constraints.rows);
  if (!dual.begin())
    return {Optimum::Kind::unbounded, {}, {}, {}, dual.point()};  // at most zero on rows, above it on the objective
  Optimum result{Optimum::Kind::infeasible, {}, {}};
  if (dual.lessen(constraints.limits)) {
    result.kind = Optimum::Kind::optimal;
    result.at = dual.point();
    dual.tell_weights(result.deciding, result.weights);
  } else {
    dual.tell_refuting(result.deciding, result.weights);
  }
  return result;
}

std::optional<RationalVector> least_in_turn(const RationalVector& objective, const std::vector<RationalVector>& rows,
                                            std::span<const RationalVector> limits) {
  Dual dual(objective, rows);
  if (!dual.begin()) return {};
  RationalVector least;
  for (const RationalVector& l : limits) {
    if (!dual.lessen(l)) return {};
    least.push_back(dual.least());
    dual.keep();
  }
  return least;
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
