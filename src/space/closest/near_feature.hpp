// Where on a figure is its nearest point: two figures that have the feature in common are equally near.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb::space {

/// One corner of a vertex, two of an edge, three of the face; the first in lexicographic order, others repeat it.
template <class Point>
struct NearFeature {
  FeatureKind kind;
  std::array<Point, 3> corners;
  friend bool operator==(const NearFeature&, const NearFeature&) = default;
};

/// Of corners in turn, each of which edges leave by its number.
template <class Point, std::size_t n>
NearFeature<Point> near_feature(const std::array<Point, n>& corners, Feature feature) {
  if (feature.kind == FeatureKind::vertex) {
    const Point& p = corners[feature.index];
    return {feature.kind, {p, p, p}};
  }
  if (feature.kind == FeatureKind::edge) {
    Point p = corners[feature.index], q = corners[(feature.index + 1) % n];
    if (coordinates(q) < coordinates(p)) std::swap(p, q);
    return {feature.kind, {p, q, p}};
  }
  return {feature.kind, {corners[0], corners[1], corners[n - 1]}};
}
inline NearFeature<Point3> near_feature(const Triangle3& t, Feature feature) {
  return near_feature(std::array{t.a, t.b, t.c}, feature);
}

/// Of the point p.
inline NearFeature<Point3> near_feature(const Triangle3& t, const Point3& p) {
  return near_feature(t, voronoi_region(t, p));
}
inline NearFeature<Point2> near_feature(const Triangle2& t, const Point2& p) {
  const Feature feature = voronoi_region(t, p);
  if (feature.kind == FeatureKind::face) return {FeatureKind::vertex, {p, p, p}};  // nothing is nearer than p itself
  return near_feature(std::array{t.a, t.b, t.c}, feature);
}
inline NearFeature<Point3> near_feature(const Segment3& s, const Point3& p) {
  return near_feature(std::array{s.a, s.b}, voronoi_region(s, p));
}
inline NearFeature<Point2> near_feature(const Segment2& s, const Point2& p) {
  return near_feature(std::array{s.a, s.b}, voronoi_region(s, p));
}
/// The point of a box that is nearest is one of doubles.
inline NearFeature<Point3> near_feature(const Aabb3& b, const Point3& p) {
  const Point3 q{std::clamp(p.x, b.min.x, b.max.x), std::clamp(p.y, b.min.y, b.max.y),
                 std::clamp(p.z, b.min.z, b.max.z)};
  return {FeatureKind::vertex, {q, q, q}};
}
inline NearFeature<Point2> near_feature(const Aabb2& b, const Point2& p) {
  const Point2 q{std::clamp(p.x, b.min.x, b.max.x), std::clamp(p.y, b.min.y, b.max.y)};
  return {FeatureKind::vertex, {q, q, q}};
}

}  // namespace plumb::space
