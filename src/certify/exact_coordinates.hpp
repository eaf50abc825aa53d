// What are the coordinates of an exact point, in the numbers of a computation?
//
// Laws: coordinate / weight, weight > 0 once made_positive has seen its sign; intervals contain, BigDyadic is exact.
// Cost: that of the point's construction.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/arith/big.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/certify/constructed.hpp"
#include "plumb/certify/exact_point.hpp"
#include "plumb/certify/implicit.hpp"

namespace plumb::certify::meeting {

template <class T, std::size_t N>
using Vec = std::array<T, N>;

/// The point at / weight.
template <class T, std::size_t N>
struct Weighted {
  Vec<T, N> at;
  T weight;
};

inline Interval interval_of(const Rational& x) { return {x.rounded(Rounding::down), x.rounded(Rounding::up)}; }

template <std::size_t N>
Weighted<Interval, N> of_rationals(const std::array<const Rational*, N>& x, Interval) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Weighted<Interval, N>{{interval_of(*x[I])...}, Interval{1.0}};
  }
  (std::make_index_sequence<N>{});
}

/// The weight is the least common multiple of the denominators, so that the integers have no common factor.
template <std::size_t N>
Weighted<BigDyadic, N> of_rationals(const std::array<const Rational*, N>& x, BigDyadic) {
  mpz_class weight = x[0]->value().value.get_den();
  for (std::size_t i = 1; i < N; ++i) {
    const mpz_class& denominator = x[i]->value().value.get_den();
    if (denominator != weight) weight = lcm(weight, denominator);
  }
  Weighted<BigDyadic, N> p;
  for (std::size_t i = 0; i < N; ++i) {
    const mpq_class& of = x[i]->value().value;
    p.at[i] = of.get_den() == weight ? BigDyadic(of.get_num())
                                     : BigDyadic(mpz_class(of.get_num() * mpz_class(weight / of.get_den())));
  }
  p.weight = BigDyadic(weight);
  return p;
}

inline std::array<const Rational*, 2> parts(const RationalPoint2& p) { return {&p.x, &p.y}; }
inline std::array<const Rational*, 3> parts(const RationalPoint3& p) { return {&p.x, &p.y, &p.z}; }

/// The point's homogeneous coordinates, of a weight of either sign; zero where a construction has no point.
template <class T, class Point>
auto weighted(const Point& point) {
  if constexpr (std::is_same_v<Point, RationalPoint2> || std::is_same_v<Point, RationalPoint3>) {
    return of_rationals(parts(point), T(0.0));
  } else {
    constexpr auto n = static_cast<std::size_t>(KindOf<Point>::dimension);
    if constexpr (std::is_same_v<T, BigDyadic>) {  // integers are made of real numbers only
      constexpr std::span<const PointPart> parts{PointTraits<Point>::parts};
      certify::mixed::require_finite({"exact point", {&parts, 1}, coordinates(point)});
    }
    auto h = homogeneous(point, [](double x) { return T(x); });
    return Weighted<T, n>{std::move(h.coordinate), std::move(h.weight)};
  }
}

template <class T>
Weighted<T, 2> coordinates_in(const ExactPoint2& p) {
  return std::visit([](const auto& point) { return weighted<T>(point); }, p.as());
}
template <class T>
Weighted<T, 3> coordinates_in(const ExactPoint3& p) {
  return std::visit([](const auto& point) { return weighted<T>(point); }, p.as());
}

/// numerator / denominator, for a denominator that is not zero.
inline Rational rational_quotient(const BigDyadic& numerator, const BigDyadic& denominator) {
  mpq_class x(numerator.mantissa(), denominator.mantissa());
  const long shift = numerator.exponent() - denominator.exponent();
  if (shift > 0) x.get_num() <<= static_cast<mp_bitcnt_t>(shift);
  if (shift < 0) x.get_den() <<= static_cast<mp_bitcnt_t>(-shift);
  return Rational(BigRational{x});
}

inline RationalPoint2 rational(const Weighted<BigDyadic, 2>& p) {
  return {rational_quotient(p.at[0], p.weight), rational_quotient(p.at[1], p.weight)};
}
inline RationalPoint3 rational(const Weighted<BigDyadic, 3>& p) {
  return {rational_quotient(p.at[0], p.weight), rational_quotient(p.at[1], p.weight),
          rational_quotient(p.at[2], p.weight)};
}

}  // namespace plumb::certify::meeting
