// Root isolation: where are the roots of a polynomial, and which sign has another one there?  Isolating intervals in
// integers.
//
// Laws: (1) everything is exact.  (2) An isolated root is the only one of its polynomial, which has each root once,
// strictly between two dyadic numbers that are no roots themselves; or the polynomial has degree 1, and the root is a
// rational number without an interval.
// Source: Collins and Akritas 1976 (Descartes' rule, bisection); Abbott 2012 (quadratic refinement).
// Cost: some microseconds for the degrees in use, which are below 7.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "arith/polynomial.hpp"
#include "plumb/arith/rounding.hpp"

namespace plumb::arith {

struct IsolatedRoot {
  Polynomial polynomial;
  mpz_class lower, upper;  // divided by 2^places
  unsigned long places = 0;
  int sign_below = 0;  // of the polynomial at the lower end

  [[nodiscard]] bool is_rational() const { return polynomial.size() == 2; }
  /// Only where is_rational().
  [[nodiscard]] mpq_class rational() const;
};

IsolatedRoot root_at(const mpq_class& x);

/// The roots of a polynomial that is not zero, in ascending order: all of them, or those in [lower, upper].
std::vector<IsolatedRoot> isolated_roots(const Polynomial& p);
std::vector<IsolatedRoot> isolated_roots(const Polynomial& p, const mpq_class& lower, const mpq_class& upper);

/// Calls visit for those in [0, 1] in ascending order, until it says false.
void visit_roots_in_unit_interval(const Polynomial& p, const std::function<bool(IsolatedRoot&)>& visit);

/// Which of the two numbers is larger?  1, 0 or -1 as for left - right.
int compare(const IsolatedRoot& left, const mpq_class& right);
int compare(IsolatedRoot left, IsolatedRoot right);

/// The sign of q at the root.  The root's interval may become smaller.
int sign_at(const Polynomial& q, IsolatedRoot& root);

/// Until the interval is no longer than that, or the root is known to be rational.
void refine(IsolatedRoot& root, const mpq_class& width);

/// The root, where it is a rational number; refines it.
std::optional<mpq_class> rational_value(IsolatedRoot& root);

double rounded(Rounding rounding, IsolatedRoot root);

}  // namespace plumb::arith
