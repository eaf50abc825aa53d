// Branch and bound over posed boxes for what is nearest to a point; ties exactly.
//
// Law: a guess changes no answer: what is offered first is offered as any other is.
// Source: RTCD 3.2, 4.2.6, 5.1.5, 6.3.2.
// Cost: some 100 ns for each node that is looked at, 500 for each triangle whose box may be nearer.
#pragma once

#include <algorithm>
#include <vector>

#include "plumb/arith/exact_distance.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "query/closest/posed_triangle.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/watch.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"
#include "space/closest/nearby_triangle.hpp"
#include "space/closest/nearest_search.hpp"

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

template <class Watch, class Mesh>
class Nearest<Watch, PosedMeshOf<Mesh>> {
 public:
  Nearest(const PosedMeshOf<Mesh>& mesh, std::size_t k, Watch watch = {}, double within = beyond_all)
      : mesh_(mesh), k_(k), watch_(watch), within_(within) {}
  [[nodiscard]] std::vector<PosedCandidate> of(const Point3& p, std::uint32_t guess = no_slot) const {
    return nearest_posed(mesh_, p, k_, guess, watch_, within_);
  }

 private:
  const PosedMeshOf<Mesh>& mesh_;
  std::size_t k_;
  Watch watch_;
  double within_;
};

/// visit(slot, d) for each triangle whose distance is at most this finite number, with its distance as a double.
template <class Mesh, class Visit>
void each_within(const PosedMeshOf<Mesh>& mesh, const Point3& p, double distance, const Visit& visit) {
  const Aabb3 point{p, p};
  const double limit = square_above_exact(distance);
  const auto enters = [&](const Aabb3& box) { return !(square_below(point, box) > limit); };
  descend(
      mesh.bvh.tree, [&](const BoxNode& node) { return enters(around(mesh, node)); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const PosedTriangle triangle = mesh.triangle(slot);
          if (!enters(around(triangle))) continue;
          const double d = query::distance(triangle, p);
          const auto exact = [&] { return ExactDistance{query::squared_distance_exact(triangle, p)}; };
          if (d < distance || (d == distance && compare(exact(), distance) != Sign::positive)) visit(slot, d);
        }
      });
}

template <class Mesh>
ClosestOnMesh closest_found(const PosedMeshOf<Mesh>& mesh, const Point3& p, const PosedCandidate& found) {
  const query::ClosestOnPosed near = query::closest_on(mesh.triangle(found.slot), p);
  return {found.item, near.point, near.distance, near.feature};
}

}  // namespace plumb::space
