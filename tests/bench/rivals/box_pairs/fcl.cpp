#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>

#include <memory>
#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {
namespace {

template <class To>
void fcl_pairs(std::span<const Aabb3> boxes, To& to) {
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
    // A number, told as a place in the boxes.
    objects.back()->setUserData(const_cast<Aabb3*>(boxes.data() + all.size()));
    all.push_back(objects.back().get());
  }
  fcl::DynamicAABBTreeCollisionManager<double> manager;
  manager.registerObjects(all);
  manager.setup();
  struct Asked {
    To& to;
    const Aabb3* first;
  } asked{to, boxes.data()};
  manager.collide(&asked, [](Object* a, Object* b, void* held) {
    const Asked& told = *static_cast<Asked*>(held);
    const auto number = [&](const Object* o) {
      return static_cast<std::size_t>(static_cast<const Aabb3*>(o->getUserData()) - told.first);
    };
    if (a->getAABB().overlap(b->getAABB())) told.to(number(a), number(b));
    return false;
  });
}

}  // namespace

std::size_t fcl_box_pairs(std::span<const Aabb3> boxes) {
  PairCount to;
  fcl_pairs(boxes, to);
  return to.count;
}
ToldPairs fcl_told_pairs(std::span<const Aabb3> boxes) {
  PairKeeper to;
  fcl_pairs(boxes, to);
  return std::move(to.pairs);
}

}  // namespace plumb::bench
