// The search: pairs of edges, then corners over faces; where nothing is the nearest for certain, crossings.
#include "query/closest/straight_guess.hpp"

#include <limits>

#include "query/closest/quick_numbers.hpp"
#include "query/closest/straight_search.hpp"

namespace plumb::query {
namespace {

using Line = Straight<Point3>;
using A = Approximate;

Feature vertex_at(SpotOnLine place) { return vertex_number(place == SpotOnLine::end ? 1 : 0); }

/// What a proof asks of a shape.  The ways that lead from a vertex into the shape; the corner beside an edge.
struct LineShape {
  const Line& line;

  [[nodiscard]] const Point3& vertex(std::uint32_t i) const { return i == 0 ? line.from : line.to; }
  [[nodiscard]] Line edge(std::uint32_t) const { return line; }
  template <class Take>
  [[nodiscard]] bool ways(std::uint32_t i, Take take) const {
    return take(i == 1 ? between<A>(line.to, line.from) : linear<A>(line).along);
  }
  template <class Take>
  [[nodiscard]] bool beside(std::uint32_t, const Point3&, Take) const {
    return true;
  }
};
struct TriangleShape {
  std::array<Point3, 3> corner;

  [[nodiscard]] const Point3& vertex(std::uint32_t i) const { return corner[i]; }
  [[nodiscard]] Line edge(std::uint32_t i) const { return straight(Segment3{corner[i], corner[(i + 1) % 3]}); }
  template <class Take>
  [[nodiscard]] bool ways(std::uint32_t i, Take take) const {
    return take(between<A>(corner[i], corner[(i + 1) % 3])) && take(between<A>(corner[i], corner[(i + 2) % 3]));
  }
  template <class Take>
  [[nodiscard]] bool beside(std::uint32_t i, const Point3& from, Take take) const {
    return take(between<A>(from, corner[(i + 2) % 3]));
  }
};
TriangleShape shape(const Triangle3& t) { return {{t.a, t.b, t.c}}; }

bool is_positive(const A& x) {
  CertainSigns ask;
  return ask(x) == Sign::positive;
}
bool is_negative(const A& x) {
  CertainSigns ask;
  return ask(x) == Sign::negative;
}

template <class P, class Q>
bool prove_vertices(const P& p, std::uint32_t i, const Q& q, std::uint32_t j) {
  const Vec3<A> w = between<A>(p.vertex(i), q.vertex(j));
  return p.ways(i, [&](const Vec3<A>& way) { return is_negative(dot(w, way)); }) &&
         q.ways(j, [&](const Vec3<A>& way) { return is_positive(dot(w, way)); });
}

/// The way from the foot on an edge along d to a point at w from it is (d x w) x d.
template <class P, class Q>
bool prove_vertex_edge(const P& p, std::uint32_t i, const Q& q, std::uint32_t j) {
  CertainSigns ask;
  const Edge3<A> e = linear<A>(q.edge(j));
  if (place_near<A>(e, p.vertex(i), ask) != SpotOnLine::inside || !ask.certain()) return false;
  const Vec3<A> c = cross(e.along, between<A>(e.from, p.vertex(i)));
  return p.ways(i, [&](const Vec3<A>& way) { return is_positive(dot(c, cross(e.along, way))); }) &&
         q.beside(j, e.from, [&](const Vec3<A>& way) { return is_negative(dot(c, cross(e.along, way))); });
}

template <class P, class Q>
bool prove_edges(const P& p, std::uint32_t i, const Q& q, std::uint32_t j) {
  CertainSigns ask;
  const Edge3<A> e = linear<A>(p.edge(i)), f = linear<A>(q.edge(j));
  if (!cross_within(e, f, ask)) return false;
  const Vec3<A> n = cross(e.along, f.along);
  const Sign toward_q = ask(dot(between<A>(e.from, f.from), n));
  if (!ask.certain()) return false;
  return p.beside(i, e.from, [&](const Vec3<A>& way) { return ask(dot(n, way)) * toward_q == Sign::negative; }) &&
         q.beside(j, f.from, [&](const Vec3<A>& way) { return ask(dot(n, way)) * toward_q == Sign::positive; });
}

template <class P>
bool prove_vertex_face(const P& p, std::uint32_t i, const Triangle3& t) {
  CertainSigns ask;
  const TriangleFace<A> face = face_of<A>(t);
  if (!projects_within(face, p.vertex(i), ask)) return false;
  const Sign above = ask(dot(face.normal, between<A>(t.a, p.vertex(i))));
  return p.ways(i, [&](const Vec3<A>& way) { return ask(dot(face.normal, way)) * above == Sign::positive; });
}

struct Plain {
  double x, y, z;
  friend Plain operator-(const Plain& a, const Plain& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};
Plain plain(const Point3& p) { return {p.x, p.y, p.z}; }
double dot(const Plain& a, const Plain& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Plain cross(const Plain& a, const Plain& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Plain moved(const Plain& p, const Plain& d, double t) { return {p.x + t * d.x, p.y + t * d.y, p.z + t * d.z}; }

/// A line, ray or segment whose products with itself are known.
struct PlainLine {
  Plain from, along;
  double square;
  bool starts, ends;
};
PlainLine plain(const Line& l) {
  const Plain from = plain(l.from);
  const Plain along = l.ends ? plain(l.to) - from : Plain{l.direction.x, l.direction.y, l.direction.z};
  return {from, along, dot(along, along), l.starts, l.ends};
}

struct PlainPair {
  SpotsOnLines places;
  Plain p, q;
  double square;
};

SpotOnLine clamp(const PlainLine& l, double& t) {
  if (l.starts && !(t > 0)) return t = 0, SpotOnLine::start;
  if (l.ends && !(t < 1)) return t = 1, SpotOnLine::end;
  return SpotOnLine::inside;
}

/// As it is commonly written; of parallel lines anything.
PlainPair plain_pair(const PlainLine& l, const PlainLine& m) {
  const Plain r = l.from - m.from;
  const double b = dot(l.along, m.along), c = dot(l.along, r), f = dot(m.along, r);
  double s = (b * f - c * m.square) / (l.square * m.square - b * b);
  SpotOnLine on_l = clamp(l, s);
  double t = (b * s + f) / m.square;
  const SpotOnLine on_m = clamp(m, t);
  if (on_m != SpotOnLine::inside) {
    s = (b * t - c) / l.square;
    on_l = clamp(l, s);
  }
  const Plain p = moved(l.from, l.along, s), q = moved(m.from, m.along, t), w = q - p;
  return {{on_l, on_m}, p, q, dot(w, w)};
}

/// The square of the distance from the face, where the point projects into it.
struct PlainFace {
  Plain corner, u, v, normal;
  double whole;
  explicit PlainFace(const std::array<Plain, 3>& t)
      : corner(t[0]), u(t[1] - t[0]), v(t[2] - t[0]), normal(cross(u, v)), whole(dot(normal, normal)) {}
  [[nodiscard]] std::optional<double> square_above(const Plain& p) const {
    const Plain w = p - corner;
    const double g = dot(cross(u, w), normal), b = dot(cross(w, v), normal), gap = dot(w, normal);
    if (!(g > 0 && b > 0 && g + b < whole)) return {};
    return gap * gap / whole;
  }
};

constexpr double no_bound = std::numeric_limits<double>::infinity();

template <class P, class Q>
bool proved(const P& p, Feature a, const Q& q, Feature b) {
  if (a.kind == FeatureKind::vertex) {
    if (b.kind == FeatureKind::vertex) return prove_vertices(p, a.index, q, b.index);
    return prove_vertex_edge(p, a.index, q, b.index);
  }
  if (b.kind == FeatureKind::vertex) return prove_vertex_edge(q, b.index, p, a.index);
  return prove_edges(p, a.index, q, b.index);
}

/// A place on edge number i of a triangle.
Feature on_triangle(std::uint32_t i, SpotOnLine place) {
  if (place == SpotOnLine::inside) return edge_number(i);
  return vertex_number(place == SpotOnLine::start ? i : (i + 1) % 3);
}

/// Does the edge cross the face?  Nothing where a sign is not certain, or zero.
std::optional<bool> crosses(const Line& line, const Triangle3& t, const TriangleFace<A>& face) {
  CertainSigns ask;
  const Edge3<A> e = linear<A>(line);
  const bool yes = crosses_within(e, face, dot(e.along, face.normal), ask);
  if (yes || ask.certain()) return yes;
  // Both ends on one side of the plane: no more need be known.
  if (!line.ends) return {};
  CertainSigns ends;
  const Sign from = ends(dot(face.normal, between<A>(t.a, line.from)));
  const Sign to = ends(dot(face.normal, between<A>(t.a, line.to)));
  if (ends.certain() && from == to) return false;
  return {};
}

}  // namespace

std::optional<FeaturePair> certain_features(const Line& a, const Triangle3& b) {
  const LineShape p{a};
  const TriangleShape q = shape(b);
  const PlainLine l = plain(a);
  const std::array<Plain, 3> corner{plain(b.a), plain(b.b), plain(b.c)};
  double least = no_bound;
  FeaturePair best{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const PlainPair c = plain_pair(l, plain(q.edge(i)));
    if (!(c.square < least)) continue;
    least = c.square;
    best = {c.places.a == SpotOnLine::inside ? edge_number(0) : vertex_at(c.places.a), on_triangle(i, c.places.b)};
  }
  const PlainFace face(corner);
  for (std::uint32_t i = 0; i < 2; ++i) {
    if (i == 0 ? !a.starts : !a.ends) continue;
    const auto square = face.square_above(plain(p.vertex(i)));
    if (!square || !(*square < least)) continue;
    least = *square;
    best = {vertex_number(i), the_face};
  }
  if (best.b.kind == FeatureKind::face) {
    if (prove_vertex_face(p, best.a.index, b)) return best;
  } else if (least < no_bound && proved(p, best.a, q, best.b)) {
    return best;
  }
  if (crosses(a, b, face_of<A>(b)) == true) return FeaturePair{edge_number(0), the_face};
  return {};
}

namespace {

/// The one of two crossings that comes first, where their x tells.
std::optional<FeaturePair> first_end(const Triangle3& a, const Triangle3& b) {
  const TriangleShape p = shape(a), q = shape(b);
  const TriangleFace<A> of_a = face_of<A>(a), of_b = face_of<A>(b);
  std::array<FeaturePair, 2> end{};
  std::array<Line, 2> line{p.edge(0), p.edge(0)};
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const bool first = i < 3;
    const Line edge = first ? p.edge(i) : q.edge(i - 3);
    const auto crossing = first ? crosses(edge, b, of_b) : crosses(edge, a, of_a);
    if (!crossing || (*crossing && count == 2)) return {};
    if (!*crossing) continue;
    line[count] = edge;
    end[count++] = first ? FeaturePair{edge_number(i), the_face} : FeaturePair{the_face, edge_number(i - 3)};
  }
  if (count != 2) return {};
  const auto at = [&](std::size_t i) { return quick_crossing(line[i], end[i].a == the_face ? a : b); };
  const auto x = at(0), y = at(1);
  if (!x || !y || x->x == y->x) return {};
  return x->x < y->x ? end[0] : end[1];
}

}  // namespace

std::optional<FeaturePair> certain_features(const Triangle3& a, const Triangle3& b) {
  const TriangleShape p = shape(a), q = shape(b);
  const std::array<Plain, 3> corners_a{plain(a.a), plain(a.b), plain(a.c)};
  const std::array<Plain, 3> corners_b{plain(b.a), plain(b.b), plain(b.c)};
  const std::array<PlainLine, 3> edges_a{plain(p.edge(0)), plain(p.edge(1)), plain(p.edge(2))};
  const std::array<PlainLine, 3> edges_b{plain(q.edge(0)), plain(q.edge(1)), plain(q.edge(2))};
  double least = no_bound;
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      const PlainPair c = plain_pair(edges_a[i], edges_b[j]);
      if (!(c.square < least)) continue;
      least = c.square;
      const Plain w = c.q - c.p;
      if (!(dot(w, corners_a[(i + 2) % 3] - c.p) <= 0 && dot(w, corners_b[(j + 2) % 3] - c.q) >= 0)) continue;
      const FeaturePair best{on_triangle(i, c.places.a), on_triangle(j, c.places.b)};
      if (proved(p, best.a, q, best.b)) return best;
      return first_end(a, b);
    }
  }
  const PlainFace of_a(corners_a), of_b(corners_b);
  std::uint32_t over = 6;  // the corner of a, or 3 more than that of b, that is over the other face
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto above_b = of_b.square_above(corners_a[i]), above_a = of_a.square_above(corners_b[i]);
    if (above_b && *above_b < least) least = *above_b, over = i;
    if (above_a && *above_a < least) least = *above_a, over = i + 3;
  }
  if (over < 3 && prove_vertex_face(p, over, b)) return FeaturePair{vertex_number(over), the_face};
  if (over >= 3 && over < 6 && prove_vertex_face(q, over - 3, a)) return FeaturePair{the_face, vertex_number(over - 3)};
  return first_end(a, b);
}

}  // namespace plumb::query
