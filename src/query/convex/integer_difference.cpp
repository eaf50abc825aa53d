#include "query/convex/integer_difference.hpp"

#include <cmath>

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

void add_directions(const FlatSet& set, bool turned, std::vector<Integers>& to) {
  const auto add = [&](const Exact3& v, bool back) {
    const mpz_class factor = common_denominator({v});
    to.push_back(times(v, back ? mpz_class(-factor) : factor));
  };
  for (const Exact3& d : set.directions) add(d, turned);
  for (const Exact3& line : set.lines) add(line, false), add(line, true);
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

}  // namespace

IntegerDifference in_integers(const FlatSet& a, const FlatSet& b) {
  IntegerDifference all;
  all.scale = lcm(common_denominator(a.points), common_denominator(b.points));
  all.origin = a.points[0];  // near to them, for the sake of shorter numbers
  const Integers origin = times(all.origin, all.scale);
  for (std::size_t s = 0; s < 2; ++s) {
    for (const Exact3& p : (s == 0 ? a : b).points)
      all.difference.points[s].push_back(arith::minus(times(p, all.scale), origin));
  }
  add_directions(a, false, all.difference.directions);
  all.directions_of_a = all.difference.directions.size();
  add_directions(b, true, all.difference.directions);
  return all;
}

std::vector<arith::DifferenceCorner> guessed_corners(const arith::Difference<mpz_class>& sets) {
  const arith::Difference<double> doubles = in_doubles(sets);
  constexpr int most_steps = 32;
  arith::DifferenceSearch<double> search(doubles, {{true, 0, 0}});
  std::vector<arith::DifferenceCorner> last = search.corners();
  for (int i = 0; i < most_steps && search.step(); ++i) last = search.corners();
  return last;
}

}  // namespace plumb::query
