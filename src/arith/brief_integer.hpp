// What is the exact value, in integers whose length nobody knows beforehand?  As many limbs as a value needs, of a few
// that stand on the stack.
//
// Laws: a value is exact, or it is lost: one that takes more than the limbs there are is lost, and so is all that is
// computed of it; nothing is ever wrong.  Nothing is allocated.
// Source: Knuth, TAOCP 4.3.1; RTCD 11.5.1.
// Cost: 1 to 2 ns an operation where 64 bits do, some 5 ns for a few limbs.
#pragma once

#include <cmath>
#include <cstdint>

#include "plumb/arith/wide_int.hpp"

namespace plumb::arith {

class BriefInteger {
 public:
  static constexpr int capacity = 34;  // limbs: 2176 bits

  BriefInteger() { set(std::int64_t{0}); }
  explicit BriefInteger(std::int64_t x) { set(x); }
  BriefInteger(const BriefInteger& x) : count_(x.count_) { copy(x); }
  BriefInteger& operator=(const BriefInteger& x) {
    count_ = x.count_;
    copy(x);
    return *this;
  }

  [[nodiscard]] bool is_lost() const { return count_ == 0; }
  /// -1, 0 or 1; 0 of what is lost.
  [[nodiscard]] int sign() const {
    if (count_ == 0) return 0;
    const std::int64_t top = last();
    return count_ == 1 ? static_cast<int>(top > 0) - static_cast<int>(top < 0) : top < 0 ? -1 : 1;
  }

  friend BriefInteger operator+(const BriefInteger& a, const BriefInteger& b) {
    BriefInteger r(uninitialized);
    std::int64_t sum = 0;
    if (a.count_ == 1 && b.count_ == 1 && !__builtin_add_overflow(a.last(), b.last(), &sum)) {
      r.set(sum);
    } else {
      r.combine<false>(a, b);
    }
    return r;
  }
  friend BriefInteger operator-(const BriefInteger& a, const BriefInteger& b) {
    BriefInteger r(uninitialized);
    std::int64_t difference = 0;
    if (a.count_ == 1 && b.count_ == 1 && !__builtin_sub_overflow(a.last(), b.last(), &difference)) {
      r.set(difference);
    } else {
      r.combine<true>(a, b);
    }
    return r;
  }
  BriefInteger operator-() const { return BriefInteger() - *this; }
  friend BriefInteger operator*(const BriefInteger& a, const BriefInteger& b) {
    BriefInteger r(uninitialized);
    if (a.count_ == 1 && b.count_ == 1) {
      r.set(static_cast<Int128>(a.last()) * b.last());
    } else {
      r.take_product(a, b);
    }
    return r;
  }
  /// x * 2^by
  friend BriefInteger operator<<(const BriefInteger& x, int by) {
    BriefInteger r(uninitialized);
    if (x.count_ == 1 && by < 64) {
      r.set(static_cast<Int128>(x.last()) * (static_cast<Int128>(1) << by));
    } else {
      r.take_shifted(x, by);
    }
    return r;
  }
  friend bool operator==(const BriefInteger& a, const BriefInteger& b) { return (a - b).sign() == 0; }

  /// Below 2^62 in magnitude: three products of such fit 128 bits.
  [[nodiscard]] bool is_short() const { return count_ == 1 && limb_[0] + (1ULL << 62) < (1ULL << 63); }
  [[nodiscard]] Int128 short_value() const { return last(); }
  static BriefInteger of(Int128 x) {
    BriefInteger r(uninitialized);
    r.set(x);
    return r;
  }

  /// A guess at x / 2^exponent: within some 2^-50 of it; 0 of what is lost.
  [[nodiscard]] double guess(int exponent) const {
    if (count_ == 0) return 0;
    if (count_ == 1) return std::ldexp(static_cast<double>(last()), -exponent);
    const double top = static_cast<double>(last()) * 0x1p64 + static_cast<double>(limb_[count_ - 2]);
    return std::ldexp(top, 64 * (count_ - 2) - exponent);
  }
  /// |x| < 2^bits(), and not much less.
  [[nodiscard]] int bits() const {
    if (count_ == 0) return 0;
    const auto top = static_cast<std::uint64_t>(last() < 0 ? ~last() : last());
    return 64 * (count_ - 1) + (top == 0 ? 1 : 65 - __builtin_clzll(top));
  }

 private:
  enum Uninitialized { uninitialized };
  explicit BriefInteger(Uninitialized) : count_(0) { limb_[0] = limb_[1] = 0; }

  [[nodiscard]] std::int64_t last() const { return static_cast<std::int64_t>(limb_[count_ - 1]); }
  [[nodiscard]] Int128 low() const {  // of two limbs or one
    return count_ == 1 ? static_cast<Int128>(last())
                       : static_cast<Int128>(static_cast<UInt128>(limb_[1]) << 64 | limb_[0]);
  }
  [[nodiscard]] std::uint64_t extension() const { return static_cast<std::uint64_t>(last() >> 63); }
  void copy(const BriefInteger& x) {
    limb_[0] = x.limb_[0], limb_[1] = x.limb_[1];  // most have no more
    if (x.count_ > 2) [[unlikely]] {
      for (int i = 2; i < x.count_; ++i) limb_[i] = x.limb_[i];
    }
  }
  void set(std::int64_t x) {
    count_ = 1;
    limb_[0] = static_cast<std::uint64_t>(x), limb_[1] = 0;
  }
  void set(Int128 x) {
    limb_[0] = static_cast<std::uint64_t>(x);
    limb_[1] = static_cast<std::uint64_t>(x >> 64);
    count_ = x == static_cast<std::int64_t>(x) ? 1 : 2;
  }
  /// Leaves off limbs that only repeat the sign.
  void trim() {
    while (count_ > 1 &&
           limb_[count_ - 1] == static_cast<std::uint64_t>(static_cast<std::int64_t>(limb_[count_ - 2]) >> 63))
      --count_;
    if (count_ > capacity) count_ = 0;
  }
  template <bool minus>
  void combine(const BriefInteger& a, const BriefInteger& b) {
    if (a.count_ == 0 || b.count_ == 0) {
      count_ = 0;
      return;
    }
    if (a.count_ <= 2 && b.count_ <= 2) {
      const Int128 x = a.low(), y = b.low();
      Int128 r = 0;
      if (!(minus ? __builtin_sub_overflow(x, y, &r) : __builtin_add_overflow(x, y, &r))) return set(r);
    }
    const int n = a.count_ > b.count_ ? a.count_ : b.count_;
    const std::uint64_t beyond_a = a.extension(), beyond_b = b.extension();
    std::uint8_t carry = 0;
    const auto one = [&](std::uint64_t x, std::uint64_t y) {
      return minus ? wide::subtract(x, y, carry) : wide::add(x, y, carry);
    };
    for (int i = 0; i < n; ++i) {
      limb_[i] = one(i < a.count_ ? a.limb_[i] : beyond_a, i < b.count_ ? b.limb_[i] : beyond_b);
    }
    limb_[n] = one(beyond_a, beyond_b);
    count_ = n + 1;
    trim();
  }
  void take_product(const BriefInteger& a, const BriefInteger& b) {
    const int n = a.count_ + b.count_;
    if (a.count_ == 0 || b.count_ == 0 || n > capacity + 1) {
      count_ = 0;
      return;
    }
    std::uint64_t over = 0;
    for (int j = 0; j < b.count_; ++j) {
      const UInt128 t = static_cast<UInt128>(a.limb_[0]) * b.limb_[j] + over;
      limb_[j] = static_cast<std::uint64_t>(t);
      over = static_cast<std::uint64_t>(t >> 64);
    }
    limb_[b.count_] = over;
    for (int i = 1; i < a.count_; ++i) {
      std::uint64_t carry = 0;
      for (int j = 0; j < b.count_; ++j) {
        const UInt128 t = static_cast<UInt128>(a.limb_[i]) * b.limb_[j] + limb_[i + j] + carry;
        limb_[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      limb_[i + b.count_] = carry;
    }
    // A negative factor was counted as 2^(64 limbs) too much.
    if (a.last() < 0) take_off(b, a.count_);
    if (b.last() < 0) take_off(a, b.count_);
    count_ = n;
    trim();
  }
  void take_off(const BriefInteger& x, int from) {
    std::uint8_t borrow = 0;
    for (int i = 0; i < x.count_; ++i) limb_[from + i] = wide::subtract(limb_[from + i], x.limb_[i], borrow);
  }
  void take_shifted(const BriefInteger& x, int by) {
    const int words = by / 64, bits = by % 64;
    if (x.count_ == 0 || x.count_ + words > capacity) {
      count_ = 0;
      return;
    }
    for (int i = 0; i < words; ++i) limb_[i] = 0;
    std::uint64_t below = 0;
    for (int i = 0; i < x.count_; ++i) {
      limb_[words + i] = x.limb_[i] << bits | below;
      below = bits == 0 ? 0 : x.limb_[i] >> (64 - bits);
    }
    limb_[words + x.count_] = bits == 0 ? x.extension() : x.extension() << bits | below;
    count_ = words + x.count_ + 1;
    trim();
  }

  std::int32_t count_;  // 0: lost
  std::uint64_t limb_[capacity + 1];
};

}  // namespace plumb::arith
