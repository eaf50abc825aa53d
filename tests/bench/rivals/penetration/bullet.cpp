#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <limits>
#include <memory>

#include "bench/rivals/bullet_calls.hpp"
#include "bench/rivals/penetration/rival.hpp"

namespace plumb::bench {
namespace {

std::shared_ptr<const btConvexHullShape> hull(const ConvexPolyhedron3& p) {
  auto shape = std::make_shared<btConvexHullShape>();
  for (const Point3& v : p.mesh.vertices) shape->addPoint(btVector3(v.x, v.y, v.z), false);
  shape->recalcLocalAabb();
  shape->setMargin(0);
  return shape;
}

double depth_of(const btConvexShape& a, const btTransform& at_a, const btConvexShape& b, const btTransform& at_b) {
  btGjkEpaSolver2::sResults results;
  if (!btGjkEpaSolver2::Penetration(&a, at_a, &b, at_b, at_a.getOrigin() - at_b.getOrigin(), results, false))
    return std::numeric_limits<double>::quiet_NaN();
  return -results.distance;
}

}  // namespace

AskDepth bullet_depth(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  return [p = hull(a), q = hull(b)] {
    static const btTransform here = btTransform::getIdentity();
    return depth_of(*p, here, *q, here);
  };
}

AskDepth bullet_depth(const Obb3& a, const Obb3& b) {
  const auto box = [](const Obb3& o) {
    const auto& [u, v, w] = o.axes;
    const std::array numbers{o.center.x, o.center.y, o.center.z, u.x, u.y,      u.z,      v.x,     v.y,
                             v.z,        w.x,        w.y,        w.z, o.half.x, o.half.y, o.half.z};
    auto p = std::make_shared<bullet::Box>(bullet::box(numbers.data()));
    p->shape.setMargin(0);
    return p;
  };
  return [p = box(a), q = box(b)] { return depth_of(p->shape, p->place, q->shape, q->place); };
}

}  // namespace plumb::bench
