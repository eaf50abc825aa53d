#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>

#include <cmath>

#include "bench/rivals/world/rival.hpp"

namespace plumb::rivals {
namespace {

using Object = fcl::CollisionObjectd;

bool count_pair(Object* a, Object* b, void* count) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  if (fcl::collide(a, b, request, result) > 0) ++*static_cast<std::size_t*>(count);
  return false;  // on to the next pair
}

}  // namespace

struct FclCubes::State {
  std::shared_ptr<fcl::CollisionGeometryd> cube = std::make_shared<fcl::Boxd>(1, 1, 1);
  std::vector<std::unique_ptr<Object>> objects;
  std::vector<Object*> placed;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  bool is_built = false;
};

FclCubes::FclCubes(std::size_t n) : state_(std::make_unique<State>()) {
  for (std::size_t i = 0; i < n; ++i) state_->objects.push_back(std::make_unique<Object>(state_->cube));
}
FclCubes::~FclCubes() = default;

void FclCubes::place(std::size_t i, const std::array<double, 4>& at) {
  Object& cube = *state_->objects[i];
  cube.setTranslation(fcl::Vector3d(at[0], at[1], at[2] + 0.5));
  cube.setRotation(fcl::AngleAxisd(2 * std::atan(at[3]), fcl::Vector3d::UnitZ()).toRotationMatrix());
  cube.computeAABB();
  state_->placed.push_back(&cube);
}

std::size_t FclCubes::detect() {
  if (!state_->is_built) {
    std::vector<Object*> all;
    for (const auto& object : state_->objects) all.push_back(object.get());
    state_->manager.registerObjects(all);
    state_->manager.setup();
    state_->is_built = true;
  } else if (2 * state_->placed.size() > state_->objects.size()) {
    state_->manager.update();
  } else {
    state_->manager.update(state_->placed);
  }
  state_->placed.clear();
  std::size_t count = 0;
  state_->manager.collide(&count, count_pair);
  return count;
}

}  // namespace plumb::rivals
