#include <btBulletCollisionCommon.h>

#include <cmath>

#include "bench/rivals/world/rival.hpp"

namespace plumb::rivals {

struct BulletCubes::State {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
  btBoxShape cube{btVector3(0.5, 0.5, 0.5)};
  std::vector<std::unique_ptr<btCollisionObject>> objects;
};

BulletCubes::BulletCubes(std::size_t n) : state_(std::make_unique<State>()) {
  State& s = *state_;
  for (std::size_t i = 0; i < n; ++i) {
    s.objects.push_back(std::make_unique<btCollisionObject>());
    s.objects.back()->setCollisionShape(&s.cube);
    // In no order: its tree of boxes, which is never balanced, becomes a list of what comes in order.
    s.objects.back()->getWorldTransform().setOrigin(btVector3(static_cast<double>(i * 48271 % 100003) * 10, 0, 0));
    s.world.addCollisionObject(s.objects.back().get());
  }
}
BulletCubes::~BulletCubes() {
  for (const auto& object : state_->objects) state_->world.removeCollisionObject(object.get());
}

void BulletCubes::place(std::size_t i, const std::array<double, 4>& at) {
  btTransform& t = state_->objects[i]->getWorldTransform();
  t.setOrigin(btVector3(at[0], at[1], at[2] + 0.5));
  t.setRotation(btQuaternion(btVector3(0, 0, 1), 2 * std::atan(at[3])));
}

std::size_t BulletCubes::detect() {
  state_->world.performDiscreteCollisionDetection();
  std::size_t points = 0;
  for (int i = 0; i < state_->dispatcher.getNumManifolds(); ++i) {
    points += static_cast<std::size_t>(state_->dispatcher.getManifoldByIndexInternal(i)->getNumContacts());
  }
  return points;
}

bool BulletCubes::is_met(const std::array<double, 3>& from, const std::array<double, 3>& to) const {
  const btVector3 p(from[0], from[1], from[2]), q(to[0], to[1], to[2]);
  btCollisionWorld::ClosestRayResultCallback found(p, q);
  state_->world.rayTest(p, q, found);
  return found.hasHit();
}

}  // namespace plumb::rivals
