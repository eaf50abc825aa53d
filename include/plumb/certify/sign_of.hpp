// What is the sign of my polynomial at these points and numbers, exactly?
//
//   sign_of(predicates::Orient2d{}, a, b, c)
//   sign_of([](auto x, auto y, auto z, auto f) { return f * z - x * x - y * y; }, x, y, z, f)
//
// The polynomial is a formula (certify/formula.hpp), or a lambda without captures that takes every coordinate as an
// argument of its own and uses + - * only.  Its error bound, and whether its terms have one degree, are derived.
// Laws: those of decide.  A number of coordinates that the polynomial does not take does not compile.
// Source: docs/proof.md; cost: that of decide: the filter where it is sure, and no code of its own beyond the small
// integers where it is not.
#pragma once

#include <tuple>

#include "plumb/arith/point.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb {

constexpr std::array<double, 1> coordinates(double x) { return {x}; }
constexpr std::array<double, 2> coordinates(const Point2& p) { return {p.x, p.y}; }
constexpr std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }
constexpr std::array<double, 2> coordinates(const Vector2& v) { return {v.x, v.y}; }
constexpr std::array<double, 3> coordinates(const Vector3& v) { return {v.x, v.y, v.z}; }
template <std::size_t N>
constexpr std::array<double, N> coordinates(const std::array<double, N>& x) {
  return x;
}

/// How many coordinates an argument of sign_of contributes.
template <class Argument>
inline constexpr int coordinate_count =
    static_cast<int>(std::tuple_size_v<decltype(coordinates(std::declval<const Argument&>()))>);

/// A lambda of scalars as a formula; Counts says how many of them each argument contributes.
template <class Lambda, bool Homogeneous, int... Counts>
struct LambdaFormula {
  static constexpr std::string_view name = "sign_of";
  static constexpr std::array<int, sizeof...(Counts)> arguments{Counts...};
  static constexpr bool homogeneous = Homogeneous;

  template <class T>
  constexpr auto operator()(const std::array<T, (std::size_t{Counts} + ...)>& p) const {
    return std::apply(Lambda{}, p);
  }
};

/// The formula that sign_of takes a polynomial for.
template <class Polynomial, class... Arguments>
struct FormulaOf {
  static constexpr bool homogeneous =
      term_degrees<LambdaFormula<Polynomial, false, coordinate_count<Arguments>...>>().equal;
  using Type = LambdaFormula<Polynomial, homogeneous, coordinate_count<Arguments>...>;
};
template <Formula F, class... Arguments>
struct FormulaOf<F, Arguments...> {
  using Type = F;
};

/// The coordinates of all arguments in turn.
template <Formula F, class... Arguments>
constexpr Coordinates<F> coordinates_of(const Arguments&... arguments) {
  return std::apply([](auto... x) { return Coordinates<F>{x...}; }, std::tuple_cat(coordinates(arguments)...));
}

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
  using F = typename FormulaOf<Polynomial, Arguments...>::Type;
  static_assert((std::size_t{coordinate_count<Arguments>} + ...) == arity<F>,
                "sign_of: the polynomial takes another number of coordinates than these arguments have");
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
