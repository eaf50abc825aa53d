// Who wants to know how much a search looks at?  As a rule nobody, at no cost.
//
// Law: a watch changes no answer.
// Cost: none of Unwatched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace plumb::space {

/// Told of each node's box and of each triangle that a search asks.
struct Unwatched {
  void node() const {}
  void triangle() const {}
};

/// Counts into what stays.
struct Counted {
  std::size_t *nodes, *triangles;
  void node() const { ++*nodes; }
  void triangle() const { ++*triangles; }
};

/// A guess that is none.
inline constexpr std::uint32_t no_slot = std::numeric_limits<std::uint32_t>::max();

}  // namespace plumb::space
