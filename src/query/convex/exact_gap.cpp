#include "query/convex/exact_gap.hpp"

#include <algorithm>
#include <cmath>

#include "arith/difference_search.hpp"

namespace plumb::query {
namespace {

using Integers = arith::Triplet<mpz_class>;

// What multiplies all of them into integers.
mpz_class common_denominator(const std::vector<Exact3>& all) {
  mpz_class common = 1;
  for (const Exact3& v : all) {
    for (const mpq_class& x : v) {
      if (!mpz_divisible_p(common.get_mpz_t(), x.get_den_mpz_t())) common = lcm(common, x.get_den());
    }
  }
  return common;
}

Integers times(const Exact3& v, const mpz_class& factor) {
  Integers r;
  for (std::size_t k = 0; k < 3; ++k) {
    mpz_divexact(r[k].get_mpz_t(), factor.get_mpz_t(), v[k].get_den_mpz_t());
    r[k] *= v[k].get_num();
  }
  return r;
}

bool is_zero_vector(const Integers& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

// Looks along the lines: distances are those of what is seen, times the size of all lines.
class LookAlong {
 public:
  void along(Integers line) {
    see(line);
    if (is_zero_vector(line)) return;
    sizes_.push_back(arith::dot(line, line));
    lines_.push_back(std::move(line));
  }
  void see(Integers& v) const {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const mpz_class part = arith::dot(v, lines_[i]);
      for (std::size_t k = 0; k < 3; ++k) v[k] = v[k] * sizes_[i] - part * lines_[i][k];
    }
  }
  [[nodiscard]] mpz_class size() const {
    mpz_class all = 1;
    for (const mpz_class& s : sizes_) all *= s;
    return all;
  }

 private:
  std::vector<Integers> lines_;  // perpendicular to one another
  std::vector<mpz_class> sizes_;
};

// The difference of the sets in integers, as seen along their lines, and by what its points are multiplied.
arith::Difference<mpz_class> in_integers(const FlatSet& a, const FlatSet& b, mpz_class& scale) {
  LookAlong look;
  arith::Difference<mpz_class> sets;
  scale = lcm(common_denominator(a.points), common_denominator(b.points));
  for (const FlatSet* set : {&a, &b}) {
    for (const Exact3& line : set->lines) look.along(times(line, common_denominator({line})));
  }
  const Integers origin = times(a.points[0], scale);  // near to them, for the sake of shorter numbers
  for (std::size_t s = 0; s < 2; ++s) {
    const FlatSet& set = s == 0 ? a : b;
    for (const Exact3& p : set.points) look.see(sets.points[s].emplace_back(arith::minus(times(p, scale), origin)));
    for (const Exact3& d : set.directions) {
      const mpz_class factor = common_denominator({d});
      look.see(sets.directions.emplace_back(times(d, s == 0 ? factor : mpz_class(-factor))));
    }
  }
  scale *= look.size();
  return sets;
}

// As many powers of two as the longest of the numbers has.
std::size_t longest(const std::vector<Integers>& all) {
  std::size_t bits = 0;
  for (const Integers& v : all) {
    for (const mpz_class& x : v) bits = std::max(bits, mpz_sizeinbase(x.get_mpz_t(), 2));
  }
  return bits;
}

arith::Triplet<double> in_doubles(const Integers& v, std::size_t bits) {
  arith::Triplet<double> r;
  for (std::size_t k = 0; k < 3; ++k) {
    long exponent = 0;
    const double part = mpz_get_d_2exp(&exponent, v[k].get_mpz_t());
    r[k] = std::ldexp(part, static_cast<int>(std::max(exponent - static_cast<long>(bits), -2000L)));
  }
  return r;
}

arith::Difference<double> in_doubles(const arith::Difference<mpz_class>& sets) {
  arith::Difference<double> r;
  const std::size_t bits = std::max(longest(sets.points[0]), longest(sets.points[1]));
  for (std::size_t s = 0; s < 2; ++s) {
    for (const Integers& p : sets.points[s]) r.points[s].push_back(in_doubles(p, bits));
  }
  for (const Integers& d : sets.directions) r.directions.push_back(in_doubles(d, longest({d})));
  return r;
}

// Corners that are likely those of the nearest point.
std::vector<arith::DifferenceCorner> guess(const arith::Difference<double>& sets) {
  constexpr int most_steps = 32;
  arith::DifferenceSearch<double> search(sets, {{true, 0, 0}});
  std::vector<arith::DifferenceCorner> last = search.corners();
  for (int i = 0; i < most_steps && search.step(); ++i) last = search.corners();
  return last;
}

Relation relation_within(const FlatSet& a, const FlatSet& b, const mpq_class& reach) {
  if (sgn(reach) == 0) return relate(a, b);
  const std::optional<mpq_class> square = squared_distance(a, b);
  if (!square) return Relation::disjoint;
  return static_cast<Relation>(sgn(mpq_class(reach * reach - *square)));
}

}  // namespace

std::optional<mpq_class> squared_distance(const FlatSet& a, const FlatSet& b) {
  if (a.points.empty() || b.points.empty()) return {};
  mpz_class scale;
  const arith::Difference<mpz_class> sets = in_integers(a, b, scale);
  arith::DifferenceSearch<mpz_class> search(sets, guess(in_doubles(sets)));
  while (search.step()) {
  }
  const mpz_class root = search.whole() * scale;
  mpq_class square(search.square(), root * root);
  square.canonicalize();
  return square;
}

Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other) {
  return relation_within(core, other, radius);
}
Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other_core, double other_radius) {
  return relation_within(core, other_core, mpq_class(radius) + mpq_class(other_radius));
}

FlatSet core_set(const Sphere3& sphere) { return flat_set(sphere.center); }
FlatSet core_set(const Capsule3& capsule) { return flat_set(Segment3{capsule.a, capsule.b}); }
FlatSet core_set(const Lozenge3& lozenge) {
  const auto exact = [](const auto& p) { return Exact3{p.x, p.y, p.z}; };
  const Exact3 corner = exact(lozenge.corner), e = exact(lozenge.edges[0]), f = exact(lozenge.edges[1]);
  return {{corner, corner + e, corner + f, corner + e + f}, {}, {}, {}};
}

}  // namespace plumb::query
