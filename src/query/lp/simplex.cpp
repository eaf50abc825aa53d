#include "plumb/query/lp/simplex.hpp"

#include "arith/exact_number.hpp"
#include "query/lp/system_rows.hpp"

namespace plumb {
namespace query {
namespace {

using SimplexKind = arith::Optimum::Kind;

LinearProof told(LinearKind kind, const arith::Optimum& optimum) {
  LinearProof proof{kind, to_rationals(optimum.at), {}, {}};
  for (std::size_t i = 0; i < optimum.deciding.size(); ++i)
    proof.weights.push_back({optimum.deciding[i], exact_number(optimum.weights[i])});
  return proof;
}

}  // namespace
}  // namespace query

LinearProof maximize(std::span<const Rational> objective, const LinearSystem& system) {
  const arith::Constraints constraints = query::constraints_of("maximize", system, objective.size());
  const arith::Optimum best = arith::maximize(query::to_mpq(objective), constraints);
  if (best.kind == query::SimplexKind::optimal) return query::told(LinearKind::optimal, best);
  if (best.kind == query::SimplexKind::infeasible) return query::told(LinearKind::infeasible, best);
  // Its dual is infeasible, which leaves open whether it is so itself.
  const arith::Optimum any = arith::maximize(arith::RationalVector(objective.size()), constraints);
  if (any.kind != query::SimplexKind::optimal) return query::told(LinearKind::infeasible, any);
  return {LinearKind::unbounded, query::to_rationals(any.at), {}, query::to_rationals(best.ray)};
}

}  // namespace plumb
