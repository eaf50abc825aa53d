#include "query/ray/hit_order.hpp"

#include "plumb/certify/ray_order.hpp"
#include "query/ray/numbers.hpp"

namespace plumb::query {

Sign compare_hits(const AnyRay& ray, const Triangle3& first, const Triangle3& second, HitRule rule) {
  const std::array<Point3, 3> p{first.a, first.b, first.c}, q{second.a, second.b, second.c};
  const auto quick = ends(ray) ? compare_segment_parameters(ray.origin, ray.end, p, q)
                               : compare_ray_parameters(ray.origin, ray.direction, p, q);
  if (quick) return *quick;
  const auto order = *first_hit_parameter(ray, first, rule) <=> *first_hit_parameter(ray, second, rule);
  return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero;
}

}  // namespace plumb::query
