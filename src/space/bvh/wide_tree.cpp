#include "plumb/space/bvh/wide_tree.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "space/bvh/boxed_item.hpp"
#include "space/bvh/parts.hpp"

namespace plumb {
namespace {

using space::IntLanes, space::Lanes;

// Which nodes of the binary tree become wide ones: those whose areas together are least, as the surface-area heuristic
// has it.
template <std::size_t width>
class Widened {
 public:
  Widened(const BoxTree& tree, std::uint32_t most_in_leaf) : old_(tree.nodes.view()), plans_(old_.size()) {
    // Children lie behind their parents, so that from the back a stack holds those without a parent yet, the first
    // child on top.
    std::vector<Below> below;
    for (std::size_t i = old_.size(); i-- > 0;) {
      if (old_[i].is_leaf()) {
        plans_[i] = {0, old_[i].count};
        below.push_back({old_[i].count, of_leaf()});
        continue;
      }
      const Below& first = below.back();
      Below& second = below[below.size() - 2];
      const std::uint32_t slots = first.slots + second.slots;
      if (slots <= most_in_leaf) {
        plans_[i] = {0, slots};
        second = {slots, of_leaf()};
      } else {
        plans_[i] = {divide(space::half_area(old_[i]), first.least, second.least), old_[i].link};
        second.slots = slots;
      }
      below.pop_back();
    }
  }

  std::vector<WideNode<width>> run(Execution execution) {
    if (old_.empty()) return {};
    struct Later {
      std::uint32_t from, node;  // the binary node, and the wide one of its children
    };
    std::vector<Later> later{{0, 0}};
    wide_.resize(1);
    while (!later.empty()) {
      const auto [from, node] = later.back();
      later.pop_back();
      Children own{children_.size(), wide_.size(), 0};
      add_children_of(from);
      own.end = children_.size();
      wide_[node] = own;
      for (std::size_t c = own.begin; c < own.end; ++c) {
        if (stays_leaf(children_[c])) continue;
        later.push_back({children_[c], static_cast<std::uint32_t>(wide_.size())});
        wide_.emplace_back();
      }
    }
    std::vector<WideNode<width>> nodes(wide_.size());
    space::for_blocks(execution, nodes.size(), 1 << 10, [&](std::size_t, std::size_t start, std::size_t end) {
      for (std::size_t i = start; i < end; ++i) fill(nodes[i], wide_[i]);
    });
    return nodes;
  }

 private:
  /// Of a node's items: the least sum of areas where they are below at most k + 1 nodes beside each other, from `width`
  /// on; before, infinite, so that lanes of them can be taken moved on.
  using Least = std::array<float, 2 * width>;
  struct Below {
    std::uint32_t slots;
    Least least;
  };
  struct Plan {
    std::uint32_t
        shares;  // four bits for each n: how many of n nodes beside each other the first child has; 0 in leaves
    std::uint32_t number;  // a leaf's slots; else the link, so that nothing else is looked at
  };
  /// Of a wide node: a part of children_, and the wide node of the first that has one; the others' follow.
  struct Children {
    std::size_t begin, first_wide, end;
  };

  static Least of_leaf() {
    Least least{};
    std::fill_n(least.begin(), width, space::Extent::infinity);
    return least;
  }

  [[nodiscard]] bool stays_leaf(std::size_t i) const { return plans_[i].shares == 0; }

  /// Of n nodes beside each other; 0 where one alone is as good.
  [[nodiscard]] std::uint32_t share_of_first(std::size_t i, std::uint32_t n) const {
    return plans_[i].shares >> 4 * (n - 1) & 15u;
  }

  /// The shares; the sums go where those of the second child were.  For each share all n at once, the second child's
  /// sums being moved on by it.
  static std::uint32_t divide(float area, const Least& first, Least& second) {
    constexpr std::size_t rows = width / 4;
    std::array<Lanes, rows> least;
    std::array<IntLanes, rows> share{};
    least.fill(space::Extent().low);
    for (std::size_t k = 1; k < width; ++k) {
      for (std::size_t row = 0; row < rows; ++row) {
        Lanes moved;
        std::memcpy(&moved, second.data() + (width - k + 4 * row), sizeof moved);
        const Lanes sum = first[width + k - 1] + moved;
        const IntLanes better = sum < least[row];
        least[row] = better ? sum : least[row];
        share[row] = better ? IntLanes{} + static_cast<std::int32_t>(k) : share[row];
      }
    }
    float* const own = second.data() + width;
    std::memcpy(own, least.data(), sizeof least);
    own[0] = area + own[width - 1];
    std::uint32_t shares = 0;
    for (std::size_t n = 1; n < width; ++n) {
      own[n] = std::min(own[n - 1], own[n]);
      if (own[n] != own[0]) shares |= static_cast<std::uint32_t>(share[n / 4][n % 4]) << 4 * n;
    }
    // One alone has children: as many as there may be.
    return shares | static_cast<std::uint32_t>(share[rows - 1][3]);
  }

  /// In the order of their slots.
  void add_children_of(std::uint32_t from) {
    struct Part {
      std::uint32_t node, share;
    };
    std::array<Part, width> later;
    std::size_t waiting = 0;
    const auto divide_by = [&](const Part& part, std::uint32_t first) {
      later[waiting++] = {part.node + plans_[part.node].number, part.share - first};
      later[waiting++] = {part.node + 1, first};
    };
    if (stays_leaf(from)) {  // the root alone
      later[waiting++] = {from, 1};
    } else {
      divide_by({from, width}, share_of_first(from, 1));
    }
    while (waiting > 0) {
      const Part part = later[--waiting];
      const std::uint32_t first = part.share == 1 ? 0 : share_of_first(part.node, part.share);
      if (first == 0) {
        children_.push_back(part.node);
      } else {
        divide_by(part, first);
      }
    }
  }

  void fill(WideNode<width>& wide, const Children& own) const {
    // What is missing: its least is above its most.
    for (std::size_t k = 0; k < 6; ++k) wide.planes[k].fill(k < 3 ? space::Extent::infinity : -space::Extent::infinity);
    std::size_t next = own.first_wide;
    for (std::size_t i = 0; i < own.end - own.begin; ++i) {
      const std::uint32_t from = children_[own.begin + i];
      const BoxNode& box = old_[from];
      for (std::size_t k = 0; k < 3; ++k) {
        wide.planes[k][i] = box.min[k];
        wide.planes[3 + k][i] = box.max[k];
      }
      if (!stays_leaf(from)) {
        wide.link[i] = static_cast<std::uint32_t>(next++);
        continue;
      }
      std::uint32_t first = from;
      while (!old_[first].is_leaf()) ++first;
      wide.link[i] = old_[first].link;
      wide.count[i] = plans_[from].number;
    }
  }

  std::span<const BoxNode> old_;
  std::vector<Plan> plans_;              // of each binary node
  std::vector<Children> wide_;           // of each wide node
  std::vector<std::uint32_t> children_;  // binary nodes
};

}  // namespace

template <std::size_t width>
WideTree<width> widen(const BoxTree& tree, std::uint32_t most_in_leaf, Execution execution) {
  return {Widened<width>(tree, most_in_leaf).run(execution)};
}

template WideTree<4> widen<4>(const BoxTree&, std::uint32_t, Execution);
template WideTree<8> widen<8>(const BoxTree&, std::uint32_t, Execution);

}  // namespace plumb
