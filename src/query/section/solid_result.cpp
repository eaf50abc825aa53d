#include "arith/exact_number.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/section/solid.hpp"
#include "query/section/meet_halfspaces.hpp"

namespace plumb::query {
namespace {

Exact3 exact_vertex(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  return {gmp_number(r.x), gmp_number(r.y), gmp_number(r.z)};
}

RationalHalfspace3 plane_of_corners(const Exact3& a, const Exact3& b, const Exact3& c) {
  const Exact3 normal = primitive(cross(b - a, c - a));
  return {meeting::rational_of(normal), exact_number(dot(normal, a))};
}

/// By the tetrahedra from the first vertex over the faces.
mpq_class volume_of_faces(const SolidIntersection3& a) {
  const Exact3 from = exact_vertex(a.vertices[0]);
  std::vector<Exact3> v;
  for (const ExactPoint3& p : a.vertices) v.push_back(exact_vertex(p) - from);
  mpq_class six_times = 0;
  for (std::size_t f = 0; f < a.faces(); ++f) {
    const auto ids = a.corners_of(f);
    if (ids[0] == 0) continue;  // flat
    for (std::size_t i = 2; i < ids.size(); ++i) six_times += dot(v[ids[0]], cross(v[ids[i - 1]], v[ids[i]]));
  }
  return six_times / 6;
}

}  // namespace
}  // namespace plumb::query

namespace plumb {

RationalHalfspace3 plane_of(const SolidIntersection3& solid, std::size_t face) {
  const auto ids = solid.corners_of(face);
  const auto corner = [&](std::size_t i) { return query::exact_vertex(solid.vertices[ids[i]]); };
  return query::plane_of_corners(corner(0), corner(1), corner(2));
}

std::vector<Point3> approximate(const SolidIntersection3& a) {
  std::vector<Point3> points;
  points.reserve(a.vertices.size());
  for (const ExactPoint3& p : a.vertices) points.push_back(approximate(p));
  return points;
}

Rational exact_volume(const SolidIntersection3& a) {
  if (!a.is_bounded()) throw InvalidShape("volume: the set goes on forever; cut it with a box");
  if (a.kind != IntersectionKind::solid || a.first.empty()) return Rational(0.0);
  return exact_number(query::volume_of_faces(a));
}

double volume(const SolidIntersection3& a) { return exact_volume(a).rounded(); }

bool operator==(const SolidIntersection3& a, const SolidIntersection3& b) {
  if (a.kind != b.kind || a.directions != b.directions || a.corners != b.corners || a.first != b.first) return false;
  if (a.kind == IntersectionKind::line || a.kind == IntersectionKind::ray)
    return Intersection3{a.kind, a.vertices} == Intersection3{b.kind, b.vertices};
  return a.vertices == b.vertices;
}

}  // namespace plumb
