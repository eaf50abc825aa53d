#include "plumb/query/ray/hits.hpp"

#include "query/ray/shot.hpp"

namespace plumb {

bool hits(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  return query::as_given(ray, [&](const auto& given) { return hits(given, triangle, rule); });
}
bool hits(const AnyRay& ray, const Sphere3& sphere) {
  return query::as_given(ray, [&](const auto& given) { return hits(given, sphere); });
}
bool hits(const AnyRay& ray, const Aabb3& box) {
  return query::as_given(ray, [&](const auto& given) { return hits(given, box); });
}

}  // namespace plumb
