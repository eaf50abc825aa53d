// Ray cast: which of the shapes in a tree does a ray hit first, any, all in order?  Shapes of any kind, asked by the
// user.
//
//   const BoxTree tree = build_box_tree(boxes);      // boxes[i] contains shapes[i]
//   const auto hit = first_hit(tree, ray, [&](std::uint32_t i) { return first_hit_parameter(ray, shapes[i]); });
//
// `parameter(item)` is the exact parameter at which the ray hits the item, or nothing: a std::optional of any number
// that compares and that a limit can be made of (RayParameter, double).  It is asked of items whose boxes the ray may
// meet.
// Laws: (1) the first item is that of the least parameter, of equal ones that of the lowest number; all items are in
// that order, each once.  (2) They are those of asking every item.
// Source: RTCD 5.3, 6.3.2.
// Cost: the descent, and `parameter` for the items of the leaves that it comes to.  Bounded by n log n operations for
// n items, their order along the ray.
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/ray/ray_slabs.hpp"

namespace plumb {

template <class Parameter>
struct ItemHit {
  std::uint32_t item;
  Parameter parameter;
};

namespace space {

/// A double that is not less.
inline double at_least(double t) { return t; }
inline double at_least(const RayParameter& t) { return t.rounded(Rounding::up); }

template <class Parameter>
bool is_before(const ItemHit<Parameter>& a, const ItemHit<Parameter>& b) {
  return a.parameter < b.parameter || (a.parameter == b.parameter && a.item < b.item);
}

template <class Question>
using ParameterOf = typename std::invoke_result_t<Question&, std::uint32_t>::value_type;

}  // namespace space

template <class Question>
auto first_hit(const BoxTree& tree, const AnyRay& ray, Question&& parameter) {
  using Found = ItemHit<space::ParameterOf<Question>>;
  std::optional<Found> best;
  const RaySlabs slabs(ray, tree);
  double limit = slabs.limit();
  descend_nearer_first(tree, limit, slabs, [&](std::uint32_t first, std::uint32_t count, double& now) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const std::uint32_t item = tree.items[slot];
      auto t = parameter(item);
      if (!t) continue;
      Found found{item, std::move(*t)};
      if (best && !space::is_before(found, *best)) continue;
      const double no_later = slabs.limit_at(space::at_least(found.parameter));
      if (no_later < now) now = no_later;
      best = std::move(found);
    }
  });
  return best;
}

/// Is any hit?  `is_hit(item)` says whether one is.
template <class Question>
bool any_hit(const BoxTree& tree, const AnyRay& ray, Question&& is_hit) {
  const RaySlabs slabs(ray, tree);
  const double limit = slabs.limit();
  return descend(
             tree, [&](const BoxNode& node) { return !(slabs(node) > limit); },
             [&](std::uint32_t first, std::uint32_t count) {
               for (std::uint32_t slot = first; slot < first + count; ++slot) {
                 if (is_hit(tree.items[slot])) return Descent::stop;
               }
               return Descent::go_on;
             }) == Descent::stop;
}

template <class Question>
auto hits(const BoxTree& tree, const AnyRay& ray, Question&& parameter) {
  using Found = ItemHit<space::ParameterOf<Question>>;
  const auto later = [](const Found& a, const Found& b) { return space::is_before(b, a); };
  std::priority_queue<Found, std::vector<Found>, decltype(later)> found(later);
  (void)any_hit(tree, ray, [&](std::uint32_t item) {
    if (auto t = parameter(item)) found.push({item, std::move(*t)});
    return false;
  });
  std::vector<Found> all;
  for (; !found.empty(); found.pop()) {
    if (all.empty() || all.back().item != found.top().item) all.push_back(found.top());
  }
  return all;
}

}  // namespace plumb
