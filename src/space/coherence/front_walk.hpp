// A part of a front, as it is in this frame.
//
//   FrontWalk walk(scene, frame);
//   for (const NodePair pair : part) walk.from(pair);
//   walk.result()
//
// A scene has the nodes of two trees (or of one, is_own), says whether two nodes' boxes meet and what their pair is
// replaced by, and tells the triangles of leaves.
// Laws: (1) what the pairs cover, pairs of leaves, is covered by those of the result, each once, in the order of a
// descent.  (2) The triangles of all pairs of leaves that may meet are asked.
// Source: RTCD 6.7.2.
// Cost: a comparison of boxes a pair, and those of what is replaced.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/pairs/leaf_pairs.hpp"

namespace plumb::space {

struct FrontPart {
  std::vector<NodePair> pairs;
  std::vector<TrianglePair> found;
  std::vector<std::uint32_t> divided_a, divided_b;
  std::size_t comparisons = 0;
  std::size_t tried = 0, parted = 0;  // parents of two neighbors, and those whose boxes are apart
};

/// What two neighbors in a front are the two halves of.
inline std::optional<NodePair> common_parent(std::span<const BoxNode> as, std::span<const BoxNode> bs, bool is_own,
                                             NodePair first, NodePair second) {
  if (is_own && (first.a == first.b || second.a == second.b)) return {};  // parts of a node with itself
  const auto is_parent = [](std::span<const BoxNode> nodes, std::uint32_t child, std::uint32_t other) {
    return child > 0 && !nodes[child - 1].is_leaf() && child - 1 + nodes[child - 1].link == other;
  };
  if (first.b == second.b && is_parent(as, first.a, second.a)) return NodePair{first.a - 1, first.b};
  if (first.a == second.a && is_parent(bs, first.b, second.b)) return NodePair{first.a, first.b - 1};
  return {};
}

template <class Scene>
class FrontWalk {
 public:
  /// So many frames pass until the parents of all have been looked at.
  static constexpr std::uint32_t frames_to_all_parents = 4;

  FrontWalk(const Scene& scene, std::uint32_t frame, bool touching)
      : scene_(scene), leaves_(scene.leaves()), frame_(frame), touching_(touching) {}

  void from(NodePair start) {
    std::array<NodePair, most_waiting_pairs> later;
    std::size_t waiting = 0;
    later[waiting++] = start;
    while (waiting > 0) {
      const NodePair pair = later[--waiting];
      if (!meets(pair)) {
        add_apart(pair);
      } else if (scene_.nodes_a()[pair.a].is_leaf() && scene_.nodes_b()[pair.b].is_leaf()) {
        add_leaves(pair);
      } else {
        divide(pair, [&](NodePair next) { later[waiting++] = next; });
      }
    }
  }

  /// One level of a descent alone; was there any?
  bool one_level(NodePair pair) {
    const bool both_leaves = scene_.nodes_a()[pair.a].is_leaf() && scene_.nodes_b()[pair.b].is_leaf();
    if (both_leaves || !meets(pair)) {
      part_.pairs.push_back(pair);
      return false;
    }
    const auto at = static_cast<std::ptrdiff_t>(part_.pairs.size());
    divide(pair, [&](NodePair next) { part_.pairs.push_back(next); });
    std::reverse(part_.pairs.begin() + at, part_.pairs.end());
    return true;
  }

  [[nodiscard]] FrontPart& result() { return part_; }

 private:
  [[nodiscard]] bool meets(NodePair pair) {
    ++part_.comparisons;
    return scene_.meets(pair);
  }

  template <class Take>
  void divide(NodePair pair, const Take& take) {
    bool a = false, b = false;
    scene_.replace(pair, [&](NodePair next) {
      a = a || next.a != pair.a;
      b = b || next.b != pair.b;
      take(next);
    });
    if (a) part_.divided_a.push_back(pair.a);
    if (b) part_.divided_b.push_back(pair.b);
  }

  void add_leaves(NodePair pair) {
    leaves_(pair, [&](const TrianglePair& found, SlotPair) {
      if (touching_ || found.relation != Relation::touching) part_.found.push_back(found);
      return Descent::go_on;
    });
    part_.pairs.push_back(pair);
    last_is_apart_ = false;
  }

  void add_apart(NodePair pair) {
    std::vector<NodePair>& all = part_.pairs;
    for (bool first = true;; first = false) {
      const auto parent = all.empty() || (first && !last_is_apart_)
                              ? std::optional<NodePair>()
                              : common_parent(scene_.nodes_a(), scene_.nodes_b(), scene_.is_own(), all.back(), pair);
      if (!parent || (first && !is_their_turn(*parent))) break;
      ++part_.tried;
      if (meets(*parent)) break;
      ++part_.parted;
      all.pop_back();
      pair = *parent;
    }
    all.push_back(pair);
    last_is_apart_ = true;
  }
  [[nodiscard]] bool is_their_turn(NodePair parent) const {
    return (parent.a + 3 * parent.b + frame_) % frames_to_all_parents == 0;
  }

  const Scene& scene_;
  typename Scene::Leaves leaves_;
  std::uint32_t frame_;
  bool touching_, last_is_apart_ = false;
  FrontPart part_;
};

}  // namespace plumb::space
