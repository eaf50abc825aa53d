// Where on a triangle is its nearest point: two triangles that have the feature in common are equally near.
#pragma once

#include <array>
#include <utility>

#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb::space {

/// One corner of a vertex, two of an edge, three of the face; the first in lexicographic order, others repeat it.
struct NearFeature {
  FeatureKind kind;
  std::array<Point3, 3> corners;
  friend bool operator==(const NearFeature&, const NearFeature&) = default;
};

inline NearFeature near_feature(const Triangle3& t, Feature feature) {
  const std::array corners{t.a, t.b, t.c};
  const auto before = [](const Point3& p, const Point3& q) {
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  if (feature.kind == FeatureKind::vertex) {
    const Point3& p = corners[feature.index];
    return {feature.kind, {p, p, p}};
  }
  if (feature.kind == FeatureKind::edge) {
    Point3 p = corners[feature.index], q = corners[(feature.index + 1) % 3];
    if (before(q, p)) std::swap(p, q);
    return {feature.kind, {p, q, p}};
  }
  return {feature.kind, corners};
}

}  // namespace plumb::space
