// How does one formula serve points with and without a weight?  Numbers that vanish when compiled.
//
// A point as given has the weight One and the offset Zero.  They are types, not values: a product with One is its other
// factor, a sum with Zero its other term, and neither leaves an operation behind.
// Laws: those of 1 and 0.  What would need a negation (Zero - x) or a sum of ones does not compile: formulas are
// written so that it does not occur. Source: docs/proof.md, "Weights".  Cost: none.
#pragma once

namespace plumb::predicates {

struct Zero {};
struct One {};

template <class T>
constexpr T operator*(const T& x, One) {
  return x;
}
template <class T>
constexpr T operator*(One, const T& x) {
  return x;
}
template <class T>
constexpr Zero operator*(const T&, Zero) {
  return {};
}
template <class T>
constexpr Zero operator*(Zero, const T&) {
  return {};
}
template <class T>
constexpr T operator+(const T& x, Zero) {
  return x;
}
template <class T>
constexpr T operator+(Zero, const T& x) {
  return x;
}
template <class T>
constexpr T operator-(const T& x, Zero) {
  return x;
}

constexpr One operator*(One, One) { return {}; }
constexpr Zero operator*(One, Zero) { return {}; }
constexpr Zero operator*(Zero, One) { return {}; }
constexpr Zero operator*(Zero, Zero) { return {}; }
constexpr Zero operator+(Zero, Zero) { return {}; }
constexpr Zero operator-(Zero, Zero) { return {}; }

}  // namespace plumb::predicates
