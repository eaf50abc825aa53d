// Which vertices has a convex shape, as numbers with their rounding, or exactly?  For guesses in doubles and their proofs.
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

template <class T = Running>
std::array<arith::Vec<T>, 1> vertices(const Point3& p) {
  return {arith::vec<T>(p)};
}
template <class T = Running>
std::array<arith::Vec<T>, 2> vertices(const Segment3& s) {
  return {arith::vec<T>(s.a), arith::vec<T>(s.b)};
}
template <class T = Running>
std::array<arith::Vec<T>, 3> vertices(const Triangle3& t) {
  return {arith::vec<T>(t.a), arith::vec<T>(t.b), arith::vec<T>(t.c)};
}
template <class T = Running>
std::array<arith::Vec<T>, 4> vertices(const Tetrahedron3& t) {
  return {arith::vec<T>(t.a), arith::vec<T>(t.b), arith::vec<T>(t.c), arith::vec<T>(t.d)};
}
template <class T = Running>
std::array<arith::Vec<T>, 8> vertices(const Aabb3& box) {
  std::array<arith::Vec<T>, 8> all;
  for (std::size_t i = 0; i < 8; ++i) {
    all[i] = {T((i & 1) != 0 ? box.max.x : box.min.x), T((i & 2) != 0 ? box.max.y : box.min.y),
              T((i & 4) != 0 ? box.max.z : box.min.z)};
  }
  return all;
}

/// corner + any of the edges.
template <class T, std::size_t N>
std::array<arith::Vec<T>, (std::size_t{1} << N)> vertices(const arith::Vec<T>& corner,
                                                          const std::array<arith::Vec<T>, N>& edges) {
  std::array<arith::Vec<T>, (std::size_t{1} << N)> all;
  all[0] = corner;
  for (std::size_t k = 0, size = 1; k < N; ++k, size *= 2) {
    for (std::size_t i = 0; i < size; ++i) all[size + i] = all[i] + edges[k];
  }
  return all;
}
/// center - half axes, and from there by twice that along each axis.
template <class T, std::size_t N>
auto vertices(const Point3& center, const std::array<Vector3, N>& axes, const std::array<double, N>& half) {
  std::array<arith::Vec<T>, N> edges;
  arith::Vec<T> corner = arith::vec<T>(center);
  for (std::size_t k = 0; k < N; ++k) {
    const arith::Vec<T> reach = arith::vec<T>(axes[k]) * T(half[k]);
    corner = corner - reach;
    edges[k] = reach + reach;
  }
  return vertices(corner, edges);
}
template <class T = Running>
std::array<arith::Vec<T>, 8> vertices(const Obb3& box) {
  return vertices<T, 3>(box.center, box.axes, {box.half.x, box.half.y, box.half.z});
}
template <class T = Running>
std::array<arith::Vec<T>, 4> vertices(const Rectangle3& r) {
  return vertices<T, 2>(r.center, r.axes, {r.half.x, r.half.y});
}
template <class T = Running>
std::vector<arith::Vec<T>> vertices(const ConvexPolyhedron3& polyhedron) {
  std::vector<arith::Vec<T>> all;
  all.reserve(polyhedron.mesh.vertices.size());
  for (const Point3& p : polyhedron.mesh.vertices) all.push_back(arith::vec<T>(p));
  return all;
}

template <class T = Running>
std::array<arith::Vec<T>, 1> vertices(const Sphere3& sphere) {
  return vertices<T>(sphere.center);
}
template <class T = Running>
std::array<arith::Vec<T>, 2> vertices(const Capsule3& capsule) {
  return {arith::vec<T>(capsule.a), arith::vec<T>(capsule.b)};
}
template <class T = Running>
std::array<arith::Vec<T>, 4> vertices(const Lozenge3& l) {
  return vertices<T, 2>(arith::vec<T>(l.corner), {arith::vec<T>(l.edges[0]), arith::vec<T>(l.edges[1])});
}

}  // namespace plumb::query
