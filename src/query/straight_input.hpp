// Is every number of two straight shapes real?  Their parts by name.
//
// Law: throws NonFinite naming the function, the shape and the part ("distance: a.direction.y is nan, ...").
// Cost: a subtraction and an addition for each number.
#pragma once

#include "figure/finite_parts.hpp"
#include "plumb/figure/linear.hpp"
#include "plumb/figure/simplex.hpp"

namespace plumb::query {

template <class S>
void require_finite_shape(std::string_view function, bool first, const S& s) {
  const auto ask = [&]<std::size_t N>(const std::array<std::string_view, 2 * N>& names, const auto&... parts) {
    std::array<std::string_view, N> own{};
    for (std::size_t i = 0; i < N; ++i) own[i] = names[first ? i : N + i];
    require_finite_parts(function, own, parts...);
  };
  if constexpr (requires {
                  s.direction;
                  s.point;
                }) {
    ask.template operator()<2>({"a.point", "a.direction", "b.point", "b.direction"}, s.point, s.direction);
  } else if constexpr (requires { s.direction; }) {
    ask.template operator()<2>({"a.origin", "a.direction", "b.origin", "b.direction"}, s.origin, s.direction);
  } else if constexpr (requires { s.c; }) {
    ask.template operator()<3>({"a.a", "a.b", "a.c", "b.a", "b.b", "b.c"}, s.a, s.b, s.c);
  } else {
    ask.template operator()<2>({"a.a", "a.b", "b.a", "b.b"}, s.a, s.b);
  }
}

template <class A, class B>
void require_finite_shapes(std::string_view function, const A& a, const B& b) {
  require_finite_shape(function, true, a);
  require_finite_shape(function, false, b);
}

}  // namespace plumb::query
