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

/// base + along * numerator / whole.
template <class T>
struct PlaceOn {
  Vec<T> base, along;
  T numerator;
};

template <class T>
struct CornerFractions {
  PlaceOn<T> on_a, on_b;
  T whole, height;  // from a to b it is height / whole normals
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
  return sparse_cross(v.at(n / 3) - v.at(0), v.at(n - n / 3) - v.at(0));
}

template <class T>
class CornerPlaces {
 public:
  CornerPlaces(const View<T>& a, const View<T>& b, const Vec<T>& normal)
      : a_(a), b_(b), normal_(normal), plane_a_(plane_normal(a, normal)), plane_b_(plane_normal(b, normal)) {}

  [[nodiscard]] CornerFractions<T> of(const Found& f) const {
    const T none(0.0);
    const Vec<T>&p = a_.at(f.i), &q = b_.at(f.j);
    if (f.kind == CornerKind::both_vertices) {
      return {{p, normal_, none}, {q, normal_, none}, sparse_dot(normal_, normal_), sparse_dot(normal_, q - p)};
    }
    if (f.kind == CornerKind::vertex_of_b) {
      const T height = sparse_dot(plane_a_, q - a_.at(0));
      return {{q, normal_, none - height}, {q, normal_, none}, sparse_dot(plane_a_, normal_), height};
    }
    if (f.kind == CornerKind::vertex_of_a) {
      const T height = sparse_dot(plane_b_, b_.at(0) - p);
      return {{p, normal_, none}, {p, normal_, height}, sparse_dot(plane_b_, normal_), height};
    }
    const Vec<T> e = a_.edge(f.i), g = b_.edge(f.j), way = q - p, m = sparse_cross(e, g);
    return {{p, e, sparse_dot(sparse_cross(g, normal_), way)},
            {q, g, sparse_dot(sparse_cross(e, normal_), way)},
            sparse_dot(m, normal_),
            sparse_dot(m, way)};
  }

 private:
  const View<T>&a_, &b_;
  Vec<T> normal_, plane_a_, plane_b_;
};

}  // namespace plumb::query::touching
