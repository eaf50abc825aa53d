// Which vertices has a convex shape, as numbers with their rounding?  For guesses in doubles and their proofs.
//
// Laws: the hull of the exact vertices is the shape, or its core where it is round; those that are input have no error.
// An empty box has vertices here, though it is empty: who asks looks first.
// Cost: none for vertices that are given; some 100 operations for a box with axes.
#pragma once

#include <array>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "query/convex/near_pair.hpp"

namespace plumb::query {

inline Vertex vertex(const Point3& p) { return arith::vec<Running>(p); }
inline Vertex vertex(const Vector3& v) { return arith::vec<Running>(v); }

inline std::array<Vertex, 1> vertices(const Point3& p) { return {vertex(p)}; }
inline std::array<Vertex, 2> vertices(const Segment3& s) { return {vertex(s.a), vertex(s.b)}; }
inline std::array<Vertex, 3> vertices(const Triangle3& t) { return {vertex(t.a), vertex(t.b), vertex(t.c)}; }
inline std::array<Vertex, 4> vertices(const Tetrahedron3& t) {
  return {vertex(t.a), vertex(t.b), vertex(t.c), vertex(t.d)};
}
inline std::array<Vertex, 8> vertices(const Aabb3& box) {
  std::array<Vertex, 8> all;
  for (std::size_t i = 0; i < 8; ++i) {
    all[i] = {Running((i & 1) != 0 ? box.max.x : box.min.x), Running((i & 2) != 0 ? box.max.y : box.min.y),
              Running((i & 4) != 0 ? box.max.z : box.min.z)};
  }
  return all;
}

/// corner + any of the edges.
template <std::size_t N>
std::array<Vertex, (std::size_t{1} << N)> vertices(const Vertex& corner, const std::array<Vertex, N>& edges) {
  std::array<Vertex, (std::size_t{1} << N)> all;
  all[0] = corner;
  for (std::size_t k = 0, size = 1; k < N; ++k, size *= 2) {
    for (std::size_t i = 0; i < size; ++i) all[size + i] = all[i] + edges[k];
  }
  return all;
}
/// center - half axes, and from there by twice that along each axis.
template <std::size_t N>
auto vertices(const Point3& center, const std::array<Vector3, N>& axes, const std::array<double, N>& half) {
  std::array<Vertex, N> edges;
  Vertex corner = vertex(center);
  for (std::size_t k = 0; k < N; ++k) {
    const Vertex reach = vertex(axes[k]) * Running(half[k]);
    corner = corner - reach;
    edges[k] = reach + reach;
  }
  return vertices(corner, edges);
}
inline std::array<Vertex, 8> vertices(const Obb3& box) {
  return vertices<3>(box.center, box.axes, {box.half.x, box.half.y, box.half.z});
}
inline std::array<Vertex, 4> vertices(const Rectangle3& r) {
  return vertices<2>(r.center, r.axes, {r.half.x, r.half.y});
}
inline std::vector<Vertex> vertices(const ConvexPolyhedron3& polyhedron) {
  std::vector<Vertex> all;
  all.reserve(polyhedron.mesh.vertices.size());
  for (const Point3& p : polyhedron.mesh.vertices) all.push_back(vertex(p));
  return all;
}

inline std::array<Vertex, 1> vertices(const Sphere3& sphere) { return {vertex(sphere.center)}; }
inline std::array<Vertex, 2> vertices(const Capsule3& capsule) { return {vertex(capsule.a), vertex(capsule.b)}; }
inline std::array<Vertex, 4> vertices(const Lozenge3& l) {
  return vertices<2>(vertex(l.corner), {vertex(l.edges[0]), vertex(l.edges[1])});
}

}  // namespace plumb::query
