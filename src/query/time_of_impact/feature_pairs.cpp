#include "query/time_of_impact/feature_pairs.hpp"

#include <cstdint>
#include <utility>

namespace plumb::query::moving {
namespace {

Feature vertex(std::uint32_t i) { return {FeatureKind::vertex, i}; }
Feature edge(std::uint32_t i) { return {FeatureKind::edge, i}; }

FeaturePair vertex_vertex(const MovingVector& p, const MovingVector& q, Feature a, Feature b) {
  const MovingVector w = difference(p, q);
  const arith::Polynomial square = dot(w, w);
  return {square, {1}, square, {}, a, b};
}

FeaturePair vertex_edge(const MovingVector& p, const MovingVector& from, const MovingVector& to, Feature a, Feature b) {
  const MovingVector w = difference(p, from), e = difference(to, from), c = cross(w, e);
  const arith::Polynomial square = dot(e, e), along = dot(w, e), numerator = dot(c, c);
  return {numerator, square, numerator, {along, difference(square, along)}, a, b};
}

FeaturePair vertex_face(const FourMoving& p) {
  const MovingVector e = difference(p[2], p[1]), f = difference(p[3], p[1]), w = difference(p[0], p[1]);
  const MovingVector n = cross(e, f);
  const arith::Polynomial gap = dot(w, n), square = dot(n, n);
  // w = u e + v f + a multiple of n: u and v times the square.
  const arith::Polynomial u = dot(cross(w, f), n), v = dot(cross(e, w), n);
  return {product(gap, gap), square, gap, {u, v, difference(square, sum(u, v))}, vertex(0), {FeatureKind::face, 0}};
}

FeaturePair edge_edge(const FourMoving& p) {
  const MovingVector e = difference(p[1], p[0]), f = difference(p[3], p[2]), w = difference(p[2], p[0]);
  const MovingVector n = cross(e, f);
  const arith::Polynomial gap = dot(w, n), square = dot(n, n);
  // w = u e - v f + a multiple of n: u and v times the square.
  const arith::Polynomial u = dot(cross(w, f), n), v = dot(cross(w, e), n);
  return {product(gap, gap), square, gap, {u, v, difference(square, u), difference(square, v)}, edge(0), edge(0)};
}

}  // namespace

std::vector<FeaturePair> feature_pairs(MovingKind kind, const FourMoving& p, bool flat) {
  std::vector<FeaturePair> pairs;
  pairs.reserve(9);
  if (kind == MovingKind::vertex_triangle) {
    for (std::uint32_t i = 0; i < 3; ++i) pairs.push_back(vertex_vertex(p[0], p[i + 1], vertex(0), vertex(i)));
    for (std::uint32_t i = 0; i < 3; ++i) {
      pairs.push_back(vertex_edge(p[0], p[i + 1], p[(i + 1) % 3 + 1], vertex(0), edge(i)));
    }
    if (!flat) pairs.push_back(vertex_face(p));
    return pairs;
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (std::uint32_t j = 0; j < 2; ++j) pairs.push_back(vertex_vertex(p[i], p[j + 2], vertex(i), vertex(j)));
  }
  for (std::uint32_t i = 0; i < 2; ++i) pairs.push_back(vertex_edge(p[i], p[2], p[3], vertex(i), edge(0)));
  for (std::uint32_t j = 0; j < 2; ++j) pairs.push_back(vertex_edge(p[j + 2], p[0], p[1], edge(0), vertex(j)));
  if (!flat) pairs.push_back(edge_edge(p));
  return pairs;
}

}  // namespace plumb::query::moving
