// Multiple precision: what is the exact value, where a thousand bits hold it?  Integers times powers of two, without
// allocations.
//
// Laws: exact, of any finite double, until a number would take more than 16 limbs between the ends of its value: from then
// on it is lost, and so is what comes of it, whose sign is not certain.
// Source: GMP 6.2 manual, low-level functions.
// Cost: no allocation; the limbs' products.
#pragma once

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "plumb/arith/lattice.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

class ShortDyadic {
 public:
  static constexpr std::size_t most_limbs = 16;

  ShortDyadic() : size_(0) {}
  /// Up to `most_limbs` of a magnitude, least significant first, of which the last is not zero.
  ShortDyadic(std::span<const mp_limb_t> limbs, bool negative, long exponent)
      : size_(static_cast<int>(limbs.size())), negative_(negative), exponent_(exponent) {
    std::copy_n(limbs.data(), limbs.size(), limb_.data());
  }
  explicit ShortDyadic(double x) : size_(0) {
    const OddForm f = odd_form(x);
    if (f.mantissa == 0) return;
    limb_[0] = static_cast<mp_limb_t>(f.mantissa < 0 ? -f.mantissa : f.mantissa);
    size_ = 1, negative_ = f.mantissa < 0, exponent_ = f.exponent;
  }
  ShortDyadic(const ShortDyadic& x) { *this = x; }
  ShortDyadic& operator=(const ShortDyadic& x) {
    size_ = x.size_, exponent_ = x.exponent_, negative_ = x.negative_, lost_ = x.lost_;
    for (int i = 0; i < size_; ++i) limb_[at(i)] = x.limb_[at(i)];  // no more than there are
    return *this;
  }

  [[nodiscard]] Unsure<Sign> sign() const {
    if (lost_) return {};
    return Unsure{size_ == 0 ? Sign::zero : negative_ ? Sign::negative : Sign::positive};
  }

  [[nodiscard]] bool is_lost() const { return lost_; }
  [[nodiscard]] std::span<const mp_limb_t> limbs() const { return {limb_.data(), at(size_)}; }
  [[nodiscard]] long exponent() const { return exponent_; }

  friend ShortDyadic operator-(const ShortDyadic& a) {
    ShortDyadic r = a;
    r.negative_ = !r.negative_;
    return r;
  }
  friend ShortDyadic operator+(const ShortDyadic& a, const ShortDyadic& b) { return sum(a, b, b.negative_); }
  friend ShortDyadic operator-(const ShortDyadic& a, const ShortDyadic& b) { return sum(a, b, !b.negative_); }
  friend ShortDyadic operator*(const ShortDyadic& a, const ShortDyadic& b) {
    ShortDyadic r;
    if (a.lost_ || b.lost_) return lost();
    if (a.size_ == 0 || b.size_ == 0) return r;
    if (a.size_ + b.size_ > most) return lost();
    const ShortDyadic &longer = a.size_ < b.size_ ? b : a, &shorter = a.size_ < b.size_ ? a : b;
    mp_limb_t top = 0;
    if (shorter.size_ == 1) {
      top = r.limb_[at(longer.size_)] = mpn_mul_1(r.limb_.data(), longer.limb_.data(), longer.size_, shorter.limb_[0]);
    } else {
      top = mpn_mul(r.limb_.data(), longer.limb_.data(), longer.size_, shorter.limb_.data(), shorter.size_);
    }
    r.size_ = a.size_ + b.size_ - (top == 0 ? 1 : 0);
    r.exponent_ = a.exponent_ + b.exponent_;
    r.negative_ = a.negative_ != b.negative_;
    return r;
  }

 private:
  static constexpr int most = static_cast<int>(most_limbs);
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  static ShortDyadic lost() {
    ShortDyadic r;
    r.lost_ = true;
    return r;
  }
  // A term of a larger exponent is shifted to the other's.
  static ShortDyadic sum(const ShortDyadic& a, const ShortDyadic& b, bool b_negative) {
    if (a.lost_ || b.lost_) return lost();
    if (b.size_ == 0) return a;
    if (a.size_ == 0) {
      ShortDyadic r = b;
      r.negative_ = b_negative;
      return r;
    }
    const bool a_higher = a.exponent_ > b.exponent_;
    const ShortDyadic &high = a_higher ? a : b, &low = a_higher ? b : a;
    std::array<mp_limb_t, most + 1> shifted;
    const long shift = high.exponent_ - low.exponent_;
    if (shift >= most * GMP_NUMB_BITS) return lost();
    const int limbs = static_cast<int>(shift) / GMP_NUMB_BITS, bits = static_cast<int>(shift) % GMP_NUMB_BITS;
    if (high.size_ + limbs >= most || low.size_ >= most) return lost();
    std::fill_n(shifted.begin(), limbs, mp_limb_t{0});
    int size = high.size_ + limbs;
    if (bits == 0) {
      std::copy_n(high.limb_.begin(), high.size_, shifted.begin() + limbs);
    } else {
      const mp_limb_t over =
          mpn_lshift(shifted.data() + limbs, high.limb_.data(), high.size_, static_cast<unsigned>(bits));
      if (over != 0) shifted[at(size++)] = over;
    }
    const bool high_negative = a_higher ? a.negative_ : b_negative, low_negative = a_higher ? b_negative : a.negative_;
    return combined({shifted.data(), size, high_negative}, {low.limb_.data(), low.size_, low_negative}, low.exponent_);
  }
  struct Term {
    const mp_limb_t* limb;
    int size;
    bool negative;
  };
  static ShortDyadic combined(const Term& a, const Term& b, long exponent) {
    const bool a_longer = a.size != b.size ? a.size > b.size : mpn_cmp(a.limb, b.limb, a.size) >= 0;
    const Term &more = a_longer ? a : b, &less = a_longer ? b : a;
    ShortDyadic r;
    r.negative_ = more.negative, r.exponent_ = exponent, r.size_ = more.size;
    if (a.negative == b.negative) {
      const mp_limb_t carry = mpn_add(r.limb_.data(), more.limb, more.size, less.limb, less.size);
      if (carry != 0) r.limb_[at(r.size_++)] = carry;
    } else {
      mpn_sub(r.limb_.data(), more.limb, more.size, less.limb, less.size);
      while (r.size_ > 0 && r.limb_[at(r.size_ - 1)] == 0) --r.size_;
    }
    r.drop_low_zeros();
    return r;
  }
  void drop_low_zeros() {
    int zeros = 0;
    while (zeros < size_ && limb_[at(zeros)] == 0) ++zeros;
    if (zeros == 0 || size_ == 0) return;
    std::copy(limb_.begin() + zeros, limb_.begin() + size_, limb_.begin());
    size_ -= zeros, exponent_ += zeros * GMP_NUMB_BITS;
  }

  std::array<mp_limb_t, most> limb_;
  int size_;
  bool negative_ = false, lost_ = false;
  long exponent_ = 0;
};

}  // namespace plumb
