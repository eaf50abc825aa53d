// btCollisionWorld: a pair is told where its manifold has a point whose distance is 0 at most.
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <memory>

#include "bench/rivals/stability/rival.hpp"

namespace plumb::bench {

using lab::stability::BodyPairs, lab::stability::WorldBody;

BodyPairs told_by_bullet(std::span<const WorldBody> bodies) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  std::vector<std::unique_ptr<btConvexShape>> shapes;
  std::vector<std::unique_ptr<btCollisionObject>> objects;
  for (const WorldBody& body : bodies) {
    if (body.half) {
      shapes.push_back(std::make_unique<btBoxShape>(btVector3(body.half->x, body.half->y, body.half->z)));
    } else {
      auto hull = std::make_unique<btConvexHullShape>();
      for (const Point3& p : body.corners) hull->addPoint(btVector3(p.x, p.y, p.z));
      shapes.push_back(std::move(hull));
    }
    shapes.back()->setMargin(0);
    const auto& [turn, t] = body.pose;
    objects.push_back(std::make_unique<btCollisionObject>());
    objects.back()->setCollisionShape(shapes.back().get());
    objects.back()->setUserIndex(static_cast<int>(objects.size() - 1));
    objects.back()->setWorldTransform(
        btTransform(btQuaternion(turn.x, turn.y, turn.z, turn.w).normalized(), btVector3(t.x, t.y, t.z)));
    world.addCollisionObject(objects.back().get());
  }
  world.performDiscreteCollisionDetection();
  BodyPairs told;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    const auto a = static_cast<std::uint32_t>(manifold.getBody0()->getUserIndex());
    const auto b = static_cast<std::uint32_t>(manifold.getBody1()->getUserIndex());
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      if (manifold.getContactPoint(k).getDistance() <= 0) told.insert({std::min(a, b), std::max(a, b)});
    }
  }
  for (const auto& object : objects) world.removeCollisionObject(object.get());
  return told;
}

}  // namespace plumb::bench
