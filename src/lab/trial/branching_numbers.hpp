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
#include "lab/trial/in_doubt.hpp"
#include "lab/trial/rational_judge.hpp"
#include "lab/trial/terms.hpp"
#include "plumb/arith/interval.hpp"
#include "tool/trial/expansion.hpp"

namespace plumb::lab::trial {

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

/// One number above another that is positive, or by itself; nothing is reduced.  Compiled once for each kind of number:
/// inlined into every algorithm, operations that take memory gain no speed.
template <class Number>
class Fraction {
 public:
  Fraction(double x = 0) : above_(x) {}  // NOLINT: a double is one; here, so that a constant 0 takes no memory

  [[nodiscard]] const Number& above() const { return above_; }
  [[nodiscard]] const Number& below() const { return below_; }
  [[nodiscard]] bool whole() const { return whole_; }

  friend Fraction operator+(const Fraction& a, const Fraction& b) { return a.plus(b); }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return a.minus(b); }
  friend Fraction operator-(const Fraction& a) { return Fraction().minus(a); }
  friend Fraction operator*(const Fraction& a, const Fraction& b) { return a.times(b); }
  friend Fraction operator/(const Fraction& a, const Fraction& b) { return a.over(b); }

  friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) { return a.against(b) <=> 0; }
  friend bool operator==(const Fraction& a, const Fraction& b) { return a.against(b) == 0; }

 private:
  explicit Fraction(Number above) : above_(std::move(above)) {}
  Fraction(Number above, Number below) : above_(std::move(above)), below_(std::move(below)), whole_(false) {}

  [[nodiscard]] Fraction plus(const Fraction& b) const;
  [[nodiscard]] Fraction minus(const Fraction& b) const;
  [[nodiscard]] Fraction times(const Fraction& b) const;
  [[nodiscard]] Fraction over(const Fraction& b) const;
  [[nodiscard]] int against(const Fraction& b) const;

  template <class Add>
  static Fraction sum(const Fraction& a, const Fraction& b, Add add);

  Number above_, below_{};
  bool whole_ = true;
};
extern template class Fraction<BigDyadic>;
extern template class Fraction<Expansion>;

/// Integers of any length, times powers of two.
using IntegerFraction = Fraction<BigDyadic>;

/// The double nearest to the square root.
double root_as_double(const IntegerFraction& square);

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

}  // namespace plumb::lab::trial
