// What is the sign of my polynomial at these points and numbers, exactly?
//
//   sign_of(predicates::Orient2d{}, a, b, c)
//   sign_of([](auto x, auto y, auto z, auto f) { return f * z - x * x - y * y; }, x, y, z, f)
//
// The polynomial is a formula (certify/formula.hpp), or a lambda without captures that takes every coordinate as an
// argument of its own and uses + - *, also by whole numbers as in 4 * a * c.  Its error bound, and whether its terms
// have one degree, are derived.
// Laws: those of decide.  What is no polynomial of these arguments does not compile (certify/accepted.hpp).
// Source: docs/proof.md.
// Cost: that of decide: the filter where it is sure, and no code of its own beyond the small integers where it is not.
#pragma once

#include "plumb/certify/accepted.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb {

/// What the filter could not decide.
template <Formula F, class... Arguments>
[[gnu::noinline]] Sign sign_of_unsure(const Arguments&... arguments) {
  return decide_exactly<F>(coordinates_of<F>(arguments...)).sign;
}

/// The sign of the polynomial; its arguments are Point2, Point3, Vector2, Vector3, double or std::array<double, N>,
/// whose coordinates are taken in turn.  Throws NonFinite.  The exact stages read the arguments again, so that the
/// filter can keep its copy in registers alone.
template <class Polynomial, class... Arguments>
[[gnu::flatten]] PLUMB_CHECKABLE constexpr Sign sign_of(Polynomial, const Arguments&... arguments) {
  static_assert(accepts<Polynomial, Arguments...>());
  using F = typename FormulaOf<Polynomial, Arguments...>::Type;
  static_assert(is_polynomial<F>());
  static_assert(use_all_coordinates<F>());
  assert_sound_thread();
  if (const int s = filter<F>(coordinates_of<F>(arguments...)); s != 0) [[likely]]
    return static_cast<Sign>(s);
  return sign_of_unsure<F>(arguments...);
}

// The library has these, as decide.hpp says of decisions.
#ifndef PLUMB_CHECKED
extern template Sign sign_of(predicates::Orient2d, const Point2&, const Point2&, const Point2&);
extern template Sign sign_of(predicates::Orient3d, const Point3&, const Point3&, const Point3&, const Point3&);
extern template Sign sign_of(predicates::InCircle, const Point2&, const Point2&, const Point2&, const Point2&);
extern template Sign sign_of(predicates::InSphere, const Point3&, const Point3&, const Point3&, const Point3&,
                             const Point3&);
#endif

}  // namespace plumb
