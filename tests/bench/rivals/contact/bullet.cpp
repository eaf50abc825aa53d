#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <memory>

#include "bench/rivals/bullet_calls.hpp"
#include "bench/rivals/contact/rival.hpp"

namespace plumb::bench {
namespace {

class Counted final : public btDiscreteCollisionDetectorInterface::Result {
 public:
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3&, btScalar) override { ++count; }
  int count = 0;
};

std::shared_ptr<const btConvexHullShape> hull(const ConvexPolyhedron3& p) {
  auto shape = std::make_shared<btConvexHullShape>();
  for (const Point3& v : p.mesh.vertices) shape->addPoint(btVector3(v.x, v.y, v.z), false);
  shape->recalcLocalAabb();
  shape->setMargin(0);
  return shape;
}

}  // namespace

AskContact bullet_contact(const Obb3& a, const Obb3& b) {
  const auto box = [](const Obb3& o) {
    const auto& [u, v, w] = o.axes;
    const std::array numbers{o.center.x, o.center.y, o.center.z, u.x, u.y,      u.z,      v.x,     v.y,
                             v.z,        w.x,        w.y,        w.z, o.half.x, o.half.y, o.half.z};
    return std::make_shared<bullet::Box>(bullet::box(numbers.data()));
  };
  return [p = box(a), q = box(b)] {
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    input.m_transformA = p->place;
    input.m_transformB = q->place;
    Counted contact;
    btBoxBoxDetector(&p->shape, &q->shape).getClosestPoints(input, contact, nullptr);
    return contact.count;
  };
}

AskContact bullet_contact(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  return [p = hull(a), q = hull(b)] {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(p.get(), q.get(), &simplex, &depth);
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    input.m_transformA.setIdentity();
    input.m_transformB.setIdentity();
    Counted contact;
    detector.getClosestPoints(input, contact, nullptr);
    return contact.count;
  };
}

}  // namespace plumb::bench
