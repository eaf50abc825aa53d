#include "plumb/space/bvh/compact_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

constexpr int most_steps = 255;
constexpr float most_plane = 0x1p100F;  // of which grids can do with steps of a byte

/// Of an axis: the finest that holds what lies from low to high, as floats.
struct StepGrid {
  int exponent;
  double into;   // steps a unit
  double first;  // the origin, in steps

  StepGrid(float low, float high) {
    const float largest = std::max(std::abs(low), std::abs(high));
    if (!(largest <= most_plane)) {
      throw InvalidShape("compact: a box of the tree reaches beyond 2^100 in its frame; build the tree anew");
    }
    exponent = CompactNode::least_exponent;
    if (largest > 0) exponent = std::max(exponent, std::ilogb(largest) - 23);
    // An extent of at least 2^n has more than 255 steps of 2^(n - 8), rounded as it may be.
    const double extent = static_cast<double>(high) - static_cast<double>(low);
    if (extent > 0) exponent = std::max(exponent, std::ilogb(extent) - 8);
    for (;; ++exponent) {
      into = std::ldexp(1.0, -exponent);
      first = std::floor(low * into);
      if (std::ceil(high * into) - first <= most_steps) return;
    }
  }

  // Products with powers of two; exact, since no double is that small.
  [[nodiscard]] std::uint8_t below(float x) const { return static_cast<std::uint8_t>(std::floor(x * into) - first); }
  [[nodiscard]] std::uint8_t above(float x) const { return static_cast<std::uint8_t>(std::ceil(x * into) - first); }
  [[nodiscard]] float origin() const { return static_cast<float>(std::ldexp(first, exponent)); }
  [[nodiscard]] std::uint8_t step() const { return static_cast<std::uint8_t>(exponent - CompactNode::least_exponent); }
};

class Compacted {
 public:
  explicit Compacted(const Bvh& bvh) : bvh_(bvh), wide_(bvh.wide.nodes.view()) {}

  CompactBvh run() {
    CompactBvh made;
    made.tree.frame = bvh_.tree.frame;
    made.tree.root = bvh_.tree.box();
    made.vertices = std::vector<Point3>(bvh_.vertices.begin(), bvh_.vertices.end());
    if (wide_.empty()) return made;
    nodes_.reserve(wide_.size());
    slots_.reserve(bvh_.triangles.size());
    add_all();
    nodes_.shrink_to_fit();
    made.tree.nodes = std::move(nodes_);
    std::vector<std::uint32_t> words;
    words.reserve(3 * slots_.size());
    for (const std::uint32_t slot : slots_) words.push_back(bvh_.tree.items[slot]);
    made.numbers = PackedNumbers(words);
    words.clear();
    for (const std::uint32_t slot : slots_) {
      const Bvh::Corners& c = bvh_.triangles[slot];
      words.insert(words.end(), c.begin(), c.end());
    }
    made.corners = PackedNumbers(words);
    return made;
  }

 private:
  /// A child to be: of a wide node, or of slots that are too many for a leaf, which are divided in their order.
  struct Part {
    FloatBox3 box;
    std::uint32_t link, count;
    [[nodiscard]] bool is_leaf() const { return count != 0 && count <= CompactNode::most_in_leaf; }
  };

  void add_all() {
    struct Later {
      Part from;
      std::uint32_t node;
    };
    nodes_.push_back({});
    std::vector<Later> later{{{no_box, 0, 0}, 0}};
    while (!later.empty()) {
      const Later now = later.back();
      later.pop_back();
      divide(now.from);
      const auto leaves =
          std::stable_partition(parts_.begin(), parts_.end(), [](const Part& p) { return !p.is_leaf(); });
      const auto inner = static_cast<std::uint32_t>(leaves - parts_.begin());
      const auto first_node = static_cast<std::uint32_t>(nodes_.size());
      nodes_[now.node] = node_of_parts(inner, first_node);
      nodes_.resize(nodes_.size() + inner);
      for (std::uint32_t i = inner; i-- > 0;) later.push_back({parts_[i], first_node + i});
    }
  }

  void divide(const Part& from) {
    parts_.clear();
    if (from.count == 0) {
      const WideNode<8>& node = wide_[from.link];
      for (std::size_t i = 0; i < 8 && node.has(i); ++i) {
        Part part{{}, node.link[i], node.count[i]};
        for (std::size_t k = 0; k < 3; ++k) {
          part.box.min[k] = node.planes[k][i];
          part.box.max[k] = node.planes[3 + k][i];
        }
        parts_.push_back(part);
      }
      return;
    }
    const std::uint32_t share = from.count / 8 + (from.count % 8 != 0 ? 1 : 0);
    for (std::uint32_t at = 0; at < from.count; at += share) {
      parts_.push_back({from.box, from.link + at, std::min(share, from.count - at)});
    }
  }

  CompactNode node_of_parts(std::uint32_t inner, std::uint32_t first_node) {
    CompactNode node{};
    node.inner = static_cast<std::uint8_t>(inner);
    node.first_node = inner > 0 ? first_node : 0;
    node.first_slot = static_cast<std::uint32_t>(slots_.size());
    for (std::size_t i = inner; i < parts_.size(); ++i) {
      node.count[i] = static_cast<std::uint8_t>(parts_[i].count);
      for (std::uint32_t slot = 0; slot < parts_[i].count; ++slot) slots_.push_back(parts_[i].link + slot);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      float low = no_box.min[k], high = no_box.max[k];
      for (const Part& part : parts_) {
        low = std::min(low, part.box.min[k]);
        high = std::max(high, part.box.max[k]);
      }
      const StepGrid grid(low, high);
      node.origin[k] = grid.origin();
      node.step[k] = grid.step();
      for (std::size_t i = 0; i < 8; ++i) {
        const bool there = i < parts_.size();
        node.planes[k][i] = there ? grid.below(parts_[i].box.min[k]) : std::uint8_t{most_steps};
        node.planes[3 + k][i] = there ? grid.above(parts_[i].box.max[k]) : std::uint8_t{0};
      }
    }
    return node;
  }

  const Bvh& bvh_;
  std::span<const WideNode<8>> wide_;
  std::vector<Part> parts_;
  std::vector<CompactNode> nodes_;
  std::vector<std::uint32_t> slots_;  // of the Bvh, in the new order
};

}  // namespace

PackedNumbers::PackedNumbers(std::span<const std::uint32_t> numbers) : size_(numbers.size()) {
  if (numbers.empty()) return;
  std::uint32_t all = 0;
  for (const std::uint32_t n : numbers) all |= n;
  width_ = std::max(1u, static_cast<std::uint32_t>(std::bit_width(all) + 7) / 8);
  if constexpr (std::endian::native != std::endian::little) width_ = sizeof(std::uint32_t);
  std::vector<std::byte> bytes(bytes_of(numbers.size(), width_));
  for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(bytes.data() + i * width_, &numbers[i], width_);
  bytes_ = std::move(bytes);
}

CompactBvh compact(const Bvh& bvh) { return Compacted(bvh).run(); }

CompactBvh build_compact_bvh(std::span<const Point3> vertices, std::span<const Bvh::Corners> triangles,
                             const BvhOptions& options) {
  return compact(build_bvh(vertices, triangles, options));
}
CompactBvh build_compact_bvh(const TriangleMesh& mesh, const BvhOptions& options) {
  return compact(build_bvh(mesh, options));
}

std::size_t memory_of(const CompactTree& tree) { return tree.nodes.size() * sizeof(CompactNode); }

std::size_t memory_of(const CompactBvh& bvh) {
  return memory_of(bvh.tree) + bvh.corners.bytes() + bvh.numbers.bytes() + bvh.vertices.size() * sizeof(Point3);
}

}  // namespace plumb
