#include "plumb/space/bvh/wide_tree.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "space/bvh/boxed_item.hpp"

namespace plumb {
namespace {

// Which nodes of the binary tree become wide ones: those whose areas together are least, as the surface-area heuristic
// has it.
template <std::size_t width>
class Widened {
 public:
  Widened(const BoxTree& tree, std::uint32_t most_in_leaf)
      : old_(tree.nodes.view()), slots_(old_.size()), inner_(old_.size()) {
    for (std::size_t i = old_.size(); i-- > 0;) {
      slots_[i] = old_[i].is_leaf() ? old_[i].count : slots_[i + 1] + slots_[i + old_[i].link];
      inner_[i] = old_[i].is_leaf() || slots_[i] <= most_in_leaf ? 0 : add(old_[i], i);
    }
  }

  std::vector<WideNode<width>> run() {
    if (old_.empty()) return {};
    struct Later {
      std::uint32_t from, node;  // the binary node, and the wide one of its children
    };
    nodes_.push_back(missing());
    std::vector<Later> later{{0, 0}};
    while (!later.empty()) {
      const auto [from, node] = later.back();
      later.pop_back();
      const std::size_t found = children_of(from);
      for (std::size_t i = 0; i < found; ++i) {
        put(node, i);
        if (nodes_[node].count[i] != 0) continue;
        nodes_[node].link[i] = static_cast<std::uint32_t>(nodes_.size());
        later.push_back({children_[i], nodes_[node].link[i]});
        nodes_.push_back(missing());
      }
    }
    return std::move(nodes_);
  }

 private:
  /// Of a node's items: the least sum of areas where they are below at most k + 1 nodes beside each other.
  using Costs = std::array<float, width>;

  // Its least is above its most.
  static WideNode<width> missing() {
    WideNode<width> node{};
    for (std::size_t k = 0; k < 6; ++k) node.planes[k].fill((k < 3 ? 1 : -1) * std::numeric_limits<float>::infinity());
    return node;
  }

  [[nodiscard]] const Costs& costs(std::size_t i) const { return costs_[inner_[i]]; }
  [[nodiscard]] bool stays_leaf(std::size_t i) const { return inner_[i] == 0; }

  /// How many of n nodes beside each other, n at least 2, the first child has where the sum is least.
  [[nodiscard]] std::size_t share_of_first(std::size_t i, std::size_t n) const {
    const Costs &first = costs(i + 1), &second = costs(i + old_[i].link);
    std::size_t best = 1;
    for (std::size_t k = 2; k < n; ++k) {
      if (first[k - 1] + second[n - k - 1] < first[best - 1] + second[n - best - 1]) best = k;
    }
    return best;
  }
  [[nodiscard]] float divided(std::size_t i, std::size_t n) const {
    const std::size_t k = share_of_first(i, n);
    return costs(i + 1)[k - 1] + costs(i + old_[i].link)[n - k - 1];
  }

  std::uint32_t add(const BoxNode& node, std::size_t i) {
    Costs own;
    own[0] = space::half_area(node) + divided(i, width);
    for (std::size_t n = 2; n <= width; ++n) own[n - 1] = std::min(own[n - 2], divided(i, n));
    costs_.push_back(own);
    return static_cast<std::uint32_t>(costs_.size() - 1);
  }

  /// In the order of their slots.
  std::size_t children_of(std::uint32_t from) {
    struct Part {
      std::uint32_t node;
      std::size_t share;
    };
    std::array<Part, width> later;
    std::size_t waiting = 0, found = 0;
    const auto divide = [&](const Part& part) {
      const std::size_t first = share_of_first(part.node, part.share);
      later[waiting++] = {part.node + old_[part.node].link, part.share - first};
      later[waiting++] = {part.node + 1, first};
    };
    if (stays_leaf(from)) {  // the root alone
      later[waiting++] = {from, 1};
    } else {
      divide({from, width});
    }
    while (waiting > 0) {
      const Part part = later[--waiting];
      if (part.share == 1 || stays_leaf(part.node) || costs(part.node)[part.share - 1] == costs(part.node)[0]) {
        children_[found++] = part.node;
      } else {
        divide(part);
      }
    }
    return found;
  }

  void put(std::uint32_t node, std::size_t i) {
    const std::uint32_t from = children_[i];
    const BoxNode& box = old_[from];
    WideNode<width>& wide = nodes_[node];
    for (std::size_t k = 0; k < 3; ++k) {
      wide.planes[k][i] = box.min[k];
      wide.planes[3 + k][i] = box.max[k];
    }
    if (!stays_leaf(from)) return;
    std::uint32_t first = from;
    while (!old_[first].is_leaf()) ++first;
    wide.link[i] = old_[first].link;
    wide.count[i] = slots_[from];
  }

  std::span<const BoxNode> old_;
  std::vector<std::uint32_t> slots_, inner_;  // of each binary node; inner_ is where its costs are, 0 for a leaf
  std::vector<Costs> costs_{Costs{}};
  std::vector<WideNode<width>> nodes_;
  std::array<std::uint32_t, width> children_;
};

}  // namespace

template <std::size_t width>
WideTree<width> widen(const BoxTree& tree, std::uint32_t most_in_leaf) {
  return {Widened<width>(tree, most_in_leaf).run()};
}

template WideTree<4> widen<4>(const BoxTree&, std::uint32_t);
template WideTree<8> widen<8>(const BoxTree&, std::uint32_t);

}  // namespace plumb
