#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>

#include <memory>
#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {

std::size_t fcl_box_pairs(std::span<const Aabb3> boxes) {
  using Object = fcl::CollisionObject<double>;
  std::vector<std::unique_ptr<Object>> objects;
  std::vector<Object*> all;
  for (const auto& [min, max] : boxes) {
    const auto box = std::make_shared<fcl::Box<double>>(max.x - min.x, max.y - min.y, max.z - min.z);
    fcl::Transform3<double> place = fcl::Transform3<double>::Identity();
    place.translation() =
        fcl::Vector3<double>(min.x + (max.x - min.x) / 2, min.y + (max.y - min.y) / 2, min.z + (max.z - min.z) / 2);
    objects.push_back(std::make_unique<Object>(box, place));
    objects.back()->computeAABB();
    all.push_back(objects.back().get());
  }
  fcl::DynamicAABBTreeCollisionManager<double> manager;
  manager.registerObjects(all);
  manager.setup();
  std::size_t count = 0;
  manager.collide(&count, [](Object* a, Object* b, void* to) {
    *static_cast<std::size_t*>(to) += a->getAABB().overlap(b->getAABB()) ? 1 : 0;
    return false;
  });
  return count;
}

}  // namespace plumb::bench
