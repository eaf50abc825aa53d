// What are the features of a line, ray, segment or triangle, over a number type?
//
// Laws: vertices and edges in the order of figure/containment/voronoi_region.hpp; an edge of no length is none, and so is the face
// of a triangle without area.  Over a number type whose signs are not certain the question says so.
// Cost: the differences; with a face 4 cross products more.
#pragma once

#include <array>
#include <optional>

#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/closest/linear_pair.hpp"

namespace plumb::query {

template <class T>
using Edge3 = Linear<Vec3<T>, Point3>;

template <class T>
struct TriangleFace {
  std::array<Point3, 3> corner;
  Vec3<T> normal;
  std::array<Vec3<T>, 3> inward;  // in the plane, from edge number i
  T whole;                        // the square of the normal
};

template <class T>
struct Body {
  struct NumberedEdge {
    Edge3<T> edge;
    std::uint32_t index;
  };

  std::array<Point3, 3> vertex{};
  std::array<NumberedEdge, 3> edges;
  std::uint32_t vertex_count = 0, edge_count = 0;
  std::optional<TriangleFace<T>> face;
};

template <class T>
typename Body<T>::NumberedEdge no_edge() {
  const T zero(0.0);
  return {{{}, {}, {zero, zero, zero}, true, true, true, 0}, 0};
}

template <class T>
Body<T> body_of(const Straight<Point3>& s, CertainSigns&) {
  const Edge3<T> e = linear<T>(s);
  Body<T> body{{e.from, e.to}, {typename Body<T>::NumberedEdge{e, 0}, no_edge<T>(), no_edge<T>()}, 0, 0, {}};
  body.vertex_count = e.ends ? 2 : e.starts || e.is_point ? 1 : 0;
  body.edge_count = e.is_point ? 0 : 1;
  return body;
}

template <class T>
TriangleFace<T> face_of(const Triangle3& t) {
  const Vec3<T> ab = between<T>(t.a, t.b), bc = between<T>(t.b, t.c), ca = between<T>(t.c, t.a);
  const Vec3<T> n = cross(ab, bc);
  return {{t.a, t.b, t.c}, n, {cross(n, ab), cross(n, bc), cross(n, ca)}, dot(n, n)};
}

template <class T>
Body<T> body_of(const Triangle3& t, CertainSigns& ask) {
  Body<T> body{{t.a, t.b, t.c}, {no_edge<T>(), no_edge<T>(), no_edge<T>()}, 3, 0, {}};
  const std::array<Segment3, 3> edges{{{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Edge3<T> e = linear<T>(edges[i]);
    if (!e.is_point) body.edges[body.edge_count++] = {e, i};
  }
  if (body.edge_count < 3) return body;
  const TriangleFace<T> face = face_of<T>(t);
  if (ask(face.whole) == Sign::positive) body.face = face;
  return body;
}

}  // namespace plumb::query
