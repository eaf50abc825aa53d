#include "plumb/space/bvh/refit.hpp"

#include <string>

#include "figure/basic/finite_parts.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/grown_tree.hpp"
#include "space/bvh/slot_boxes.hpp"

namespace plumb {
namespace {

using space::SlotRange;

// The leaves' boxes from those of their slots, and all others from the leaves'.
template <class BoxOf>
void fit_leaves(BoxTree& tree, const BoxFrame& frame, Execution execution, const BoxOf& box_of) {
  std::vector<BoxNode>& nodes = tree.nodes.writable();
  tree.frame = frame;
  space::for_blocks(execution, nodes.size(), 1 << 12, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (!nodes[i].is_leaf()) continue;
      space::Extent box;
      for (std::uint32_t slot = nodes[i].link; slot < nodes[i].link + nodes[i].count; ++slot) {
        const FloatBox3 b = frame.around(box_of(slot));
        box.take(space::Lanes{b.min[0], b.min[1], b.min[2], 0}, space::Lanes{b.max[0], b.max[1], b.max[2], 0});
      }
      nodes[i] = space::node_of(box, nodes[i].link, nodes[i].count);
    }
  });
  space::fit_all(nodes);
}

class PartsRebuilt {
 public:
  PartsRebuilt(Bvh& bvh, double most, const BvhOptions& options) : bvh_(bvh), most_(most), options_(options) {}

  std::size_t run() {
    const std::span<const BoxNode> old = bvh_.tree.nodes.view();
    if (old.empty()) return 0;
    count_slots();
    struct Later {
      std::uint32_t node, parent, depth;
    };
    std::vector<Later> later{{0, SlotRange::no_parent, 0}};
    while (!later.empty()) {
      const Later now = later.back();
      later.pop_back();
      const auto index = static_cast<std::uint32_t>(nodes_.size());
      if (now.parent != SlotRange::no_parent) nodes_[now.parent].link = index - now.parent;
      const BoxNode& node = old[now.node];
      if (!node.is_leaf() && is_bad(now.node)) {
        rebuild(now.node, now.depth);
        continue;
      }
      nodes_.push_back(node);
      if (node.is_leaf()) {
        for (std::uint32_t slot = node.link; slot < node.link + node.count; ++slot) from_.push_back(slot);
        continue;
      }
      later.push_back({now.node + node.link, index, now.depth + 1});
      later.push_back({now.node + 1, SlotRange::no_parent, now.depth + 1});
    }
    if (rebuilt_ == 0) return 0;
    bvh_.tree.nodes = std::move(nodes_);
    move_slots(bvh_.tree.items);
    move_slots(bvh_.triangles);
    widen(bvh_, options_.execution);
    return rebuilt_;
  }

 private:
  // Of each node, all slots below it; they are one range.
  void count_slots() {
    const std::span<const BoxNode> old = bvh_.tree.nodes.view();
    slots_.resize(old.size());
    for (std::size_t i = old.size(); i-- > 0;)
      slots_[i] = old[i].is_leaf() ? old[i].count : slots_[i + 1] + slots_[i + old[i].link];
  }

  [[nodiscard]] bool is_bad(std::uint32_t i) const {
    const std::span<const BoxNode> old = bvh_.tree.nodes.view();
    const double children = static_cast<double>(space::half_area(old[i + 1])) + space::half_area(old[i + old[i].link]);
    return children > most_ * space::half_area(old[i]);
  }

  void rebuild(std::uint32_t node, std::uint32_t depth) {
    const auto first = static_cast<std::uint32_t>(from_.size());
    std::vector<space::BoxedItem> items(slots_[node]);
    for (std::uint32_t k = 0; k < items.size(); ++k) {
      const FloatBox3 box = bvh_.tree.frame.around(space::box_around(bvh_.triangles[first + k], bvh_.vertices.view()));
      items[k] = {box.min, first + k, box.max, 0};
    }
    space::Built built = space::build_binned(std::move(items), options_, depth);
    for (BoxNode& n : built.nodes) {
      if (n.is_leaf()) n.link += first;
    }
    nodes_.insert(nodes_.end(), built.nodes.begin(), built.nodes.end());
    from_.insert(from_.end(), built.items.begin(), built.items.end());
    rebuilt_ += built.items.size();
  }

  template <class T>
  void move_slots(KeptArray<T>& slots) const {
    std::vector<T> moved;
    moved.reserve(from_.size());
    for (const std::uint32_t slot : from_) moved.push_back(slots[slot]);
    slots = std::move(moved);
  }

  Bvh& bvh_;
  double most_;
  BvhOptions options_;
  std::vector<std::uint32_t> slots_;
  std::vector<BoxNode> nodes_;
  std::vector<std::uint32_t> from_;  // where each slot was before
  std::size_t rebuilt_ = 0;
};

}  // namespace

void refit(Bvh& bvh, std::span<const Point3> vertices, Execution execution) {
  space::require_equal_lengths("refit", "vertices", vertices.size(), "bvh.vertices", bvh.vertices.size());
  figure::require_finite_points("refit", "vertices", vertices);
  std::vector<Point3>& own = bvh.vertices.writable();
  std::copy(vertices.begin(), vertices.end(), own.begin());
  const std::span<const Bvh::Corners> triangles = bvh.triangles.view();
  fit_leaves(bvh.tree, space::frame_of(execution, vertices), execution,
             [&](std::uint32_t slot) { return space::box_around(triangles[slot], own); });
  widen(bvh, execution);
}

void refit(BoxTree& tree, std::span<const Aabb3> boxes, Execution execution) {
  const std::span<const std::uint32_t> items = tree.items.view();
  const std::uint32_t most = items.empty() ? 0 : 1 + *std::max_element(items.begin(), items.end());
  space::require_equal_lengths("refit", "boxes", boxes.size(), "tree", most);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!space::is_sound(boxes[i])) space::check_box("refit", "boxes[" + std::to_string(i) + "]", boxes[i]);
  }
  fit_leaves(tree, space::frame_of(execution, boxes), execution,
             [&](std::uint32_t slot) { return boxes[items[slot]]; });
}

std::size_t rebuild_parts(Bvh& bvh, double most, const BvhOptions& options) {
  space::check_options("rebuild_parts", options);
  if (!(most >= 1))
    throw InvalidShape("rebuild_parts: most is " + std::to_string(most) + ", but it must be at least 1");
  return PartsRebuilt(bvh, most, options).run();
}

}  // namespace plumb
