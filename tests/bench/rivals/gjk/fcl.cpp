// FCL: collide of convex shapes, with its own GJK solver.
#include "bench/rivals/gjk/rival.hpp"

#ifdef PLUMB_BENCH_FCL
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>

#include "plumb/figure/hull/hull3.hpp"

namespace plumb::bench {
namespace {

using Hull = fcl::Convexd;

std::shared_ptr<void> make(const std::vector<double>& numbers) {
  std::vector<Point3> points;
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    vertices->emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  const Hull3 hull = convex_hull(points);
  auto faces = std::make_shared<std::vector<int>>();
  int count = 0;
  for (std::size_t f = 0; f + 1 < hull.first.size(); ++f, ++count) {
    faces->push_back(static_cast<int>(hull.first[f + 1] - hull.first[f]));
    for (std::size_t c = hull.first[f]; c < hull.first[f + 1]; ++c) faces->push_back(static_cast<int>(hull.corners[c]));
  }
  return std::make_shared<Hull>(vertices, count, faces);
}
bool meet(const void* a, const void* b) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::CollisionResultd result;
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  return fcl::collide(static_cast<const Hull*>(a), here, static_cast<const Hull*>(b), here, request, result) != 0;
}

}  // namespace

std::vector<GjkRival> gjk_fcl_rival() { return {{"fcl", make, meet}}; }

}  // namespace plumb::bench
#else
std::vector<plumb::bench::GjkRival> plumb::bench::gjk_fcl_rival() { return {}; }
#endif
