// Separating axis test: what separates a figure from others?  The points, edges and faces of small ones, over any
// number type.
//
// A body is all sums of its points with weights that add up to one, and of multiples of the edges that are rays or
// lines.  Its edges and those of another body span, two at a time, the normals of all planes that can separate them:
// two edges of one face, or one of each body.
// Laws: edges of no length are left out; coordinates are taken from an origin given.  The figure is not empty.
// Source: RTCD 5.2.1.
// Cost: some 10 to 100 operations.
#pragma once

#include <array>
#include <cstdint>

#include "arith/vec.hpp"
#include "figure/basic/in_space.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/query/body/pairs.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb::query::axes {

enum class EdgeEnd : unsigned char { none, one, both };  // infinite ones

template <class T>
struct AxisBody {
  std::array<arith::Vec<T>, 8> points;
  std::array<arith::Vec<T>, 6> edges;
  std::array<EdgeEnd, 6> ends{};
  std::array<std::array<std::uint8_t, 2>, 4> faces;
  std::size_t point_count = 0, edge_count = 0, face_count = 0;

  void add_point(const arith::Vec<T>& p) { points[point_count++] = p; }
  void add_edge(const arith::Vec<T>& along, EdgeEnd end = EdgeEnd::none) {
    ends[edge_count] = end;
    edges[edge_count++] = along;
  }
  void add_face(std::size_t i, std::size_t j) {
    faces[face_count++] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)};
  }
  void add_faces_of_all_edges() {
    for (std::size_t i = 0; i < edge_count; ++i) {
      for (std::size_t j = i + 1; j < edge_count; ++j) add_face(i, j);
    }
  }
};

template <class T>
arith::Vec<T> from_origin(const Point3& p, const Point3& origin) {
  return {T(p.x) - T(origin.x), T(p.y) - T(origin.y), T(p.z) - T(origin.z)};
}

template <class T, class... Points>
void add_corners(AxisBody<T>& body, const Point3& origin, const Points&... corners) {
  (body.add_point(from_origin<T>(in_space(corners), origin)), ...);
}
template <class T, class Point>
void add_edge_between(AxisBody<T>& body, const Point& a, const Point& b) {
  if (a != b) body.add_edge(from_origin<T>(in_space(b), in_space(a)));
}
template <class T, class Vector>
void add_way(AxisBody<T>& body, const Vector& v, EdgeEnd end) {
  if (v != Vector{}) body.add_edge(arith::vec<T>(in_space(v)), end);
}

/// The points to either side of those there are.
template <class T, class Vector>
void add_axis(AxisBody<T>& body, const Vector& axis, double half) {
  if (half == 0 || axis == Vector{}) return;
  const arith::Vec<T> along = arith::vec<T>(in_space(axis)), reach = along * T(half);
  const std::size_t n = body.point_count;
  for (std::size_t i = 0; i < n; ++i) {
    body.add_point(body.points[i] + reach);
    body.points[i] = body.points[i] - reach;
  }
  body.add_edge(along);
}

/// A point of it, or beside it: what coordinates are best taken from.
template <class Shape>
Point3 origin_of(const Shape& s) {
  if constexpr (requires { s.center; }) {
    return in_space(s.center);
  } else if constexpr (requires { s.origin; }) {
    return in_space(s.origin);
  } else if constexpr (requires { s.point; }) {
    return in_space(s.point);
  } else if constexpr (requires { s.a; }) {
    return in_space(s.a);
  } else if constexpr (requires { s.min; }) {
    return in_space(s.min);
  } else {
    return in_space(s);
  }
}

/// Of the figures that have few points: not of planes with a normal, polygons, what halfspaces bound, and polyhedra.
template <class Shape>
inline constexpr bool has_body = is_one_of(figure_kind<Shape>,
                                           {FigureKind::point, FigureKind::line, FigureKind::ray, FigureKind::segment,
                                            FigureKind::three_point_plane, FigureKind::triangle, FigureKind::rectangle,
                                            FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb});

template <class T, class Shape>
AxisBody<T> axis_body_of(const Shape& s, const Point3& origin) {
  constexpr FigureKind kind = figure_kind<Shape>;
  AxisBody<T> body;
  if constexpr (kind == FigureKind::point) {
    add_corners(body, origin, s);
  } else if constexpr (kind == FigureKind::line) {
    add_corners(body, origin, s.point);
    add_way(body, s.direction, EdgeEnd::both);
  } else if constexpr (kind == FigureKind::ray) {
    add_corners(body, origin, s.origin);
    add_way(body, s.direction, EdgeEnd::one);
  } else if constexpr (kind == FigureKind::segment) {
    add_corners(body, origin, s.a, s.b);
    add_edge_between(body, s.a, s.b);
  } else if constexpr (kind == FigureKind::three_point_plane) {
    add_corners(body, origin, s.a);
    add_edge_between(body, s.a, s.b);
    add_edge_between(body, s.a, s.c);
    body.ends.fill(EdgeEnd::both);
    body.add_faces_of_all_edges();
  } else if constexpr (kind == FigureKind::triangle) {
    add_corners(body, origin, s.a, s.b, s.c);
    add_edge_between(body, s.a, s.b);
    add_edge_between(body, s.b, s.c);
    add_edge_between(body, s.c, s.a);
    if (body.edge_count > 1) body.add_face(0, 1);
  } else if constexpr (kind == FigureKind::tetrahedron) {
    add_corners(body, origin, s.a, s.b, s.c, s.d);
    const std::array corners{&s.a, &s.b, &s.c, &s.d};
    std::array<std::array<int, 4>, 4> edge{};  // of two corners; -1 for none
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        edge[i][j] = edge[j][i] = *corners[i] == *corners[j] ? -1 : static_cast<int>(body.edge_count);
        add_edge_between(body, *corners[i], *corners[j]);
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {  // the face without corner i
      const std::size_t a = (i + 1) % 4, b = (i + 2) % 4, c = (i + 3) % 4;
      const std::array sides{edge[a][b], edge[b][c], edge[c][a]};
      const std::size_t skip = sides[0] < 0 ? 0 : sides[1] < 0 ? 1 : 2;  // one of no length, or any
      const int first = sides[(skip + 1) % 3], second = sides[(skip + 2) % 3];
      if (first >= 0 && second >= 0) body.add_face(static_cast<std::size_t>(first), static_cast<std::size_t>(second));
    }
  } else if constexpr (kind == FigureKind::aabb) {
    const Point3 min = in_space(s.min), max = in_space(s.max);
    const arith::Vec<T> low = from_origin<T>(min, origin), high = from_origin<T>(max, origin);
    const std::array<bool, 3> flat{min.x == max.x, min.y == max.y, min.z == max.z};
    for (unsigned corner = 0; corner < 8; ++corner) {
      if (((corner & 1u) != 0 && flat[0]) || ((corner & 2u) != 0 && flat[1]) || ((corner & 4u) != 0 && flat[2]))
        continue;
      body.add_point({(corner & 1u) != 0 ? high.x : low.x, (corner & 2u) != 0 ? high.y : low.y,
                      (corner & 4u) != 0 ? high.z : low.z});
    }
    const T zero(0.0), one(1.0);
    if (!flat[0]) body.add_edge({one, zero, zero});
    if (!flat[1]) body.add_edge({zero, one, zero});
    if (!flat[2]) body.add_edge({zero, zero, one});
    body.add_faces_of_all_edges();
  } else {  // axes and half extents
    add_corners(body, origin, s.center);
    const auto half = coordinates(s.half);
    for (std::size_t i = 0; i < half.size(); ++i) add_axis(body, s.axes[i], half[i]);
    body.add_faces_of_all_edges();
  }
  return body;
}

/// The image times the pose's weight, of coordinates from the origin: edges of no length may be among it.
template <class T>
void pose(AxisBody<T>& body, const WeightedPose<T>& by) {
  for (std::size_t i = 0; i < body.point_count; ++i) body.points[i] = by.image(body.points[i]);
  if (by.stands) return;
  for (std::size_t i = 0; i < body.edge_count; ++i) body.edges[i] = by.turned(body.edges[i]);
}

}  // namespace plumb::query::axes
