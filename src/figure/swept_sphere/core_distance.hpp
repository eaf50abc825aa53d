// Distance of segments: how far apart are two cores, points, segments or parallelograms?  Over intervals first, over
// integers for certain.
//
// A core is corner + s edges[0] + t edges[1], 0 <= s, t <= 1, over any number type with + - *.
// Laws: (1) every distance that is visited is one between points of the two cores, as a square of the form numerator /
// denominator, denominator > 0; the least of them is the distance of the cores.  It is that of two vertices, of a
// vertex and an edge or a face that it projects into, of two edges with their nearest points inside, or zero where an
// edge meets a face.  A parallelogram with parallel edges is the union of its edges.  (2) Where an interval does not
// tell a sign the question says so, and what was visited means nothing.
// Source: RTCD 5.1.2, 5.1.9.
// Cost: for two segments some 100 operations, for two parallelograms some 3000.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "arith/vec.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb::figure::swept {

template <class T>
struct Edge {
  arith::Vec<T> from, along;
};

template <class T>
struct Core {
  std::vector<arith::Vec<T>> vertices;
  std::vector<Edge<T>> edges;
  bool has_face = false;  // maybe one without area
};

template <class T>
Core<T> core_of(const arith::Vec<T>& corner, const arith::Vec<T>& e, const arith::Vec<T>& f, bool e_is_zero,
                bool f_is_zero) {
  Core<T> c{{corner}, {}, !e_is_zero && !f_is_zero};
  if (!e_is_zero) c.vertices.push_back(corner + e), c.edges.push_back({corner, e});
  if (!f_is_zero) c.vertices.push_back(corner + f), c.edges.push_back({corner, f});
  if (c.has_face) {
    c.vertices.push_back(corner + e + f);
    c.edges.push_back({corner + f, e});
    c.edges.push_back({corner + e, f});
  }
  return c;
}
/// Times a number, about the origin.
template <class T>
Core<T> scaled(const Core<T>& c, const T& by) {
  Core<T> made{{}, {}, c.has_face};
  for (const arith::Vec<T>& v : c.vertices) made.vertices.push_back(v * by);
  for (const Edge<T>& e : c.edges) made.edges.push_back({e.from * by, e.along * by});
  return made;
}
template <class T>
Core<T> core_of(const Point3& p) {
  return {{arith::vec<T>(p)}, {}, false};
}
template <class T>
Core<T> core_of(const Capsule3& c) {
  const arith::Vec<T> a = arith::vec<T>(c.a), e = arith::vec<T>(c.b) - a;
  return core_of(a, e, e, c.a == c.b, true);
}
template <class T>
Core<T> core_of(const Lozenge3& l) {
  const Vector3 zero{0, 0, 0};
  return core_of(arith::vec<T>(l.corner), arith::vec<T>(l.edges[0]), arith::vec<T>(l.edges[1]), l.edges[0] == zero,
                 l.edges[1] == zero);
}

template <class T, class Ask>
bool between(Ask& ask, const T& x, const T& most) {
  return ask(x) != Sign::negative && ask(most - x) != Sign::negative;
}

template <class T, class Ask, class Visit>
void vertex_edge(const arith::Vec<T>& v, const Edge<T>& e, Ask& ask, Visit visit) {
  const arith::Vec<T> w = v - e.from, d = e.along;
  const T square = dot(d, d);
  if (!between(ask, dot(w, d), square)) return;
  const arith::Vec<T> c = cross(w, d);
  visit(dot(c, c), square);
}

template <class T, class Ask, class Visit>
void edge_edge(const Edge<T>& p, const Edge<T>& q, Ask& ask, Visit visit) {
  const arith::Vec<T> n = cross(p.along, q.along), w = q.from - p.from;
  const T square = dot(n, n);
  if (ask(square) != Sign::positive) return;
  if (!between(ask, dot(w, cross(q.along, n)), square) || !between(ask, dot(w, cross(p.along, n)), square)) return;
  const T gap = dot(w, n);
  visit(gap * gap, square);
}

template <class T>
struct Face {
  arith::Vec<T> corner, e, f, normal;
  T square;
};

template <class T>
Face<T> face_of(const Core<T>& c) {
  const arith::Vec<T> e = c.edges[0].along, f = c.edges[1].along, n = cross(e, f);
  return {c.vertices[0], e, f, n, dot(n, n)};
}

// Is corner + w / scale in the parallelogram, as seen along its normal?
template <class T, class Ask>
bool projects_into(const Face<T>& face, const arith::Vec<T>& w, const T& scale, Ask& ask) {
  const T most = face.square * scale;
  return between(ask, dot(cross(w, face.f), face.normal), most) &&
         between(ask, dot(cross(face.e, w), face.normal), most);
}

template <class T, class Ask, class Visit>
void vertex_face(const arith::Vec<T>& v, const Face<T>& face, Ask& ask, Visit visit) {
  const arith::Vec<T> w = v - face.corner;
  if (!projects_into(face, w, T(1.0), ask)) return;
  const T gap = dot(w, face.normal);
  visit(gap * gap, face.square);
}

template <class T, class Ask, class Visit>
void edge_face(const Edge<T>& e, const Face<T>& face, Ask& ask, Visit visit) {
  const arith::Vec<T> w = e.from - face.corner;
  const T from = dot(w, face.normal), change = dot(e.along, face.normal);
  const Sign start = ask(from), end = ask(from + change);
  if (start * end == Sign::positive || (start == Sign::zero && end == Sign::zero)) return;
  // The plane is met at e.from + e.along from / (from - end), where numerator and denominator have one sign.
  const bool falls = start == Sign::positive || end == Sign::negative;
  const T zero = T(0.0), fall = falls ? zero - change : change, part = falls ? from : zero - from;
  if (projects_into(face, w * fall + e.along * part, fall, ask)) visit(zero, T(1.0));
}

/// Calls visit(numerator, denominator) for the squares of the distances that may be the least.
template <class T, class Ask, class Visit>
void visit_distances(const Core<T>& p, const Core<T>& q, Ask& ask, Visit visit) {
  for (const arith::Vec<T>& v : p.vertices) {
    for (const arith::Vec<T>& w : q.vertices) visit(dot(v - w, v - w), T(1.0));
  }
  for (const auto& [a, b] : {std::pair{&p, &q}, std::pair{&q, &p}}) {
    for (const arith::Vec<T>& v : a->vertices) {
      for (const Edge<T>& e : b->edges) vertex_edge(v, e, ask, visit);
    }
    if (!b->has_face) continue;
    const Face<T> face = face_of(*b);
    if (ask(face.square) != Sign::positive) continue;
    for (const arith::Vec<T>& v : a->vertices) vertex_face(v, face, ask, visit);
    for (const Edge<T>& e : a->edges) edge_face(e, face, ask, visit);
  }
  for (const Edge<T>& e : p.edges) {
    for (const Edge<T>& f : q.edges) edge_edge(e, f, ask, visit);
  }
}

}  // namespace plumb::figure::swept
