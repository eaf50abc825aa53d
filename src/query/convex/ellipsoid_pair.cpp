#include "query/convex/ellipsoid_pair.hpp"

#include "arith/polynomial.hpp"

namespace plumb::query {
namespace {

using Quadric = std::array<std::array<mpq_class, 4>, 4>;
using Quartic = std::array<mpq_class, 5>;

/// |inverse (x - center)|^2 - 1, over (x, 1).
Quadric quadric_of(const ExactMap& map) {
  const ExactMap back = inverse(map);
  const std::array<const Exact3*, 4> columns{&back.columns[0], &back.columns[1], &back.columns[2], &back.translation};
  Quadric q;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) q[i][j] = dot(*columns[i], *columns[j]);
  }
  q[3][3] -= 1;
  return q;
}

mpq_class determinant_of(Quadric m) {
  mpq_class product = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t pivot = k;
    while (pivot < 4 && sgn(m[pivot][k]) == 0) ++pivot;
    if (pivot == 4) return 0;
    if (pivot != k) std::swap(m[pivot], m[k]), product = -product;
    product *= m[k][k];
    for (std::size_t i = k + 1; i < 4; ++i) {
      const mpq_class factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 4; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return product;
}

/// Through its values at 0 to 4, by Newton's differences.
Quartic quartic_through(Quartic values) {
  for (std::size_t order = 1; order < 5; ++order) {
    for (std::size_t i = 4; i >= order; --i)
      values[i] = (values[i] - values[i - 1]) / mpq_class(static_cast<unsigned long>(order));
  }
  Quartic polynomial;
  for (std::size_t k = 5; k-- > 0;) {  // times (t - k), plus the difference
    for (std::size_t i = 4; i > 0; --i)
      polynomial[i] = polynomial[i - 1] - mpq_class(static_cast<unsigned long>(k)) * polynomial[i];
    polynomial[0] = values[k] - mpq_class(static_cast<unsigned long>(k)) * polynomial[0];
  }
  return polynomial;
}

/// A positive multiple.
arith::Polynomial integers_of(const Quartic& quartic) {
  mpz_class denominator = 1;
  for (const mpq_class& c : quartic) denominator = lcm(denominator, c.get_den());
  arith::Polynomial p;
  for (const mpq_class& c : quartic) p.emplace_back(c.get_num() * (denominator / c.get_den()));
  arith::make_primitive(p);
  return p;
}

}  // namespace

Relation relate_ellipsoids(const ExactMap& a, const ExactMap& b) {
  const Quadric p = quadric_of(a), q = quadric_of(b);
  Quartic values;
  for (std::size_t t = 0; t < 5; ++t) {
    Quadric sum;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) sum[i][j] = mpq_class(static_cast<unsigned long>(t)) * p[i][j] + q[i][j];
    }
    values[t] = determinant_of(std::move(sum));
  }
  const int positive = arith::count_positive_roots(integers_of(quartic_through(values)));
  return positive == 0 ? Relation::overlapping : positive == 1 ? Relation::touching : Relation::disjoint;
}

}  // namespace plumb::query
