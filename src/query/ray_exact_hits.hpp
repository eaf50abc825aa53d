// Is it hit, where doubles do not tell?  Of finite numbers: who calls has asked.
#pragma once

#include "plumb/query/ray.hpp"

namespace plumb::query {

bool is_hit(const AnyRay& ray, const Triangle3& triangle, HitRule rule);
bool is_hit(const AnyRay& ray, const Sphere3& sphere);
bool is_hit(const AnyRay& ray, const Aabb3& box);

}  // namespace plumb::query
