#include "query/kinds/kind_hit.hpp"

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb::degenerate {

namespace {

bool inner(const Ray3& ray, const Triangle3& triangle) { return relate(ray, triangle) == Relation::overlapping; }

bool holds_inside(const Triangle3& triangle, const Point3& p) {
  return relate(Segment3{p, p}, triangle) == Relation::overlapping;
}

// More than the origin in common; a ray without direction is its origin, and has no end.
bool beyond_origin(const Ray3& ray, const Triangle3& triangle) {
  if (ray.direction == Vector3{0, 0, 0}) return true;
  return first_hit_parameter(ray, triangle)->sign() == Sign::positive ||
         intersection(ray, triangle).kind != IntersectionKind::point;
}

}  // namespace

Answer first_hit_under(const Ray3& ray, const Triangle3& triangle, const Convention& c) {
  const auto hit = first_hit(ray, triangle);
  if (!hit) return 0.0;
  const bool open = c.ends == Ends::open;
  const bool counts = c.boundary == Boundary::out
                          ? inner(ray, triangle) || (!open && holds_inside(triangle, ray.origin))
                          : !open || beyond_origin(ray, triangle);
  if (!counts) return 0.0;
  Answer yes = 1.0;
  yes.numbers.push_back(hit->t);
  return yes;
}

}  // namespace plumb::degenerate
