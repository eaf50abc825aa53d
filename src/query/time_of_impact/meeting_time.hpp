// Time of impact: during which part of [0, 1] are two features within reach of each other, one of them moving along a
// line?
//
// Each pair of features has its condition: a polynomial of degree 2 that is not positive where the lines or planes of
// the two are within reach, and linear ones that are not negative where the nearest points are in the features.
// Laws: (1) two bodies, whose hulls do not meet at time 0, meet at time t exactly when the condition of some pair holds
// there, for distance is reached between features.  (2) A condition holds during one interval, as both sets are convex.
// (3) A feature without length or area has no condition of its own; its vertices and edges have.
// Source: RTCD 5.5.2 to 5.5.7.
// Cost: 30 to 100 operations a pair.
#pragma once

#include <optional>

#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "query/time_of_impact/moving_body.hpp"

namespace plumb::query {

enum class MeetingPair : unsigned char { vertex_vertex, vertex_edge, edge_vertex, edge_edge, vertex_face, face_vertex };

struct PairIndex {
  MeetingPair kind;
  std::uint32_t a, b;
};

/// Tells a judge the condition of a pair: first judge.not_negative(c, d) for each c + d t; then judge.not_positive(c,
/// d, e) for c + 2 d t + e t^2, or judge.zero(c, d) where c + d t has to be zero.  Says whether there is one.
template <class T>
class MeetingCondition {
 public:
  using Vec = Vec3<T>;

  /// `velocity` is that of a, seen from b.
  MeetingCondition(const MovingBody<T>& a, const MovingBody<T>& b, const Vec& velocity)
      : a_(a),
        b_(b),
        velocity_(velocity),
        back_{negated(velocity.x), negated(velocity.y), negated(velocity.z)},
        swept_(a.swept || b.swept) {
    if (!swept_) return;
    const T reach = a.reach + b.reach;
    square_ = reach * reach;
  }

  template <class Judge>
  bool tell(PairIndex pair, Judge& judge) const {
    switch (pair.kind) {
      case MeetingPair::vertex_vertex:
        return near(a_.vertices[pair.a] - b_.vertices[pair.b], velocity_, square_, judge);
      case MeetingPair::vertex_edge:
        return point_line(a_.vertices[pair.a], line_of(b_, pair.b), velocity_, judge);
      case MeetingPair::edge_vertex:
        return point_line(b_.vertices[pair.b], line_of(a_, pair.a), back_, judge);
      case MeetingPair::edge_edge:
        return line_line(line_of(a_, pair.a), line_of(b_, pair.b), judge);
      case MeetingPair::vertex_face:
        return point_face(a_.vertices[pair.a], b_, pair.b, velocity_, judge);
      default:
        return point_face(b_.vertices[pair.b], a_, pair.a, back_, judge);
    }
  }

 private:
  struct Line {
    Vec from, along;
  };

  static T negated(const T& x) { return T(0.0) - x; }
  static Line line_of(const MovingBody<T>& body, std::uint32_t edge) {
    const auto& [from, to] = body.edges[edge].ends;
    return {body.vertices[from], body.vertices[to] - body.vertices[from]};
  }

  /// 0 <= from + change t <= most.
  template <class Judge>
  static void between(const T& from, const T& change, const T& most, Judge& judge) {
    judge.not_negative(from, change);
    judge.not_negative(most - from, negated(change));
  }
  /// |apart + velocity t|^2 <= limit.
  template <class Judge>
  static bool near(const Vec& apart, const Vec& velocity, const T& limit, Judge& judge) {
    judge.not_positive(dot(apart, apart) - limit, dot(apart, velocity), dot(velocity, velocity));
    return true;
  }

  /// |from + change t|^2 <= reach^2 area.
  template <class Judge>
  bool level(const T& from, const T& change, const T& area, Judge& judge) const {
    if (swept_) {
      judge.not_positive(from * from - square_ * area, from * change, change * change);
    } else {
      judge.zero(from, change);
    }
    return true;
  }

  template <class Judge>
  bool point_line(const Vec& p, const Line& e, const Vec& velocity, Judge& judge) const {
    const T length = dot(e.along, e.along);
    if (certainly_zero(length)) return false;
    const Vec d = p - e.from;
    between(dot(d, e.along), dot(velocity, e.along), length, judge);
    return near(cross(d, e.along), cross(velocity, e.along), square_ * length, judge);
  }

  template <class Judge>
  bool line_line(const Line& p, const Line& q, Judge& judge) const {
    const Vec n = cross(p.along, q.along), w = q.from - p.from;
    const T area = dot(n, n);
    if (certainly_zero(area)) return false;
    const Vec of_p = cross(q.along, n), of_q = cross(p.along, n);
    between(dot(w, of_p), dot(back_, of_p), area, judge);
    between(dot(w, of_q), dot(back_, of_q), area, judge);
    return level(dot(w, n), dot(back_, n), area, judge);
  }

  template <class Judge>
  bool point_face(const Vec& p, const MovingBody<T>& body, std::uint32_t face, const Vec& velocity,
                  Judge& judge) const {
    const auto& f = body.faces[face];
    const T area = dot(f.normal, f.normal);
    if (certainly_zero(area)) return false;
    for (std::size_t i = 0; i < f.corners.size(); ++i) {
      const Vec &from = body.vertices[f.corners[i]], &to = body.vertices[f.corners[(i + 1) % f.corners.size()]];
      const Vec inward = cross(f.normal, to - from);
      judge.not_negative(dot(p - from, inward), dot(velocity, inward));
    }
    return level(dot(p, f.normal) - f.offset, dot(velocity, f.normal), area, judge);
  }

  const MovingBody<T>&a_, &b_;
  const Vec velocity_, back_;
  const bool swept_;
  T square_{0.0};
};

}  // namespace plumb::query
