// What are the features of a line, ray, segment or triangle, over a number type?  Its corners are points as given, or
// vectors of that type, as those under a pose.
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

template <class T, class P = Point3>
using Edge3 = LinearFigure<Vec3<T>, P>;

template <class T, class P = Point3>
struct TriangleFace {
  std::array<P, 3> corner;
  Vec3<T> normal;
  std::array<Vec3<T>, 3> inward;  // in the plane, from edge number i
  T whole;                        // the square of the normal
};

template <class T, class P = Point3>
struct StraightBody {
  struct NumberedEdge {
    Edge3<T, P> edge;
    std::uint32_t index;
  };

  std::array<P, 3> vertex;
  std::array<NumberedEdge, 3> edges;
  std::uint32_t vertex_count = 0, edge_count = 0;
  std::optional<TriangleFace<T, P>> face;
};

template <class T, class P>
typename StraightBody<T, P>::NumberedEdge no_edge(const P& at) {
  const T zero(0.0);
  return {{at, at, {zero, zero, zero}, true, true, true, 0}, 0};
}

template <class T>
StraightBody<T> body_of(const Straight<Point3>& s, CertainSigns&) {
  const Edge3<T> e = linear<T>(s);
  const auto none = no_edge<T>(e.from);
  StraightBody<T> body{{e.from, e.to, e.to}, {typename StraightBody<T>::NumberedEdge{e, 0}, none, none}, 0, 0, {}};
  body.vertex_count = e.ends ? 2 : e.starts || e.is_point ? 1 : 0;
  body.edge_count = e.is_point ? 0 : 1;
  return body;
}

template <class T, class P>
TriangleFace<T, P> face_of(const P& a, const P& b, const P& c) {
  const Vec3<T> ab = between<T>(a, b), bc = between<T>(b, c), ca = between<T>(c, a);
  const Vec3<T> n = cross(ab, bc);
  return {{a, b, c}, n, {cross(n, ab), cross(n, bc), cross(n, ca)}, dot(n, n)};
}
template <class T>
TriangleFace<T> face_of(const Triangle3& t) {
  return face_of<T>(t.a, t.b, t.c);
}

template <class T>
StraightBody<T> body_of(const Triangle3& t, CertainSigns& ask) {
  const auto none = no_edge<T>(t.a);
  StraightBody<T> body{{t.a, t.b, t.c}, {none, none, none}, 3, 0, {}};
  const std::array<Segment3, 3> edges{{{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Edge3<T> e = linear<T>(edges[i]);
    if (!e.is_point) body.edges[body.edge_count++] = {e, i};
  }
  if (body.edge_count < 3) return body;
  body.face = face_of<T>(t);
  if (ask(body.face->whole) != Sign::positive) body.face.reset();
  return body;
}

/// The corners are told over the number type; the order of an edge's ends is not told.
template <class T>
StraightBody<T, Vec3<T>> body_of(const std::array<Vec3<T>, 3>& corner, CertainSigns& ask) {
  using P = Vec3<T>;
  const auto none = no_edge<T>(corner[0]);
  StraightBody<T, P> body{corner, {none, none, none}, 3, 0, {}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const P &from = corner[i], &to = corner[(i + 1) % 3], along = to - from;
    if (ask(dot(along, along)) == Sign::positive)
      body.edges[body.edge_count++] = {{from, to, along, true, true, false, 0}, i};
  }
  if (body.edge_count < 3) return body;
  body.face = face_of<T>(corner[0], corner[1], corner[2]);
  if (ask(body.face->whole) != Sign::positive) body.face.reset();
  return body;
}

}  // namespace plumb::query
