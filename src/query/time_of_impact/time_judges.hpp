// Time of impact: when does a condition first hold, as far as doubles tell, to a pair of doubles, and exactly?
//
// Judges of query/time_of_impact/meeting_time.hpp, of one condition each.
// Laws: (1) QuickTime: no time before earliest() meets the condition, infinite where none in [0, 1] does; where
// certain() some time does, and the first is no later than latest().  (2) PreciseTime has the first time, given that
// QuickTime was certain.  (3) ExactTime has it whatever the numbers.  (4) HoldsAt says whether one time meets it.
// Source: RTCD 5.5.
// Cost: a few operations, and a root, for each part of the condition; GMP where exact.
#pragma once

#include <algorithm>
#include <optional>

#include "arith/running_error.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/arith/root.hpp"

namespace plumb::query {

class QuickTime {
 public:
  /// Nothing meets the condition before `from` or after `to`.
  QuickTime(double from, double to) : low_(from), high_(to) {}

  void not_negative(const Running& from, const Running& change);
  void zero(const Running& from, const Running& change);
  void not_positive(const Running& from, const Running& half_change, const Running& square);

  [[nodiscard]] double earliest() const { return earliest_; }
  [[nodiscard]] bool certain() const { return certain_; }
  [[nodiscard]] double latest() const { return latest_; }

 private:
  static constexpr double never = Interval::infinity;

  void first_is(const Interval& t, bool surely);

  double low_, high_;                        // outside of these a linear part fails
  double surely_low_ = 0, surely_high_ = 1;  // between these every linear part holds
  double earliest_ = never, latest_ = never;
  bool certain_ = false;
};

class PreciseTime {
 public:
  void not_negative(const Ball&, const Ball&) {}
  void zero(const Ball& from, const Ball& change) { time_ = quotient(Ball(0.0) - from, change); }
  void not_positive(const Ball& from, const Ball& half_change, const Ball& square);

  /// The double that the rounding names, where that is certain.
  [[nodiscard]] std::optional<double> rounded(Rounding rounding) const { return time_.rounded(rounding); }

 private:
  Ball time_{0.0};
};

class ExactTime {
 public:
  void not_negative(const BigDyadic& from, const BigDyadic& change);
  void zero(const BigDyadic& from, const BigDyadic& change) {
    not_positive(from * from, from * change, change * change);
  }
  void not_positive(const BigDyadic& from, const BigDyadic& half_change, const BigDyadic& square);

  [[nodiscard]] const std::optional<Root>& first() const { return first_; }

 private:
  mpq_class low_ = 0, high_ = 1;
  std::optional<Root> first_;
};

/// Does the condition hold at a time that is known, p / q, of which q is positive?
class HoldsAt {
 public:
  HoldsAt(const BigDyadic& p, const BigDyadic& q) : p_(p), q_(q) {}

  void not_negative(const BigDyadic& from, const BigDyadic& change) {
    if (holds_) holds_ = (from * q_ + change * p_).sign() != Sign::negative;
  }
  void zero(const BigDyadic& from, const BigDyadic& change) {
    if (holds_) holds_ = (from * q_ + change * p_).sign() == Sign::zero;
  }
  void not_positive(const BigDyadic& from, const BigDyadic& half_change, const BigDyadic& square) {
    if (!holds_) return;
    const BigDyadic by_half = half_change * p_;
    holds_ = ((from * q_ + by_half + by_half) * q_ + square * p_ * p_).sign() != Sign::positive;
  }

  [[nodiscard]] bool holds() const { return holds_; }

 private:
  const BigDyadic &p_, &q_;
  bool holds_ = true;
};

}  // namespace plumb::query
