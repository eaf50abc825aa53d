#include "space/broad_phase/asked_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "plumb/space/bvh/build.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/ray/ray_slabs.hpp"
#include "space/closest/box_distance.hpp"
#include "space/pairs/boxes_meet.hpp"
#include "space/pairs/leaf_pairs.hpp"

namespace plumb::space {
namespace {

// Nanoseconds, on a machine that others used as well, of which the ratios count: a box that is asked beside the tree by a
// box and by a ray; a box of a tree that is made.
constexpr double of_box_beside = 9, of_ray_beside = 55, of_box_made = 200;
// So few are always asked one by one.
constexpr std::size_t few_beside = 16;

constexpr double beyond_doubles = std::numeric_limits<double>::infinity();

/// By nothing, where that lies beyond the doubles.
double less_by(double x, double by) { return x - by > -beyond_doubles ? x - by : x; }
double more_by(double x, double by) { return x + by < beyond_doubles ? x + by : x; }

void add_to(FloatBox3& all, const FloatBox3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    all.min[k] = std::min(all.min[k], box.min[k]);
    all.max[k] = std::max(all.max[k], box.max[k]);
  }
}

/// The first hit of boxes that are shown one after the other.
struct BestHit {
  const AnyRay& ray;
  const SlotBoxes& all;
  std::optional<AskedBoxes::SlotHit> best;
  std::optional<RayParameter> exactly;  // of the best, once it is asked for

  /// Is it the best so far?
  bool show(std::uint32_t slot) {
    const auto hit = first_hit(ray, all.boxes[slot]);
    if (!hit || !is_before(slot, *hit)) return false;
    if (best && best->hit.t != hit->t) exactly.reset();
    best = {slot, *hit};
    return true;
  }

 private:
  bool is_before(std::uint32_t slot, const Hit& hit) {
    if (!best) return true;
    if (hit.t != best->hit.t) return hit.t < best->hit.t;
    if (all.boxes[slot] == all.boxes[best->slot]) return slot < best->slot;
    if (!exactly) exactly = first_hit_parameter(ray, all.boxes[best->slot]);
    auto own = first_hit_parameter(ray, all.boxes[slot]);
    const auto order = *own <=> *exactly;
    if (order < 0) exactly = std::move(own);
    return order < 0 || (order == 0 && slot < best->slot);
  }
};

}  // namespace

void AskedBoxes::put_beside(std::uint32_t slot) {
  if (slot >= is_beside_.size()) {
    fat_.resize(std::size_t{slot} + 1);
    is_beside_.resize(std::size_t{slot} + 1, 2);
  }
  if (is_beside_[slot] == 1) return;
  beside_.push_back(slot);
  is_beside_[slot] = 1;
}

void AskedBoxes::make(const SlotBoxes& all) const {
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = 0; slot < all.boxes.size(); ++slot) {
    if (all.alive[slot] != 0) slots.push_back(slot);
  }
  Vector3 wide{};  // margin_ mean lengths
  const double part = margin_ / static_cast<double>(std::max<std::size_t>(slots.size(), 1));
  for (const std::uint32_t slot : slots) {
    const Aabb3& b = all.boxes[slot];
    wide = {wide.x + (b.max.x * part - b.min.x * part), wide.y + (b.max.y * part - b.min.y * part),
            wide.z + (b.max.z * part - b.min.z * part)};
  }
  std::vector<Aabb3> fat(all.boxes.size()), of_items;
  of_items.reserve(slots.size());
  for (const std::uint32_t slot : slots) {
    const Aabb3& b = all.boxes[slot];
    fat[slot] = {{less_by(b.min.x, wide.x), less_by(b.min.y, wide.y), less_by(b.min.z, wide.z)},
                 {more_by(b.max.x, wide.x), more_by(b.max.y, wide.y), more_by(b.max.z, wide.z)}};
    of_items.push_back(fat[slot]);
  }
  std::vector<std::uint8_t> is_beside(all.boxes.size(), 2);  // 2: there is no box
  for (const std::uint32_t slot : slots) is_beside[slot] = 0;
  tree_ = build_box_tree(of_items, {.method = BvhMethod::linear, .execution = Execution::serial});
  slot_of_ = std::move(slots), fat_ = std::move(fat), is_beside_ = std::move(is_beside);
  beside_.clear();
  is_made_ = true;
}

template <class Work>
void AskedBoxes::for_each_beside(const SlotBoxes& all, const Work& work) const {
  if (is_made_) {
    for (const std::uint32_t slot : beside_) {
      if (all.alive[slot] != 0) work(slot);
    }
    return;
  }
  for (std::uint32_t slot = 0; slot < all.boxes.size(); ++slot) {
    if (all.alive[slot] != 0) work(slot);
  }
}

template <class Ask>
auto AskedBoxes::asked(const SlotBoxes& all, double of_each_beside, const Ask& ask) const {
  const double of_tree = of_box_made * static_cast<double>(all.boxes.size());
  if (paid_beside_.load(std::memory_order_relaxed) > of_tree) {
    const std::unique_lock alone(made_by_one_);
    if (paid_beside_.load(std::memory_order_relaxed) > of_tree) {
      make(all);
      paid_beside_.store(0, std::memory_order_relaxed);
    }
  }
  const std::shared_lock with_others(made_by_one_);
  const std::size_t beside = is_made_ ? beside_.size() : all.boxes.size();
  if (beside > few_beside) {
    paid_beside_.fetch_add(of_each_beside * static_cast<double>(beside), std::memory_order_relaxed);
  }
  return ask();
}

std::vector<std::uint32_t> AskedBoxes::in_box(const SlotBoxes& all, const Aabb3& box, bool touching) const {
  return asked(all, of_box_beside, [&] {
    std::vector<std::uint32_t> found;
    for_each_beside(all, [&](std::uint32_t slot) {
      if (boxes_meet(all.boxes[slot], box, touching)) found.push_back(slot);
    });
    if (is_made_) {
      const auto [min, max] = tree_.frame.around(box);
      const BoxNode asked_for{min, 0, max, 0};
      descend(
          tree_, [&](const BoxNode& node) { return nodes_meet(node, asked_for); },
          [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t s = first; s < first + count; ++s) {
              const std::uint32_t slot = slot_of_[tree_.items[s]];
              if (is_beside_[slot] == 0 && boxes_meet(all.boxes[slot], box, touching)) found.push_back(slot);
            }
          });
    }
    if (!std::is_sorted(found.begin(), found.end())) std::sort(found.begin(), found.end());
    return found;
  });
}

std::optional<AskedBoxes::SlotHit> AskedBoxes::first_hit(const SlotBoxes& all, const AnyRay& ray) const {
  BestHit best{ray, all, {}, {}};
  along(all, ray, [&](std::uint32_t slot) {
    best.show(slot);
    return best.best ? best.best->hit.t : beyond_doubles;
  });
  return best.best;
}

void AskedBoxes::along(const SlotBoxes& all, const AnyRay& ray,
                       const std::function<double(std::uint32_t)>& show) const {
  asked(all, of_ray_beside, [&] {
    // Keys of the ray begin where it comes to all boxes, those beside the tree too.
    FloatBox3 around = tree_.box();
    for_each_beside(all, [&](std::uint32_t slot) { add_to(around, tree_.frame.around(all.boxes[slot])); });
    const RaySlabs slabs(ray, tree_.frame, around);
    double limit = slabs.limit(), last = beyond_doubles;
    const auto look = [&](std::uint32_t slot) {
      const double most = show(slot);
      if (most == last) return;
      last = most;
      limit = std::min(limit, slabs.limit_at(std::nextafter(most, beyond_doubles)));
    };
    for_each_beside(all, [&](std::uint32_t slot) {
      const auto [min, max] = tree_.frame.around(all.boxes[slot]);
      if (!(slabs({min, 0, max, 0}) > limit)) look(slot);
    });
    descend_nearer_first(tree_, limit, slabs, [&](std::uint32_t first, std::uint32_t count, double&) {
      for (std::uint32_t s = first; s < first + count; ++s) {
        const std::uint32_t slot = slot_of_[tree_.items[s]];
        if (is_beside_[slot] == 0) look(slot);
      }
    });
  });
}

void AskedBoxes::near(const SlotBoxes& all, const Aabb3& box, double within,
                      const std::function<double(std::uint32_t)>& show) const {
  asked(all, of_box_beside, [&] {
    SquareLimits limits = limits_above(tree_.frame, within);
    double last = within;
    const auto look = [&](std::uint32_t slot) {
      if (square_below(all.boxes[slot], box) > limits.of_figures) return;
      const double most = show(slot);
      if (most == last) return;
      last = most;
      limits = limits_above(tree_.frame, most);
    };
    for_each_beside(all, look);
    const FloatBox3 at = tree_.frame.around(box);
    double limit = limits.of_nodes;
    descend_nearer_first(
        tree_, limit, [&](const BoxNode& node) { return square_below(at, node); },
        [&](std::uint32_t first, std::uint32_t count, double& now) {
          for (std::uint32_t s = first; s < first + count; ++s) {
            const std::uint32_t slot = slot_of_[tree_.items[s]];
            if (is_beside_[slot] == 0) look(slot);
          }
          now = limits.of_nodes;
        });
  });
}

}  // namespace plumb::space
