// What sign has a + b sqrt(c), or a + b sqrt(c) + d sqrt(e)?  The polynomials that decide when the signs of the terms
// do not.
//
// x + y with x and y of opposite signs has the sign of x times that of x^2 - y^2.  For x = a, y = b sqrt(c) that is
// a^2 - b^2 c.  For x = a + b sqrt(c), y = d sqrt(e) it is a radical again,
//   (a^2 + b^2 c - d^2 e) + 2 a b sqrt(c).
// Laws: the signs of b and d change nothing in these polynomials; scaling a, b and d by one power of two scales them.
// Source: RTCD 4.3 (radii); the repeated squaring is classical.  The terms differ in degree.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/standard.hpp"

namespace plumb::predicates {

/// A factor that is not there.
struct One {
  template <class Input>
  constexpr One operator()(const Input&) const {
    return {};
  }
  friend constexpr One operator*(One, One) { return {}; }
  template <class T>
  friend constexpr T operator*(One, const T& x) {
    return x;
  }
  template <class T>
  friend constexpr T operator*(const T& x, One) {
    return x;
  }
};

template <class A, class B, class C>
constexpr auto radical_norm(const A& a, const B& b, const C& c) {
  return a * a - b * b * c;
}

/// The rational part of (a + b sqrt(c))^2 - d^2 e.
template <class A, class B, class C, class D, class E>
constexpr auto radical_pair_part(const A& a, const B& b, const C& c, const D& d, const E& e) {
  return (a * a + b * b * c) - d * d * e;
}

/// The product of a + b sqrt(c) + d sqrt(e) over both signs of both roots.
template <class A, class B, class C, class D, class E>
constexpr auto radical_pair_norm(const A& a, const B& b, const C& c, const D& d, const E& e) {
  const auto ab = a * b;
  return radical_norm(radical_pair_part(a, b, c, d, e), ab + ab, c);
}

/// (a, b, c): a^2 - b^2 c.
struct RadicalNorm {
  static constexpr std::string_view name = "radical_norm";
  static constexpr std::array arguments{1, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
    return radical_norm(p[0], p[1], p[2]);
  }
};

/// (a, b, c, d, e): a^2 + b^2 c - d^2 e.
struct RadicalPairPart {
  static constexpr std::string_view name = "radical_pair_part";
  static constexpr std::array arguments{1, 1, 1, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 5>& p) const {
    return radical_pair_part(p[0], p[1], p[2], p[3], p[4]);
  }
};

/// (a, b, c, d, e): (a^2 + b^2 c - d^2 e)^2 - 4 a^2 b^2 c.
struct RadicalPairNorm {
  static constexpr std::string_view name = "radical_pair_norm";
  static constexpr std::array arguments{1, 1, 1, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 5>& p) const {
    return radical_pair_norm(p[0], p[1], p[2], p[3], p[4]);
  }
};

}  // namespace plumb::predicates
