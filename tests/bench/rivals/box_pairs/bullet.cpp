#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {
namespace {

btVector3 vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

template <class Broadphase>
struct Kept {
  template <class... Arguments>
  explicit Kept(std::span<const Aabb3> boxes, Arguments... arguments) : broadphase(arguments...) {
    for (const auto& [min, max] : boxes) {
      proxies.push_back(broadphase.createProxy(vector_of(min), vector_of(max), 0, nullptr, 1, 1, nullptr));
      // A number, told as a place in the boxes.
      proxies.back()->m_clientObject = const_cast<Aabb3*>(boxes.data() + proxies.size() - 1);
    }
    broadphase.calculateOverlappingPairs(nullptr);
  }
  ~Kept() {
    // Else each proxy is looked for among all pairs; the sweep finds pairs by their places.
    if constexpr (std::is_same_v<Broadphase, btDbvtBroadphase>)
      broadphase.getOverlappingPairCache()->getOverlappingPairArray().clear();
    for (btBroadphaseProxy* p : proxies) broadphase.destroyProxy(p, nullptr);
  }
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;

  std::size_t move(std::span<const Aabb3> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      broadphase.setAabb(proxies[i], vector_of(boxes[i].min), vector_of(boxes[i].max), nullptr);
    broadphase.calculateOverlappingPairs(nullptr);
    return count();
  }
  std::size_t count() {
    return static_cast<std::size_t>(broadphase.getOverlappingPairCache()->getNumOverlappingPairs());
  }

  Broadphase broadphase;
  std::vector<btBroadphaseProxy*> proxies;
};

}  // namespace

std::size_t bullet_box_pairs(std::span<const Aabb3> boxes) {
  Kept<btDbvtBroadphase> kept(boxes);
  return kept.count();
}

ToldPairs bullet_told_pairs(std::span<const Aabb3> boxes) {
  Kept<btDbvtBroadphase> kept(boxes);
  const btBroadphasePairArray& pairs = kept.broadphase.getOverlappingPairCache()->getOverlappingPairArray();
  const auto number = [&](const btBroadphaseProxy* p) {
    return static_cast<std::size_t>(static_cast<const Aabb3*>(p->m_clientObject) - boxes.data());
  };
  PairKeeper to;
  for (int i = 0; i < pairs.size(); ++i) to(number(pairs[i].m_pProxy0), number(pairs[i].m_pProxy1));
  return std::move(to.pairs);
}

struct BulletTree::State : Kept<btDbvtBroadphase> {
  using Kept::Kept;
};
BulletTree::BulletTree(std::span<const Aabb3> boxes) : state_(std::make_unique<State>(boxes)) {}
BulletTree::~BulletTree() = default;
std::size_t BulletTree::move(std::span<const Aabb3> boxes) { return state_->move(boxes); }

struct BulletSweep::State : Kept<bt32BitAxisSweep3> {
  using Kept::Kept;
};
BulletSweep::BulletSweep(std::span<const Aabb3> boxes)
    : state_(std::make_unique<State>(boxes, btVector3(-10, -10, -10), btVector3(10, 10, 10), 100000U)) {}
BulletSweep::~BulletSweep() = default;
std::size_t BulletSweep::move(std::span<const Aabb3> boxes) { return state_->move(boxes); }

}  // namespace plumb::bench
