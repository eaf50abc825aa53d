// Which numbers does a shape hold, and what are they called?  For exceptions that name the part.
//
// Cost: one subtraction for each number.
#pragma once

#include <bit>
#include <string>

#include "overlap_signs.hpp"
#include "plumb/figure/box.hpp"
#include "plumb/figure/linear.hpp"
#include "plumb/figure/plane.hpp"
#include "plumb/figure/simplex.hpp"

namespace plumb::query {

/// Throws NonFinite naming the function relate, the shape by `which`, and the part: "relate: a.min.y is nan, ...".
template <class Shape>
void require_shape(std::string_view which, const Shape& s) {
  const auto look = [&](const auto&... named) {
    const auto require = [&](std::string_view part, const auto& numbers) {
      const std::string name = std::string(which).append(part);
      require_numbers(Names<1>{name}, numbers);
    };
    const auto pair = [&](const auto& p) { require(p.first, p.second); };
    (pair(named), ...);
  };
  const auto part = [](std::string_view name, const auto& numbers) { return std::pair(name, numbers); };
  if constexpr (requires { s.point; }) {
    look(part(".point", s.point), part(".direction", s.direction));
  } else if constexpr (requires { s.origin; }) {
    look(part(".origin", s.origin), part(".direction", s.direction));
  } else if constexpr (requires { s.axes; }) {
    look(part(".center", s.center), part(".axes[0]", s.axes[0]), part(".axes[1]", s.axes[1]),
         part(".axes[2]", s.axes[2]), part(".half", s.half));
  } else if constexpr (requires { s.normal; }) {
    look(part(".normal", s.normal), part(".offset", s.offset));
  } else if constexpr (requires { s.min; }) {
    look(part(".min", s.min), part(".max", s.max));
  } else if constexpr (requires { s.d; }) {
    look(part(".a", s.a), part(".b", s.b), part(".c", s.c), part(".d", s.d));
  } else if constexpr (requires { s.c; }) {
    look(part(".a", s.a), part(".b", s.b), part(".c", s.c));
  } else if constexpr (requires { s.a; }) {
    look(part(".a", s.a), part(".b", s.b));
  } else {
    look(part("", s));
  }
}

/// Zero where all numbers are real, NaN otherwise.
template <class Shape>
double not_real(const Shape& s) {
  static_assert(sizeof(Shape) % sizeof(double) == 0);
  double zero = 0;
  for (const double x : std::bit_cast<std::array<double, sizeof(Shape) / sizeof(double)>>(s)) zero += x - x;
  return zero;
}

template <class A, class B>
void require_shapes(const A& a, const B& b) {
  if (not_real(a) + not_real(b) == 0) [[likely]]
    return;
  require_shape("a", a);
  require_shape("b", b);
}

}  // namespace plumb::query
