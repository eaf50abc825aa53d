// Do two arrays that belong together have as many items?  By name where they do not.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "plumb/arith/error.hpp"

namespace plumb::space {

/// Throws UnequalLengths: "refit: vertices has 2 items, bvh.vertices has 3".
inline void require_equal_lengths(std::string_view function, std::string_view one, std::size_t n,
                                  std::string_view other, std::size_t m) {
  if (n == m) return;
  throw UnequalLengths(std::string(function)
                           .append(": ")
                           .append(one)
                           .append(" has ")
                           .append(std::to_string(n))
                           .append(" items, ")
                           .append(other)
                           .append(" has ")
                           .append(std::to_string(m)));
}

}  // namespace plumb::space
