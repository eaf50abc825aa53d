// Branch and bound for the triangles nearest to a point: boxes by squares that are rounded outward, triangles by
// distances, ties exactly.
//
// Law: a guess changes no answer: what is offered first is offered as any other is.
// Source: RTCD 5.1.5, 6.3.2.
// Cost: a bound for each child of a node that is entered, a distance for each triangle whose box may be nearer.
#pragma once

#include <algorithm>
#include <vector>

#include "plumb/query/closest/closest.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/bvh/watch.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"

namespace plumb::space {

/// The k nearest triangles of those that were offered; of a Bvh or a CompactBvh.
template <class Watch = Unwatched, class Mesh = Bvh>
class Nearest {
 public:
  struct Candidate {
    std::uint32_t item, slot;
    double distance;
  };

  Nearest(const Mesh& mesh, std::size_t k, Watch watch = {})
      : tree_(mesh.tree), triangles_(mesh), k_(std::min(k, triangles_.slots())), watch_(watch) {}

  /// A triangle that may be near, as one of this slot was before, is offered first where k is 1; a number that is no
  /// slot is no guess.
  const std::vector<Candidate>& of(const Point3& p, std::uint32_t guess = no_slot) {
    p_ = p;
    found_.clear();
    if (k_ == 0) return found_;
    const BoxFrame& frame = tree_.frame;
    const Aabb3 point{p, p};
    const FloatBox3 at = frame.around(point);
    const std::uint32_t offered = k_ == 1 && guess < triangles_.slots() ? guess : no_slot;
    SquareLimits limits;
    const auto bound = [&](const BoxNode& node) {
      watch_.node();
      return square_below(at, node);
    };
    const auto visit = [&](std::uint32_t first, std::uint32_t count, double& now) {
      for (std::uint32_t slot = first; slot < first + count; ++slot) {
        if (slot == offered) continue;
        const Triangle3 t = triangles_.triangle(slot);
        if (square_below(point, box_around(t.a, t.b, t.c)) > limits.of_triangles) continue;
        watch_.triangle();
        const double d = plumb::distance(p, t);
        if (!offer({triangles_.number(slot), slot, d}) || found_.size() < k_) continue;
        limits = limits_above(frame, found_.back().distance);
        now = limits.of_nodes;
      }
    };
    if (offered != no_slot) {
      watch_.triangle();
      offer({triangles_.number(guess), guess, plumb::distance(p, triangles_.triangle(guess))});
      limits = limits_above(frame, found_.back().distance);
    }
    double limit = limits.of_nodes;
    descend_nearer_first(tree_, limit, bound, visit);
    return found_;
  }

 private:
  bool offer(const Candidate& candidate) {
    const auto nearer = [&](const Candidate& x, const Candidate& y) {
      return x.distance != y.distance ? x.distance < y.distance : comes_first(x, y);
    };
    if (found_.size() == k_ && !nearer(candidate, found_.back())) return false;
    const auto place = std::upper_bound(found_.begin(), found_.end(), candidate, nearer) - found_.begin();
    if (place > 0 && found_[static_cast<std::size_t>(place - 1)].item == candidate.item) return false;  // in two slots
    if (found_.size() == k_) found_.pop_back();
    found_.insert(found_.begin() + place, candidate);
    return true;
  }

  /// Of distances that round alike.
  [[nodiscard]] bool comes_first(const Candidate& x, const Candidate& y) const {
    const Triangle3 s = triangles_.triangle(x.slot), t = triangles_.triangle(y.slot);
    if (near_feature(s, voronoi_region(s, p_)) == near_feature(t, voronoi_region(t, p_))) return x.item < y.item;
    const Sign order = compare(exact_distance(p_, s), exact_distance(p_, t));
    return order == Sign::zero ? x.item < y.item : order == Sign::negative;
  }

  const decltype(Mesh::tree)& tree_;
  SlotTriangles triangles_;
  std::size_t k_;
  Watch watch_;
  Point3 p_{};
  std::vector<Candidate> found_;
};

template <class Mesh, class Candidate>
ClosestOnMesh closest_found(const Mesh& mesh, const Point3& p, const Candidate& found) {
  const Closest closest = closest_points(p, mesh.triangle(found.slot));
  return {found.item, closest.on_b, closest.distance, closest.feature_b};
}

}  // namespace plumb::space
