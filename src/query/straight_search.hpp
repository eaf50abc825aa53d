// Which pair of features holds the closest points of two bodies?  All pairs, the least distance by signs.
//
// Laws: (1) a pair of features has a candidate where it has one closest pair alone and that lies strictly within both:
// vertex and anything, two edges that are not parallel, an edge that crosses a face.  The closest pairs of two bodies
// are a convex set that differs from a part of either by one vector; its corners are such candidates, and the first one
// in lexicographic order is a corner.  (2) So the least candidate, of equal ones the first, is the answer by the rule
// of closest_pairs.hpp.  It is visited first under the features of the lowest dimension and number.  (3) Where a sign
// is not certain the question says so, and the answer means nothing. Source: RTCD 5.1.10; core_distance.hpp in figure/.
// Cost: for two triangles some 5000 operations.
#pragma once

#include "query/straight_body.hpp"

namespace plumb::query {

template <class T>
struct Found {
  ClosePair<T, Point3> pair;
  Feature a, b;
};

template <class T>
Edge3<T> point_edge(const Point3& p) {
  const T zero(0.0);
  return {p, p, {zero, zero, zero}, true, false, true, 0};
}

template <class T>
bool strictly_on(const Edge3<T>& e, const Point3& p, Signs& ask) {
  return place_near<T>(e, p, ask) == Place::inside;
}

/// The closest pair of two edges, if it is one alone and within both.
template <class T>
bool cross_within(const Edge3<T>& e, const Edge3<T>& f, Signs& ask) {
  const Vec3<T> n = cross(e.along, f.along), w = between<T>(e.from, f.from);
  const T whole = dot(n, n);
  if (ask(whole) != Sign::positive) return false;
  return place_on(e, dot(cross(w, f.along), n), whole, ask) == Place::inside &&
         place_on(f, dot(cross(w, e.along), n), whole, ask) == Place::inside;
}

template <class T>
bool projects_within(const TriangleFace<T>& face, const Point3& p, Signs& ask) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (ask(dot(face.inward[i], between<T>(face.corner[i], p))) != Sign::positive) return false;
  }
  return true;
}

/// Does the edge cross the plane of the face strictly within both?  `rise`: that of the normal along the edge.
template <class T>
bool crosses_within(const Edge3<T>& e, const TriangleFace<T>& face, const T& rise, Signs& ask) {
  const Sign up = ask(rise);
  if (up == Sign::zero) return false;
  if (e.starts && ask(dot(face.normal, between<T>(face.corner[0], e.from))) * up != Sign::negative) return false;
  if (e.ends && ask(dot(face.normal, between<T>(face.corner[0], e.to))) * up != Sign::positive) return false;
  const std::array<Vec3<T>, 3> to{between<T>(e.from, face.corner[0]), between<T>(e.from, face.corner[1]),
                                  between<T>(e.from, face.corner[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    if (ask(dot(e.along, cross(to[i], to[(i + 1) % 3]))) * up != Sign::positive) return false;
  }
  return true;
}

template <class T>
PointOn<T, Point3> fixed(const Point3& p) {
  const T zero(0.0);
  return {p, {zero, zero, zero}, zero, T(1.0)};
}

template <class T>
ClosePair<T, Point3> vertex_face_pair(const Point3& v, const TriangleFace<T>& face) {
  const T gap = dot(face.normal, between<T>(v, face.corner[0]));
  return {fixed<T>(v), {v, face.normal, gap, face.whole}, gap * gap, face.whole};
}

template <class T>
ClosePair<T, Point3> crossing_pair(const Edge3<T>& e, const TriangleFace<T>& face, const T& rise, bool up) {
  const T zero(0.0), gap = dot(face.normal, between<T>(e.from, face.corner[0]));
  const PointOn<T, Point3> p{e.from, e.along, up ? gap : zero - gap, up ? rise : zero - rise};
  return {p, p, zero, T(1.0)};
}

template <class T>
ClosePair<T, Point3> turned(const ClosePair<T, Point3>& p) {
  return {p.b, p.a, p.square, p.square_whole};
}

/// Which comes first in lexicographic order: negative for p.
template <class T>
Sign lexicographic(const PointOn<T, Point3>& p, const PointOn<T, Point3>& q, Signs& ask) {
  const auto against = [&](double p_base, const T& p_along, double q_base, const T& q_along) {
    const T from_base = coordinate_difference<T>(p_base, q_base) * p.whole * q.whole;
    return ask(from_base + (p_along * p.numerator * q.whole - q_along * q.numerator * p.whole));
  };
  Sign s = against(p.base.x, p.along.x, q.base.x, q.along.x);
  if (s == Sign::zero) s = against(p.base.y, p.along.y, q.base.y, q.along.y);
  if (s == Sign::zero) s = against(p.base.z, p.along.z, q.base.z, q.along.z);
  return s;
}

/// Keeps the least of what it is shown.
template <class T>
class Least {
 public:
  explicit Least(Signs& ask) : ask_(ask) {}
  void see(const ClosePair<T, Point3>& pair, Feature a, Feature b) {
    if (best_) {
      const Sign s = ask_(pair.square * best_->pair.square_whole - best_->pair.square * pair.square_whole);
      if (s == Sign::positive) return;
      if (s == Sign::zero && lexicographic(pair.a, best_->pair.a, ask_) != Sign::negative) return;
    }
    best_ = Found<T>{pair, a, b};
  }
  [[nodiscard]] const std::optional<Found<T>>& best() const { return best_; }

 private:
  Signs& ask_;
  std::optional<Found<T>> best_;
};

constexpr Feature vertex_number(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge_number(std::uint32_t i) { return {FeatureKind::edge, i}; }
inline constexpr Feature the_face{FeatureKind::face, 0};

/// Vertices of p with all of q, edges of p with the face of q; the other way round the caller turns them.
template <class T, class See>
void see_vertices_on_edges(const Body<T>& p, const Body<T>& q, Signs& ask, See see) {
  for (std::uint32_t i = 0; i < p.vertex_count; ++i) {
    for (std::uint32_t j = 0; j < q.edge_count; ++j) {
      const auto& [edge, index] = q.edges[j];
      if (strictly_on(edge, p.vertex[i], ask))
        see(close_pair<T>(point_edge<T>(p.vertex[i]), edge, {Place::start, Place::inside}), vertex_number(i),
            edge_number(index));
    }
  }
}
template <class T, class See>
void see_on_face(const Body<T>& p, const Body<T>& q, Signs& ask, See see) {
  if (!q.face) return;
  for (std::uint32_t i = 0; i < p.vertex_count; ++i) {
    if (projects_within(*q.face, p.vertex[i], ask))
      see(vertex_face_pair(p.vertex[i], *q.face), vertex_number(i), the_face);
  }
  for (std::uint32_t i = 0; i < p.edge_count; ++i) {
    const auto& [edge, index] = p.edges[i];
    const T rise = dot(edge.along, q.face->normal);
    if (crosses_within(edge, *q.face, rise, ask))
      see(crossing_pair(edge, *q.face, rise, ask(rise) == Sign::positive), edge_number(index), the_face);
  }
}

/// Nothing only where a sign was not certain.
template <class T>
std::optional<Found<T>> closest_features(const Body<T>& p, const Body<T>& q, Signs& ask) {
  Least<T> least(ask);
  const auto see = [&](const ClosePair<T, Point3>& pair, Feature a, Feature b) { least.see(pair, a, b); };
  const auto see_turned = [&](const ClosePair<T, Point3>& pair, Feature b, Feature a) {
    least.see(turned(pair), a, b);
  };
  for (std::uint32_t i = 0; i < p.vertex_count; ++i) {
    for (std::uint32_t j = 0; j < q.vertex_count; ++j) {
      see(close_pair<T>(point_edge<T>(p.vertex[i]), point_edge<T>(q.vertex[j]), {Place::start, Place::start}),
          vertex_number(i), vertex_number(j));
    }
  }
  see_vertices_on_edges(p, q, ask, see);
  see_vertices_on_edges(q, p, ask, see_turned);
  for (std::uint32_t i = 0; i < p.edge_count; ++i) {
    for (std::uint32_t j = 0; j < q.edge_count; ++j) {
      const auto &e = p.edges[i], &f = q.edges[j];
      if (cross_within(e.edge, f.edge, ask))
        see(close_pair<T>(e.edge, f.edge, {Place::inside, Place::inside}), edge_number(e.index), edge_number(f.index));
    }
  }
  see_on_face(p, q, ask, see);
  see_on_face(q, p, ask, see_turned);
  return least.best();
}

}  // namespace plumb::query
