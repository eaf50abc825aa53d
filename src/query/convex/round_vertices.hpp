// Which vertices has the core of a round shape, as numbers with their rounding?  For guesses in doubles and their proofs.
//
// Laws: the hull of the exact vertices is the core; those that are input have no error.
// Source: none.
// Cost: none for vertices that are given.
#pragma once

#include <array>

#include "arith/running_error.hpp"
#include "query/body/boundary.hpp"

namespace plumb::query {

/// A vertex, of which a coordinate may be rounded.
using Vertex = arith::Vec<Running>;
inline arith::Plain plain(const Vertex& v) { return {v.x.value, v.y.value, v.z.value}; }
inline Vertex vertex(const Point3& p) { return arith::vec<Running>(p); }
inline Vertex vertex(const Vector3& v) { return arith::vec<Running>(v); }

template <class Round>
inline constexpr std::size_t vertex_count = figure_kind<Round> == FigureKind::ball      ? 1
                                            : figure_kind<Round> == FigureKind::capsule ? 2
                                                                                        : 4;

template <class Round>
std::array<Vertex, vertex_count<Round>> vertices(const Round& s) {
  std::array<Vertex, vertex_count<Round>> all;
  auto next = all.begin();
  for_each_corner<Running>(s, [&](const Vertex& p) { *next++ = p; });
  return all;
}

}  // namespace plumb::query
