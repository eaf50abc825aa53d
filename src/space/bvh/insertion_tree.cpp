#include "plumb/space/bvh/insertion_tree.hpp"

#include <algorithm>
#include <string>

#include "plumb/arith/error.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/bvh/pair_tree.hpp"

namespace plumb {
namespace {

float half_area(const FloatBox3& b) {
  const float x = b.max[0] - b.min[0], y = b.max[1] - b.min[1], z = b.max[2] - b.min[2];
  return x * (y + z) + y * z;
}

FloatBox3 merged(const FloatBox3& a, const FloatBox3& b) {
  FloatBox3 box = a;
  for (std::size_t k = 0; k < 3; ++k) {
    box.min[k] = std::min(a.min[k], b.min[k]);
    box.max[k] = std::max(a.max[k], b.max[k]);
  }
  return box;
}

}  // namespace

void InsertionTree::insert(std::uint32_t item, const Aabb3& box) {
  space::check_box("InsertionTree::insert", "box", box);
  if (contains(item)) {
    throw InvalidShape("InsertionTree::insert: item " + std::to_string(item) + " is there already; remove it first");
  }
  const FloatBox3 around = frame_.around(box);
  const std::uint32_t sibling = best_sibling(around);
  const std::uint32_t own = new_place({around, none, {none, item}});
  if (place_of_.size() <= item) place_of_.resize(std::size_t{item} + 1, none);
  place_of_[item] = own;
  if (sibling == none) {
    root_ = own;
    return;
  }
  const std::uint32_t parent = places_[sibling].parent;
  const std::uint32_t pair = new_place({merged(around, places_[sibling].box), parent, {sibling, own}});
  replace_child(parent, sibling, pair);
  places_[sibling].parent = places_[own].parent = pair;
  fit_from(pair);
}

void InsertionTree::remove(std::uint32_t item) {
  if (!contains(item)) {
    throw InvalidShape("InsertionTree::remove: there is no item " + std::to_string(item));
  }
  const std::uint32_t own = place_of_[item], pair = places_[own].parent;
  place_of_[item] = none;
  free_.push_back(own);
  if (pair == none) {
    root_ = none;
    return;
  }
  const auto [a, b] = places_[pair].children;
  const std::uint32_t sibling = a == own ? b : a, parent = places_[pair].parent;
  replace_child(parent, pair, sibling);
  places_[sibling].parent = parent;
  free_.push_back(pair);
  fit_from(parent);
}

// Where a pair of the item and what is there adds the least area: that of the pair, and what all above grow by.  Of
// places that are equally good the deepest, and on the way the children with fewer items: equal boxes make no chain.
std::uint32_t InsertionTree::best_sibling(const FloatBox3& box) const {
  if (root_ == none) return none;
  std::uint32_t now = root_, best = root_;
  float least = half_area(merged(box, places_[root_].box)), grown = 0;
  while (!places_[now].is_item()) {
    const Place& place = places_[now];
    grown += half_area(merged(box, place.box)) - half_area(place.box);
    std::uint32_t next = none;
    float next_cost = 0;
    for (const std::uint32_t child : place.children) {
      const float pair = half_area(merged(box, places_[child].box));
      if (grown + pair <= least) {
        least = grown + pair;
        best = child;
      }
      const float growth = pair - half_area(places_[child].box);
      if (next == none || growth < next_cost || (growth == next_cost && places_[child].items < places_[next].items)) {
        next = child;
        next_cost = growth;
      }
    }
    if (grown > least) break;  // whatever is below adds that much at least
    now = next;
  }
  return best;
}

std::uint32_t InsertionTree::new_place(const Place& place) {
  if (free_.empty()) {
    places_.push_back(place);
    return static_cast<std::uint32_t>(places_.size() - 1);
  }
  const std::uint32_t at = free_.back();
  free_.pop_back();
  places_[at] = place;
  return at;
}

void InsertionTree::replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
  if (parent == none) {
    root_ = by;
    return;
  }
  auto& children = places_[parent].children;
  children[children[0] == child ? 0 : 1] = by;
}

void InsertionTree::fit_from(std::uint32_t place) {
  for (; place != none; place = places_[place].parent) {
    Place& p = places_[place];
    const Place &a = places_[p.children[0]], &b = places_[p.children[1]];
    p.box = merged(a.box, b.box);
    p.items = a.items + b.items;
  }
}

BoxTree InsertionTree::laid_out(const BvhOptions& options) const {
  space::check_options("InsertionTree::laid_out", options);
  BoxTree tree;
  tree.frame = frame_;
  if (root_ == none) return tree;
  std::vector<std::uint32_t> order{root_};  // parents before their children
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Place& place = places_[order[i]];
    if (!place.is_item()) order.insert(order.end(), place.children.begin(), place.children.end());
  }
  std::vector<space::BoxedItem> items;
  std::vector<std::uint32_t> cluster(places_.size());
  for (const std::uint32_t at : order) {
    const Place& place = places_[at];
    if (!place.is_item()) continue;
    cluster[at] = static_cast<std::uint32_t>(items.size());
    items.push_back({place.box.min, place.children[1], place.box.max, 0});
  }
  space::PairTree pairs{items, {}};
  for (std::size_t i = order.size(); i-- > 0;) {
    const Place& place = places_[order[i]];
    if (place.is_item()) continue;
    pairs.pairs.push_back({cluster[place.children[0]], cluster[place.children[1]]});
    cluster[order[i]] = pairs.root();
  }
  space::Built built = space::lay_out(pairs, options);
  tree.nodes = std::move(built.nodes);
  tree.items = std::move(built.items);
  return tree;
}

namespace space {

// In an order that knows nothing of where items lie: a mesh's own would make a chain.
Built build_by_insertion(const std::vector<BoxedItem>& items, const BvhOptions& options) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::uint64_t mixed = (i + 1) * 0x9e3779b97f4a7c15;
    mixed = (mixed ^ mixed >> 30) * 0xbf58476d1ce4e5b9;
    order.emplace_back(mixed ^ mixed >> 27, i);
  }
  std::sort(order.begin(), order.end());
  InsertionTree tree;  // of the numbers of the frame, which are doubles
  for (const auto& [mixed, i] : order) {
    const BoxedItem& one = items[i];
    tree.insert(one.item, {{one.min[0], one.min[1], one.min[2]}, {one.max[0], one.max[1], one.max[2]}});
  }
  BoxTree built = tree.laid_out(options);
  return {std::move(built.nodes.writable()), std::move(built.items.writable())};
}

}  // namespace space
}  // namespace plumb
