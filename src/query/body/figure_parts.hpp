// Which numbers make up a figure, and what are they called?  Of all that are not lists.
//
// Law: each point, vector and number once, in the order of the figure's members.
// Cost: none, where the names are not looked at.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "plumb/arith/point.hpp"

namespace plumb::query {

template <class Numbers>
struct Part {
  std::string_view name;
  const Numbers& numbers;
};
template <class Numbers>
Part(const char*, const Numbers&) -> Part<Numbers>;

template <class Shape>
concept HasRadius = requires(const Shape& s) {
  s.radius;
};

/// Without the radius.
template <class Shape>
constexpr auto core_parts(const Shape& s) {
  if constexpr (requires { s.origin; }) {
    return std::tuple{Part{".origin", s.origin}, Part{".direction", s.direction}};
  } else if constexpr (requires { s.point; }) {
    return std::tuple{Part{".point", s.point}, Part{".direction", s.direction}};
  } else if constexpr (requires { s.normal; }) {
    return std::tuple{Part{".normal", s.normal}, Part{".offset", s.offset}};
  } else if constexpr (requires { s.d; }) {
    return std::tuple{Part{".a", s.a}, Part{".b", s.b}, Part{".c", s.c}, Part{".d", s.d}};
  } else if constexpr (requires { s.c; }) {
    return std::tuple{Part{".a", s.a}, Part{".b", s.b}, Part{".c", s.c}};
  } else if constexpr (requires { s.a; }) {
    return std::tuple{Part{".a", s.a}, Part{".b", s.b}};
  } else if constexpr (requires {
                         requires std::tuple_size_v<decltype(s.axes)>
                         == 3;
                       }) {
    return std::tuple{Part{".center", s.center}, Part{".axes[0]", s.axes[0]}, Part{".axes[1]", s.axes[1]},
                      Part{".axes[2]", s.axes[2]}, Part{".half", s.half}};
  } else if constexpr (requires { s.axes; }) {
    return std::tuple{Part{".center", s.center}, Part{".axes[0]", s.axes[0]}, Part{".axes[1]", s.axes[1]},
                      Part{".half", s.half}};
  } else if constexpr (requires { s.center; }) {
    return std::tuple{Part{".center", s.center}};
  } else if constexpr (requires { s.min; }) {
    return std::tuple{Part{".min", s.min}, Part{".max", s.max}};
  } else if constexpr (requires { s.corner; }) {
    return std::tuple{Part{".corner", s.corner}, Part{".edges[0]", s.edges[0]}, Part{".edges[1]", s.edges[1]}};
  } else if constexpr (requires { s.apex; }) {
    return std::tuple{Part{".apex", s.apex}, Part{".base", s.base}};
  } else {
    return std::tuple{Part{"", s}};  // a point
  }
}

template <class Shape>
constexpr auto parts(const Shape& s) {
  if constexpr (HasRadius<Shape>) {
    return std::tuple_cat(core_parts(s), std::tuple{Part{".radius", s.radius}});
  } else {
    return core_parts(s);
  }
}

}  // namespace plumb::query
