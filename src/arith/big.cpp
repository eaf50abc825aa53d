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

/// The mantissa, read where it stands.
class BigDyadic::View {
 public:
  explicit View(const BigDyadic& x) : large_(x.large_ == nullptr ? nullptr : x.large_->mantissa.get_mpz_t()) {
    if (large_ != nullptr) return;
    const auto size = static_cast<mp_size_t>(x.short_.limbs().size());
    mpz_roinit_n(short_, x.short_.limbs().data(), is_negative(x.short_) ? -size : size);
  }
  [[nodiscard]] mpz_srcptr get() const { return large_ != nullptr ? large_ : short_; }
  [[nodiscard]] int sign() const { return mpz_sgn(get()); }

 private:
  mpz_srcptr large_;
  mpz_t short_;
};

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
  const View l(a), r(b);
  if (l.sign() == 0 && !subtract) return b;
  if (r.sign() == 0) return a;
  const bool a_higher = l.sign() != 0 && a.exponent() > b.exponent();
  Large sum{{}, a_higher || l.sign() == 0 ? b.exponent() : a.exponent()};
  mpz_ptr to = sum.mantissa.get_mpz_t();
  mpz_srcptr left = l.get(), right = r.get();
  mpz_srcptr& high = a_higher ? left : right;
  mpz_mul_2exp(to, high, static_cast<mp_bitcnt_t>((a_higher ? a : b).exponent() - sum.exponent));
  high = to;
  (subtract ? mpz_sub : mpz_add)(to, left, right);
  drop_trailing_zeros(sum.mantissa, sum.exponent);
  return BigDyadic(std::move(sum));
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
  Large product{{}, a.exponent() + b.exponent()};
  mpz_mul(product.mantissa.get_mpz_t(), View(a).get(), View(b).get());
  return BigDyadic(std::move(product));
}

}  // namespace plumb
