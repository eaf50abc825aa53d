#include "query/vclip/nearest_features.hpp"

namespace plumb::query::vclipping {
namespace {

using Ends = DifferenceCorners::Ends;

/// Vertices of features, of either solid: those of a, then of b, whichever is which.
class Turned {
 public:
  explicit Turned(bool swapped) : swapped_(swapped) {}
  [[nodiscard]] Ends operator()(std::uint32_t first, std::uint32_t second) const {
    return swapped_ ? Ends{second, first} : Ends{first, second};
  }

 private:
  bool swapped_;
};

/// A vertex and the corners of the other feature that its nearest point needs.
std::optional<DifferenceCorners> to_edge(const Solid& v, std::uint32_t vertex, const Solid& e, std::uint32_t edge,
                                         const Turned& turned, CheckedSigns& sign) {
  const std::uint32_t head = e.next(edge);
  const auto toward = [&](std::uint32_t from, std::uint32_t to) {
    return sign(
        [&]<class T>() { return dot(v.place<T>(vertex) - e.place<T>(from), e.place<T>(to) - e.place<T>(from)); });
  };
  const Sign at_tail = toward(edge, head), at_head = toward(head, edge);
  if (at_tail == Sign::negative || at_head == Sign::negative) return {};
  DifferenceCorners d;
  if (at_tail == Sign::positive) d.add(turned(v.vertex(vertex), e.vertex(head)));
  if (at_head == Sign::positive) d.add(turned(v.vertex(vertex), e.vertex(edge)));
  return d;
}

/// By the triangles of a fan.
std::optional<DifferenceCorners> to_face(const Solid& v, std::uint32_t vertex, const Solid& f, std::uint32_t face,
                                         const Turned& turned, CheckedSigns& sign) {
  const std::uint32_t first = f.mesh().first[face], end = f.mesh().first[face + 1];
  // Seen in the plane of a triangle: is the vertex on its side of the edge from p to q?
  const auto side = [&](std::uint32_t p, std::uint32_t q, std::uint32_t third) {
    return sign([&]<class T>() {
      const Vec<T> from = f.place<T>(p), u = f.place<T>(q) - from, c = f.place<T>(third) - from;
      return dot(c * dot(u, u) - u * dot(u, c), v.place<T>(vertex) - from);
    });
  };
  for (std::uint32_t c = first + 1; c + 1 < end; ++c) {
    if (collinear(f.at(first), f.at(c), f.at(c + 1))) continue;
    const std::array<std::uint32_t, 3> triangle{first, c, c + 1};
    DifferenceCorners d;
    bool inside = true;
    for (std::size_t k = 0; k < 3 && inside; ++k) {
      const Sign s = side(triangle[(k + 1) % 3], triangle[(k + 2) % 3], triangle[k]);
      inside = s != Sign::negative;
      if (s == Sign::positive) d.add(turned(v.vertex(vertex), f.vertex(triangle[k])));
    }
    if (inside) return d;
  }
  return {};
}

/// Where two edges run parallel, an end of one is beside the other.
std::optional<DifferenceCorners> of_parallel(const Solid& a, std::uint32_t edge_a, const Solid& b, std::uint32_t edge_b,
                                             CheckedSigns& sign) {
  for (const std::uint32_t end : {edge_a, a.next(edge_a)}) {
    if (const auto d = to_edge(a, end, b, edge_b, Turned(false), sign)) return d;
  }
  for (const std::uint32_t end : {edge_b, b.next(edge_b)}) {
    if (const auto d = to_edge(b, end, a, edge_a, Turned(true), sign)) return d;
  }
  return {};
}

/// The numerators of where along two edges, from their tails, the nearest points are, and the denominator.
template <class T>
struct Parameters {
  T on_a, on_b, whole;
};
template <class T>
Parameters<T> parameters(const Solid& a, std::uint32_t edge_a, const Solid& b, std::uint32_t edge_b) {
  const Vec<T> from = a.place<T>(edge_a), to = b.place<T>(edge_b), u = a.place<T>(a.next(edge_a)) - from,
               w = b.place<T>(b.next(edge_b)) - to, r = from - to;
  const T uu = dot(u, u), ww = dot(w, w), uw = dot(u, w), ur = dot(u, r), wr = dot(w, r);
  const Vec<T> normal = cross(u, w);
  return {uw * wr - ww * ur, uu * wr - uw * ur, dot(normal, normal)};
}

std::optional<DifferenceCorners> of_edges(const Solid& a, std::uint32_t edge_a, const Solid& b, std::uint32_t edge_b,
                                          CheckedSigns& sign) {
  const auto asked = [&](const auto& take) {
    return sign([&]<class T>() { return take(parameters<T>(a, edge_a, b, edge_b)); });
  };
  if (asked([](const auto& p) { return p.whole; }) == Sign::zero) return of_parallel(a, edge_a, b, edge_b, sign);
  const Sign a_low = asked([](const auto&p) { return p.on_a; }), b_low = asked([](const auto&p) { return p.on_b; }),
             a_high = asked([](const auto&p) { return p.whole - p.on_a; }),
             b_high = asked([](const auto&p) { return p.whole - p.on_b; }),
             upper = asked([](const auto&p) { return p.on_a + p.on_b - p.whole; });
  if (a_low == Sign::negative || b_low == Sign::negative || a_high == Sign::negative || b_high == Sign::negative)
    return {};
  const std::uint32_t p = a.vertex(edge_a), q = a.vertex(a.next(edge_a)), r = b.vertex(edge_b),
                      s = b.vertex(b.next(edge_b));
  DifferenceCorners d;
  const auto add = [&](Sign weight, std::uint32_t of_a, std::uint32_t of_b) {
    if (weight == Sign::positive) d.add({of_a, of_b});
  };
  if (upper == Sign::positive) {  // of the parallelogram of differences, the half at both heads
    add(upper, q, s), add(b_high, q, r), add(a_high, p, s);
  } else {
    add(-upper, p, r), add(a_low, q, r), add(b_low, p, s);
  }
  return d;
}

/// The vertices of a feature, all of which are in the plane at right angles to the way.
class FeatureVertices {
 public:
  FeatureVertices(const Solid& s, const MeshFeature& f) : some_{s.vertex(f.corner), 0} {
    if (f.kind == FeatureKind::edge) some_[1] = s.vertex(s.next(f.corner)), size_ = 2;
    if (f.kind != FeatureKind::face) return;
    const std::uint32_t face = s.face_of(f.corner), first = s.mesh().first[face];
    face_ = std::span(s.mesh().corners).subspan(first, s.mesh().first[face + 1] - first);
  }
  [[nodiscard]] std::span<const std::uint32_t> all() const {
    return face_.empty() ? std::span(some_).first(size_) : face_;
  }

 private:
  std::array<std::uint32_t, 2> some_;
  std::size_t size_ = 1;
  std::span<const std::uint32_t> face_;
};

template <class T>
std::optional<FeaturesProved> proved(const Solid& a, const Solid& b, const DifferenceCorners& corners,
                                     std::span<const std::uint32_t> of_a, std::span<const std::uint32_t> of_b) {
  CertainSigns ask;
  const NearestOfCorners<T> n = nearest_of<T>(a.core(), b.core(), corners, ask);
  if (!ask.certain()) return {};
  const bool within = is_within(n, corners.size, ask);
  const Sign apart = ask(n.square);
  if (!ask.certain()) return {};
  if (!within || apart == Sign::zero) return FeaturesProved{within, within && apart == Sign::zero};
  const T zero(0.0);
  const bool holds = support_of(a.core(), of_a, n.way, ask).holds &&
                     support_of(b.core(), of_b, Vec<T>{zero, zero, zero} - n.way, ask).holds;
  if (!ask.certain()) return {};
  return FeaturesProved{holds, false};
}

/// The edge of the face above or in which the vertex is.
MeshFeature bounding_edge(const Solid& v, std::uint32_t vertex, const Solid& f, const MeshFeature& face,
                          CheckedSigns& sign) {
  const auto is = [&](const VoronoiPlane& p, Sign wanted) {
    return sign([&]<class T>() { return p.value(f, v.place<T>(vertex)); }) == wanted;
  };
  MeshFeature found = face;
  any_plane_of_face(f, f.face_of(face.corner), [&](const VoronoiPlane& p) {
    if (!is(p, Sign::zero)) return false;
    const auto is_beyond_end = [&](const VoronoiPlane& end) { return is(end, Sign::negative); };
    if (any_end_plane(f, p.beyond.corner, is_beyond_end)) return false;
    found = p.beyond;
    return true;
  });
  return found;
}

}  // namespace

MeshFeaturePair without_bounded_faces(const Solid& a, const Solid& b, MeshFeaturePair at, CheckedSigns& sign) {
  if (at.a.kind == FeatureKind::face) at.a = bounding_edge(b, at.b.corner, a, at.a, sign);
  if (at.b.kind == FeatureKind::face) at.b = bounding_edge(a, at.a.corner, b, at.b, sign);
  return at;
}

std::optional<DifferenceCorners> corners_of_features(const Solid& a, const Solid& b, const MeshFeaturePair& at,
                                                     CheckedSigns& sign) {
  using enum FeatureKind;
  const MeshFeature &p = at.a, &q = at.b;
  if (p.kind == vertex && q.kind == vertex) {
    DifferenceCorners d;
    d.add({a.vertex(p.corner), b.vertex(q.corner)});
    return d;
  }
  if (p.kind == vertex && q.kind == edge) return to_edge(a, p.corner, b, q.corner, Turned(false), sign);
  if (p.kind == edge && q.kind == vertex) return to_edge(b, q.corner, a, p.corner, Turned(true), sign);
  if (p.kind == vertex) return to_face(a, p.corner, b, b.face_of(q.corner), Turned(false), sign);
  if (q.kind == vertex) return to_face(b, q.corner, a, a.face_of(p.corner), Turned(true), sign);
  return of_edges(a, p.corner, b, q.corner, sign);
}

FeaturesProved prove_features(const Solid& a, const Solid& b, const MeshFeaturePair& at,
                              const DifferenceCorners& corners) {
  const FeatureVertices of_a(a, at.a), of_b(b, at.b);
  if (const auto p = proved<Running>(a, b, corners, of_a.all(), of_b.all())) return *p;
  if (const auto p = proved<ShortDyadic>(a, b, corners, of_a.all(), of_b.all())) return *p;
  return *proved<BigDyadic>(a, b, corners, of_a.all(), of_b.all());
}

}  // namespace plumb::query::vclipping
