// Branch and bound over pairs of nodes for the nearest pair of triangles, the nearest nodes first; ties exactly.
//
// Law: a guess changes no answer: what is offered first is offered as any other is.
// Source: RTCD 5.1.10, 6.3.2.
// Cost: a bound for each pair that a pair of nodes is replaced by, a distance for each pair of triangles whose boxes
// may be nearer.
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/arith/rational.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/watch.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"
#include "space/closest/pair_queue.hpp"

namespace plumb::space {

/// A tree whose boxes are asked for in a frame of its own or another.
class FramedMesh {
 public:
  FramedMesh(const Bvh& mesh, const BoxFrame& frame)
      : mesh_(mesh), frame_(frame), is_own_frame_(mesh.tree.frame == frame), nodes_(mesh.tree.nodes.view()) {}

  [[nodiscard]] const BoxNode& node(std::uint32_t i) const { return nodes_[i]; }
  [[nodiscard]] std::span<const BoxNode> nodes() const { return nodes_; }
  [[nodiscard]] std::size_t slots() const { return mesh_.triangles.size(); }
  [[nodiscard]] FloatBox3 box(std::uint32_t i) const {
    const FloatBox3 own = nodes_[i].box();
    return is_own_frame_ ? own : frame_.around(mesh_.tree.frame.outside(own));
  }
  [[nodiscard]] Aabb3 triangle_box(std::uint32_t slot) const {
    return box_around(mesh_.triangles[slot], mesh_.vertices.view());
  }
  [[nodiscard]] Triangle3 triangle(std::uint32_t slot) const { return mesh_.triangle(slot); }
  [[nodiscard]] std::uint32_t item(std::uint32_t slot) const { return mesh_.tree.items[slot]; }

 private:
  const Bvh& mesh_;
  BoxFrame frame_;
  bool is_own_frame_;
  std::span<const BoxNode> nodes_;
};

template <class Watch = Unwatched>
class ClosestSearch {
 public:
  struct Candidate {
    std::uint32_t a, b;  // numbers
    std::uint32_t slot_a, slot_b;
    Triangle3 s, t;
    double distance;
  };

  /// Of meshes that are not empty.
  ClosestSearch(const Bvh& a, const Bvh& b, Watch watch = {})
      : frame_(a.tree.frame.exponent() < b.tree.frame.exponent() ? b.tree.frame : a.tree.frame),
        a_(a, frame_),
        b_(b, frame_),
        watch_(watch) {}

  /// A pair that may be near, as that of these slots was before; numbers that are no slots are no guess.
  void guess(std::uint32_t slot_a, std::uint32_t slot_b) {
    if (slot_a < a_.slots() && slot_b < b_.slots()) offer(slot_a, slot_b, true);
  }

  Candidate run() {
    push({0, 0});
    while (!later_.empty() && !(later_.top().bound > limits_.of_nodes)) {
      const NodePair pair = later_.top().pair;
      later_.pop();
      const BoxNode &a = a_.node(pair.a), &b = b_.node(pair.b);
      if (a.is_leaf() && b.is_leaf()) {
        leaves(a, b);
      } else {
        replace_pair(a_.nodes(), b_.nodes(), descend_larger{}, pair, [&](NodePair next) { push(next); });
      }
    }
    return best_;
  }

 private:
  void push(NodePair pair) {
    watch_.node();
    const double bound = square_below(a_.box(pair.a), b_.box(pair.b));
    if (!(bound > limits_.of_nodes)) later_.push({bound, pair});
  }

  void leaves(const BoxNode& a, const BoxNode& b) {
    for (std::uint32_t i = a.link; i < a.link + a.count; ++i) {
      const Aabb3 box = a_.triangle_box(i);
      for (std::uint32_t k = b.link; k < b.link + b.count; ++k) {
        const double bound = square_below(box, b_.triangle_box(k));
        if (!(bound > limits_.of_figures)) offer(i, k, bound == 0);
      }
    }
  }

  void offer(std::uint32_t slot_a, std::uint32_t slot_b, bool may_meet) {
    const std::uint32_t a = a_.item(slot_a), b = b_.item(slot_b);
    const bool comes_first = a != best_.a ? a < best_.a : b < best_.b;
    if (meet_ && !comes_first) return;
    watch_.triangle();
    const Triangle3 s = a_.triangle(slot_a), t = b_.triangle(slot_b);
    if (may_meet && relate(s, t) != Relation::disjoint) {  // from now on only pairs that do and come first
      best_ = {a, b, slot_a, slot_b, s, t, 0};
      meet_ = true;
      limits_ = {0, 0};
    }
    if (meet_) return;
    const Candidate candidate{a, b, slot_a, slot_b, s, t, distance(s, t)};
    if (candidate.distance > best_.distance) return;
    std::optional<BestExactly> exactly;
    if (candidate.distance == best_.distance && found_ && !is_before(candidate, comes_first, exactly)) return;
    best_ = candidate;
    best_exactly_ = std::move(exactly);
    found_ = true;
    limits_ = limits_above(frame_, candidate.distance);
  }

  /// What is known of a pair where another comes as near.
  struct BestExactly {
    Rational square;
    double square_above;

    explicit BestExactly(Rational s) : square(std::move(s)), square_above(square.rounded(Rounding::up)) {}
  };

  /// Of distances that round alike.  Many pairs may: those whose boxes are no nearer are told by these alone.
  [[nodiscard]] bool is_before(const Candidate& c, bool comes_first, std::optional<BestExactly>& exactly) {
    if (!best_exactly_) best_exactly_.emplace(squared_distance_exact(best_.s, best_.t));
    if (!comes_first &&
        exact_square_below(a_.triangle_box(c.slot_a), b_.triangle_box(c.slot_b)) >= best_exactly_->square_above) {
      return false;
    }
    const Closest closest = closest_points(c.s, c.t), best = closest_points(best_.s, best_.t);
    if (near_feature(c.s, closest.feature_a) == near_feature(best_.s, best.feature_a) &&
        near_feature(c.t, closest.feature_b) == near_feature(best_.t, best.feature_b)) {
      if (comes_first) exactly = best_exactly_;
      return comes_first;
    }
    exactly.emplace(squared_distance_exact(c.s, c.t));
    const auto order = exactly->square <=> best_exactly_->square;
    return order < 0 || (order == 0 && comes_first);
  }

  BoxFrame frame_;
  FramedMesh a_, b_;
  Watch watch_;
  PairQueue later_;
  SquareLimits limits_;
  Candidate best_{0, 0, 0, 0, {}, {}, std::numeric_limits<double>::infinity()};
  std::optional<BestExactly> best_exactly_;  // where it had to be known
  bool found_ = false, meet_ = false;
};

template <class Candidate>
ClosestTriangles closest_pair_found(const Candidate& found) {
  return {found.a, found.b, closest_points(found.s, found.t)};
}

}  // namespace plumb::space
