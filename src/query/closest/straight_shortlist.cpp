// Every pair of features is weighed in doubles: is its candidate there, and between which bounds is its distance?
#include "query/closest/straight_shortlist.hpp"

#include <algorithm>
#include <limits>

#include "arith/running_error.hpp"
#include "query/closest/straight_search.hpp"

namespace plumb::query {
namespace {

using A = Approximate;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bounds of a square of distance, and whether its points are certain to exist, or not to.
struct Weight {
  double low = 0, high = infinity;
  bool out = false;
};

/// Of n / d, both not negative.
Weight weight(const A& n, const A& d, bool within) {
  const Running square = quotient(Running(n.value, n.reach()), Running(d.value, d.reach()));
  return {std::max(square.lower(), 0.0), within ? square.upper() : infinity, false};
}
constexpr Weight gone{0, infinity, true};

Weight vertex_edge(const Point3& v, const Edge3<A>& e) {
  CertainSigns ask;
  const bool on = strictly_on(e, v, ask);
  if (ask.certain() && !on) return gone;
  const auto pair = vertex_edge_pair(v, e);
  return weight(pair.square, pair.square_whole, ask.certain());
}

Weight edge_edge(const Edge3<A>& e, const Edge3<A>& f) {
  CertainSigns ask;
  const bool cross = cross_within(e, f, ask);
  if (ask.certain() && !cross) return gone;
  const auto pair = close_pair<A>(e, f, {SpotOnLine::inside, SpotOnLine::inside});
  return weight(pair.square, pair.square_whole, ask.certain());
}

Weight vertex_face(const Point3& v, const TriangleFace<A>& face) {
  CertainSigns ask;
  const bool within = projects_within(face, v, ask);
  if (ask.certain() && !within) return gone;
  const auto pair = vertex_face_pair(v, face);
  return weight(pair.square, pair.square_whole, ask.certain());
}

Weight edge_face(const Edge3<A>& e, const TriangleFace<A>& face) {
  CertainSigns ask;
  const bool crosses = crosses_within(e, face, dot(e.along, face.normal), ask);
  if (ask.certain()) return crosses ? Weight{0, 0, false} : gone;
  // A sign that is not certain matters only where the ends are not certain to lie on one side.
  if (!e.starts || !e.ends) return {};
  CertainSigns ends;
  const Sign from = ends(dot(face.normal, between<A>(face.corner[0], e.from)));
  const Sign to = ends(dot(face.normal, between<A>(face.corner[0], e.to)));
  return ends.certain() && from == to ? gone : Weight{};
}

class Weights {
 public:
  Weights(const StraightBody<A>& p, const StraightBody<A>& q) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      for (std::uint32_t j = 0; j < 3; ++j) {
        const Edge3<A>&e = p.edges[i].edge, &f = q.edges[j].edge;
        if (i < p.vertex_count && j < q.vertex_count) {
          const Vec3<A> w = between<A>(p.vertex[i], q.vertex[j]);
          keep(vertices_[i][j], weight(dot(w, w), A(1), true));
        }
        if (i < p.vertex_count && j < q.edge_count) keep(vertex_edge_[i][j], vertex_edge(p.vertex[i], f));
        if (i < p.edge_count && j < q.vertex_count) keep(edge_vertex_[i][j], vertex_edge(q.vertex[j], e));
        if (i < p.edge_count && j < q.edge_count) keep(edges_[i][j], edge_edge(e, f));
      }
      if (q.face && i < p.vertex_count) keep(vertex_face_[i], vertex_face(p.vertex[i], *q.face));
      if (q.face && i < p.edge_count) keep(edge_face_[i], edge_face(p.edges[i].edge, *q.face));
      if (p.face && i < q.vertex_count) keep(face_vertex_[i], vertex_face(q.vertex[i], *p.face));
      if (p.face && i < q.edge_count) keep(face_edge_[i], edge_face(q.edges[i].edge, *p.face));
    }
  }

  [[nodiscard]] Shortlist list() const {
    Shortlist all{};
    const auto is_left = [&](const Weight& w) { return !w.out && !(w.low > least_); };
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        all.vertices[i][j] = is_left(vertices_[i][j]);
        all.vertex_edge[i][j] = is_left(vertex_edge_[i][j]);
        all.edge_vertex[i][j] = is_left(edge_vertex_[i][j]);
        all.edges[i][j] = is_left(edges_[i][j]);
      }
      all.vertex_face[i] = is_left(vertex_face_[i]);
      all.edge_face[i] = is_left(edge_face_[i]);
      all.face_vertex[i] = is_left(face_vertex_[i]);
      all.face_edge[i] = is_left(face_edge_[i]);
    }
    return all;
  }

 private:
  void keep(Weight& to, const Weight& w) {
    to = w;
    if (!w.out && w.high < least_) least_ = w.high;
  }

  double least_ = infinity;
  Shortlist::Table<Weight> vertices_, vertex_edge_, edge_vertex_, edges_;
  std::array<Weight, 3> vertex_face_, edge_face_, face_vertex_, face_edge_;
};

template <class P, class Q>
Shortlist list_of(const P& a, const Q& b) {
  CertainSigns ask;
  return Weights(body_of<A>(a, ask), body_of<A>(b, ask)).list();
}

}  // namespace

Shortlist shortlist(const Straight<Point3>& a, const Triangle3& b) { return list_of(a, b); }
Shortlist shortlist(const Triangle3& a, const Triangle3& b) { return list_of(a, b); }

}  // namespace plumb::query
