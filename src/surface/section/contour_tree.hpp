// What of a contour lies beside a place?  Its edges in runs, halved again and again, each with its box.
//
// Laws: boxes are of nearest doubles, whose order is that of the corners where they differ: what lies strictly beside a
// box does so exactly.
// Source: RTCD 6.6 (a hierarchy in preorder, with skip pointers).  Cost: 64 bytes a corner; some steps for each edge
// near the place, and a logarithm of the contour.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/aabb/aabb.hpp"
#include "surface/section/cut_corners.hpp"

namespace plumb::surface {

/// The box of the nearest doubles of corners.
Aabb2 nearest_box(std::span<const std::uint32_t> corners, const CutCorners& at);

class ContourTree {
 public:
  /// A closed contour of two corners or more, which outlives the tree.
  ContourTree(std::span<const std::uint32_t> loop, const CutCorners& corners);

  /// Calls `edge(from, to)` for all edges but those of runs that lie beside the place: `right(from, to)` for runs
  /// strictly right of it that are neither above nor below, by the corners where they begin and end.
  template <class Right, class Edge>
  void visit(const Aabb2& place, const Right& right, const Edge& edge) const {
    for (std::size_t i = 0; i < runs_.size();) {
      const Run& run = runs_[i];
      if (run.box.max.y < place.min.y || run.box.min.y > place.max.y || run.box.max.x < place.min.x) {
        i = run.next;
      } else if (run.box.min.x > place.max.x) {
        right(corner_before(run.first), loop_[run.last]);
        i = run.next;
      } else {
        if (run.first == run.last) edge(corner_before(run.first), loop_[run.last]);
        ++i;
      }
    }
  }

 private:
  struct Run {
    Aabb2 box;
    std::uint32_t first, last;  // edges, each by the corner where it ends
    std::uint32_t next;         // the run after those within this one
  };
  [[nodiscard]] std::uint32_t corner_before(std::uint32_t edge) const {
    return edge == 0 ? loop_.back() : loop_[edge - 1];
  }
  Aabb2 build(std::uint32_t first, std::uint32_t last, const CutCorners& corners);

  std::span<const std::uint32_t> loop_;
  std::vector<Run> runs_;
};

}  // namespace plumb::surface
