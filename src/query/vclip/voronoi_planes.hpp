// Voronoi planes: on which side of the planes that bound the Voronoi region of a polyhedron's vertex, edge or face is a
// point?
//
// Laws: a value is positive on the feature's own side, over any number type; its scale says nothing.  The height over a
// face is positive outside.
// Source: RTCD 9.2.1; Mirtich 1998.
// Cost: some 10 operations for the planes of vertices, some 30 for those of edges.
#pragma once

#include "figure/basic/mesh_corners.hpp"
#include "plumb/query/vclip/vclip.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query::vclipping {

using arith::cross, arith::dot, arith::Vec;

/// A polyhedron whose corners are asked for over any number type.
class Solid : public MeshCorners {
 public:
  Solid(const ConvexPolyhedron3& polyhedron, const CoreCorners& corners, bool is_mirrored)
      : MeshCorners(polyhedron), corners_(corners), is_mirrored_(is_mirrored) {}

  [[nodiscard]] const CoreCorners& core() const { return corners_; }
  [[nodiscard]] std::uint32_t vertex(std::uint32_t corner) const { return mesh().corners[corner]; }
  template <class T>
  [[nodiscard]] Vec<T> place(std::uint32_t corner) const {
    return corners_.at<T>(vertex(corner));
  }

  /// Over the face's plane, times the length of a normal.
  template <class T>
  [[nodiscard]] T height(std::uint32_t face, const Vec<T>& y) const {
    return dot(normal<T>(face), y - place<T>(mesh().first[face]));
  }
  /// Along the normal that height() has.
  template <class T>
  [[nodiscard]] Vec<T> normal(std::uint32_t face) const {
    const std::uint32_t a = mesh().first[face], b = next(a, face), c = corner_off_line(a, face);
    const Vec<T> u = place<T>(b) - place<T>(a), v = place<T>(c) - place<T>(a);
    return is_mirrored_ ? cross(v, u) : cross(u, v);
  }
  /// Does y project onto the face's side of its edge?
  template <class T>
  [[nodiscard]] T inward(std::uint32_t corner, std::uint32_t face, const Vec<T>& y) const {
    const Vec<T> tail = place<T>(corner), u = place<T>(next(corner, face)) - tail,
                 c = place<T>(corner_off_line(corner, face)) - tail;
    return dot(c * dot(u, u) - u * dot(u, c), y - tail);
  }

 private:
  const CoreCorners& corners_;
  bool is_mirrored_;
};

/// A plane that bounds a feature's Voronoi region, and the feature beyond.
struct VoronoiPlane {
  enum class Kind : unsigned char {
    toward,  // through the corner `from`, positive toward `to`
    away,    // the same, positive away from it
    inner,   // at right angles to face `to`, through its edge `from`, positive above the face
    outer,   // the same, positive beyond the edge
  };
  Kind kind;
  std::uint32_t from, to;
  MeshFeature beyond;

  template <class T>
  [[nodiscard]] T value(const Solid& solid, const Vec<T>& y) const {
    const T zero(0.0);
    if (kind == Kind::inner) return solid.inward(from, to, y);
    if (kind == Kind::outer) return zero - solid.inward(from, to, y);
    const Vec<T> at = solid.place<T>(from);
    const T along = dot(y - at, solid.place<T>(to) - at);
    return kind == Kind::toward ? along : zero - along;
  }
};

/// Toward `take` until it says true: of a vertex, those to its edges, and to faces in whose straight edge it lies.
template <class Take>
bool any_plane_of_vertex(const Solid& s, std::uint32_t corner, Take take) {
  std::uint32_t c = corner;
  do {
    const std::uint32_t face = s.face_of(c);
    if (take(VoronoiPlane{VoronoiPlane::Kind::away, c, s.next(c, face), {FeatureKind::edge, c}})) return true;
    if (s.is_straight(c, face) &&
        take(VoronoiPlane{VoronoiPlane::Kind::away, c, s.corner_off_line(c, face), {FeatureKind::face, c}}))
      return true;
    c = s.next(s.twin(c));
  } while (c != corner);
  return false;
}

/// Of an edge, those to its ends.
template <class Take>
bool any_end_plane(const Solid& s, std::uint32_t corner, Take take) {
  const std::uint32_t head = s.next(corner);
  return take(VoronoiPlane{VoronoiPlane::Kind::toward, corner, head, {FeatureKind::vertex, corner}}) ||
         take(VoronoiPlane{VoronoiPlane::Kind::toward, head, corner, {FeatureKind::vertex, head}});
}

/// Of an edge, those to its faces.
template <class Take>
bool any_side_plane(const Solid& s, std::uint32_t corner, Take take) {
  const std::uint32_t other = s.twin(corner);
  return take(VoronoiPlane{VoronoiPlane::Kind::outer, corner, s.face_of(corner), {FeatureKind::face, corner}}) ||
         take(VoronoiPlane{VoronoiPlane::Kind::outer, other, s.face_of(other), {FeatureKind::face, other}});
}

/// Of a face, those to its edges.
template <class Take>
bool any_plane_of_face(const Solid& s, std::uint32_t face, Take take) {
  for (std::uint32_t c = s.mesh().first[face]; c < s.mesh().first[face + 1]; ++c) {
    if (take(VoronoiPlane{VoronoiPlane::Kind::inner, c, face, {FeatureKind::edge, c}})) return true;
  }
  return false;
}

}  // namespace plumb::query::vclipping
