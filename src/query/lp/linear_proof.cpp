#include "plumb/query/lp/linear_proof.hpp"

#include <string>

#include "arith/exact_number.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/query/lp/linear_program.hpp"
#include "query/lp/corner_point.hpp"
#include "query/lp/system_rows.hpp"

namespace plumb {
namespace query {
namespace {

template <class Halfspace>
LinearSystem system_of(std::span<const Halfspace> halfspaces) {
  LinearSystem r;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    figure::require_sound("linear_system", "halfspaces[" + std::to_string(i) + "]", halfspaces[i]);
    std::vector<Rational> row;
    for (const double x : numbers_of(halfspaces[i].normal)) row.emplace_back(x);
    r.add(std::move(row), halfspaces[i].offset);
  }
  return r;
}

template <std::size_t D>
std::array<typename LpOf<D>::Halfspace, D> corner_planes(const typename LpOf<D>::Answer& answer) {
  if (answer.kind == LinearKind::infeasible)
    throw DegeneratePoint("exact_point: the program is infeasible, so it has no point; ask its kind before");
  std::array<typename LpOf<D>::Halfspace, D> r;
  for (std::size_t k = 0; k < D; ++k) r[k] = answer.corner[k].halfspace;
  return r;
}

/// Weights under which the vectors, which have no more than one such sum, add up to the last one.
template <std::size_t D>
std::vector<mpq_class> weights_of(const std::vector<Numbers<D>>& vectors, const Numbers<D>& sum) {
  const std::size_t n = vectors.size();
  std::vector<std::vector<mpq_class>> rows(D, std::vector<mpq_class>(n + 1));
  for (std::size_t k = 0; k < D; ++k) {
    for (std::size_t i = 0; i < n; ++i) rows[k][i] = vectors[i][k];
    rows[k][n] = sum[k];
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    while (sgn(rows[pivot][i]) == 0) ++pivot;  // the vectors are independent
    std::swap(rows[i], rows[pivot]);
    const mpq_class by = rows[i][i];
    for (mpq_class& x : rows[i]) x /= by;
    for (std::size_t k = 0; k < D; ++k) {
      if (k == i || sgn(rows[k][i]) == 0) continue;
      const mpq_class times = rows[k][i];
      for (std::size_t j = 0; j <= n; ++j) rows[k][j] -= times * rows[i][j];
    }
  }
  std::vector<mpq_class> weights;
  for (std::size_t i = 0; i < n; ++i) weights.push_back(rows[i][n]);
  return weights;
}

template <std::size_t D>
LinearProof proof_of(const typename LpOf<D>::Answer& answer) {
  LinearProof proof{answer.kind, {}, {}, {}};
  if (answer.kind != LinearKind::infeasible) proof.point = to_rationals(exact_corner<D>(corner_planes<D>(answer)));
  if (answer.kind == LinearKind::unbounded) {
    if constexpr (D == 2) {
      proof.ray = to_rationals(exact_corner<D>(answer.ray_lines));
    } else {
      proof.ray = to_rationals(exact_corner<D>(answer.ray_planes));
    }
    return proof;
  }
  if (answer.deciding_count == 0) return proof;
  // Of a contradiction the others add up to the last one turned round.
  const bool is_optimal = answer.kind == LinearKind::optimal;
  const std::size_t named = answer.deciding_count - (is_optimal ? 0 : 1);
  std::vector<Numbers<D>> normals;
  for (std::size_t i = 0; i < named; ++i) normals.push_back(numbers_of(answer.deciding[i].halfspace.normal));
  Numbers<D> sum = numbers_of(is_optimal ? answer.direction : answer.deciding[named].halfspace.normal);
  if (!is_optimal) {
    for (double& x : sum) x = -x;
  }
  const std::vector<mpq_class> weights = weights_of<D>(normals, sum);
  for (std::size_t i = 0; i < named; ++i)
    proof.weights.push_back({answer.deciding[i].number, exact_number(weights[i])});
  if (!is_optimal) proof.weights.push_back({answer.deciding[named].number, 1});
  return proof;
}

}  // namespace
}  // namespace query

LinearSystem linear_system(std::span<const Halfspace2> halfspaces) { return query::system_of(halfspaces); }
LinearSystem linear_system(std::span<const Halfspace3> halfspaces) { return query::system_of(halfspaces); }

ExactPoint2 exact_point(const LinearAnswer2& answer) {
  const auto p = query::exact_corner<2>(query::corner_planes<2>(answer));
  return RationalPoint2{exact_number(p[0]), exact_number(p[1])};
}
ExactPoint3 exact_point(const LinearAnswer3& answer) {
  const auto p = query::exact_corner<3>(query::corner_planes<3>(answer));
  return RationalPoint3{exact_number(p[0]), exact_number(p[1]), exact_number(p[2])};
}

LinearProof proof_of(const LinearAnswer2& answer) { return query::proof_of<2>(answer); }
LinearProof proof_of(const LinearAnswer3& answer) { return query::proof_of<3>(answer); }

}  // namespace plumb
