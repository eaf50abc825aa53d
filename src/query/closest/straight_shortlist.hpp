// Closest features: which pairs of features can hold the closest points at all?  What plain doubles leave of them.
//
// Laws: what is left out is certain to have no candidate (straight_search.hpp), or one that is farther apart than
// another pair; numbers that are none leave everything in.
// Source: query/closest/straight_search.hpp.
// Cost: below a microsecond for two triangles.
#pragma once

#include <array>

#include "query/closest/straight_body.hpp"

namespace plumb::query {

/// By the places in a body's lists.
struct Shortlist {
  template <class Entry>
  using Table = std::array<std::array<Entry, 3>, 3>;

  Table<bool> vertices, vertex_edge, edge_vertex, edges;  // [of a][of b]
  std::array<bool, 3> vertex_face, edge_face, face_vertex, face_edge;
};
inline constexpr Shortlist everything = [] {
  constexpr std::array<bool, 3> all{true, true, true};
  constexpr Shortlist::Table<bool> pairs{all, all, all};
  return Shortlist{pairs, pairs, pairs, pairs, all, all, all, all};
}();

Shortlist shortlist(const Straight<Point3>& a, const Triangle3& b);
Shortlist shortlist(const Triangle3& a, const Triangle3& b);

}  // namespace plumb::query
