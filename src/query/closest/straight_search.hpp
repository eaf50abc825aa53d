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

template <class T, class P = Point3>
struct Found {
  ClosePair<T, P> pair;
  Feature a, b;
};

template <class T, class P>
bool strictly_on(const LinearFigure<Vec3<T>, P>& e, const P& p, CertainSigns& ask) {
  return place_near<T>(e, p, ask) == SpotOnLine::inside;
}

/// The closest pair of two edges, if it is one alone and within both.
template <class T, class P>
std::optional<ClosePair<T, P>> pair_within(const LinearFigure<Vec3<T>, P>& e, const LinearFigure<Vec3<T>, P>& f,
                                           CertainSigns& ask) {
  const Vec3<T> n = cross(e.along, f.along), w = between<T>(e.from, f.from);
  const T whole = dot(n, n);
  if (ask(whole) != Sign::positive) return {};
  const T on_e = dot(cross(w, f.along), n);
  if (place_on(e, on_e, whole, ask) != SpotOnLine::inside) return {};
  const T on_f = dot(cross(w, e.along), n);
  if (place_on(f, on_f, whole, ask) != SpotOnLine::inside) return {};
  const T gap = dot(w, n);
  return ClosePair<T, P>{{e.from, e.along, on_e, whole}, {f.from, f.along, on_f, whole}, gap * gap, whole};
}
template <class T, class P>
bool cross_within(const LinearFigure<Vec3<T>, P>& e, const LinearFigure<Vec3<T>, P>& f, CertainSigns& ask) {
  return pair_within(e, f, ask).has_value();
}

template <class T, class P>
bool projects_within(const TriangleFace<T, P>& face, const P& p, CertainSigns& ask) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (ask(dot(face.inward[i], between<T>(face.corner[i], p))) != Sign::positive) return false;
  }
  return true;
}

/// Does the edge's line, which goes through the plane this way, pass strictly within the face?
template <class T, class P>
bool passes_within(const LinearFigure<Vec3<T>, P>& e, const TriangleFace<T, P>& face, Sign up, CertainSigns& ask) {
  const std::array<Vec3<T>, 3> to{between<T>(e.from, face.corner[0]), between<T>(e.from, face.corner[1]),
                                  between<T>(e.from, face.corner[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    if (ask(dot(e.along, cross(to[i], to[(i + 1) % 3]))) * up != Sign::positive) return false;
  }
  return true;
}
/// Does the edge cross the plane of the face strictly within both?  `rise`: that of the normal along the edge.
template <class T, class P>
bool crosses_within(const LinearFigure<Vec3<T>, P>& e, const TriangleFace<T, P>& face, const T& rise,
                    CertainSigns& ask) {
  const Sign up = ask(rise);
  if (up == Sign::zero) return false;
  if (e.starts && ask(dot(face.normal, between<T>(face.corner[0], e.from))) * up != Sign::negative) return false;
  if (e.ends && ask(dot(face.normal, between<T>(face.corner[0], e.to))) * up != Sign::positive) return false;
  return passes_within(e, face, up, ask);
}

template <class T, class P>
PointOn<T, P> fixed(const P& p) {
  const T zero(0.0);
  return {p, {zero, zero, zero}, zero, T(1.0)};
}

template <class T, class P>
ClosePair<T, P> vertex_pair(const P& v, const P& w) {
  const Vec3<T> to = between<T>(v, w);
  return {fixed<T>(v), fixed<T>(w), dot(to, to), T(1.0)};
}
template <class T, class P>
ClosePair<T, P> vertex_edge_pair(const P& v, const LinearFigure<Vec3<T>, P>& e) {
  const Vec3<T> to = between<T>(e.from, v), c = cross(to, e.along);
  const T whole = dot(e.along, e.along);
  return {fixed<T>(v), {e.from, e.along, dot(to, e.along), whole}, dot(c, c), whole};
}
/// Does the vertex project strictly into the edge?
template <class T, class P>
std::optional<ClosePair<T, P>> pair_within(const P& v, const LinearFigure<Vec3<T>, P>& e, CertainSigns& ask) {
  const Vec3<T> to = between<T>(e.from, v);
  const T part = dot(to, e.along), whole = dot(e.along, e.along);
  if (place_on(e, part, whole, ask) != SpotOnLine::inside) return {};
  const Vec3<T> c = cross(to, e.along);
  return ClosePair<T, P>{fixed<T>(v), {e.from, e.along, part, whole}, dot(c, c), whole};
}
template <class T, class P>
ClosePair<T, P> vertex_face_pair(const P& v, const TriangleFace<T, P>& face) {
  const T gap = dot(face.normal, between<T>(v, face.corner[0]));
  return {fixed<T>(v), {v, face.normal, gap, face.whole}, gap * gap, face.whole};
}

/// The place is told where the edge crosses the face, strictly within both.
template <class T, class P>
std::optional<ClosePair<T, P>> pair_within(const LinearFigure<Vec3<T>, P>& e, const TriangleFace<T, P>& face,
                                           CertainSigns& ask) {
  const T zero(0.0), rise = dot(e.along, face.normal), gap = dot(face.normal, between<T>(e.from, face.corner[0]));
  const Sign up = ask(rise);
  if (up == Sign::zero || (e.starts && ask(gap) * up != Sign::positive)) return {};
  if ((e.ends && ask(rise - gap) * up != Sign::positive) || !passes_within(e, face, up, ask)) return {};
  const bool rises = up == Sign::positive;
  const PointOn<T, P> p{e.from, e.along, rises ? gap : zero - gap, rises ? rise : zero - rise};
  return ClosePair<T, P>{p, p, zero, T(1.0)};
}

template <class T, class P>
ClosePair<T, P> turned(const ClosePair<T, P>& p) {
  return {p.b, p.a, p.square, p.square_whole};
}

/// Which comes first in lexicographic order: negative for p.
template <class T, class P>
Sign lexicographic(const PointOn<T, P>& p, const PointOn<T, P>& q, CertainSigns& ask) {
  const auto against = [&](const T& beyond, const T& p_along, const T& q_along) {
    return ask(beyond * p.whole * q.whole + (p_along * p.numerator * q.whole - q_along * q.numerator * p.whole));
  };
  const Vec3<T> beyond = between<T>(q.base, p.base);
  Sign s = against(beyond.x, p.along.x, q.along.x);
  if (s == Sign::zero) s = against(beyond.y, p.along.y, q.along.y);
  if (s == Sign::zero) s = against(beyond.z, p.along.z, q.along.z);
  return s;
}

/// Which of several that are as near is told?
enum class LeastOf : unsigned char { first_in_order, any };

/// Keeps the least of what it is shown.
template <class T, class P>
class Least {
 public:
  Least(LeastOf of, CertainSigns& ask) : of_(of), ask_(ask) {}
  void see(const ClosePair<T, P>& pair, Feature a, Feature b) {
    if (best_) {
      const Sign s = ask_(pair.square * best_->pair.square_whole - best_->pair.square * pair.square_whole);
      if (s == Sign::positive) return;
      if (s == Sign::zero && of_ == LeastOf::any) return;
      if (s == Sign::zero && lexicographic(pair.a, best_->pair.a, ask_) != Sign::negative) return;
    }
    best_ = Found<T, P>{pair, a, b};
  }
  [[nodiscard]] const std::optional<Found<T, P>>& best() const { return best_; }

 private:
  LeastOf of_;
  CertainSigns& ask_;
  std::optional<Found<T, P>> best_;
};

constexpr Feature vertex_number(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge_number(std::uint32_t i) { return {FeatureKind::edge, i}; }
inline constexpr Feature the_face{FeatureKind::face, 0};

/// Those of the pairs of features that are on the list.  Nothing only where a sign was not certain.
template <class T, class P = Point3>
class FeatureSearch {
 public:
  FeatureSearch(const StraightBody<T, P>& p, const StraightBody<T, P>& q, const Shortlist& list, CertainSigns& ask,
                LeastOf of = LeastOf::first_in_order)
      : p_(p), q_(q), list_(list), ask_(ask), least_(of, ask) {}

  std::optional<Found<T, P>> run() {
    for_all(p_.vertex_count, q_.vertex_count, list_.vertices, [&](std::uint32_t i, std::uint32_t j) {
      least_.see(vertex_pair<T>(p_.vertex[i], q_.vertex[j]), vertex_number(i), vertex_number(j));
    });
    for_all(p_.vertex_count, q_.edge_count, list_.vertex_edge, [&](std::uint32_t i, std::uint32_t j) {
      const auto& [edge, index] = q_.edges[j];
      if (const auto pair = pair_within<T>(p_.vertex[i], edge, ask_))
        least_.see(*pair, vertex_number(i), edge_number(index));
    });
    for_all(p_.edge_count, q_.vertex_count, list_.edge_vertex, [&](std::uint32_t i, std::uint32_t j) {
      const auto& [edge, index] = p_.edges[i];
      if (const auto pair = pair_within<T>(q_.vertex[j], edge, ask_))
        least_.see(turned(*pair), edge_number(index), vertex_number(j));
    });
    for_all(p_.edge_count, q_.edge_count, list_.edges, [&](std::uint32_t i, std::uint32_t j) {
      const auto &e = p_.edges[i], &f = q_.edges[j];
      if (const auto pair = pair_within<T>(e.edge, f.edge, ask_))
        least_.see(*pair, edge_number(e.index), edge_number(f.index));
    });
    if (q_.face) {
      on_face(p_, *q_.face, list_.vertex_face, list_.edge_face,
              [&](const ClosePair<T, P>& pair, Feature f) { least_.see(pair, f, the_face); });
    }
    if (p_.face) {
      on_face(q_, *p_.face, list_.face_vertex, list_.face_edge,
              [&](const ClosePair<T, P>& pair, Feature f) { least_.see(turned(pair), the_face, f); });
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
  void on_face(const StraightBody<T, P>& p, const TriangleFace<T, P>& face, const std::array<bool, 3>& vertices,
               const std::array<bool, 3>& edges, See see) {
    for (std::uint32_t i = 0; i < p.vertex_count; ++i) {
      if (vertices[i] && projects_within(face, p.vertex[i], ask_))
        see(vertex_face_pair(p.vertex[i], face), vertex_number(i));
    }
    for (std::uint32_t i = 0; i < p.edge_count; ++i) {
      if (!edges[i]) continue;
      const auto& [edge, index] = p.edges[i];
      if (const auto pair = pair_within<T>(edge, face, ask_)) see(*pair, edge_number(index));
    }
  }

  const StraightBody<T, P>& p_;
  const StraightBody<T, P>& q_;
  const Shortlist& list_;
  CertainSigns& ask_;
  Least<T, P> least_;
};

}  // namespace plumb::query
