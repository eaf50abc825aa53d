// Branch and bound over posed boxes for what is nearest to a point; ties exactly.
//
// Law: a guess changes no answer: what is offered first is offered as any other is.
// Source: RTCD 3.2, 4.2.6, 5.1.5, 6.3.2.
// Cost: some 100 ns for each node that is looked at, 500 for each triangle whose box may be nearer.
#pragma once

#include <algorithm>
#include <vector>

#include "plumb/query/closest/closest.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "plumb/space/closest/posed_closest.hpp"
#include "query/closest/posed_triangle.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/watch.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"
#include "space/closest/nearby_triangle.hpp"

namespace plumb::space {

struct PosedCandidate {
  std::uint32_t item, slot;
  double distance;
};

/// The k nearest, in order, of those within a distance.  A triangle that may be near, as one of this slot was before, is offered first where k is
/// 1; a number that is no slot is no guess.
template <class Mesh, class Watch = Unwatched>
std::vector<PosedCandidate> nearest_posed(const PosedMeshOf<Mesh>& mesh, const Point3& p, std::size_t k,
                                          std::uint32_t guess = no_slot, Watch watch = {}, double within = beyond_all) {
  std::vector<PosedCandidate> found;
  k = std::min(k, mesh.bvh.slots());
  if (k == 0) return found;
  const Aabb3 point{p, p};
  const auto nearer = [&](const PosedCandidate& x, const PosedCandidate& y) {
    if (x.distance != y.distance) return x.distance < y.distance;
    const auto feature = [&](const PosedCandidate& c) {  // as given: what is one before the pose is one under it
      return near_feature(mesh.bvh.triangle(c.slot), query::nearest_feature(mesh.triangle(c.slot), p));
    };
    if (feature(x) == feature(y)) return x.item < y.item;
    const auto order = query::squared_distance_exact(mesh.triangle(x.slot), p) <=>
                       query::squared_distance_exact(mesh.triangle(y.slot), p);
    return order < 0 || (order == 0 && x.item < y.item);
  };
  const auto bound = [&](const BoxNode& node) {
    watch.node();
    return square_below(point, around(mesh, node));
  };
  const auto is_within = [&](const PosedCandidate& c) {
    if (c.distance != within || within == beyond_all) return c.distance <= within;
    return query::compare_distance(mesh.triangle(c.slot), p, within) != Sign::positive;
  };
  double limit = square_above_exact(within);
  const std::uint32_t offered = k == 1 && guess < mesh.bvh.slots() ? guess : no_slot;
  if (offered != no_slot) {
    watch.triangle();
    const PosedCandidate candidate{mesh.bvh.number(guess), guess, query::distance(mesh.triangle(guess), p)};
    if (is_within(candidate)) found.push_back(candidate), limit = square_above(candidate.distance);
  }
  descend_nearer_first(mesh.bvh.tree, limit, bound, [&](std::uint32_t first, std::uint32_t count, double& now) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      if (slot == offered) continue;
      const PosedTriangle triangle = mesh.triangle(slot);
      if (square_below(point, around(triangle)) > now) continue;
      if (found.size() == k && distance_below(NearbyTriangle(triangle), p) > raised(found.back().distance)) continue;
      watch.triangle();
      const PosedCandidate candidate{mesh.bvh.number(slot), slot, query::distance(triangle, p)};
      if ((found.size() == k && !nearer(candidate, found.back())) || !is_within(candidate)) continue;
      const auto place = std::upper_bound(found.begin(), found.end(), candidate, nearer) - found.begin();
      if (place > 0 && found[static_cast<std::size_t>(place - 1)].item == candidate.item) continue;  // in two slots
      if (found.size() == k) found.pop_back();
      found.insert(found.begin() + place, candidate);
      if (found.size() == k) now = square_above(found.back().distance);
    }
  });
  return found;
}

template <class Mesh>
ClosestOnMesh posed_found(const PosedMeshOf<Mesh>& mesh, const Point3& p, const PosedCandidate& found) {
  const query::ClosestOnPosed near = query::closest_on(mesh.triangle(found.slot), p);
  return {found.item, near.point, near.distance, near.feature};
}

}  // namespace plumb::space
