// Which vertices has a convex shape, as numbers with their rounding, or exactly?  For guesses in doubles and their proofs.
//
// Laws: the hull of the exact vertices is the shape, or its core where it is round; those that are input have no error.
// An empty box has vertices here, though it is empty: who asks looks first.
// Cost: none for vertices that are given; some 100 operations for a box with axes.
#pragma once

#include <array>
#include <vector>

#include "query/body/boundary.hpp"
#include "query/convex/near_pair.hpp"

namespace plumb::query {

inline Vertex vertex(const Point3& p) { return arith::vec<Running>(p); }
inline Vertex vertex(const Vector3& v) { return arith::vec<Running>(v); }

template <class Shape>
inline constexpr std::size_t vertex_count = 8;  // of a box
template <>
inline constexpr std::size_t vertex_count<Point3> = 1;
template <>
inline constexpr std::size_t vertex_count<Sphere3> = 1;
template <>
inline constexpr std::size_t vertex_count<Segment3> = 2;
template <>
inline constexpr std::size_t vertex_count<Capsule3> = 2;
template <>
inline constexpr std::size_t vertex_count<Triangle3> = 3;
template <>
inline constexpr std::size_t vertex_count<Tetrahedron3> = 4;
template <>
inline constexpr std::size_t vertex_count<Rectangle3> = 4;
template <>
inline constexpr std::size_t vertex_count<Lozenge3> = 4;

template <class T = Running, class Shape>
std::array<arith::Vec<T>, vertex_count<Shape>> vertices(const Shape& s) {
  std::array<arith::Vec<T>, vertex_count<Shape>> all;
  auto next = all.begin();
  for_each_corner<T>(s, [&](const arith::Vec<T>& p) { *next++ = p; });
  return all;
}
template <class T = Running>
std::vector<arith::Vec<T>> vertices(const ConvexPolyhedron3& polyhedron) {
  std::vector<arith::Vec<T>> all;
  all.reserve(polyhedron.mesh.vertices.size());
  for_each_corner<T>(polyhedron, [&](const arith::Vec<T>& p) { all.push_back(p); });
  return all;
}

}  // namespace plumb::query
