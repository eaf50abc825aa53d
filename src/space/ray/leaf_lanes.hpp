// What do rays meet in a tree's leaves?  Its nodes and triangles, however they are kept, a vector of triangles at once.
//
// Cost: three loads of corners and nine of numbers a triangle, turned in registers.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_LEAF_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_LEAF_LANES
#undef PLUMB_LEAF_LANES
#else
#define PLUMB_LEAF_LANES
#endif

#include <hwy/highway.h>

#include <limits>
#include <type_traits>

#include "plumb/space/bvh/bvh.hpp"
#include "query/ray/triangle_lanes.hpp"
#include "space/bvh/compact_lanes.hpp"
#include "space/ray/wide_rays.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace in_lanes = query::HWY_NAMESPACE;
using in_lanes::D, in_lanes::V, in_lanes::lanes;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// How a tree is kept: its nodes, which compact ones become as they are opened, and the corners of slots, three each.
class WideForm {
 public:
  using Node = WideNode<8>;
  explicit WideForm(const Bvh& bvh) : nodes_(bvh.wide.nodes.data()), corners_(bvh.triangles.data()) {}

  [[nodiscard]] const Node& opened(std::uint32_t node) const { return nodes_[node]; }
  [[nodiscard]] std::size_t vertex(std::size_t slot, std::size_t k) const { return corners_[slot][k]; }
  [[nodiscard]] const void* node_at(std::uint32_t node) const { return nodes_ + node; }
  [[nodiscard]] const void* leaf_at(std::uint32_t slot) const { return corners_ + slot; }

 private:
  const Node* nodes_;
  const Bvh::Corners* corners_;
};
class CompactForm {
 public:
  using Node = CompactNode;
  explicit CompactForm(const CompactBvh& bvh) : nodes_(bvh.tree.nodes.data()), corners_(bvh.corners.view()) {}

  [[nodiscard]] HWY_INLINE WideNode<8> opened(std::uint32_t node) const {
    WideNode<8> wide;
    widen_node(nodes_[node], wide);
    return wide;
  }
  [[nodiscard]] std::size_t vertex(std::size_t slot, std::size_t k) const { return corners_[3 * slot + k]; }
  [[nodiscard]] const void* node_at(std::uint32_t node) const { return nodes_ + node; }
  [[nodiscard]] const void* leaf_at(std::uint32_t slot) const {
    return corners_.bytes + 3 * std::size_t{slot} * corners_.width;
  }

 private:
  const Node* nodes_;
  PackedView corners_;
};
template <class Mesh>
using FormOf = std::conditional_t<std::is_same_v<Mesh, Bvh>, WideForm, CompactForm>;

/// The triangles of slots, a vector of them at once.
template <class Form>
struct Leaves {
  Form form;
  const double* numbers;  // three a vertex

  /// The numbers of vertices, lane by lane.
  HWY_INLINE static in_lanes::Lanes3 turned(const double* const* at) {
#if HWY_TARGET == HWY_SCALAR
    return {hn::Set(D(), at[0][0]), hn::Set(D(), at[0][1]), hn::Set(D(), at[0][2])};
#else
    const V even = pairs(D(), at, 0), odd = pairs(D(), at + 1, 0);
    return {hn::InterleaveLower(D(), even, odd), hn::InterleaveUpper(D(), even, odd),
            hn::InterleaveUpper(D(), pairs(D(), at, 1), pairs(D(), at + 1, 1))};
#endif
  }

  /// Of a node or leaf that will be looked at next: the node, or its triangles' corners.
  HWY_INLINE void fetch_next(std::uint32_t link, std::uint32_t count) const {
    const void *const node = form.node_at(link), *const leaf = form.leaf_at(link);
    const auto* const at = static_cast<const char*>(count == 0 ? node : leaf);
    for (std::size_t i = 0; i < sizeof(typename Form::Node); i += 64) __builtin_prefetch(at + i);
  }
  /// The vertices of a leaf whose corners have been fetched.
  HWY_INLINE void fetch(std::uint32_t first, std::uint32_t count) const {
    for (std::size_t slot = first, end = slot + count; slot < end; ++slot) {
      for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(numbers + 3 * form.vertex(slot, k));
    }
  }

  /// work(from, there, p, q, r): the triangles of slots from `from` on, of which bits say which lanes are; until it
  /// answers false.
  template <class Work>
  HWY_INLINE void for_vectors(std::uint32_t first, std::uint32_t count, const Work& work) const {
    for (std::uint32_t from = first, end = first + count; from < end; from += lanes) {
      const std::uint32_t rest = end - from;
      const double* at[3][lanes];
      for (std::uint32_t i = 0; i < lanes; ++i) {
        const std::uint32_t slot = from + (i < rest ? i : rest - 1);
        for (std::size_t k = 0; k < 3; ++k) at[k][i] = numbers + 3 * form.vertex(slot, k);
      }
      const unsigned there = rest < lanes ? (1u << rest) - 1 : (1u << lanes) - 1;
      if (!work(from, there, turned(at[0]), turned(at[1]), turned(at[2]))) return;
    }
  }

  /// What is done with a vector is inline: called, it would get nine vectors through memory.
  HWY_INLINE double visit(const AskedRay& asked, std::uint32_t first, std::uint32_t count, double limit) const {
    const in_lanes::RayLanes ray(asked.ray, asked.doubts);
    for_vectors(
        first, count,
        [&](std::uint32_t from, unsigned there, const auto& p, const auto& q, const auto& r)
            __attribute__((always_inline)) {
              limit = visited(asked, in_lanes::tell(ray, p, q, r), from, there, limit);
              return limit != -infinity;
            });
    return limit;
  }

  /// Those that may be hit; the limit from now on.
  HWY_INLINE static double visited(const AskedRay& asked, const in_lanes::TrianglesTold& told, std::uint32_t from,
                                   unsigned there, double limit) {
    unsigned maybe = ~told.no & there;
    if (maybe == 0) return limit;
    HWY_ALIGN double least[lanes], most[lanes];
    hn::Store(told.least, D(), least);
    hn::Store(told.most, D(), most);
    for (; maybe != 0; maybe &= maybe - 1) {
      const auto i = static_cast<unsigned>(__builtin_ctz(maybe));
      limit = asked.visitor->visit(from + i, (told.yes >> i & 1) != 0, least[i], most[i]);
      if (limit == -infinity) break;
    }
    return limit;
  }

 private:
#if HWY_TARGET != HWY_SCALAR
  /// Two numbers from each second vertex on, from the number k on.
  template <class Tag>
  HWY_INLINE static hn::Vec<Tag> pairs(Tag tag, const double* const* at, std::size_t k) {
    if constexpr (hn::MaxLanes(Tag()) == 2) {
      return hn::LoadU(tag, at[0] + k);
    } else {
      const hn::Half<Tag> half;
      return hn::Combine(tag, pairs(half, at + hn::MaxLanes(half), k), pairs(half, at, k));
    }
  }
#endif
};

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
