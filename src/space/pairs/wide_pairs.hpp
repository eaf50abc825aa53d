// Which triangles of two trees meet, or of one, by their wide forms: 64 boxes at a time, and triangles eight at a time.
//
// Law: each pair of slots whose triangles meet is told once, of one tree of two slots; in an order that depends on the
// trees alone.
// Source: RTCD 6.3.3, 6.6, 13.7.
// Cost: that of pair_lanes.hpp for pairs of nodes and of leaves, and relate for the triangles that may meet.
#pragma once

#include <algorithm>
#include <vector>

#include "space/pairs/leaf_pairs.hpp"
#include "space/pairs/pair_lanes.hpp"

namespace plumb::space {

/// A child of a wide node, or the root: as WideNode says.
struct WidePlace {
  std::uint32_t link, count;
  std::uint32_t parent, child;  // whose box it is; not of the root

  [[nodiscard]] bool is_leaf() const { return count != 0; }
};
inline constexpr WidePlace wide_root{0, 0, 0, 0};

struct WidePair {
  WidePlace a, b;

  [[nodiscard]] bool is_leaves() const { return a.is_leaf() && b.is_leaf(); }
};

/// What takes the place of pairs that are not two leaves: those of their children that meet.
class WideChildren {
 public:
  /// Of trees in one frame; the same tree where `own`.
  WideChildren(std::span<const WideNode<8>> as, std::span<const WideNode<8>> bs, bool own)
      : as_(as), bs_(bs), own_(own) {}

  /// take(WidePair) of each.
  template <class Take>
  void operator()(const WidePair& pair, const Take& take) const {
    if (pair.a.is_leaf()) {
      take_each(children_met(as_[pair.a.parent], pair.a.child, bs_[pair.b.link]), [&](std::uint32_t k) {
        take(WidePair{pair.a, place(bs_, pair.b.link, k)});
      });
      return;
    }
    if (pair.b.is_leaf()) {
      take_each(children_met(bs_[pair.b.parent], pair.b.child, as_[pair.a.link]), [&](std::uint32_t i) {
        take(WidePair{place(as_, pair.a.link, i), pair.b});
      });
      return;
    }
    const ChildrenMet met = children_met(as_[pair.a.link], bs_[pair.b.link]);
    const bool with_itself = own_ && pair.a.link == pair.b.link;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const unsigned of_i = with_itself ? met[i] & ~0u << i : met[i];
      if (of_i == 0) continue;
      const WidePlace a = place(as_, pair.a.link, i);
      take_each(of_i, [&](std::uint32_t k) { take(WidePair{a, place(bs_, pair.b.link, k)}); });
    }
  }

 private:
  static WidePlace place(std::span<const WideNode<8>> nodes, std::uint32_t node, std::uint32_t child) {
    return {nodes[node].link[child], nodes[node].count[child], node, child};
  }
  template <class Take>
  static void take_each(unsigned bits, const Take& take) {
    for (; bits != 0; bits &= bits - 1) take(static_cast<std::uint32_t>(__builtin_ctz(bits)));
  }

  std::span<const WideNode<8>> as_, bs_;
  bool own_;
};

/// What a search asks of two leaves of wide trees; the last that were read are kept.
class WideLeafPairs {
 public:
  WideLeafPairs(const SlotMesh<Bvh>& a, const SlotMesh<Bvh>& b, bool is_own, const SimpleStars* stars)
      : a_(a), b_(b), is_own_(is_own), judge_(a, b, is_own, stars) {}

  /// take(TrianglePair, SlotPair) of each pair; it may say Descent::stop.
  template <class Take>
  Descent operator()(const WidePair& leaves, const Take& take) {
    const bool same_leaf = is_own_ && leaves.a.link == leaves.b.link;
    for (std::uint32_t i = 0; i < leaves.a.count; i += most_in_lanes) {
      const TriangleLanes& of_a = kept_a_.read(a_, leaves.a, i);
      for (std::uint32_t k = same_leaf ? i : 0; k < leaves.b.count; k += most_in_lanes) {
        if (told(of_a, leaves.a.link + i, kept_b_[leaves.b.child].read(b_, leaves.b, k), leaves.b.link + k, take) ==
            Descent::stop)
          return Descent::stop;
      }
    }
    return Descent::go_on;
  }

  /// What will be read of them is brought near.  Inline: GCC would leave out the call of what only fetches.
  [[gnu::always_inline]] void fetch(const WidePair& leaves) const {
    kept_a_.fetch(a_, leaves.a);
    kept_b_[leaves.b.child].fetch(b_, leaves.b);
  }

 private:
  struct Kept {
    [[gnu::always_inline]] void fetch(const SlotMesh<Bvh>& mesh, const WidePlace& leaf) const {
      if (lanes.n != 0 && slot == leaf.link) return;
      for (std::uint32_t s = leaf.link; s < leaf.link + std::min<std::uint32_t>(leaf.count, most_in_lanes); ++s) {
        for (const std::uint32_t v : mesh.triangles[s]) __builtin_prefetch(&mesh.vertices[v]);
      }
    }
    const TriangleLanes& read(const SlotMesh<Bvh>& mesh, const WidePlace& leaf, std::uint32_t from) {
      const std::uint32_t first = leaf.link + from, n = std::min<std::uint32_t>(leaf.count - from, most_in_lanes);
      if (lanes.n != 0 && slot == first) return lanes;
      for (std::uint32_t i = 0; i < most_in_lanes; ++i) {
        const Bvh::Corners& corners = mesh.triangles[first + std::min(i, n - 1)];
        for (std::size_t c = 0; c < 3; ++c) {
          const Point3& p = mesh.vertices[corners[c]];
          lanes.corners[3 * c][i] = p.x, lanes.corners[3 * c + 1][i] = p.y, lanes.corners[3 * c + 2][i] = p.z;
        }
      }
      lanes.n = n, slot = first;
      complete(lanes);
      return lanes;
    }
    TriangleLanes lanes;
    std::uint32_t slot = 0;  // of the first
  };

  template <class Take>
  Descent told(const TriangleLanes& of_a, std::uint32_t slot_a, const TriangleLanes& of_b, std::uint32_t slot_b,
               const Take& take) const {
    MayMeet may;
    find_near(of_a, of_b, may);
    for (std::uint32_t i = 0; i < of_a.n; ++i) {
      unsigned near = may[i];
      if (is_own_ && slot_a == slot_b) near &= ~1u << i;
      for (; near != 0; near &= near - 1) {
        const SlotPair slots{slot_a + i, slot_b + static_cast<std::uint32_t>(__builtin_ctz(near))};
        if (judge_(slots, take) == Descent::stop) return Descent::stop;
      }
    }
    return Descent::go_on;
  }

  const SlotMesh<Bvh>&a_, &b_;
  bool is_own_;
  JudgedPair<SlotMesh<Bvh>> judge_;
  Kept kept_a_;
  std::array<Kept, 8> kept_b_;  // by the child that the leaf is
};

}  // namespace plumb::space
