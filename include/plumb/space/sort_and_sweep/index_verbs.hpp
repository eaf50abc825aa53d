// The verbs of indexes that hold what is put into them: one spelling for any of them, the index first.
//
//   const auto handle = insert(index, box);      move(index, handle, there);      remove(index, handle);
//   in_box(index, box), overlapping_pairs(index), memory_of(index), first_hit(index, ray)
//
// BoxStore (grids, loose octrees, sorted lists) and MovingBoxes have them as members; what is built from a span (build_*) is asked by
// functions of the same names, so that generic code asks any index.
// Laws: those of the member, which is called with what is given.
// Source: none.
// Cost: that of the member.  Nothing is searched.
#pragma once

#include <cstddef>
#include <utility>

#include "plumb/predicates/standard.hpp"

namespace plumb {

template <class Index, class Box>
requires requires(Index& index, const Box& box) { index.insert(box); }
decltype(auto) insert(Index& index, const Box& box) { return index.insert(box); }

template <class Index, class Handle, class Box>
requires requires(Index& index, const Handle& handle, const Box& box) { index.move(handle, box); }
void move(Index& index, const Handle& handle, const Box& box) { index.move(handle, box); }

template <class Index, class Handle>
requires requires(Index& index, const Handle& handle) { index.remove(handle); }
void remove(Index& index, const Handle& handle) { index.remove(handle); }

template <class Index, class... Options>
requires requires(const Index& index, Options&&... options) {
  index.overlapping_pairs(std::forward<Options>(options)...);
}
auto overlapping_pairs(const Index& index, Options&&... options) {
  return index.overlapping_pairs(std::forward<Options>(options)...);
}

template <class Index, class Box, class... Options>
requires requires(const Index& index, const Box& box, Options&&... options) {
  index.in_box(box, std::forward<Options>(options)...);
}
auto in_box(const Index& index, const Box& box, Options&&... options) {
  return index.in_box(box, std::forward<Options>(options)...);
}

template <class Index, class Ray>
requires requires(const Index& index, const Ray& ray) { index.first_hit(ray); }
auto first_hit(const Index& index, const Ray& ray) { return index.first_hit(ray); }

/// Bytes that it keeps.
template <class Index>
requires requires(const Index& index) { index.memory(); }
std::size_t memory_of(const Index& index) { return index.memory(); }

}  // namespace plumb
