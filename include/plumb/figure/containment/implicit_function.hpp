// Implicit surface: where does a point lie to the shape that a polynomial says: all points with f <= 0?
//
//   const auto torus = implicit_shape3([](auto x, auto y, auto z, auto major, auto minor) {
//     const auto s = x * x + y * y + z * z + major * major - minor * minor;
//     const auto d = major + major;
//     return s * s - (x * x + y * y) * (d * d);
//   }, 3.0, 1.0);
//   contains(torus, Point3{4, 0, 0})
//
// The polynomial is a lambda without captures that takes the coordinates and then the parameters, each as an argument
// of its own, and uses + - * only: no constants, which are parameters as well.
// Laws: (1) inside where f < 0, boundary where f = 0, outside where f > 0, exactly.  (2) What is inside has a ball
// around it in the set.  The converse holds where the gradient is not zero on the surface f = 0: a point of it that is
// a maximum of f, such as any of f = -x x at x = 0, is called boundary though all around it is in the set.
// A number that is NaN or infinite throws NonFinite.
// Source: RTCD 2.2.1.
// Cost: that of sign_of for the polynomial.  Nothing is searched.
#pragma once

#include <array>
#include <concepts>

#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

/// All p with polynomial(p, parameters...) <= 0.
template <class Polynomial, std::size_t N = 0>
struct ImplicitShape2 {
  std::array<double, N> parameters;
};
template <class Polynomial, std::size_t N = 0>
struct ImplicitShape3 {
  std::array<double, N> parameters;
};

template <class Polynomial, std::convertible_to<double>... Parameters>
constexpr ImplicitShape2<Polynomial, sizeof...(Parameters)> implicit_shape2(Polynomial, Parameters... parameters) {
  return {{static_cast<double>(parameters)...}};
}
template <class Polynomial, std::convertible_to<double>... Parameters>
constexpr ImplicitShape3<Polynomial, sizeof...(Parameters)> implicit_shape3(Polynomial, Parameters... parameters) {
  return {{static_cast<double>(parameters)...}};
}

namespace figure::implicit_function {

/// "parameters[0]" and so on.
template <std::size_t N>
struct ParameterNames {
  std::array<std::array<char, 24>, N> text{};
  std::array<std::size_t, N> length{};

  constexpr ParameterNames() {
    for (std::size_t i = 0; i < N; ++i) {
      const auto put = [&](char c) { text[i][length[i]++] = c; };
      for (const char c : std::string_view("parameters[")) put(c);
      std::size_t unit = 1;
      while (i / unit >= 10) unit *= 10;
      for (; unit > 0; unit /= 10) put(static_cast<char>('0' + i / unit % 10));
      put(']');
    }
  }
};
template <std::size_t N>
inline constexpr ParameterNames<N> parameter_names;

/// As sign_of takes it, with names for the refusal of numbers.
template <class Polynomial, int Dimension, std::size_t N>
struct Formula : FormulaOf<Polynomial, std::array<double, Dimension>, std::array<double, N>>::Type {
  static constexpr std::string_view name = "contains";
  static constexpr auto arguments = [] {
    std::array<int, N + 1> counts{};
    counts.fill(1);
    counts[0] = Dimension;
    return counts;
  }();
  static constexpr auto argument_names = [] {
    std::array<std::string_view, N + 1> names{"p"};
    for (std::size_t i = 0; i < N; ++i) {
      const auto& [text, length] = parameter_names<N>;
      names[i + 1] = {text[i].data(), length[i]};
    }
    return names;
  }();
};

template <class Polynomial, class Point, std::size_t N>
Location locate(const std::array<double, N>& parameters, const Point& p) {
  using F = Formula<Polynomial, coordinate_count<Point>, N>;
  return static_cast<Location>(-static_cast<int>(sign_of(F{}, p, parameters)));
}

}  // namespace figure::implicit_function

template <class Polynomial, std::size_t N>
Location locate(const ImplicitShape2<Polynomial, N>& shape, const Point2& p) {
  return figure::implicit_function::locate<Polynomial>(shape.parameters, p);
}
template <class Polynomial, std::size_t N>
Location locate(const ImplicitShape3<Polynomial, N>& shape, const Point3& p) {
  return figure::implicit_function::locate<Polynomial>(shape.parameters, p);
}

template <class Polynomial, std::size_t N>
bool contains(const ImplicitShape2<Polynomial, N>& shape, const Point2& p) {
  return locate(shape, p) != Location::outside;
}
template <class Polynomial, std::size_t N>
bool contains(const ImplicitShape3<Polynomial, N>& shape, const Point3& p) {
  return locate(shape, p) != Location::outside;
}

}  // namespace plumb
