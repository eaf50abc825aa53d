#include "plumb/space/bvh/compact_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "space/bvh/kept_file.hpp"
#include "space/bvh/tree_check.hpp"

namespace plumb {
namespace space {
namespace {

constexpr FileKind compact_kind{"plumbcmp", 2, "compact tree", "write_compact_bvh(path, build_compact_bvh(mesh))"};

struct CompactHead {
  FileOpening opening;
  std::int32_t exponent;
  std::uint32_t corner_width, number_width, unused;
  std::uint64_t nodes, vertices, slots, length;
  FloatBox3 root;
  std::byte rest[32];
  std::uint64_t checksum;
};
static_assert(sizeof(CompactHead) == 128 && std::is_trivially_copyable_v<CompactHead>);

std::uint64_t compact_length(const CompactHead& h) {
  return sizeof(CompactHead) + h.nodes * sizeof(CompactNode) + h.vertices * sizeof(Point3) +
         PackedNumbers::bytes_of(3 * h.slots, h.corner_width) + PackedNumbers::bytes_of(h.slots, h.number_width);
}

CompactHead compact_head_of(const std::string& path, std::span<const std::byte> bytes) {
  const auto head = head_in<CompactHead>(compact_kind, path, bytes);
  if (head.nodes >= most_in_file || head.vertices > most_in_file || head.slots >= most_in_file) {
    refuse_file(compact_kind, path, BvhFileProblem::broken_law, "promises more than 2^32 nodes, vertices or slots");
  }
  for (const std::uint32_t width : {head.corner_width, head.number_width}) {
    if (width >= 1 && width <= sizeof(std::uint32_t)) continue;
    refuse_file(compact_kind, path, BvhFileProblem::broken_law, "has numbers of " + std::to_string(width) + " bytes");
  }
  require_length(compact_kind, path, bytes.size(), head.length, compact_length(head));
  require_checksum(compact_kind, path, bytes);
  require_exponent(compact_kind, path, head.exponent);
  return head;
}

constexpr std::uint8_t no_depth = 0xff;
static_assert(CompactTree::most_levels < no_depth);

/// Are the child's planes floats, which sums in floats and in doubles give alike?
bool are_floats(const CompactNode& node, std::size_t child) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double size = node.step_size(k), origin = static_cast<double>(node.origin[k]) / size;
    if (origin != std::floor(origin)) return false;
    for (const std::size_t plane : {k, 3 + k}) {
      const double steps = origin + node.planes[plane][child];
      if (!(std::abs(steps) <= 0x1p24) || !(std::abs(steps * size) <= 0x1.fffffep127)) return false;
    }
  }
  return true;
}

FloatBox3 common(const FloatBox3& a, const FloatBox3& b) {
  FloatBox3 both;
  for (std::size_t k = 0; k < 3; ++k) {
    both.min[k] = std::max(a.min[k], b.min[k]);
    both.max[k] = std::min(a.max[k], b.max[k]);
  }
  return both;
}

/// Nodes in their order, each after its parent: so a pass over them knows of each the boxes on the way to it.
class CompactCheck {
 public:
  explicit CompactCheck(const CompactBvh& bvh)
      : bvh_(bvh),
        nodes_(bvh.tree.nodes.view()),
        depth_(nodes_.size(), no_depth),
        box_(nodes_.size()),
        leaf_of_(bvh.slots(), in_no_slot) {}

  std::string broken() {
    if (std::string broken = broken_mesh(bvh_); !broken.empty()) return broken;
    if (nodes_.empty() != (bvh_.slots() == 0)) return "it has nodes without triangles, or triangles without nodes";
    SlotLists lists;
    if (std::string broken = broken_numbers(bvh_, lists); !broken.empty()) return broken;
    if (!nodes_.empty()) {
      depth_[0] = 0;
      box_[0] = bvh_.tree.root;
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (std::string broken = broken_node(i); !broken.empty()) return "node " + std::to_string(i) + broken;
    }
    for (std::size_t slot = 0; slot < leaf_of_.size(); ++slot) {
      if (leaf_of_[slot] == in_no_slot) return "slot " + std::to_string(slot) + " is in no leaf";
    }
    return broken_boxes(
        bvh_, lists, [&](std::uint32_t slot) { return leaf_boxes_[leaf_of_[slot]]; },
        [&](std::uint32_t) { return std::string("the boxes on the way to its leaf"); });
  }

 private:
  std::string broken_node(std::size_t i) {
    const CompactNode& node = nodes_[i];
    if (depth_[i] == no_depth) return " is nobody's child";
    if (depth_[i] >= CompactTree::most_levels) return " lies deeper than a tree may be";
    if (node.inner > CompactNode::width) return " has more than eight children";
    if (node.inner > 0 && (node.first_node <= i || node.first_node > nodes_.size() - node.inner))
      return " has a child out of bounds";
    std::size_t slot = node.first_slot;
    bool any = false;
    for (std::size_t child = 0; child < CompactNode::width; ++child) {
      if (!node.has(child)) continue;
      any = true;
      if (!are_floats(node, child)) return " has a box that is no floats";
      const FloatBox3 box = common(box_[i], node.box(child));
      const std::size_t count = node.count[child];
      if (child < node.inner) {
        if (count != 0) return " has a child that is a leaf as well";
        const std::uint32_t below = node.link(child);
        if (depth_[below] != no_depth) return " has another's child";
        depth_[below] = static_cast<std::uint8_t>(depth_[i] + 1);
        box_[below] = box;
        continue;
      }
      if (count > CompactNode::most_in_leaf) return " has too large a leaf";
      if (slot > leaf_of_.size() || count > leaf_of_.size() - slot) return " has slots out of bounds";
      for (const std::size_t end = slot + count; slot < end; ++slot) {
        if (leaf_of_[slot] != in_no_slot) return " has slots that are not its own";
        leaf_of_[slot] = static_cast<std::uint32_t>(leaf_boxes_.size());
      }
      leaf_boxes_.push_back(box);
    }
    return any ? "" : " has no children";
  }

  const CompactBvh& bvh_;
  std::span<const CompactNode> nodes_;
  std::vector<std::uint8_t> depth_;
  std::vector<FloatBox3> box_;          // what all boxes from the root to a node have in common
  std::vector<std::uint32_t> leaf_of_;  // of each slot
  std::vector<FloatBox3> leaf_boxes_;
};

}  // namespace

std::string broken_law(const CompactBvh& bvh) { return CompactCheck(bvh).broken(); }

}  // namespace space

void write_compact_bvh(const std::string& path, const CompactBvh& bvh) {
  space::CompactHead head{};
  head.opening = space::opening_of(space::compact_kind);
  head.exponent = bvh.tree.frame.exponent();
  head.corner_width = bvh.corners.width();
  head.number_width = bvh.numbers.width();
  head.nodes = bvh.tree.nodes.size();
  head.vertices = bvh.vertices.size();
  head.slots = bvh.slots();
  head.root = bvh.tree.root;
  head.length = space::compact_length(head);
  const std::array arrays{std::as_bytes(bvh.tree.nodes.view()), std::as_bytes(bvh.vertices.view()),
                          bvh.corners.memory(), bvh.numbers.memory()};
  space::write_file(path, std::as_writable_bytes(std::span<space::CompactHead, 1>(&head, 1)), arrays);
}

CompactBvh map_compact_bvh(const std::string& path) {
  const space::FileBytes file = space::map_file(path);
  const space::CompactHead head = space::compact_head_of(path, file.bytes);
  space::FileArrays arrays(file, sizeof head);
  CompactBvh bvh;
  bvh.tree.nodes = arrays.next<CompactNode>(head.nodes);
  bvh.vertices = arrays.next<Point3>(head.vertices);
  const auto packed = [&](std::uint64_t n, std::uint32_t width) {
    return PackedNumbers(arrays.next<std::byte>(PackedNumbers::bytes_of(n, width)), static_cast<std::size_t>(n), width);
  };
  bvh.corners = packed(3 * head.slots, head.corner_width);
  bvh.numbers = packed(head.slots, head.number_width);
  bvh.tree.frame = BoxFrame::of_exponent(head.exponent);
  bvh.tree.root = head.root;
  if (const std::string broken = space::broken_law(bvh); !broken.empty())
    space::refuse_file(space::compact_kind, path, BvhFileProblem::broken_law, broken);
  return bvh;
}

CompactBvh read_compact_bvh(const std::string& path) {
  CompactBvh bvh = map_compact_bvh(path);
  (void)bvh.tree.nodes.writable();
  (void)bvh.vertices.writable();
  bvh.corners.own();
  bvh.numbers.own();
  return bvh;
}

}  // namespace plumb
