// How does one formula serve points with and without a weight?  Numbers that vanish when compiled.
//
// A point as given has the weight TagOne and the offset TagZero.  They are types, not values: a product with TagOne is
// its other factor, a sum with TagZero its other term, and neither leaves an operation behind.
// Laws: those of 1 and 0.  What would need a negation (TagZero - x) or a sum of ones does not compile: formulas are
// written so that it does not occur.
// Source: docs/proof.md, "Weights".
// Cost: none.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb::predicates {

struct TagZero {};
struct TagOne {};

template <class T>
constexpr T operator*(const T& x, TagOne) {
  return x;
}
template <class T>
constexpr T operator*(TagOne, const T& x) {
  return x;
}
template <class T>
constexpr TagZero operator*(const T&, TagZero) {
  return {};
}
template <class T>
constexpr TagZero operator*(TagZero, const T&) {
  return {};
}
template <class T>
constexpr T operator+(const T& x, TagZero) {
  return x;
}
template <class T>
constexpr T operator+(TagZero, const T& x) {
  return x;
}
template <class T>
constexpr T operator-(const T& x, TagZero) {
  return x;
}

constexpr TagOne operator*(TagOne, TagOne) { return {}; }
constexpr TagZero operator*(TagOne, TagZero) { return {}; }
constexpr TagZero operator*(TagZero, TagOne) { return {}; }
constexpr TagZero operator*(TagZero, TagZero) { return {}; }
constexpr TagZero operator+(TagZero, TagZero) { return {}; }
constexpr TagZero operator-(TagZero, TagZero) { return {}; }

}  // namespace plumb::predicates
