// Which rays must be shot at a shape?  Those aimed exactly at its corners, edges and faces, from near, far and inside.
//
// A ray of a Material is drawn after the shape, so that its probes lie on what was drawn.
#pragma once

#include <cmath>

#include "figure/basic/shape_cases.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb::ray_cases {

using shape_cases::Material, shape_cases::on_shapes;

inline Vector3 toward(const Point3& from, const Point3& to) {
  const Vector3 d{to.x - from.x, to.y - from.y, to.z - from.z};
  return std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z) ? d : Vector3{to.x, to.y, to.z};
}

/// Of any kind; often through a probe, along an axis, or none.
inline AnyRay ray_of(Material& m) {
  const Point3 origin = m.probe3(), target = m.probe3();
  const std::size_t kind = m.below(3), way = m.below(8);
  Vector3 d = toward(origin, target);
  if (way == 0) d = m.vector3();
  if (way == 1) d = {0, d.y, d.z};
  if (way == 2) d = {0, 0, d.z};
  if (way == 3) d = {-d.x, -d.y, -d.z};
  if (kind == 0) return Ray3{origin, d};
  if (kind == 1) return Segment3{origin, way == 4 ? origin : target};
  return Line3{origin, d};
}

inline std::string text_of(const AnyRay& r) {
  const auto kind = r.kind == AnyRay::Kind::ray ? "ray" : r.kind == AnyRay::Kind::segment ? "segment" : "line";
  std::string text = kind;
  for (const double x :
       {r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z, r.end.x, r.end.y, r.end.z}) {
    std::array<char, 40> digits{};
    std::snprintf(digits.data(), digits.size(), " %a", x);
    text += digits.data();
  }
  return text;
}

/// How often did what happen?
struct Tally {
  long misses = 0, vertices = 0, edges = 0, faces = 0, interiors = 0;
  void count(const std::optional<Hit>& hit) {
    if (!hit) {
      ++misses;
      return;
    }
    switch (hit->feature.kind) {
      case FeatureKind::vertex:
        ++vertices;
        break;
      case FeatureKind::edge:
        ++edges;
        break;
      case FeatureKind::face:
        ++faces;
        break;
      default:
        ++interiors;
    }
  }
};

}  // namespace plumb::ray_cases
