#include "plumb/arith/big.hpp"

#include "plumb/arith/wide_int.hpp"

namespace plumb {
namespace {

void import(mpz_class& to, std::span<const mp_limb_t> limbs, bool negative) {
  mpz_ptr z = to.get_mpz_t();
  const auto size = static_cast<mp_size_t>(limbs.size());
  if (size == 0) return;
  std::ranges::copy(limbs, mpz_limbs_write(z, size));
  mpz_limbs_finish(z, negative ? -size : size);
}

/// Where there are few enough limbs.
ShortDyadic short_of(const mpz_class& x, long exponent) {
  const std::size_t size = mpz_size(x.get_mpz_t());
  return {std::span(mpz_limbs_read(x.get_mpz_t()), size), sgn(x) < 0, size == 0 ? 0 : exponent};
}

bool is_short(const mpz_class& x) { return mpz_size(x.get_mpz_t()) <= ShortDyadic::most_limbs; }

/// Where zeros fill limbs: cancellation leaves them, and products would carry them along.
void drop_trailing_zeros(mpz_class& mantissa, long& exponent) {
  if (sgn(mantissa) == 0) return;
  const mp_bitcnt_t zeros = mpz_scan1(mantissa.get_mpz_t(), 0);
  if (zeros < GMP_NUMB_BITS) return;
  mantissa >>= zeros;
  exponent += static_cast<long>(zeros);
}

ShortDyadic two_limbs(UInt128 magnitude, bool negative, long exponent) {
  const auto low = static_cast<mp_limb_t>(magnitude), high = static_cast<mp_limb_t>(magnitude >> 64);
  if (low == 0 && high != 0) return {std::array{high}, negative, exponent + 64};
  const std::array limbs{low, high};
  return {std::span(limbs).first(high != 0 ? 2 : low != 0 ? 1 : 0), negative, exponent};
}

/// Of one limb each, of exponents that 128 bits hold: as most are.
bool is_brief(const ShortDyadic& a, const ShortDyadic& b) { return a.limbs().size() == 1 && b.limbs().size() == 1; }
bool is_negative(const ShortDyadic& x) { return x.sign().value() == Sign::negative; }

ShortDyadic brief_sum(const ShortDyadic& high, bool high_negative, const ShortDyadic& low, bool low_negative) {
  const UInt128 a = UInt128{high.limbs()[0]} << (high.exponent() - low.exponent()), b = low.limbs()[0];
  if (high_negative == low_negative) return two_limbs(a + b, high_negative, low.exponent());
  return a < b ? two_limbs(b - a, low_negative, low.exponent()) : two_limbs(a - b, high_negative, low.exponent());
}

}  // namespace

BigDyadic::BigDyadic(Large x) {
  if (is_short(x.mantissa)) {
    short_ = short_of(x.mantissa, x.exponent);
  } else {
    large_ = std::make_unique<Large>(std::move(x));
  }
}

BigDyadic::BigDyadic(const mpz_class& x) {
  if (is_short(x)) {
    short_ = short_of(x, 0);
  } else {
    large_ = std::make_unique<Large>(Large{x, 0});
  }
}

mpz_class BigDyadic::mantissa() const {
  if (large_ != nullptr) return large_->mantissa;
  mpz_class r;
  import(r, short_.limbs(), short_.sign().value() == Sign::negative);
  return r;
}

// The term of the larger exponent is shifted to the other's; a zero is not, for its exponent says nothing of its size.
BigDyadic BigDyadic::sum(const BigDyadic& a, const BigDyadic& b, bool subtract) {
  if (a.large_ == nullptr && b.large_ == nullptr) [[likely]] {
    if (is_brief(a.short_, b.short_)) {
      const long above = a.short_.exponent() - b.short_.exponent();
      const bool negative = is_negative(a.short_), b_negative = is_negative(b.short_) != subtract;
      if (above >= 0 && above < 64) return BigDyadic(brief_sum(a.short_, negative, b.short_, b_negative));
      if (above < 0 && above > -64) return BigDyadic(brief_sum(b.short_, b_negative, a.short_, negative));
    }
    BigDyadic r(subtract ? a.short_ - b.short_ : a.short_ + b.short_);
    if (!r.short_.is_lost()) return r;
  }
  Large l = a.as_large(), r = b.as_large();
  if (subtract) r.mantissa = -r.mantissa;
  if (sgn(l.mantissa) == 0) return BigDyadic(std::move(r));
  if (sgn(r.mantissa) == 0) return BigDyadic(std::move(l));
  Large &high = l.exponent > r.exponent ? l : r, &low = l.exponent > r.exponent ? r : l;
  high.mantissa <<= static_cast<mp_bitcnt_t>(high.exponent - low.exponent);
  low.mantissa += high.mantissa;
  drop_trailing_zeros(low.mantissa, low.exponent);
  return BigDyadic(std::move(low));
}

BigDyadic BigDyadic::product(const BigDyadic& a, const BigDyadic& b) {
  if (a.large_ == nullptr && b.large_ == nullptr) [[likely]] {
    if (is_brief(a.short_, b.short_)) {
      return BigDyadic(two_limbs(UInt128{a.short_.limbs()[0]} * b.short_.limbs()[0],
                                 is_negative(a.short_) != is_negative(b.short_),
                                 a.short_.exponent() + b.short_.exponent()));
    }
    BigDyadic r(a.short_ * b.short_);
    if (!r.short_.is_lost()) return r;
  }
  Large l = a.as_large();
  const Large r = b.as_large();
  l.mantissa *= r.mantissa;
  l.exponent += r.exponent;
  return BigDyadic(std::move(l));
}

}  // namespace plumb
