// DynamicAABBTreeCollisionManager, and collide of each pair that it hands over.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <memory>

#include "bench/rivals/stability/rival.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::bench {
namespace {

using lab::stability::BodyPairs, lab::stability::WorldBody;
using Object = fcl::CollisionObjectd;

std::shared_ptr<fcl::CollisionGeometryd> shape_of(const WorldBody& body) {
  if (body.half) return std::make_shared<fcl::Boxd>(2 * body.half->x, 2 * body.half->y, 2 * body.half->z);
  const Hull3 hull = convex_hull(body.corners);
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  const auto faces = std::make_shared<std::vector<int>>();
  for (const Point3& p : body.corners) vertices->emplace_back(p.x, p.y, p.z);
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    faces->push_back(static_cast<int>(hull.face(f).size()));
    for (const std::uint32_t corner : hull.face(f)) faces->push_back(static_cast<int>(corner));
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.face_count()), faces);
}

bool note_pair(Object* a, Object* b, void* to) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  if (fcl::collide(a, b, request, result) == 0) return false;
  const auto number = [](const Object* o) { return *static_cast<const std::uint32_t*>(o->getUserData()); };
  static_cast<BodyPairs*>(to)->insert({std::min(number(a), number(b)), std::max(number(a), number(b))});
  return false;  // on to the next pair
}

}  // namespace

BodyPairs told_by_fcl(std::span<const WorldBody> bodies) {
  std::vector<std::uint32_t> numbers(bodies.size());
  std::vector<std::unique_ptr<Object>> objects;
  std::vector<Object*> all;
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    const auto& [turn, t] = bodies[i].pose;
    fcl::Transform3d place = fcl::Transform3d::Identity();
    place.linear() = fcl::Quaterniond(turn.w, turn.x, turn.y, turn.z).normalized().toRotationMatrix();
    place.translation() = fcl::Vector3d(t.x, t.y, t.z);
    objects.push_back(std::make_unique<Object>(shape_of(bodies[i]), place));
    numbers[i] = i;
    objects[i]->setUserData(&numbers[i]);
    all.push_back(objects[i].get());
  }
  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObjects(all);
  manager.setup();
  BodyPairs told;
  manager.collide(&told, note_pair);
  return told;
}

}  // namespace plumb::bench
