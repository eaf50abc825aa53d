#include "plumb/query/lp/elimination.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "arith/exact_number.hpp"
#include "plumb/arith/error.hpp"
#include "query/lp/system_rows.hpp"

namespace plumb {
namespace query {
namespace {

using arith::RationalVector;

/// A row, and how often each row of the system is in it.
struct EliminationRow {
  RationalVector row;
  mpq_class limit;
  std::map<std::size_t, mpq_class> of;
};

EliminationRow sum_of_rows(const EliminationRow& a, const mpq_class& s, const EliminationRow& b, const mpq_class& t) {
  EliminationRow r{{}, s * a.limit + t * b.limit, {}};
  for (std::size_t k = 0; k < a.row.size(); ++k) r.row.emplace_back(s * a.row[k] + t * b.row[k]);
  for (const auto& [i, x] : a.of) r.of[i] += s * x;
  for (const auto& [i, x] : b.of) r.of[i] += t * x;
  return r;
}

class Elimination {
 public:
  Elimination(std::string_view function, const LinearSystem& system, const EliminationOptions& options)
      : function_(function), options_(options), dimension_(system.rows.empty() ? 0 : system.rows[0].size()) {
    const arith::Constraints c = constraints_of(function, system, dimension_);
    for (std::size_t i = 0; i < c.rows.size(); ++i) add({c.rows[i], c.limits[i], {{i, 1}}});
  }

  [[nodiscard]] std::size_t dimension() const { return dimension_; }
  [[nodiscard]] const std::vector<EliminationRow>& rows() const { return rows_; }
  /// The row 0 <= a negative number, where one has been met.
  [[nodiscard]] const std::optional<EliminationRow>& refuted() const { return refuted_; }

  /// All variables from this one on, the cheapest first.
  void eliminate_from(std::size_t first) {
    std::vector<std::size_t> left;
    for (std::size_t k = first; k < dimension_; ++k) left.push_back(k);
    while (!left.empty() && !refuted_) {
      const auto cheapest = std::ranges::min_element(left, {}, [&](std::size_t k) { return growth(k); });
      eliminate(*cheapest);
      left.erase(cheapest);
    }
  }

  /// A solution, after the elimination of all variables.
  [[nodiscard]] RationalVector solution() const {
    RationalVector x(dimension_);
    for (auto stage = stages_.rbegin(); stage != stages_.rend(); ++stage) {
      std::optional<mpq_class> least, most;
      for (const EliminationRow& r : stage->rows) {
        const mpq_class& by = r.row[stage->variable];
        if (sgn(by) == 0) continue;
        mpq_class rest = r.limit;
        for (std::size_t k = 0; k < dimension_; ++k) {
          if (k != stage->variable) rest -= r.row[k] * x[k];
        }
        rest /= by;
        if (sgn(by) > 0 && (!most || rest < *most)) most = rest;
        if (sgn(by) < 0 && (!least || rest > *least)) least = rest;
      }
      x[stage->variable] = least ? *least : most ? *most : mpq_class(0);
    }
    return x;
  }

 private:
  struct Stage {
    std::size_t variable;
    std::vector<EliminationRow> rows;  // before it went
  };

  /// How many rows more there are without it.
  [[nodiscard]] long growth(std::size_t k) const {
    long above = 0, below = 0;
    for (const EliminationRow& r : rows_) {
      above += sgn(r.row[k]) > 0 ? 1 : 0;
      below += sgn(r.row[k]) < 0 ? 1 : 0;
    }
    return above * below - above - below;
  }

  /// A multiple whose first number that is not zero is 1 or -1, where no tighter one is there.
  void add(EliminationRow r) {
    std::size_t k = 0;
    while (k < r.row.size() && sgn(r.row[k]) == 0) ++k;
    if (k == r.row.size()) {
      if (sgn(r.limit) < 0 && !refuted_) refuted_ = std::move(r);
      return;
    }
    const mpq_class by = abs(r.row[k]);
    for (mpq_class& x : r.row) x /= by;
    r.limit /= by;
    for (auto& [i, x] : r.of) x /= by;
    const auto [place, is_new] = places_.try_emplace(r.row, rows_.size());
    if (is_new) {
      rows_.push_back(std::move(r));
    } else if (r.limit < rows_[place->second].limit) {
      rows_[place->second] = std::move(r);
    }
  }

  void eliminate(std::size_t k) {
    stages_.push_back({k, std::move(rows_)});
    const std::vector<EliminationRow>& before = stages_.back().rows;
    rows_.clear(), places_.clear();
    for (const EliminationRow& a : before) {
      if (sgn(a.row[k]) == 0) add(a);
      if (sgn(a.row[k]) <= 0) continue;
      for (const EliminationRow& b : before) {
        if (sgn(b.row[k]) >= 0) continue;
        add(sum_of_rows(a, -b.row[k], b, a.row[k]));
        if (refuted_) return;
        if (rows_.size() > options_.most_rows)
          throw Error(std::string(function_) + ": without variable " + std::to_string(k) + " there are more than " +
                      std::to_string(options_.most_rows) + " rows; options.most_rows may be more");
      }
    }
    if (options_.without_redundant) drop_redundant();
  }

  void drop_redundant() {
    for (std::size_t i = rows_.size(); i-- > 0;) {
      arith::Constraints others;
      for (std::size_t j = 0; j < rows_.size(); ++j) {
        if (j != i) others.add(rows_[j].row, rows_[j].limit);
      }
      const arith::Optimum most = arith::maximize(rows_[i].row, others);
      if (most.kind == arith::Optimum::Kind::optimal && arith::dot(rows_[i].row, most.at) <= rows_[i].limit)
        rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    places_.clear();
    for (std::size_t i = 0; i < rows_.size(); ++i) places_[rows_[i].row] = i;
  }

  std::string_view function_;
  EliminationOptions options_;
  std::size_t dimension_;
  std::vector<EliminationRow> rows_;
  std::map<RationalVector, std::size_t> places_;
  std::optional<EliminationRow> refuted_;
  std::vector<Stage> stages_;
};

}  // namespace
}  // namespace query

LinearProof solve_by_elimination(const LinearSystem& system, const EliminationOptions& options) {
  query::Elimination e("solve_by_elimination", system, options);
  e.eliminate_from(0);
  if (!e.refuted()) return {LinearKind::optimal, query::to_rationals(e.solution()), {}, {}};
  LinearProof proof{LinearKind::infeasible, {}, {}, {}};
  for (const auto& [i, weight] : e.refuted()->of) proof.weights.push_back({i, exact_number(weight)});
  return proof;
}

LinearSystem project(const LinearSystem& system, std::size_t dimension, const EliminationOptions& options) {
  query::Elimination e("project", system, options);
  if (!system.rows.empty() && dimension > e.dimension())
    throw InvalidShape("project: dimension " + std::to_string(dimension) + " is more than the " +
                       std::to_string(e.dimension()) + " variables that the rows have");
  e.eliminate_from(dimension);
  LinearSystem shadow;
  if (e.refuted()) {
    shadow.add(std::vector<Rational>(dimension), exact_number(e.refuted()->limit));
    return shadow;
  }
  for (const auto& r : e.rows())
    shadow.add(query::to_rationals(std::span(r.row).first(dimension)), exact_number(r.limit));
  return shadow;
}

}  // namespace plumb
