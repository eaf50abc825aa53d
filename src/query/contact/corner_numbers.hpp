// Where is a corner of a contact, on either body, and how far apart are these two points?  Fractions over any number
// type.
//
// A vertex is moved along the normal to the plane of the other's feature; through an edge that is the plane that holds
// the edge and what is at right angles to it and to the normal.  Two edges e, f with m = e x f, n the normal: they are
// apart by m . (q - p) / (m . n) normals.
// Laws: exact over numbers that are.  `whole` is not zero.
// Source: RTCD 5.1.9, 5.3.1.
// Cost: some 60 to 120 operations.
#pragma once

#include "query/contact/clipped_features.hpp"

namespace plumb::query::touching {

/// base + along * numerator / whole.  In a plane along two axes of space the third coordinate is known.
template <class T>
struct PlaceOn {
  Vec<T> base, along;
  T numerator;
  int level_axis = -1;
  const Vec<T>* level = nullptr;  // has that coordinate
};

template <class T>
struct CornerFractions {
  PlaceOn<T> on_a, on_b;
  T whole, height;  // from a to b it is height / whole normals
};

/// How far a corner's points are apart: height / whole normals.
template <class T>
struct Gap {
  T height, whole;
};

/// A normal of the plane of a feature that is a face, an edge or a vertex, `normal` that of the contact.
template <class T>
Vec<T> plane_normal(const View<T>& v, const Vec<T>& normal) {
  if (v.size() == 1) return normal;
  if (v.size() == 2) {
    const Vec<T> e = v.edge(0);
    return normal * sparse_dot(e, e) - e * sparse_dot(e, normal);
  }
  const std::size_t n = v.size();
  if (n == 4) return sparse_cross(v.edge(0), v.edge(1));
  return sparse_cross(v.at(n / 3) - v.at(0), v.at(n - n / 3) - v.at(0));
}

/// The axis of space that a vector is along by zeros; below zero where it is along none, or where exact numbers need not
/// know.
template <class T>
int axis_along(const Vec<T>& v) {
  if constexpr (std::is_same_v<T, Ball>) {
    const bool x = certainly_zero(v.x), y = certainly_zero(v.y), z = certainly_zero(v.z);
    if (x && y) return z ? -1 : 2;
    if (z && (x || y)) return x ? 1 : 0;
  }
  return -1;
}

template <class T>
class CornerPlaces {
 public:
  CornerPlaces(const View<T>& a, const View<T>& b, const Vec<T>& normal)
      : a_(a), b_(b), normal_(normal), across_a_(a.edges()), across_b_(b.edges()) {}

  [[nodiscard]] const View<T>& view_of_a() const { return a_; }
  [[nodiscard]] const View<T>& view_of_b() const { return b_; }

  [[nodiscard]] CornerFractions<T> of(const Found& f) const {
    const T none(0.0);
    if (f.kind == CornerKind::both_vertices) {
      const Vec<T>&p = a_.at(f.i), &q = b_.at(f.j);
      return {{p, normal_, none}, {q, normal_, none}, sparse_dot(normal_, normal_), sparse_dot(normal_, q - p)};
    }
    if (f.kind == CornerKind::vertex_of_b) {
      const Vec<T>& q = b_.at(f.j);
      const Plane& plane = plane_of(a_, plane_a_);
      const T height = sparse_dot(plane.normal, q - a_.at(0));
      return {{q, normal_, none - height, plane.axis, &a_.at(0)}, {q, normal_, none}, plane.along, height};
    }
    if (f.kind == CornerKind::vertex_of_a) {
      const Vec<T>& p = a_.at(f.i);
      const Plane& plane = plane_of(b_, plane_b_);
      const T height = sparse_dot(plane.normal, b_.at(0) - p);
      return {{p, normal_, none}, {p, normal_, height, plane.axis, &b_.at(0)}, plane.along, height};
    }
    const Vec<T>&p = a_.at(f.i), &q = b_.at(f.j), &e = a_.edge(f.i), &g = b_.edge(f.j);
    const Vec<T>&across_e = across(e, f.i, across_a_), &across_g = across(g, f.j, across_b_);
    const Vec<T> way = q - p;
    return {{p, e, sparse_dot(across_g, way)},
            {q, g, sparse_dot(across_e, way)},
            sparse_dot(e, across_g),
            sparse_dot(sparse_cross(e, g), way)};
  }

  /// These numbers of it alone.
  [[nodiscard]] Gap<T> gap(const Found& f) const {
    if (f.kind == CornerKind::both_vertices) {
      return {sparse_dot(normal_, b_.at(f.j) - a_.at(f.i)), sparse_dot(normal_, normal_)};
    }
    if (f.kind == CornerKind::vertex_of_b) {
      const Plane& plane = plane_of(a_, plane_a_);
      return {sparse_dot(plane.normal, b_.at(f.j) - a_.at(0)), plane.along};
    }
    if (f.kind == CornerKind::vertex_of_a) {
      const Plane& plane = plane_of(b_, plane_b_);
      return {sparse_dot(plane.normal, b_.at(0) - a_.at(f.i)), plane.along};
    }
    const Vec<T> m = sparse_cross(a_.edge(f.i), b_.edge(f.j));
    return {sparse_dot(m, b_.at(f.j) - a_.at(f.i)), sparse_dot(m, normal_)};
  }

 private:
  struct Plane {
    Vec<T> normal;
    T along;  // the contact's normal
    int axis;
  };
  const Plane& plane_of(const View<T>& v, std::optional<Plane>& plane) const {
    if (!plane) {
      Vec<T> n = plane_normal(v, normal_);
      const int axis = axis_along(n);
      if (axis >= 0 && axis == axis_along(normal_)) n = normal_;  // which is shorter
      plane = Plane{n, sparse_dot(n, normal_), axis};
    }
    return *plane;
  }

  const Vec<T>& across(const Vec<T>& edge, std::size_t i, Once<Vec<T>>& to) const {
    return to(i, [&] { return sparse_cross(edge, normal_); });
  }

  const View<T>&a_, &b_;
  Vec<T> normal_;
  // When first asked for.
  mutable std::optional<Plane> plane_a_, plane_b_;
  mutable Once<Vec<T>> across_a_, across_b_;  // edges and the normal
};

}  // namespace plumb::query::touching
