#include <limits>
#include <memory>

#include "bench/rivals/fcl_calls.hpp"
#include "bench/rivals/penetration/rival.hpp"

namespace plumb::bench {
namespace {

using fcl_calls::Vec;

std::shared_ptr<const fcl::Convexd> convex(const ConvexPolyhedron3& p) {
  auto vertices = std::make_shared<std::vector<Vec>>();
  for (const Point3& v : p.mesh.vertices) vertices->emplace_back(v.x, v.y, v.z);
  auto faces = std::make_shared<std::vector<int>>();
  int count = 0;
  for (std::size_t f = 0; f + 1 < p.mesh.first.size(); ++f, ++count) {
    faces->push_back(static_cast<int>(p.mesh.first[f + 1] - p.mesh.first[f]));
    for (std::uint32_t c = p.mesh.first[f]; c < p.mesh.first[f + 1]; ++c)
      faces->push_back(static_cast<int>(p.mesh.corners[c]));
  }
  return std::make_shared<const fcl::Convexd>(vertices, count, faces);
}

template <class Shape>
double depth_of(const Shape& a, const fcl::Transform3d& at_a, const Shape& b, const fcl::Transform3d& at_b) {
  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;
  if (fcl::collide(&a, at_a, &b, at_b, request, result) == 0) return std::numeric_limits<double>::quiet_NaN();
  return result.getContact(0).penetration_depth;
}

}  // namespace

AskDepth fcl_depth(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  return [p = convex(a), q = convex(b)] {
    static const fcl::Transform3d here = fcl::Transform3d::Identity();
    return depth_of(*p, here, *q, here);
  };
}

AskDepth fcl_depth(const Obb3& a, const Obb3& b) {
  const auto numbers = [](const Obb3& o) {
    const auto& [u, v, w] = o.axes;
    return std::array{o.center.x, o.center.y, o.center.z, u.x, u.y,      u.z,      v.x,     v.y,
                      v.z,        w.x,        w.y,        w.z, o.half.x, o.half.y, o.half.z};
  };
  return [p = fcl_calls::Box(numbers(a).data()), q = fcl_calls::Box(numbers(b).data())] {
    return depth_of(p.shape, p.place, q.shape, q.place);
  };
}

}  // namespace plumb::bench
