// Which features of two figures in the plane z = 0 have a point in common?  One of them a segment.
//
// Tells take(feature_a, feature_b) of every two: vertices and edges by exact coordinates, and what a figure is as a whole,
// which holds ends of the segment.
// Laws: exact; of figures that meet at least one pair is told.
// Source: RTCD 5.1.9, 5.4.
// Cost: some microseconds; for what overlaps from the start along a line.
#pragma once

#include <concepts>
#include <tuple>

#include "plumb/arith/big.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "query/body/vectors.hpp"
#include "query/time_of_impact/moving_body.hpp"

namespace plumb::query {

class FlatFeatures {
 public:
  template <class Shape>
  explicit FlatFeatures(const Shape& s) : body(moving_body<BigDyadic>(BodyShape(&s))) {
    whole = body.vertices.size() == 1 ? body.vertex_features[0]
            : body.faces.empty()      ? body.edges[0].feature
                                      : Feature{FeatureKind::face, 0};
  }

  using Place = Vec3<BigDyadic>;
  [[nodiscard]] const Place& from(std::size_t edge) const { return body.vertices[body.edges[edge].ends[0]]; }
  [[nodiscard]] const Place& to(std::size_t edge) const { return body.vertices[body.edges[edge].ends[1]]; }
  /// On which side of an edge is a place?
  [[nodiscard]] Sign side(std::size_t edge, const Place& p) const {
    return cross(to(edge) - from(edge), p - from(edge)).z.sign();
  }
  [[nodiscard]] bool on_edge(std::size_t edge, const Place& p) const {
    return side(edge, p) == Sign::zero && dot(p - from(edge), p - to(edge)).sign() != Sign::positive;
  }

  MovingBody<BigDyadic> body;
  Feature whole;
};

namespace flat_features {

inline bool equal(const FlatFeatures::Place& p, const FlatFeatures::Place& q) {
  const auto d = p - q;
  return d.x.sign() == Sign::zero && d.y.sign() == Sign::zero;
}
inline bool cross_at_edges(const FlatFeatures& a, std::size_t i, const FlatFeatures& b, std::size_t j) {
  const auto between = [](const FlatFeatures& e, std::size_t k, const FlatFeatures& f, std::size_t l) {
    const Sign from = e.side(k, f.from(l)), to = e.side(k, f.to(l));
    return from != Sign::zero && from == -to;
  };
  return between(a, i, b, j) && between(b, j, a, i);
}
/// Ends of a segment that the other holds.
template <class Other, class Take>
void tell_ends(const Segment3& s, const Other& other, const Feature& whole, const Take& take) {
  if (contains(other, s.a)) take(Feature{FeatureKind::vertex, 0}, whole);
  if (contains(other, s.b)) take(Feature{FeatureKind::vertex, 1}, whole);
}

}  // namespace flat_features

template <class A, class B, class Take>
void tell_meeting_features(const A& of_a, const B& of_b, const Take& take) {
  const FlatFeatures a(of_a), b(of_b);
  take(a.whole, b.whole);
  if constexpr (std::same_as<A, Segment3> && !std::same_as<B, Point3>) {
    flat_features::tell_ends(of_a, of_b, b.whole, take);
  } else if constexpr (std::same_as<B, Segment3> && !std::same_as<A, Point3>) {
    flat_features::tell_ends(of_b, of_a, a.whole, [&](const Feature& end, const Feature& whole) { take(whole, end); });
  }
  if (a.body.swept || b.body.swept) return;  // there a vertex is no point
  const auto& [vertices_a, features_a] = std::tie(a.body.vertices, a.body.vertex_features);
  const auto& [vertices_b, features_b] = std::tie(b.body.vertices, b.body.vertex_features);
  for (std::size_t i = 0; i < vertices_a.size(); ++i) {
    for (std::size_t j = 0; j < vertices_b.size(); ++j) {
      if (flat_features::equal(vertices_a[i], vertices_b[j])) take(features_a[i], features_b[j]);
    }
    for (std::size_t j = 0; j < b.body.edges.size(); ++j) {
      if (b.on_edge(j, vertices_a[i])) take(features_a[i], b.body.edges[j].feature);
    }
  }
  for (std::size_t i = 0; i < a.body.edges.size(); ++i) {
    for (std::size_t j = 0; j < vertices_b.size(); ++j) {
      if (a.on_edge(i, vertices_b[j])) take(a.body.edges[i].feature, features_b[j]);
    }
    for (std::size_t j = 0; j < b.body.edges.size(); ++j) {
      if (flat_features::cross_at_edges(a, i, b, j)) take(a.body.edges[i].feature, b.body.edges[j].feature);
    }
  }
}

}  // namespace plumb::query
