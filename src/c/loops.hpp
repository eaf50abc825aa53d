// What does a handle of loops hold?  Lists of vertices, and what a caller in C sees of them.
//
// Source: none.
// Cost: none.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "c/guarded.hpp"

struct plumb_loops {
  /// The vector's numbers stay where they are when it is moved.
  void add(std::vector<std::uint32_t> vertices, bool is_closed) {
    lists.push_back(std::move(vertices));
    each.push_back({lists.back().data(), lists.back().size(), is_closed});
  }

  std::vector<std::vector<std::uint32_t>> lists;
  std::vector<plumb_loop> each;
};
