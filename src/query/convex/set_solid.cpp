// Boxes, tetrahedra and polyhedra as what bounds them.
#include "plumb/predicates.hpp"
#include "query/convex/set_parts.hpp"

namespace plumb::query::meeting {
namespace {

template <std::size_t N>
Bound<N> up_to(std::size_t axis, double offset, int side) {
  Bound<N> bound{Bound<N>::Kind::axis, side};
  bound.axis = axis;
  bound.offset = offset;
  return bound;
}

/// On the side of the plane abc where `inside` is.
Bound<3> face(const Point3& a, const Point3& b, const Point3& c, const Point3& inside) {
  Bound<3> bound{Bound<3>::Kind::face, 0};
  bound.a = a, bound.b = b, bound.c = c;
  bound.side = -static_cast<int>(value_sign(bound, inside));
  return bound;
}

/// Counterclockwise from outside: the value is positive below, where the inside is.
Bound<3> face_of(const PolygonMesh& mesh, std::size_t f) {
  const auto corner = [&](std::size_t i) -> const Point3& { return mesh.vertices[mesh.corners[i]]; };
  const std::size_t first = mesh.first[f];
  std::size_t b = first + 1;
  while (corner(b) == corner(first)) ++b;
  std::size_t c = b + 1;
  while (collinear(corner(first), corner(b), corner(c))) ++c;
  Bound<3> bound{Bound<3>::Kind::face, -1};
  bound.a = corner(first), bound.b = corner(b), bound.c = corner(c);
  return bound;
}

}  // namespace

ConvexSet<2> convex_set(const Aabb2& box) {
  const auto& [a, b] = box;
  ConvexSet<2> set;
  if (a.x > b.x || a.y > b.y) return set;
  if (a.x == b.x || a.y == b.y) return segment_set<2>(a, b);
  set.dimension = 2;
  set.vertices = {a, {b.x, a.y}, b, {a.x, b.y}};
  set.edges = {{.from = 0, .to = 1}, {.from = 1, .to = 2}, {.from = 2, .to = 3}, {.from = 3, .to = 0}};
  set.bounds = {up_to<2>(1, a.y, -1), up_to<2>(0, b.x, 1), up_to<2>(1, b.y, 1), up_to<2>(0, a.x, -1)};
  set.first_side = 0;
  return set;
}

ConvexSet<3> convex_set(const Aabb3& box) {
  const auto& [a, b] = box;
  ConvexSet<3> set;
  if (a.x > b.x || a.y > b.y || a.z > b.z) return set;
  set.vertices.reserve(8);
  set.edges.reserve(12);
  set.bounds.reserve(6);
  for (unsigned k = 0; k < 8; ++k) {
    set.vertices.push_back({(k & 1) != 0 ? b.x : a.x, (k & 2) != 0 ? b.y : a.y, (k & 4) != 0 ? b.z : a.z});
  }
  if (a.x == b.x || a.y == b.y || a.z == b.z) return flat_set(set.vertices);
  set.dimension = 3;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    set.bounds.push_back(up_to<3>(axis, part(a, axis), -1));
    set.bounds.push_back(up_to<3>(axis, part(b, axis), 1));
    for (int k = 0; k < 8; ++k) {
      if ((k & 1 << axis) == 0) set.edges.push_back({.from = k, .to = k | 1 << axis});
    }
  }
  return set;
}

ConvexSet<3> convex_set(const Tetrahedron3& t) {
  const auto& [a, b, c, d] = t;
  const std::array<Point3, 4> corners{a, b, c, d};
  if (orient3d(a, b, c, d) == Sign::zero) return flat_set(corners);
  ConvexSet<3> set;
  set.dimension = 3;
  set.vertices.assign(corners.begin(), corners.end());
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) set.edges.push_back({.from = i, .to = j});
  }
  set.bounds = {face(b, c, d, a), face(a, c, d, b), face(a, b, d, c), face(a, b, c, d)};
  return set;
}

ConvexSet<3> convex_set(const ConvexPolyhedron3& polyhedron) {
  const PolygonMesh& mesh = polyhedron.mesh;
  ConvexSet<3> set;
  set.dimension = 3;
  set.vertices = mesh.vertices;
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
    set.bounds.push_back(face_of(mesh, f));
    std::uint32_t from = mesh.corners[mesh.first[f + 1] - 1];
    for (std::size_t i = mesh.first[f]; i < mesh.first[f + 1]; ++i) {
      const std::uint32_t to = mesh.corners[i];
      if (from < to) set.edges.push_back({.from = static_cast<int>(from), .to = static_cast<int>(to)});
      from = to;
    }
  }
  return set;
}

}  // namespace plumb::query::meeting
