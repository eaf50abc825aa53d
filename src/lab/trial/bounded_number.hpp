// How far off may a double be, as far as the largest of all inputs tells?  Static filters of code that branches.
//
// Beside the value go a bound of its magnitude and one of its error.  Both depend on the bound of all inputs and on the
// way through the code alone, not on the question, but for quotients, which a small denominator makes large: so where
// the code is straight, compilers compute them once for all.
// Laws: (1) the exact value is off by no more than the error, for all inputs below the bound; (2) what
// overflows has no finite bound, and a comparison that the errors leave open, or a division by what may be zero, puts
// the question in doubt.
// Source: RTCD 11.2; Fortune and Van Wyk 1996 (static filters).
// Cost: that of doubles to about twice that.
#pragma once

#include <cmath>

#include "lab/trial/in_doubt.hpp"

namespace plumb::lab::trial {

class BoundedNumber {
 public:
  BoundedNumber(double x = 0) : BoundedNumber(x, std::fabs(x), 0) {}  // NOLINT: a double is one
  /// Of magnitude below `input_bound`, a constant that compilers fold.
  static BoundedNumber input(double x) { return {x, input_bound, 0}; }
  static constexpr int input_exponent = 3;
  static constexpr double input_bound = 1 << input_exponent;

  friend BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
    return sum(a, b, a.value_ + b.value_);
  }
  friend BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) {
    return sum(a, b, a.value_ - b.value_);
  }
  friend BoundedNumber operator-(const BoundedNumber& a) { return {-a.value_, a.largest_, a.error_}; }
  friend BoundedNumber magnitude(const BoundedNumber& a) { return {std::fabs(a.value_), a.largest_, a.error_}; }
  friend BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
    const double largest = a.largest_ * b.largest_ * above;
    return {a.value_ * b.value_, largest + tiny,
            (a.largest_ * b.error_ + a.error_ * b.largest_ + unit * largest + 4 * tiny) * above};
  }
  friend BoundedNumber operator/(const BoundedNumber& a, const BoundedNumber& b) {
    const double least = (std::fabs(b.value_) - b.error_) * below;
    if (!(least > 0x1p-900)) {
      in_doubt = true;
      return a;
    }
    const double largest = a.largest_ / least * above;
    return {a.value_ / b.value_, largest + tiny,
            ((largest * b.error_ + a.error_ + 2 * tiny) / least + unit * largest + 4 * tiny) * above};
  }

  friend bool operator<(const BoundedNumber& a, const BoundedNumber& b) {
    const double difference = a.value_ - b.value_, slack = (a.error_ + b.error_) * above;
    return told(difference < -slack, difference >= slack);
  }
  friend bool operator>(const BoundedNumber& a, const BoundedNumber& b) { return b < a; }
  friend bool operator<=(const BoundedNumber& a, const BoundedNumber& b) { return !(b < a); }
  friend bool operator>=(const BoundedNumber& a, const BoundedNumber& b) { return !(a < b); }
  friend bool operator==(const BoundedNumber& a, const BoundedNumber& b) {
    const double difference = a.value_ - b.value_, slack = (a.error_ + b.error_) * above;
    return told(difference == 0 && slack == 0, difference < -slack || difference > slack);
  }

 private:
  // Bounds are rounded to nearest like all else: the factors pay for the few roundings of each, and `tiny` for what
  // underflows.
  static constexpr double unit = 0x1p-53, above = 1 + 0x1p-49, below = 1 - 0x1p-49, tiny = 0x1p-1074;

  BoundedNumber(double value, double largest, double error) : value_(value), largest_(largest), error_(error) {}
  static BoundedNumber sum(const BoundedNumber& a, const BoundedNumber& b, double value) {
    if (a.largest_ == 0) return {value, b.largest_, b.error_};
    if (b.largest_ == 0) return {value, a.largest_, a.error_};
    const double largest = (a.largest_ + b.largest_) * above;
    return {value, largest, (a.error_ + b.error_ + unit * largest) * above};
  }

  double value_, largest_, error_;
};

}  // namespace plumb::lab::trial
