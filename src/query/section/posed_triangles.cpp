#include "query/section/posed_triangles.hpp"

#include "query/convex/set_parts.hpp"
#include "query/section/meet.hpp"

namespace plumb::query {
namespace {

meeting::ConvexSet<3> exact_set(const PosedTriangle3& t) {
  std::vector<meeting::Vec<BigDyadic, 3>> corners;
  for (const Vec3<BigDyadic>& p : posed_corners<BigDyadic>(t)) corners.push_back({p.x, p.y, p.z});
  return meeting::flat_set(std::move(corners));
}

}  // namespace

Intersection3 intersection(const PosedTriangle3& a, const PosedTriangle3& b) {
  return meeting::meet(exact_set(a), exact_set(b));
}

}  // namespace plumb::query
