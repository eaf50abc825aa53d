#include "query/time_of_impact/time_judges.hpp"

#include <array>

#include "arith/exact_number.hpp"

namespace plumb::query {

namespace {

Interval interval(const Running& x) { return {x.lower(), x.upper()}; }

}  // namespace

void QuickTime::not_negative(const Running& from_value, const Running& change_value) {
  const Interval from = interval(from_value), change = interval(change_value);
  const Interval back{-from.upper, -from.lower};
  if (change.lower > 0) {
    const Interval at = quotient(back, change);
    low_ = std::max(low_, at.lower), surely_low_ = std::max(surely_low_, at.upper);
  } else if (change.upper < 0) {
    const Interval at = quotient(back, change);
    high_ = std::min(high_, at.upper), surely_high_ = std::min(surely_high_, at.lower);
  } else {
    const Interval all = from + change * Interval{0, 1};
    if (all.upper < 0) high_ = -never;
    if (!(all.lower >= 0)) surely_high_ = -never;
  }
}

void QuickTime::first_is(const Interval& t, bool surely) {
  const double first = std::max(low_, t.lower);
  if (!(first <= high_)) return;
  earliest_ = first;
  certain_ = surely && t.lower >= surely_low_ && t.upper <= surely_high_;
  latest_ = t.upper;
}

void QuickTime::zero(const Running& from, const Running& change) {
  if (!(low_ <= high_)) return;
  const Interval start = interval(from), by = interval(change);
  if (by.lower > 0 || by.upper < 0) return first_is(quotient(Interval{-start.upper, -start.lower}, by), true);
  const Interval all = start + by * Interval{0, 1};
  if (all.lower <= 0 && all.upper >= 0) first_is({0, 1}, false);
}

void QuickTime::not_positive(const Running& from, const Running& half_change, const Running& square) {
  if (!(low_ <= high_)) return;
  const Interval c = interval(from), h = interval(half_change), s = interval(square);
  // The condition is convex in time.
  if (!(c.lower > 0)) return first_is({0, 1}, false);
  if (h.lower >= 0) return;
  const Running rest = half_change * half_change - square * from;
  const Interval under = interval(rest);
  if (under.upper < 0) return;
  const Interval first = quotient(c, root(under) + Interval{-h.upper, -h.lower});
  first_is({std::max(first.lower, 0.0), first.upper}, under.lower > 0 && h.upper < 0 && s.lower > 0);
}

void PreciseTime::not_positive(const Ball& from, const Ball& half_change, const Ball& square) {
  time_ = quotient(from, root(half_change * half_change - square * from) - half_change);
}

void ExactTime::not_negative(const BigDyadic& from, const BigDyadic& change) {
  if (change.sign() == Sign::zero) {
    if (from.sign() == Sign::negative) high_ = -1;
    return;
  }
  const mpq_class at = -gmp_number(from) / gmp_number(change);
  if (change.sign() == Sign::positive) {
    low_ = std::max(low_, at);
  } else {
    high_ = std::min(high_, at);
  }
}

void ExactTime::not_positive(const BigDyadic& from, const BigDyadic& half_change, const BigDyadic& square) {
  if (low_ > high_) return;
  const std::array<mpq_class, 3> c{gmp_number(from), 2 * gmp_number(half_change), gmp_number(square)};
  if (c[0] + (c[1] + c[2] * low_) * low_ <= 0) {
    first_ = Root(exact_number(low_));
    return;
  }
  const std::array coefficients{exact_number(c[0]), exact_number(c[1]), exact_number(c[2])};
  const std::vector<Root> roots = real_roots(coefficients, exact_number(low_), exact_number(high_));
  if (!roots.empty()) first_ = roots.front();
}

}  // namespace plumb::query
