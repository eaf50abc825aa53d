#include "arith/isolated_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "arith/big_rounding.hpp"

namespace plumb::arith {
namespace {

Polynomial linear(const mpz_class& root, unsigned long places) {
  return {mpz_class(-root), mpz_class(mpz_class(1) << places)};
}

/// Takes halves of the interval until each has one root or none; returns false when told to stop.  Ends, for the signs
/// of a polynomial without repeated roots vary at most once where an interval is short beside the distances of roots.
class Isolation {
 public:
  Isolation(Polynomial square_free, const std::function<bool(IsolatedRoot&)>& visit)
      : rest_(std::move(square_free)), visit_(visit) {}

  /// In [lower, upper] / 2^places.
  bool closed(const mpz_class& lower, const mpz_class& upper, unsigned long places) {
    if (!take_out(lower, places)) return false;
    // What is at the upper end comes last, but is divided out first: no end of an interval may be a root.
    const bool at_upper = lower != upper && rest_.size() > 1 && sign_at(rest_, DyadicPlace{upper, places}) == 0;
    if (at_upper) divide_out(upper, places);
    if (!open(lower, upper, places)) return false;
    return !at_upper || give(upper, places);
  }

 private:
  void divide_out(const mpz_class& x, unsigned long places) {
    Polynomial factor = linear(x, places);
    make_primitive(factor);
    rest_ = exact_quotient(std::move(rest_), factor);
  }
  bool give(const mpz_class& x, unsigned long places) {
    IsolatedRoot root;
    root.polynomial = linear(x, places);
    make_primitive(root.polynomial);
    return visit_(root);
  }
  bool take_out(const mpz_class& x, unsigned long places) {
    if (rest_.size() < 2 || sign_at(rest_, DyadicPlace{x, places}) != 0) return true;
    divide_out(x, places);
    return give(x, places);
  }
  bool open(const mpz_class& lower, const mpz_class& upper, unsigned long places) {
    if (rest_.size() < 2) return true;
    const int count = variations(rest_, lower, upper, places).count;
    if (count == 0) return true;
    if (count == 1) return give_between(lower, upper, places);
    const mpz_class middle = lower + upper, twice_lower = lower * 2, twice_upper = upper * 2;
    const bool at_middle = sign_at(rest_, DyadicPlace{middle, places + 1}) == 0;
    if (at_middle) divide_out(middle, places + 1);
    return open(twice_lower, middle, places + 1) && (!at_middle || give(middle, places + 1)) &&
           open(middle, twice_upper, places + 1);
  }
  bool give_between(const mpz_class& lower, const mpz_class& upper, unsigned long places) {
    IsolatedRoot root;
    root.polynomial = rest_;
    root.lower = lower;
    root.upper = upper;
    root.places = places;
    root.sign_below = sign_at(rest_, DyadicPlace{lower, places});
    return visit_(root);
  }

  Polynomial rest_;  // without the roots that were at an end of some interval
  const std::function<bool(IsolatedRoot&)>& visit_;
};

/// One half of the interval, or the root itself where it is in the middle.
void halve(IsolatedRoot& r) {
  const mpz_class middle = r.lower + r.upper;
  const int s = sign_at(r.polynomial, DyadicPlace{middle, r.places + 1});
  ++r.places;
  if (s == 0) {
    r.polynomial = linear(middle, r.places);
    make_primitive(r.polynomial);
  } else if (s == r.sign_below) {
    r.lower = middle;
    r.upper *= 2;
  } else {
    r.lower *= 2;
    r.upper = middle;
  }
}

/// Intervals that become smaller faster and faster: the secant guesses which part of 2^bits the root is in.  Each step
/// leaves half of the interval at most, and what is refined until it is certain ends with that: the interval becomes
/// short beside any distance that is not zero, and what may be zero is asked before (by common divisors, or a number).
class Refinement {
 public:
  void step(IsolatedRoot& r) {
    if (r.is_rational()) return;
    if (bits_ < 2) {
      halve(r);
      bits_ = 2;
      return;
    }
    const mpz_class below = abs(scaled_value(r.polynomial, DyadicPlace{r.lower, r.places}));
    const mpz_class above = abs(scaled_value(r.polynomial, DyadicPlace{r.upper, r.places}));
    const mpz_class width = r.upper - r.lower, parts = mpz_class(1) << bits_;
    mpz_class part = ((below << (bits_ + 1)) + below + above) / (2 * (below + above));
    part = std::clamp<mpz_class>(part, 1, parts - 1);
    const unsigned long places = r.places + bits_;
    const mpz_class start = r.lower << bits_, guess = start + part * width;
    const int s = sign_at(r.polynomial, DyadicPlace{guess, places});
    const mpz_class other = s == r.sign_below ? mpz_class(guess + width) : mpz_class(guess - width);
    const int t = s == 0 ? 0 : sign_at(r.polynomial, DyadicPlace{other, places});
    if (s == 0 || t == 0) {
      r.polynomial = linear(s == 0 ? guess : other, places);
      make_primitive(r.polynomial);
    } else if (s != t || beyond(other, r, places)) {
      r.lower = std::min(guess, other);
      r.upper = std::max(guess, other);
      r.places = places;
      bits_ *= 2;
    } else {
      bits_ /= 2;
      halve(r);
    }
  }

 private:
  // An end of the interval has the other sign by itself.
  static bool beyond(const mpz_class& x, const IsolatedRoot& r, unsigned long places) {
    return x == (r.lower << (places - r.places)) || x == (r.upper << (places - r.places));
  }

  unsigned long bits_ = 2;
};

/// The largest double that is not above.
double below(const mpz_class& mantissa, unsigned long places) {
  return rounded_quotient(Rounding::down, BigDyadic(mantissa), BigDyadic(mpz_class(mpz_class(1) << places)));
}

/// The double above, which may be infinite.
double next(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

/// Half way between two neighboring doubles, where infinity stands for 2^1024.
mpq_class half_way(double a, double b) {
  const auto exact = [](double x) {
    return std::isfinite(x) ? mpq_class(x) : mpq_class((x > 0 ? 1 : -1) * mpq_class(mpz_class(1) << 1024));
  };
  return (exact(a) + exact(b)) / 2;
}

/// The root is strictly between neighboring doubles a < b.
double between(Rounding rounding, const IsolatedRoot& r, double a, double b) {
  if (rounding == Rounding::down) return a;
  if (rounding == Rounding::up) return b;
  const mpq_class middle = half_way(a, b);
  const int c = compare(r, middle);
  return c < 0 ? a : c > 0 ? b : plumb::rounded(rounding, middle);
}

}  // namespace

mpq_class IsolatedRoot::rational() const {
  mpq_class x(-polynomial[0], polynomial[1]);
  x.canonicalize();
  return x;
}

IsolatedRoot root_at(const mpq_class& x) {
  IsolatedRoot r;
  r.polynomial = {mpz_class(-x.get_num()), x.get_den()};
  return r;
}

void visit_roots_in_unit_interval(const Polynomial& p, const std::function<bool(IsolatedRoot&)>& visit) {
  if (variations(p, 0, 1, 0).count == 0 && sgn(p.front()) != 0 && sign_at(p, DyadicPlace{1, 0}) != 0) return;
  Isolation(square_free_part(p), visit).closed(0, 1, 0);
}

std::vector<IsolatedRoot> isolated_roots(const Polynomial& p) {
  Polynomial q = p;
  make_primitive(q);
  if (q.size() < 2) return {};
  mpz_class largest;
  for (const mpz_class& c : q) largest = std::max<mpz_class>(largest, abs(c));
  const mpz_class bound = largest / abs(q.back()) + 2;
  const mpz_class power = mpz_class(1) << mpz_sizeinbase(bound.get_mpz_t(), 2);
  std::vector<IsolatedRoot> roots;
  const std::function<bool(IsolatedRoot&)> visit = [&](IsolatedRoot& r) { return roots.push_back(r), true; };
  Isolation(square_free_part(q), visit).closed(-power, power, 0);
  return roots;
}

std::vector<IsolatedRoot> isolated_roots(const Polynomial& p, const mpq_class& lower, const mpq_class& upper) {
  Polynomial q = p;
  make_primitive(q);
  if (q.size() < 2 || lower > upper) return {};
  mpz_class first, last;
  mpz_fdiv_q(first.get_mpz_t(), lower.get_num_mpz_t(), lower.get_den_mpz_t());
  mpz_cdiv_q(last.get_mpz_t(), upper.get_num_mpz_t(), upper.get_den_mpz_t());
  std::vector<IsolatedRoot> roots;
  const std::function<bool(IsolatedRoot&)> visit = [&](IsolatedRoot& r) {
    if (compare(r, lower) >= 0 && compare(r, upper) <= 0) roots.push_back(r);
    return true;
  };
  Isolation(square_free_part(q), visit).closed(first, last, 0);
  return roots;
}

int compare(const IsolatedRoot& left, const mpq_class& right) {
  if (left.is_rational()) return sgn(mpq_class(left.rational() - right));
  const auto side = [&](const mpz_class& end) {
    return cmp(end * right.get_den(), mpz_class(right.get_num() << left.places));
  };
  if (side(left.lower) >= 0) return 1;
  if (side(left.upper) <= 0) return -1;
  return sign_at(left.polynomial, right) * left.sign_below;
}

void refine(IsolatedRoot& root, const mpq_class& width) {
  Refinement refinement;
  const auto is_longer = [&] {
    return mpz_class(root.upper - root.lower) * width.get_den() > mpz_class(width.get_num() << root.places);
  };
  while (!root.is_rational() && is_longer()) refinement.step(root);
}

// A root n / d in lowest terms of a polynomial in integers has a d that divides its last coefficient.
std::optional<mpq_class> rational_value(IsolatedRoot& root) {
  if (root.is_rational()) return root.rational();
  const mpz_class last = abs(root.polynomial.back());
  refine(root, mpq_class(1, 2 * last));
  if (root.is_rational()) return root.rational();
  const mpz_class times = last * root.upper;
  mpz_class numerator;
  mpz_fdiv_q_2exp(numerator.get_mpz_t(), times.get_mpz_t(), root.places);
  mpq_class x(numerator, last);  // within the interval, of which it is half a step long, no other one is
  x.canonicalize();
  return compare(root, x) == 0 ? std::optional(x) : std::nullopt;
}

int sign_at(const Polynomial& q, IsolatedRoot& root) {
  if (q.size() < 2) return q.empty() ? 0 : sgn(q[0]);
  Refinement refinement;
  bool may_be_zero = true;
  for (int steps = 0;; ++steps) {
    if (root.is_rational()) return sign_at(q, root.rational());
    const Variations v = variations(q, root.lower, root.upper, root.places);
    if (v.count == 0 && v.sign != 0) return v.sign;  // a zero at an end is no root within
    if (may_be_zero && steps == 2) {
      const Polynomial common = greatest_common_divisor(root.polynomial, q);
      // Of the common roots only one can be in the interval, and it is not at an end.
      if (common.size() > 1 && sign_at(common, DyadicPlace{root.lower, root.places}) !=
                                   sign_at(common, DyadicPlace{root.upper, root.places}))
        return 0;
      may_be_zero = false;
    }
    refinement.step(root);
  }
}

// Refines the one whose interval is longer.  A step squares an interval that is short: together, one of them would gain
// as many digits as there are powers of two in what the other needs to become short at all.
int compare(IsolatedRoot left, IsolatedRoot right) {
  if (right.is_rational()) return compare(left, right.rational());
  Refinement of_left, of_right;
  for (int steps = 0;; ++steps) {
    if (left.is_rational()) return -compare(right, left.rational());
    if (right.is_rational()) return compare(left, right.rational());
    const auto ordered = [](const mpz_class& a, unsigned long places_a, const mpz_class& b, unsigned long places_b) {
      return (a << places_b) <= (b << places_a);
    };
    if (ordered(left.upper, left.places, right.lower, right.places)) return -1;
    if (ordered(right.upper, right.places, left.lower, left.places)) return 1;
    if (steps == 2) {
      const Polynomial common = greatest_common_divisor(left.polynomial, right.polynomial);
      const bool left_starts = ordered(left.lower, left.places, right.lower, right.places);
      const bool left_ends = ordered(left.upper, left.places, right.upper, right.places);
      const IsolatedRoot& last_start = left_starts ? right : left;
      const IsolatedRoot& first_end = left_ends ? left : right;
      if (common.size() > 1 && sign_at(common, DyadicPlace{last_start.lower, last_start.places}) !=
                                   sign_at(common, DyadicPlace{first_end.upper, first_end.places}))
        return 0;
    }
    const bool right_is_longer = ordered(left.upper - left.lower, left.places, right.upper - right.lower, right.places);
    right_is_longer ? of_right.step(right) : of_left.step(left);
  }
}

double rounded(Rounding rounding, IsolatedRoot r) {
  Refinement refinement;
  for (;; refinement.step(r)) {
    if (r.is_rational()) return plumb::rounded(rounding, r.rational());
    const double a = below(r.lower, r.places);
    const double b = 0.0 - below(mpz_class(-r.upper), r.places);
    if (next(a) == b) return between(rounding, r, a, b);
    const double c = next(a);
    if (next(c) != b) continue;
    const int s = compare(r, mpq_class(c));
    if (s == 0) return c + 0.0;
    return s < 0 ? between(rounding, r, a, c) : between(rounding, r, c, b);
  }
}

}  // namespace plumb::arith
