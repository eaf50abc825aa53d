// The first triangle that a ray hits, of a tree of any volumes: nearer ones first, parameters compared exactly.
//
// Triangles have hit(slot), a Hit rounded once, parameter(slot), exactly, and number(slot).
// Law: of the least exact parameter, and of equal ones the lowest number, as long as bound(node) is at most that of every
// triangle below the node, and infinite only where none is hit.
// Source: RTCD 6.3.2.
// Cost: the descent, and the exact parameters of hits whose doubles tie.
#pragma once

#include <optional>

#include "plumb/query/ray/batch.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb::space {

inline constexpr double most_parameter = std::numeric_limits<double>::max();

template <class Tree, class Triangles, class Bound>
std::optional<NumberedHit> nearest_hit(const Tree& tree, const Triangles& triangles, const Bound& bound) {
  struct Best {
    std::uint32_t number, slot;
    Hit hit;
  };
  std::optional<Best> best;
  double limit = most_parameter;
  const auto is_before = [&](const Best& h) {
    if (!best || h.hit.t != best->hit.t) return !best || h.hit.t < best->hit.t;
    const auto order = triangles.parameter(h.slot) <=> triangles.parameter(best->slot);
    return order < 0 || (order == 0 && h.number < best->number);
  };
  descend_nearer_first(tree, limit, bound, [&](std::uint32_t first, std::uint32_t count, double& until) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const auto hit = triangles.hit(slot);
      if (!hit) continue;
      const Best found{triangles.number(slot), slot, *hit};
      if (!is_before(found)) continue;
      best = found;
      until = std::min(until, raised(hit->t));
    }
  });
  if (!best) return {};
  return NumberedHit{best->number, best->hit};
}

}  // namespace plumb::space
