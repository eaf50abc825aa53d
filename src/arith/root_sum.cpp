#include "arith/root_sum.hpp"

#include <vector>

namespace plumb {
namespace {

/// times * sqrt(mantissa) * 2^half.
struct KindOfRoot {
  mpq_class times;
  mpz_class mantissa;
  long half;
};

mpq_class scaled_by_power(mpq_class x, long power) {
  const auto shift = static_cast<mp_bitcnt_t>(power < 0 ? -power : power);
  if (power < 0) {
    mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), shift);
  } else {
    mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), shift);
  }
  return x;
}

KindOfRoot kind_of(const RootTerm& term) {
  KindOfRoot kind{mpq_class(term.times), term.radicand.mantissa(), term.radicand.exponent()};
  if ((kind.half & 1) != 0) kind.mantissa <<= 1, --kind.half;
  kind.half /= 2;
  return kind;
}

/// Adds one root to another, of which it is a rational multiple.  False where it is none.
bool joins(KindOfRoot& one, const KindOfRoot& other) {
  const mpz_class product = one.mantissa * other.mantissa;
  if (mpz_perfect_square_p(product.get_mpz_t()) == 0) return false;
  mpq_class ratio(sqrt(product), one.mantissa);
  ratio.canonicalize();
  one.times += scaled_by_power(other.times * ratio, other.half - one.half);
  return true;
}

/// The sum with so many digits behind the point of each mantissa's root: from `low` to `high`.
Sign sign_within(const std::vector<KindOfRoot>& kinds, mp_bitcnt_t digits) {
  mpq_class low(0), high(0);
  for (const KindOfRoot& k : kinds) {
    mpz_class floor, rest;
    const mpz_class shifted = k.mantissa << (2 * digits);
    mpz_sqrtrem(floor.get_mpz_t(), rest.get_mpz_t(), shifted.get_mpz_t());
    const mpz_class ceil = rest == 0 ? floor : mpz_class(floor + 1);
    const long power = k.half - static_cast<long>(digits);
    const mpq_class one = scaled_by_power(k.times * mpq_class(floor), power),
                    other = scaled_by_power(k.times * mpq_class(ceil), power);
    low += k.times > 0 ? one : other;
    high += k.times > 0 ? other : one;
  }
  return low > 0 ? Sign::positive : high < 0 ? Sign::negative : Sign::zero;
}

}  // namespace

Sign sign_of_root_sum(std::span<const RootTerm> terms) {
  std::vector<KindOfRoot> kinds;
  for (const RootTerm& term : terms) {
    if (term.times == 0 || term.radicand.sign() == Sign::zero) continue;
    const KindOfRoot kind = kind_of(term);
    bool is_new = true;
    for (std::size_t i = 0; i < kinds.size() && is_new; ++i) is_new = !joins(kinds[i], kind);
    if (is_new) kinds.push_back(kind);
  }
  std::erase_if(kinds, [](const KindOfRoot& k) { return k.times == 0; });
  if (kinds.empty()) return Sign::zero;
  for (mp_bitcnt_t digits = 64;; digits *= 2)
    if (const Sign s = sign_within(kinds, digits); s != Sign::zero) return s;
}

}  // namespace plumb
