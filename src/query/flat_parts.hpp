// Which numbers make up a figure, and what are they called?  For all figures with straight edges and flat faces.
//
// each_part(shape, f) calls f({before, index, after}, coordinates) for each point, vector and number; a part of a list
// is named before[index]after.
// Cost: that of f.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "plumb/certify/sign_of.hpp"
#include "plumb/query/pairs.hpp"

namespace plumb::query {

struct PartName {
  std::string_view before;
  std::size_t index = static_cast<std::size_t>(-1);
  std::string_view after = {};

  [[nodiscard]] std::string text() const {
    std::string s(before);
    if (index != static_cast<std::size_t>(-1)) s.append("[").append(std::to_string(index)).append("]");
    return s.append(after);
  }
};

template <class Shape, class F>
void each_part(const Shape& s, F f) {
  const auto part = [&f](std::string_view name, const auto& x) { f(PartName{name}, coordinates(x)); };
  if constexpr (requires { s.direction; }) {
    if constexpr (requires { s.origin; }) {
      part(".origin", s.origin);
    } else {
      part(".point", s.point);
    }
    part(".direction", s.direction);
  } else if constexpr (requires { s.normal, s.offset; }) {
    part(".normal", s.normal), part(".offset", s.offset);
  } else if constexpr (requires { s.halfspaces; }) {
    for (std::size_t i = 0; i < s.halfspaces.size(); ++i) {
      f(PartName{".halfspaces", i, ".normal"}, coordinates(s.halfspaces[i].normal));
      f(PartName{".halfspaces", i, ".offset"}, coordinates(s.halfspaces[i].offset));
    }
  } else if constexpr (requires { s.a, s.b; }) {
    part(".a", s.a), part(".b", s.b);
    if constexpr (requires { s.c; }) part(".c", s.c);
    if constexpr (requires { s.d; }) part(".d", s.d);
  } else if constexpr (requires { s.axes, s.half; }) {
    part(".center", s.center);
    for (std::size_t i = 0; i < s.axes.size(); ++i) f(PartName{".axes", i}, coordinates(s.axes[i]));
    part(".half", s.half);
  } else if constexpr (requires { s.directions; }) {
    for (std::size_t i = 0; i < s.min.size(); ++i) f(PartName{".min", i}, coordinates(s.min[i]));
    for (std::size_t i = 0; i < s.max.size(); ++i) f(PartName{".max", i}, coordinates(s.max[i]));
  } else if constexpr (requires { s.min, s.max; }) {
    part(".min", s.min), part(".max", s.max);
  } else if constexpr (requires { s.mesh; }) {
    for (std::size_t i = 0; i < s.mesh.vertices.size(); ++i)
      f(PartName{".mesh.vertices", i}, coordinates(s.mesh.vertices[i]));
  } else if constexpr (requires { s.vertices; }) {
    for (std::size_t i = 0; i < s.vertices.size(); ++i) f(PartName{".vertices", i}, coordinates(s.vertices[i]));
  } else if constexpr (requires { s.outer, s.holes; }) {
    for (std::size_t i = 0; i < s.outer.vertices.size(); ++i)
      f(PartName{".outer.vertices", i}, coordinates(s.outer.vertices[i]));
    for (std::size_t k = 0; k < s.holes.size(); ++k) {
      for (const auto& p : s.holes[k].vertices) f(PartName{".holes", k, ".vertices"}, coordinates(p));
    }
  } else {
    part("", s);  // a point
  }
}

}  // namespace plumb::query
