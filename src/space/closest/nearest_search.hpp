// Branch and bound for the triangles, or other figures, nearest to a point: boxes by squares that are rounded outward,
// figures by distances, ties exactly.
//
// Law: a guess changes no answer: what is offered first is offered as any other is.
// Source: RTCD 5.1.5, 6.3.2.
// Cost: a bound for each child of a node that is entered, a distance for each figure whose box may be nearer.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "plumb/query/closest/closest.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/bvh/watch.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/figure_box.hpp"
#include "space/closest/near_feature.hpp"

namespace plumb::space {

/// The nearest double, which knows no planes: in space doubles tell it at once.
template <class Point, class Figure>
double distance_in_space(const Point& p, const Figure& figure) {
  if constexpr (std::is_same_v<Point, Point2>) {
    return plumb::distance(in_space(p), in_space(figure));
  } else {
    return plumb::distance(p, figure);
  }
}

/// How the figures in a tree's slots are told: of a Bvh or a CompactBvh.
template <class Mesh>
struct SlotsOf {
  using Items = SlotTriangles;
};

/// Nodes, and the figures in their leaves, that may be within a square of a distance: visit(slot, figure, limits).
template <class Mesh, class Items, class Watch, class Visit>
void descend_to_near(const Mesh& mesh, const Items& items, const typename Items::Point& p, SquareLimits& limits,
                     Watch& watch, const Visit& visit) {
  const Point3 q = in_space(p);
  const Aabb3 point{q, q};
  const FloatBox3 at = mesh.tree.frame.around(point);
  double limit = limits.of_nodes;
  descend_nearer_first(
      mesh.tree, limit,
      [&](const BoxNode& node) {
        watch.node();
        return square_below(at, node);
      },
      [&](std::uint32_t first, std::uint32_t count, double& now) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const auto& figure = items.figure(slot);
          if (square_below(point, box_in_space(figure)) > limits.of_figures) continue;
          visit(slot, figure);
          now = limits.of_nodes;
        }
      });
}

/// The k nearest figures of those that were offered.
template <class Watch = Unwatched, class Mesh = Bvh>
class Nearest {
 public:
  using Items = typename SlotsOf<Mesh>::Items;
  using Point = typename Items::Point;
  struct Candidate {
    std::uint32_t item, slot;
    double distance;
  };

  /// Figures farther away than `within`, which is not negative, do not count.
  Nearest(const Mesh& mesh, std::size_t k, Watch watch = {}, double within = std::numeric_limits<double>::infinity())
      : mesh_(mesh), items_(mesh), k_(std::min(k, items_.slots())), watch_(watch), within_(within) {}

  /// A figure that may be near, as one of this slot was before, is offered first where k is 1; a number that is no
  /// slot is no guess.
  const std::vector<Candidate>& of(const Point& p, std::uint32_t guess = no_slot) {
    p_ = p;
    found_.clear();
    if (k_ == 0) return found_;
    const std::uint32_t offered = k_ == 1 && guess < items_.slots() ? guess : no_slot;
    SquareLimits limits = limits_above_exact(mesh_.tree.frame, within_);
    if (offered != no_slot) {
      watch_.triangle();
      if (offer({items_.number(guess), guess, distance_in_space(p, items_.figure(guess))}))
        limits = limits_above(mesh_.tree.frame, found_.back().distance);
    }
    descend_to_near(mesh_, items_, p, limits, watch_, [&](std::uint32_t slot, const auto& figure) {
      if (slot == offered) return;
      watch_.triangle();
      const double d = distance_in_space(p, figure);
      if (offer({items_.number(slot), slot, d}) && found_.size() == k_) {
        limits = limits_above(mesh_.tree.frame, found_.back().distance);
      }
    });
    return found_;
  }

  /// Those exactly as near as the last that was found, of higher numbers, in ascending order.
  std::vector<std::uint32_t> tied_with_last() {
    std::vector<std::uint32_t> tied;
    if (found_.empty()) return tied;
    const Candidate last = found_.back();
    SquareLimits limits = limits_above(mesh_.tree.frame, last.distance);
    descend_to_near(mesh_, items_, p_, limits, watch_, [&](std::uint32_t slot, const auto& figure) {
      const Candidate other{items_.number(slot), slot, distance_in_space(p_, figure)};
      if (other.item <= last.item || other.distance != last.distance) return;
      if (order_of(other, last) == Sign::zero) tied.push_back(other.item);
    });
    std::ranges::sort(tied);
    tied.erase(std::unique(tied.begin(), tied.end()), tied.end());  // in two slots
    return tied;
  }

 private:
  bool offer(const Candidate& candidate) {
    const auto nearer = [&](const Candidate& x, const Candidate& y) {
      return x.distance != y.distance ? x.distance < y.distance : comes_first(x, y);
    };
    if (found_.size() == k_ && !nearer(candidate, found_.back())) return false;
    if (!is_within(candidate)) return false;
    const auto place = std::upper_bound(found_.begin(), found_.end(), candidate, nearer) - found_.begin();
    if (place > 0 && found_[static_cast<std::size_t>(place - 1)].item == candidate.item) return false;  // in two slots
    if (found_.size() == k_) found_.pop_back();
    found_.insert(found_.begin() + place, candidate);
    return true;
  }

  [[nodiscard]] bool is_within(const Candidate& c) const {
    return c.distance < within_ || within_ == std::numeric_limits<double>::infinity() ||
           (c.distance == within_ && compare(exact_distance(p_, items_.figure(c.slot)), within_) != Sign::positive);
  }
  /// Of distances that round alike.
  [[nodiscard]] bool comes_first(const Candidate& x, const Candidate& y) const {
    const Sign order = order_of(x, y);
    return order == Sign::zero ? x.item < y.item : order == Sign::negative;
  }
  [[nodiscard]] Sign order_of(const Candidate& x, const Candidate& y) const {
    const auto &s = items_.figure(x.slot), &t = items_.figure(y.slot);
    if (near_feature(s, p_) == near_feature(t, p_)) return Sign::zero;
    return compare(exact_distance(p_, s), exact_distance(p_, t));
  }

  const Mesh& mesh_;
  Items items_;
  std::size_t k_;
  Watch watch_;
  double within_;
  Point p_{};
  std::vector<Candidate> found_;
};

/// visit(slot, d) for each figure whose distance is at most this finite number, with its distance as a double.
template <class Mesh, class Items, class Visit>
void each_within(const Mesh& mesh, const Items& items, const typename Items::Point& p, double distance,
                 const Visit& visit) {
  SquareLimits limits = limits_above_exact(mesh.tree.frame, distance);
  Unwatched watch;
  descend_to_near(mesh, items, p, limits, watch, [&](std::uint32_t slot, const auto& figure) {
    const double d = distance_in_space(p, figure);
    if (d < distance || (d == distance && compare(exact_distance(p, figure), distance) != Sign::positive)) {
      visit(slot, d);
    }
  });
}

/// The same of a mesh's triangles.
template <class Mesh, class Visit>
void each_within(const Mesh& mesh, const Point3& p, double distance, const Visit& visit) {
  each_within(mesh, SlotTriangles(mesh), p, distance, visit);
}

template <class Mesh, class Candidate>
ClosestOnMesh closest_found(const Mesh& mesh, const Point3& p, const Candidate& found) {
  const Closest closest = closest_points(p, mesh.triangle(found.slot));
  return {found.item, closest.on_b, closest.distance, closest.feature_b};
}

}  // namespace plumb::space
