// How is Bullet asked?  Its shapes from plain numbers and its functions, as built for doubles (its float64 libraries).
//
// Laws: none; it is on trial.  Margins are set to 0 where they are the caller's.
// Source: Bullet 3.24's headers.
// Cost: Bullet's.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/Gimpact/btTriangleShapeEx.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <LinearMath/btAabbUtil2.h>

#include <array>
#include <limits>
#include <vector>

namespace plumb::bench::bullet {

inline btVector3 point(const double* x) { return {x[0], x[1], x[2]}; }

class AnyHit final : public btTriangleRaycastCallback {
 public:
  using btTriangleRaycastCallback::btTriangleRaycastCallback;
  btScalar reportHit(const btVector3&, btScalar fraction, int, int) override {
    hit = true;
    return fraction;
  }
  bool hit = false;
};

class AnyContact final : public btDiscreteCollisionDetectorInterface::Result {
 public:
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3&, btScalar) override { any = true; }
  bool any = false;
};

inline btPrimitiveTriangle triangle(const double* x) {
  btPrimitiveTriangle t;
  for (int i = 0; i < 3; ++i) t.m_vertices[i] = point(x + 3 * i);
  t.m_margin = 0;
  t.buildTriPlane();
  return t;
}

struct Box {
  btBoxShape shape;
  btTransform place;
};
inline Box box(const double* x) {
  const btMatrix3x3 axes(x[3], x[6], x[9], x[4], x[7], x[10], x[5], x[8], x[11]);  // in columns
  return {btBoxShape(point(x + 12)), btTransform(axes, point(x))};
}

/// As btConvexConvexAlgorithm asks; the sphere of radius 0 and clouds of points are Bullet's points and segments.
inline double gap(const btConvexShape& a, const btConvexShape& b) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&a, &b, &simplex, &depth);
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA.setIdentity();
  input.m_transformB.setIdentity();
  btPointCollector found;
  detector.getClosestPoints(input, found, nullptr);
  return !found.m_hasResult ? std::numeric_limits<double>::quiet_NaN() : found.m_distance < 0 ? 0 : found.m_distance;
}

/// The hull of points, which the shape refers to.
class Cloud {
 public:
  Cloud(const double* x, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) points_.push_back(point(x + 3 * i));
  }
  [[nodiscard]] btConvexPointCloudShape shape() const {
    btConvexPointCloudShape s(const_cast<btVector3*>(points_.data()), static_cast<int>(points_.size()),
                              btVector3(1, 1, 1), false);
    s.setMargin(0);
    return s;
  }

 private:
  std::vector<btVector3> points_;
};

inline bool hits(const btVector3& from, const btVector3& to, std::array<btVector3, 3> corners) {
  AnyHit callback(from, to);
  callback.processTriangle(corners.data(), 0, 0);
  return callback.hit;
}

/// As btGImpactCollisionAlgorithm asks.
inline bool meet(btPrimitiveTriangle a, btPrimitiveTriangle b) {
  GIM_TRIANGLE_CONTACT contact;
  return a.overlap_test_conservative(b) && a.find_triangle_collision_clip_method(b, contact);
}

inline bool meet(const Box& a, const Box& b) {
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = a.place;
  input.m_transformB = b.place;
  AnyContact contact;
  btBoxBoxDetector(&a.shape, &b.shape).getClosestPoints(input, contact, nullptr);
  return contact.any;
}

}  // namespace plumb::bench::bullet
