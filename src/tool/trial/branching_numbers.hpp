// In which numbers does code that branches know whether it branched rightly?  Intervals, fractions of integers or of
// expansions, rationals.
//
// Laws: (1) a comparison that intervals cannot tell, and a division by zero, put the question in doubt; (2) fractions
// and rationals are exact, those of expansions while nothing overflows or underflows: what they get wrong is the code's
// fault, not the arithmetic's.
// Source: RTCD 11.4, 11.5.
// Cost: some ns an operation for intervals, a hundred to thousands for fractions.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <compare>
#include <utility>

#include "arith/exact_number.hpp"
#include "plumb/arith/interval.hpp"
#include "tool/trial/in_doubt.hpp"
#include "tool/trial/rational_judge.hpp"

namespace plumb::tool::trial {

/// A number that lies in an interval.
class Enclosed {
 public:
  Enclosed(double x = 0) : of_(x) {}  // NOLINT: a double is one
  explicit Enclosed(Interval of) : of_(of) {}

  friend Enclosed operator+(const Enclosed& a, const Enclosed& b) { return Enclosed(a.of_ + b.of_); }
  friend Enclosed operator-(const Enclosed& a, const Enclosed& b) { return Enclosed(a.of_ - b.of_); }
  friend Enclosed operator*(const Enclosed& a, const Enclosed& b) { return Enclosed(a.of_ * b.of_); }
  friend Enclosed operator/(const Enclosed& a, const Enclosed& b) { return Enclosed(quotient(a.of_, b.of_)); }
  friend Enclosed operator-(const Enclosed& a) { return Enclosed(Interval(-a.of_.upper, -a.of_.lower)); }
  friend Enclosed magnitude(const Enclosed& a) {
    if (a.of_.lower >= 0) return a;
    if (a.of_.upper <= 0) return -a;
    return Enclosed(Interval(0, std::max(-a.of_.lower, a.of_.upper)));
  }

  friend bool operator<(const Enclosed& a, const Enclosed& b) {
    return told(a.of_.upper < b.of_.lower, a.of_.lower >= b.of_.upper);
  }
  friend bool operator<=(const Enclosed& a, const Enclosed& b) {
    return told(a.of_.upper <= b.of_.lower, a.of_.lower > b.of_.upper);
  }
  friend bool operator>(const Enclosed& a, const Enclosed& b) { return b < a; }
  friend bool operator>=(const Enclosed& a, const Enclosed& b) { return b <= a; }
  friend bool operator==(const Enclosed& a, const Enclosed& b) {
    return told(a.of_.upper <= b.of_.lower && b.of_.upper <= a.of_.lower,
                a.of_.upper < b.of_.lower || b.of_.upper < a.of_.lower);
  }

 private:
  Interval of_;
};

/// One number above another that is positive, or by itself; nothing is reduced.
template <class Number>
class Fraction {
 public:
  Fraction(double x = 0) : above_(x) {}  // NOLINT: a double is one

  [[nodiscard]] const Number& above() const { return above_; }
  [[nodiscard]] const Number& below() const { return below_; }
  [[nodiscard]] bool whole() const { return whole_; }

  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    return sum(a, b, [](const Number& x, const Number& y) { return x + y; });
  }
  friend Fraction operator-(const Fraction& a, const Fraction& b) {
    return sum(a, b, [](const Number& x, const Number& y) { return x - y; });
  }
  friend Fraction operator-(const Fraction& a) { return Fraction() - a; }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    if (a.whole_ && b.whole_) return Fraction(a.above_ * b.above_);
    return {a.above_ * b.above_, a.whole_ ? b.below_ : b.whole_ ? a.below_ : a.below_ * b.below_};
  }
  friend Fraction operator/(const Fraction& a, const Fraction& b) {
    const Sign sign = b.above_.sign();
    if (sign == Sign::zero) {
      in_doubt = true;
      return a;
    }
    const Number above = b.whole_ ? a.above_ : a.above_ * b.below_;
    const Number below = a.whole_ ? b.above_ : a.below_ * b.above_;
    return sign == Sign::positive ? Fraction(above, below) : Fraction(Number() - above, Number() - below);
  }

  friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
    return static_cast<int>((a - b).above_.sign()) <=> 0;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) { return (a <=> b) == 0; }

 private:
  explicit Fraction(Number above) : above_(std::move(above)) {}
  Fraction(Number above, Number below) : above_(std::move(above)), below_(std::move(below)), whole_(false) {}

  template <class Add>
  static Fraction sum(const Fraction& a, const Fraction& b, Add add) {
    if (a.whole_ && b.whole_) return Fraction(add(a.above_, b.above_));
    if (a.whole_) return {add(a.above_ * b.below_, b.above_), b.below_};
    if (b.whole_) return {add(a.above_, b.above_ * a.below_), a.below_};
    if ((a.below_ - b.below_).sign() == Sign::zero) return {add(a.above_, b.above_), a.below_};
    return {add(a.above_ * b.below_, b.above_ * a.below_), a.below_ * b.below_};
  }

  Number above_, below_{};
  bool whole_ = true;
};

/// Integers of any length, times powers of two.
using IntegerFraction = Fraction<BigDyadic>;

/// The double nearest to the square root.
inline double root_as_double(const IntegerFraction& square) {
  const mpq_class above = gmp_number(square.above());
  return nearest_root(square.whole() ? above : mpq_class(above / gmp_number(square.below())));
}

class GmpRational {
 public:
  GmpRational(double x = 0) : of_(x) {}  // NOLINT: a double is one

  friend GmpRational operator+(const GmpRational& a, const GmpRational& b) { return GmpRational(a.of_ + b.of_); }
  friend GmpRational operator-(const GmpRational& a, const GmpRational& b) { return GmpRational(a.of_ - b.of_); }
  friend GmpRational operator*(const GmpRational& a, const GmpRational& b) { return GmpRational(a.of_ * b.of_); }
  friend GmpRational operator/(const GmpRational& a, const GmpRational& b) {
    if (sgn(b.of_) == 0) in_doubt = true;
    return sgn(b.of_) == 0 ? a : GmpRational(a.of_ / b.of_);
  }
  friend GmpRational operator-(const GmpRational& a) { return GmpRational(-a.of_); }

  friend std::strong_ordering operator<=>(const GmpRational& a, const GmpRational& b) {
    return cmp(a.of_, b.of_) <=> 0;
  }
  friend bool operator==(const GmpRational& a, const GmpRational& b) { return a.of_ == b.of_; }
  friend double root_as_double(const GmpRational& square) { return nearest_root(square.of_); }

 private:
  explicit GmpRational(mpq_class of) : of_(std::move(of)) {}
  mpq_class of_;
};

}  // namespace plumb::tool::trial
