// Closest features: which pair of features holds the closest points of two bodies?  All pairs, the least distance by
// signs.
//
// Laws: (1) a pair of features has a candidate where it has one closest pair alone and that lies strictly within both:
// vertex and anything, two edges that are not parallel, an edge that crosses a face.  The closest pairs of two bodies
// are a convex set that differs from a part of either by one vector; its corners are such candidates, and the first one
// in lexicographic order is a corner.  (2) So the least candidate, of equal ones the first, is the answer by the rule
// of query/closest/pairs.hpp.  It is visited first under the features of the lowest dimension and number.  (3) Where a sign
// is not certain the question says so, and the answer means nothing.
// Source: RTCD 5.1.10; core_distance.hpp in figure/.
// Cost: a few hundred operations a pair on the list.
#pragma once

#include "query/closest/straight_shortlist.hpp"

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
bool strictly_on(const Edge3<T>& e, const Point3& p, CertainSigns& ask) {
  return place_near<T>(e, p, ask) == SpotOnLine::inside;
}

/// The closest pair of two edges, if it is one alone and within both.
template <class T>
bool cross_within(const Edge3<T>& e, const Edge3<T>& f, CertainSigns& ask) {
  const Vec3<T> n = cross(e.along, f.along), w = between<T>(e.from, f.from);
  const T whole = dot(n, n);
  if (ask(whole) != Sign::positive) return false;
  return place_on(e, dot(cross(w, f.along), n), whole, ask) == SpotOnLine::inside &&
         place_on(f, dot(cross(w, e.along), n), whole, ask) == SpotOnLine::inside;
}

template <class T>
bool projects_within(const TriangleFace<T>& face, const Point3& p, CertainSigns& ask) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (ask(dot(face.inward[i], between<T>(face.corner[i], p))) != Sign::positive) return false;
  }
  return true;
}

/// Does the edge cross the plane of the face strictly within both?  `rise`: that of the normal along the edge.
template <class T>
bool crosses_within(const Edge3<T>& e, const TriangleFace<T>& face, const T& rise, CertainSigns& ask) {
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
Sign lexicographic(const PointOn<T, Point3>& p, const PointOn<T, Point3>& q, CertainSigns& ask) {
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
  explicit Least(CertainSigns& ask) : ask_(ask) {}
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
  CertainSigns& ask_;
  std::optional<Found<T>> best_;
};

constexpr Feature vertex_number(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge_number(std::uint32_t i) { return {FeatureKind::edge, i}; }
inline constexpr Feature the_face{FeatureKind::face, 0};

/// Those of the pairs of features that are on the list.  Nothing only where a sign was not certain.
template <class T>
class FeatureSearch {
 public:
  FeatureSearch(const Body<T>& p, const Body<T>& q, const Shortlist& list, CertainSigns& ask)
      : p_(p), q_(q), list_(list), ask_(ask), least_(ask) {}

  std::optional<Found<T>> run() {
    for_all(p_.vertex_count, q_.vertex_count, list_.vertices, [&](std::uint32_t i, std::uint32_t j) {
      least_.see(close_pair<T>(point_edge<T>(p_.vertex[i]), point_edge<T>(q_.vertex[j]),
                               {SpotOnLine::start, SpotOnLine::start}),
                 vertex_number(i), vertex_number(j));
    });
    for_all(p_.vertex_count, q_.edge_count, list_.vertex_edge, [&](std::uint32_t i, std::uint32_t j) {
      const auto& [edge, index] = q_.edges[j];
      if (strictly_on(edge, p_.vertex[i], ask_))
        least_.see(close_pair<T>(point_edge<T>(p_.vertex[i]), edge, {SpotOnLine::start, SpotOnLine::inside}),
                   vertex_number(i), edge_number(index));
    });
    for_all(p_.edge_count, q_.vertex_count, list_.edge_vertex, [&](std::uint32_t i, std::uint32_t j) {
      const auto& [edge, index] = p_.edges[i];
      if (strictly_on(edge, q_.vertex[j], ask_))
        least_.see(close_pair<T>(edge, point_edge<T>(q_.vertex[j]), {SpotOnLine::inside, SpotOnLine::start}),
                   edge_number(index), vertex_number(j));
    });
    for_all(p_.edge_count, q_.edge_count, list_.edges, [&](std::uint32_t i, std::uint32_t j) {
      const auto &e = p_.edges[i], &f = q_.edges[j];
      if (cross_within(e.edge, f.edge, ask_))
        least_.see(close_pair<T>(e.edge, f.edge, {SpotOnLine::inside, SpotOnLine::inside}), edge_number(e.index),
                   edge_number(f.index));
    });
    if (q_.face) {
      on_face(p_, *q_.face, list_.vertex_face, list_.edge_face,
              [&](const ClosePair<T, Point3>& pair, Feature f) { least_.see(pair, f, the_face); });
    }
    if (p_.face) {
      on_face(q_, *p_.face, list_.face_vertex, list_.face_edge,
              [&](const ClosePair<T, Point3>& pair, Feature f) { least_.see(turned(pair), the_face, f); });
    }
    return least_.best();
  }

 private:
  template <class Take>
  void for_all(std::uint32_t m, std::uint32_t n, const Shortlist::Table<bool>& listed, Take take) {
    for (std::uint32_t i = 0; i < m; ++i) {
      for (std::uint32_t j = 0; j < n; ++j) {
        if (listed[i][j]) take(i, j);
      }
    }
  }
  template <class See>
  void on_face(const Body<T>& p, const TriangleFace<T>& face, const std::array<bool, 3>& vertices,
               const std::array<bool, 3>& edges, See see) {
    for (std::uint32_t i = 0; i < p.vertex_count; ++i) {
      if (vertices[i] && projects_within(face, p.vertex[i], ask_))
        see(vertex_face_pair(p.vertex[i], face), vertex_number(i));
    }
    for (std::uint32_t i = 0; i < p.edge_count; ++i) {
      if (!edges[i]) continue;
      const auto& [edge, index] = p.edges[i];
      const T rise = dot(edge.along, face.normal);
      if (crosses_within(edge, face, rise, ask_))
        see(crossing_pair(edge, face, rise, ask_(rise) == Sign::positive), edge_number(index));
    }
  }

  const Body<T>& p_;
  const Body<T>& q_;
  const Shortlist& list_;
  CertainSigns& ask_;
  Least<T> least_;
};

}  // namespace plumb::query
