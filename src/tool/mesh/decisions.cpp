#include "tool/mesh/decisions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "plumb/predicates.hpp"

namespace plumb::tool {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

struct Box {
  std::array<double, 3> min, max;
};

double coordinate(const Point3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

void set_coordinate(Point3& p, std::size_t axis, double x) { (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = x; }

Box box_of(std::span<const Point3> points) {
  Box box{{points[0].x, points[0].y, points[0].z}, {points[0].x, points[0].y, points[0].z}};
  for (const Point3& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], coordinate(p, axis));
      box.max[axis] = std::max(box.max[axis], coordinate(p, axis));
    }
  }
  return box;
}

// The corners of the box and eight vertices spread over the list: points outside, inside and on the surface.
std::vector<Point3> fixed_points(std::span<const Point3> vertices, const Box& box) {
  std::vector<Point3> fixed;
  for (unsigned i = 0; i < 8; ++i) {
    const auto side = [&](unsigned axis) { return (i >> axis & 1) != 0 ? box.max[axis] : box.min[axis]; };
    fixed.push_back({side(0), side(1), side(2)});
  }
  for (std::size_t i = 0; i < 8; ++i) fixed.push_back(vertices[i * (vertices.size() - 1) / 7]);
  return fixed;
}

// A point beside the plane of a, b, c: a moved along an axis along which the triangle is seen as an area.  Any sphere
// through a, b, c cuts their plane in their circle, so any such point serves.  None for collinear points.
std::optional<Point3> off_plane(const Point3& a, const Point3& b, const Point3& c, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto seen = [&](const Point3& p) {
      return Point2{coordinate(p, (axis + 1) % 3), coordinate(p, (axis + 2) % 3)};
    };
    if (orient2d(seen(a), seen(b), seen(c)) == Sign::zero) continue;
    Point3 off = a;
    const double x = coordinate(a, axis);
    const double other = x == box.max[axis] ? box.min[axis] : box.max[axis];
    set_coordinate(off, axis, other != x ? other : std::fabs(x) > 1 ? x / 2 : x + 1);
    return off;
  }
  return std::nullopt;
}

std::size_t corner_of(const TriangleMesh::Triangle& t, std::uint32_t vertex) {
  return static_cast<std::size_t>(std::ranges::find(t, vertex) - t.begin());
}

// For each face and corner the vertex beyond the opposite edge.
std::vector<TriangleMesh::Triangle> beyond_edges(const TriangleMesh& mesh, std::span<const InteriorEdge> edges) {
  std::vector<TriangleMesh::Triangle> beyond(mesh.triangles.size(), TriangleMesh::Triangle{none, none, none});
  for (const InteriorEdge& e : edges) {
    beyond[e.face_c][corner_of(mesh.triangles[e.face_c], e.c)] = e.d;
    beyond[e.face_d][corner_of(mesh.triangles[e.face_d], e.d)] = e.c;
  }
  return beyond;
}

// A vertex beside the two faces of an edge: beyond one of their four outer edges.
std::uint32_t next_neighbor(const TriangleMesh& mesh, std::span<const TriangleMesh::Triangle> beyond,
                            const InteriorEdge& e) {
  for (const std::uint32_t face : {e.face_c, e.face_d}) {
    for (const std::uint32_t corner : {e.a, e.b}) {
      const std::uint32_t v = beyond[face][corner_of(mesh.triangles[face], corner)];
      if (v != none && v != e.c && v != e.d) return v;
    }
  }
  return none;
}

}  // namespace

MeshDecisions::MeshDecisions(const TriangleMesh& mesh, const MeshEdges& edges)
    : mesh_(mesh), edges_(interior_edges(edges)) {
  const Box box = box_of(mesh.vertices);
  fixed_ = fixed_points(mesh.vertices, box);
  const std::vector<TriangleMesh::Triangle> beyond = beyond_edges(mesh, edges_);
  const auto& v = mesh.vertices;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const InteriorEdge& e = edges_[i];
    const Sign bend = orient3d(v[e.a], v[e.b], v[e.c], v[e.d]);
    ++(bend == Sign::positive ? answers_.convex : bend == Sign::zero ? answers_.flat : answers_.reflex);
    if (bend == Sign::zero) {
      if (const auto off = off_plane(v[e.a], v[e.b], v[e.c], box)) flat_.push_back({i, *off});
    } else if (const std::uint32_t next = next_neighbor(mesh, beyond, e); next != none) {
      bent_.push_back({i, next});
    }
  }
}

Lattice MeshDecisions::lattice() const {
  ExponentSpan span;
  const auto include = [&](const Point3& p) {
    for (const double x : {p.x, p.y, p.z}) span.include(odd_form(x));
  };
  for (const Point3& p : mesh_.vertices) include(p);
  for (const FlatEdge& e : flat_) include(e.off);
  return span.lattice();
}

std::uint64_t MeshDecisions::count(Kind kind) const {
  switch (kind) {
    case Kind::edge_delaunay_flat:
      return flat_.size();
    case Kind::edge_delaunay:
      return bent_.size();
    case Kind::face_side:
      return mesh_.triangles.size() * fixed_.size();
    case Kind::orient_yz:
    case Kind::orient_zx:
    case Kind::orient_xy:
      return mesh_.triangles.size();
    default:
      return edges_.size();
  }
}

std::array<Point3, 5> MeshDecisions::points(Kind kind, std::uint64_t i) const {
  const auto& v = mesh_.vertices;
  switch (kind) {
    case Kind::edge_delaunay_flat: {
      const InteriorEdge& e = edges_[flat_[i].edge];
      return {v[e.a], v[e.b], v[e.c], flat_[i].off, v[e.d]};
    }
    case Kind::edge_delaunay: {
      const InteriorEdge& e = edges_[bent_[i].edge];
      return {v[e.a], v[e.b], v[e.c], v[e.d], v[bent_[i].next]};
    }
    case Kind::face_side: {
      const TriangleMesh::Triangle& t = mesh_.triangles[i / fixed_.size()];
      return {v[t[0]], v[t[1]], v[t[2]], fixed_[i % fixed_.size()]};
    }
    case Kind::orient_yz:
    case Kind::orient_zx:
    case Kind::orient_xy: {
      const TriangleMesh::Triangle& t = mesh_.triangles[i];
      return {v[t[0]], v[t[1]], v[t[2]]};
    }
    case Kind::edge_coplanar: {
      const InteriorEdge& e = edges_[i];
      return {v[e.c], v[e.d], v[e.a], v[e.b]};
    }
    default: {
      const InteriorEdge& e = edges_[i];
      return {v[e.a], v[e.b], v[e.c], v[e.d]};
    }
  }
}

}  // namespace plumb::tool
