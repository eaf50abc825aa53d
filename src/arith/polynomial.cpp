#include "arith/polynomial.hpp"

#include <algorithm>
#include <utility>

namespace plumb::arith {
namespace {

void drop_leading_zeros(Polynomial& p) {
  while (!p.empty() && sgn(p.back()) == 0) p.pop_back();
}

/// p becomes the remainder of a multiple of p by q.
void reduce(Polynomial& p, const Polynomial& q) {
  mpz_class lead;
  while (p.size() >= q.size()) {
    lead = p.back();
    const std::size_t shift = p.size() - q.size();
    p.pop_back();
    for (mpz_class& c : p) c *= q.back();
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
      mpz_submul(p[i + shift].get_mpz_t(), lead.get_mpz_t(), q[i].get_mpz_t());
    }
    drop_leading_zeros(p);
  }
}

/// p(x) becomes p(x + by).
void shift_by(Polynomial& p, const mpz_class& by) {
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (std::size_t j = p.size() - 1; j-- > i;) mpz_addmul(p[j].get_mpz_t(), p[j + 1].get_mpz_t(), by.get_mpz_t());
  }
}

}  // namespace

void make_primitive(Polynomial& p) {
  drop_leading_zeros(p);
  mpz_class divisor;
  for (const mpz_class& c : p) {
    divisor = gcd(divisor, c);
    if (divisor == 1) return;
  }
  for (mpz_class& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d;
  for (std::size_t i = 1; i < p.size(); ++i) d.emplace_back(p[i] * static_cast<unsigned long>(i));
  return d;
}

Polynomial greatest_common_divisor(Polynomial p, Polynomial q) {
  make_primitive(p);
  make_primitive(q);
  if (p.size() < q.size()) std::swap(p, q);
  while (!q.empty()) {
    reduce(p, q);
    make_primitive(p);
    std::swap(p, q);
  }
  return p;
}

Polynomial exact_quotient(Polynomial p, const Polynomial& q) {
  // By rational coefficients it would be a polynomial; times a power of q's last coefficient it is one by integers.
  Polynomial quotient(p.size() - q.size() + 1);
  mpz_class lead;
  for (std::size_t at = quotient.size(); at-- > 0;) {
    lead = p[at + q.size() - 1];
    for (std::size_t i = 0; i < at + q.size() - 1; ++i) p[i] *= q.back();
    for (std::size_t i = at + 1; i < quotient.size(); ++i) quotient[i] *= q.back();
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
      mpz_submul(p[at + i].get_mpz_t(), lead.get_mpz_t(), q[i].get_mpz_t());
    }
    quotient[at] = lead;
  }
  make_primitive(quotient);
  return quotient;
}

Polynomial square_free_part(Polynomial p) {
  make_primitive(p);
  if (p.size() < 3) return p;
  const Polynomial repeated = greatest_common_divisor(p, derivative(p));
  return repeated.size() < 2 ? p : exact_quotient(std::move(p), repeated);
}

int count_positive_roots(const Polynomial& p) {
  // Changes of sign along the chain of negated remainders: at zero, and far beyond all roots.
  int more = 0, last_at_zero = 0, last_beyond = 0;
  const auto count = [](int& last, int sign) {
    const int change = sign != 0 && sign == -last ? 1 : 0;
    if (sign != 0) last = sign;
    return change;
  };
  const auto negate = [](Polynomial& q) {
    for (mpz_class& c : q) c = -c;
  };
  Polynomial here = p, next = derivative(p);
  while (!here.empty()) {
    more += count(last_at_zero, sgn(here.front())) - count(last_beyond, sgn(here.back()));
    Polynomial rest = std::move(here);
    here = next;
    if (!next.empty()) {
      if (sgn(next.back()) < 0) negate(next);  // so that what is left is a positive multiple of the remainder
      reduce(rest, next);
      negate(rest);
      make_primitive(rest);
      next = std::move(rest);
    }
  }
  return more;
}

mpz_class scaled_value(const Polynomial& p, const DyadicPlace& x) {
  mpz_class value, term;
  for (std::size_t i = p.size(); i-- > 0;) {
    value *= x.mantissa;
    term = p[i] << (x.places * static_cast<unsigned long>(p.size() - 1 - i));
    value += term;
  }
  return value;
}

int sign_at(const Polynomial& p, const DyadicPlace& x) { return sgn(scaled_value(p, x)); }

int sign_at(const Polynomial& p, const mpq_class& x) {
  mpz_class value, power = 1;
  for (std::size_t i = p.size(); i-- > 0;) {
    value = value * x.get_num() + p[i] * power;
    power *= x.get_den();
  }
  return sgn(value);
}

Variations variations(const Polynomial& p, const mpz_class& lower, const mpz_class& upper, unsigned long places) {
  Polynomial b = p;
  for (std::size_t i = 0; i < b.size(); ++i) b[i] <<= places * static_cast<unsigned long>(b.size() - 1 - i);
  shift_by(b, lower);
  const mpz_class width = upper - lower;
  mpz_class power = 1;
  for (mpz_class& c : b) {
    c *= power;
    power *= width;
  }
  std::reverse(b.begin(), b.end());
  shift_by(b, 1);  // the Bernstein coefficients, from the upper end to the lower, times binomials
  Variations v{0, 0, !b.empty() && (sgn(b.front()) == 0 || sgn(b.back()) == 0)};
  int last = 0;
  for (const mpz_class& c : b) {
    const int s = sgn(c);
    if (s != 0 && last != 0 && s != last) ++v.count;
    if (s != 0) last = s;
  }
  v.sign = v.count == 0 ? last : 0;
  return v;
}

}  // namespace plumb::arith
