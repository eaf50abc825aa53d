#include "query/section/posed_triangles.hpp"

#include "plumb/query/section/posed.hpp"
#include "query/convex/set_parts.hpp"
#include "query/section/meet.hpp"

namespace plumb::query {
namespace {

meeting::ConvexSet<3> exact_set(const std::array<Vec3<BigDyadic>, 3>& at) {
  std::vector<meeting::Vec<BigDyadic, 3>> corners;
  for (const Vec3<BigDyadic>& p : at) corners.push_back({p.x, p.y, p.z});
  return meeting::flat_set(std::move(corners));
}

}  // namespace

Intersection3 intersection(const PosedTriangle3& a, const PosedTriangle3& b) {
  const CornersTogether<BigDyadic> both(a, b);
  if (both.has_weight) return posed_intersection3(posed_view(a), posed_view(b));
  return meeting::meet(exact_set(both.a), exact_set(both.b));
}

}  // namespace plumb::query
