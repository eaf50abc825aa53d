// Does a number type keep its law at every step of a formula, not only at its end?
//
// A Watched number carries a number under test beside the exact value; a check that the test supplies is called after
// each operation.  Mixed types (coordinate, rounded difference, product) stay what the number type makes of them.
#pragma once

#include <gmpxx.h>

#include <array>

#include "plumb/certify/formula.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {

template <class Number, class Check>
struct Watched {
  Number number;
  mpq_class exact;
  const Check* check;
};

template <class Number, class Check>
Watched<Number, Check> watched(const Number& number, const mpq_class& exact, const Check* check) {
  (*check)(number, exact);
  return {number, exact, check};
}

template <class A, class B, class Check>
auto operator+(const Watched<A, Check>& a, const Watched<B, Check>& b) {
  return watched(a.number + b.number, a.exact + b.exact, a.check);
}
template <class A, class B, class Check>
auto operator-(const Watched<A, Check>& a, const Watched<B, Check>& b) {
  return watched(a.number - b.number, a.exact - b.exact, a.check);
}
template <class A, class B, class Check>
auto operator*(const Watched<A, Check>& a, const Watched<B, Check>& b) {
  return watched(a.number * b.number, a.exact * b.exact, a.check);
}

template <class A, class Check>
auto twice(const Watched<A, Check>& a) {
  return watched(certify::tape::doubled(a.number), mpq_class(2 * a.exact), a.check);
}

/// Two number types run side by side.
template <class A, class B>
struct Beside {
  A a;
  B b;
};

template <class A, class B>
constexpr auto twice(const Beside<A, B>& x) {
  return Beside<decltype(certify::tape::doubled(x.a)), decltype(certify::tape::doubled(x.b))>{
      certify::tape::doubled(x.a), certify::tape::doubled(x.b)};
}

template <class A, class B, class C, class D>
constexpr auto operator+(const Beside<A, B>& x, const Beside<C, D>& y) {
  return Beside<decltype(x.a + y.a), decltype(x.b + y.b)>{x.a + y.a, x.b + y.b};
}
template <class A, class B, class C, class D>
constexpr auto operator-(const Beside<A, B>& x, const Beside<C, D>& y) {
  return Beside<decltype(x.a - y.a), decltype(x.b - y.b)>{x.a - y.a, x.b - y.b};
}
template <class A, class B, class C, class D>
constexpr auto operator*(const Beside<A, B>& x, const Beside<C, D>& y) {
  return Beside<decltype(x.a * y.a), decltype(x.b * y.b)>{x.a * y.a, x.b * y.b};
}

/// Formulas that use what the classic ones do not: bare coordinates in products and sums, sums of coordinates, powers,
/// unequal factors, long sums.
struct Irregular {
  static constexpr std::string_view name = "irregular";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    const auto sum = p[0] + p[1], difference = p[2] - p[3];
    const auto square = p[4] * p[4];
    return (sum * difference) * p[5] + p[6] * square - (difference * p[7]) * (sum + p[0]) + square * difference;
  }
};

struct HighPower {
  static constexpr std::string_view name = "high power";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    const auto x = p[0] - p[2];
    const auto x2 = x * x, x4 = x2 * x2;
    const auto y = p[1] * p[3];
    return x4 * x4 - y * y * (y * y) + x4 * (y * x2);
  }
};

/// Multiplies coordinates, differences and products by whole numbers, and takes opposites.
struct WithConstants {
  static constexpr std::string_view name = "with constants";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    const auto x = p[0] - p[4], y = p[1] - p[5];
    return 4.0 * x * (3 * p[2]) * y - (-7 * p[3]) * (y * y) + x * x * 100 * p[2] - -(x * y) * p[3] * 2.0f;
  }
};

/// Calls visit.operator()<F>() for every formula of the manifest and the irregular ones.
template <class Visit>
void for_each_formula(const Visit& visit) {
#define PLUMB_VISIT(formula) visit.template operator()<predicates::formula>();
  PLUMB_CLASSICS(PLUMB_VISIT)
#undef PLUMB_VISIT
  visit.template operator()<Irregular>();
  visit.template operator()<HighPower>();
  visit.template operator()<WithConstants>();
}

}  // namespace plumb
