#include "space/bvh/pair_tree.hpp"

#include <algorithm>

#include "space/bvh/grown_tree.hpp"
#include "space/bvh/place_cutter.hpp"

namespace plumb::space {
namespace {

class Layout {
 public:
  Layout(const PairTree& tree, const BvhOptions& options) : tree_(tree), options_(options) {
    const std::size_t all = tree.items.size() + tree.pairs.size();
    items_.resize(all, 1);
    height_.resize(all, 0);
    cost_.resize(all);
    leaf_.resize(all, true);
    std::vector<Extent> box(all);
    for (std::size_t c = 0; c < all; ++c) {
      if (c < tree.items.size()) {
        box[c].take(tree.items[c].low(), tree.items[c].high());
        cost_[c] = half_area(box[c]) * options.item_cost;
        continue;
      }
      const auto [a, b] = tree.pairs[c - tree.items.size()];
      box[c] = box[a];
      box[c].take(box[b]);
      items_[c] = items_[a] + items_[b];
      const float area = half_area(box[c]), as_leaf = area * options.item_cost * static_cast<float>(items_[c]);
      cost_[c] = area + cost_[a] + cost_[b];
      leaf_[c] = items_[c] <= options.most_in_leaf && as_leaf <= cost_[c];
      if (leaf_[c]) cost_[c] = as_leaf;
      height_[c] = leaf_[c] ? 0 : 1 + std::max(height_[a], height_[b]);
    }
  }

  Built run() {
    std::vector<Later> later{{tree_.root(), 0, SlotRange::no_parent}};
    while (!later.empty()) {
      const Later now = later.back();
      later.pop_back();
      const auto index = static_cast<std::uint32_t>(built_.nodes.size());
      if (now.parent != SlotRange::no_parent) built_.nodes[now.parent].link = index - now.parent;
      const SlotRange as_range{0, items_[now.cluster], now.depth};
      if (leaf_[now.cluster]) {
        put(items_of(now.cluster), now.depth);
      } else if (now.depth + height_[now.cluster] > most_tree_depth && must_halve(as_range, 1)) {
        put(items_of(now.cluster), now.depth);
      } else {
        built_.nodes.push_back(BoxNode{});
        const auto [a, b] = tree_.pairs[now.cluster - tree_.items.size()];
        later.push_back({b, now.depth + 1, index});
        later.push_back({a, now.depth + 1, SlotRange::no_parent});
      }
    }
    fit_all(built_.nodes);
    return std::move(built_);
  }

 private:
  struct Later {
    std::uint32_t cluster, depth;
    std::uint32_t parent;  // whose second child it is
  };

  [[nodiscard]] std::vector<BoxedItem> items_of(std::uint32_t cluster) const {
    std::vector<BoxedItem> items;
    std::vector<std::uint32_t> later{cluster};
    while (!later.empty()) {
      const std::uint32_t c = later.back();
      later.pop_back();
      if (c < tree_.items.size()) {
        items.push_back(tree_.items[c]);
        continue;
      }
      const auto [a, b] = tree_.pairs[c - tree_.items.size()];
      later.push_back(b);
      later.push_back(a);
    }
    return items;
  }

  // As a leaf, or in halves where they are too many for one.
  void put(std::vector<BoxedItem> items, std::uint32_t depth) {
    BvhOptions halves = options_;
    halves.method = BvhMethod::object_median;
    const bool is_leaf = items.size() <= options_.most_in_leaf;
    const auto start = static_cast<std::uint32_t>(built_.items.size());
    const SlotRange whole{0, static_cast<std::uint32_t>(items.size()), depth};
    const auto leaf = [&](const SlotRange& range) {
      Extent box;
      for (const BoxedItem& item : std::span(items).subspan(range.begin, range.size())) {
        box.take(item.low(), item.high());
        built_.items.push_back(item.item);
      }
      return box;
    };
    if (is_leaf) {
      built_.nodes.push_back(node_of(leaf(whole), start, whole.size()));
      return;
    }
    PlaceCutter cutter(items, halves);
    std::vector<BoxNode> nodes = grow_one(whole, cutter, leaf);
    for (BoxNode& node : nodes) {
      if (node.is_leaf()) node.link += start;
    }
    built_.nodes.insert(built_.nodes.end(), nodes.begin(), nodes.end());
  }

  const PairTree& tree_;
  BvhOptions options_;
  // Of each cluster:
  std::vector<std::uint32_t> items_, height_;
  std::vector<float> cost_;
  std::vector<bool> leaf_;
  Built built_;
};

}  // namespace

Built lay_out(const PairTree& tree, const BvhOptions& options) { return Layout(tree, options).run(); }

}  // namespace plumb::space
