// Which of several edges of a face seems nearest, and which face farthest below, is a guess in doubles, which holds no
// bound.
#include "query/vclip/walk.hpp"

#include <algorithm>
#include <cmath>

#include "query/vclip/clipped_edge.hpp"

namespace plumb::query::vclipping {
namespace {

using arith::Plain;

/// The square of the distance of two segments, one of which may be a point.
double guessed_square(const Plain& a, const Plain& b, const Plain& c, const Plain& d) {
  const Plain u = b - a, v = d - c, r = a - c;
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
  const double det = uu * vv - uv * uv;
  const auto clamped = [](double x) { return x > 0 ? std::min(x, 1.0) : 0.0; };
  double s = det > 0 ? clamped((uv * vr - ur * vv) / det) : 0;
  const double t = vv > 0 ? clamped((uv * s + vr) / vv) : 0;
  s = uu > 0 ? clamped((uv * t - ur) / uu) : 0;
  const Plain between = r + u * s - v * t;
  return dot(between, between);
}

/// The edge that seems nearest.
struct NearestGuess {
  std::optional<std::uint32_t> edge;
  double least = 0;
  void add(std::uint32_t c, double square) {
    if (!edge || square < least) edge = c, least = square;
  }
};

}  // namespace

Outcome Walk::step() {
  const FeatureKind a = at_[0].kind, b = at_[1].kind;
  using enum FeatureKind;
  if (a == vertex && b == vertex) return from_vertices();
  if (a == edge && b == edge) return from_edges();
  if (a == vertex && b == edge) return from_vertex_and_edge(0);
  if (a == edge && b == vertex) return from_vertex_and_edge(1);
  if (a == vertex && b == face) return from_vertex_and_face(0);
  if (a == face && b == vertex) return from_vertex_and_face(1);
  if (a == edge && b == face) return from_edge_and_face(0);
  if (a == face && b == edge) return from_edge_and_face(1);
  return move(0, {vertex, at_[0].corner});  // of two faces, which no walk comes to: a corner of the first
}

Outcome Walk::from_vertices() {
  for (const std::size_t i : {0U, 1U}) {
    std::optional<MeshFeature> beyond;
    const auto is_beyond = [&](const VoronoiPlane& p) {
      const bool is = sign_([&]<class T>() { return p.value(*solids_[i], place<T>(1 - i)); }) == Sign::negative;
      if (is) beyond = p.beyond;
      return is;
    };
    if (any_plane_of_vertex(*solids_[i], at_[i].corner, is_beyond)) return move(i, *beyond);
  }
  // Of a vertex within a flat part of the surface, what is below it has passed, too.
  for (const std::size_t i : {0U, 1U}) {
    const auto is_outside = [&](const VoronoiPlane& p) { return !is_below(i, solids_[i]->face_of(p.from)); };
    if (!any_plane_of_vertex(*solids_[i], at_[i].corner, is_outside))
      return move(i, {FeatureKind::face, at_[i].corner});
  }
  return Outcome::nearest;
}

bool Walk::is_below(std::size_t which, std::uint32_t face) const {
  return sign_([&]<class T>() { return solids_[which]->height(face, place<T>(1 - which)); }) == Sign::negative;
}

Outcome Walk::from_vertex_and_edge(std::size_t v) {
  const std::size_t e = 1 - v;
  const Solid &of_vertex = *solids_[v], &of_edge = *solids_[e];
  std::optional<MeshFeature> beyond;
  const auto is_beyond = [&](const VoronoiPlane& p) {
    const bool is = sign_([&]<class T>() { return p.value(of_edge, place<T>(v)); }) == Sign::negative;
    if (is) beyond = p.beyond;
    return is;
  };
  if (any_end_plane(of_edge, at_[e].corner, is_beyond) || any_side_plane(of_edge, at_[e].corner, is_beyond))
    return move(e, *beyond);
  ClippedEdge edge(of_edge, at_[e].corner, of_vertex, sign_);
  any_plane_of_vertex(of_vertex, at_[v].corner, [&](const VoronoiPlane& p) { return !edge.cut(p); });
  if (const auto to = edge.nearer_beyond(at_[v].corner)) return move(v, *to);
  const std::uint32_t face = of_edge.face_of(at_[e].corner);  // and of an edge between faces in one plane
  if (is_below(e, face) && is_below(e, of_edge.face_of(of_edge.twin(at_[e].corner))))
    return move(e, {FeatureKind::face, at_[e].corner});
  return Outcome::nearest;
}

Outcome Walk::from_edges() {
  for (const std::size_t i : {0U, 1U}) {
    const Solid &clipping = *solids_[i], &clipped = *solids_[1 - i];
    ClippedEdge by_ends(clipped, at_[1 - i].corner, clipping, sign_);
    any_end_plane(clipping, at_[i].corner, [&](const VoronoiPlane& p) { return !by_ends.cut(p); });
    if (const auto to = by_ends.nearer_beyond()) return move(i, *to);
    ClippedEdge by_sides(clipped, at_[1 - i].corner, clipping, sign_);
    any_side_plane(clipping, at_[i].corner, [&](const VoronoiPlane& p) { return !by_sides.cut(p); });
    if (const auto to = by_sides.nearer_beyond()) return move(i, *to);
  }
  return Outcome::nearest;
}

double Walk::guessed_square_to(std::size_t face_of, std::uint32_t face, std::uint32_t edge) const {
  const Solid &s = *solids_[face_of], &other = *solids_[1 - face_of];
  const MeshFeature& from = at_[1 - face_of];
  const Plain a = other.place<double>(from.corner),
              b = from.kind == FeatureKind::edge ? other.place<double>(other.next(from.corner)) : a;
  return guessed_square(a, b, s.place<double>(edge), s.place<double>(s.next(edge, face)));
}

Outcome Walk::from_vertex_and_face(std::size_t v) {
  const std::size_t f = 1 - v;
  const Solid &of_vertex = *solids_[v], &of_face = *solids_[f];
  const std::uint32_t face = of_face.face_of(at_[f].corner);
  NearestGuess beyond;
  any_plane_of_face(of_face, face, [&](const VoronoiPlane& p) {
    if (sign_([&]<class T>() { return p.value(of_face, place<T>(v)); }) == Sign::negative)
      beyond.add(p.beyond.corner, guessed_square_to(f, face, p.beyond.corner));
    return false;
  });
  if (beyond.edge) return move(f, {FeatureKind::edge, *beyond.edge});
  const Sign height = sign_([&]<class T>() { return of_face.height(face, place<T>(v)); });
  if (height == Sign::zero) return Outcome::holds_vertex;
  std::optional<MeshFeature> nearer;
  const auto leads_nearer = [&](const VoronoiPlane& p) {
    const Sign climb = sign_(
        [&]<class T>() { return dot(of_face.normal<T>(face), of_vertex.place<T>(p.to) - of_vertex.place<T>(p.from)); });
    if (climb * height != Sign::negative) return false;
    nearer = p.beyond.kind == FeatureKind::edge ? p.beyond : MeshFeature{FeatureKind::vertex, p.to};
    return true;
  };
  if (any_plane_of_vertex(of_vertex, at_[v].corner, leads_nearer)) return move(v, *nearer);
  return height == Sign::positive ? Outcome::nearest : out_of_local_minimum(v);
}

Outcome Walk::out_of_local_minimum(std::size_t v) {
  const Solid& s = *solids_[1 - v];
  std::optional<std::uint32_t> best;
  double most = 0;
  for (std::uint32_t face = 0; face + 1 < s.mesh().first.size(); ++face) {
    if (sign_([&]<class T>() { return s.height(face, place<T>(v)); }) != Sign::positive) continue;
    const Plain n = s.normal<double>(face);
    const double height = s.height(face, place<double>(v)) / std::sqrt(dot(n, n));
    if (!best || height > most) best = face, most = height;
  }
  if (!best) return Outcome::holds_vertex;
  return move(1 - v, {FeatureKind::face, s.mesh().first[*best]});
}

Outcome Walk::from_edge_and_face(std::size_t e) {
  const std::size_t f = 1 - e;
  const Solid& of_face = *solids_[f];
  const std::uint32_t face = of_face.face_of(at_[f].corner), tail = at_[e].corner, head = solids_[e]->next(tail);
  ClippedEdge edge(*solids_[e], tail, of_face, sign_);
  any_plane_of_face(of_face, face, [&](const VoronoiPlane& p) { return !edge.cut(p); });
  if (edge.is_excluded()) {
    NearestGuess nearest;
    for (std::uint32_t c = of_face.mesh().first[face]; c < of_face.mesh().first[face + 1]; ++c)
      nearest.add(c, guessed_square_to(f, face, c));
    return move(f, {FeatureKind::edge, *nearest.edge});
  }
  const Sign low = edge.height_at(edge.low(), face, false), high = edge.height_at(edge.high(), face, true);
  if (low * high != Sign::positive) {
    entry_ = edge.low();
    return Outcome::crosses;
  }
  if (edge.climb(face) * low != Sign::negative)  // it comes nearer toward its tail
    return edge.low() ? move(f, edge.low()->beyond) : move(e, {FeatureKind::vertex, tail});
  return edge.high() ? move(f, edge.high()->beyond) : move(e, {FeatureKind::vertex, head});
}

}  // namespace plumb::query::vclipping
