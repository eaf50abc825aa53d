// Of two figures whose boxes meet: do they have a point in common, or overlap?
#pragma once

#include <type_traits>

#include "plumb/query/overlap/overlap.hpp"

namespace plumb::space::kd {

/// As of intersects; without touching as of relate.
template <class A, class B>
bool figures_meet(const A& a, const B& b, bool touching) {
  if (!touching) return relate(a, b) == Relation::overlapping;
  if constexpr (std::is_same_v<A, B> && (std::is_same_v<A, Aabb2> || std::is_same_v<A, Aabb3>)) {
    return true;  // it is what their boxes do
  } else {
    return intersects(a, b);
  }
}

}  // namespace plumb::space::kd
