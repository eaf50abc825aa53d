// Branch and bound over posed boxes for what is nearest to a point or to another moved mesh; ties exactly.
//
// Law: a guess changes no answer: what is offered first is offered as any other is.
// Source: RTCD 3.2, 4.2.6, 5.1.5, 5.1.10, 6.3.2.
// Cost: some 100 ns for each node that is looked at, 500 for each triangle whose box may be nearer; of two meshes tens
// of microseconds for each pair of triangles that no wall stops.
#pragma once

#include <algorithm>
#include <compare>
#include <limits>
#include <optional>
#include <vector>

#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/space/bvh/descend_compact_pairs.hpp"
#include "plumb/space/closest/posed_closest.hpp"
#include "query/closest/posed_triangle.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/watch.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"
#include "space/closest/near_wall.hpp"
#include "space/closest/pair_queue.hpp"

namespace plumb::space {

inline constexpr double beyond_all = std::numeric_limits<double>::infinity();

/// A triangle of doubles, and how far from it a point of the posed one can be: no farther than a corner.
struct NearbyTriangle {
  Triangle3 triangle;
  double off;

  explicit NearbyTriangle(const PosedTriangle& t) : triangle(t.shape), off(0) {
    for (Point3* p : {&triangle.a, &triangle.b, &triangle.c}) {
      const Aabb3 box = around(t.pose, *p);
      if (!is_bounded(box)) off = beyond_all;
      *p = box.min;
      const double x = raised(box.max.x - box.min.x), y = raised(box.max.y - box.min.y);
      off = std::max(off, raised(raised(x + y) + raised(box.max.z - box.min.z)));
    }
  }
};

/// At most the distance of the posed triangles, and of a point.
inline double distance_below(const NearbyTriangle& s, const NearbyTriangle& t) {
  const double off = raised(s.off + t.off);
  return off < beyond_all ? lowered(lowered(distance(s.triangle, t.triangle)) - off) : 0;
}
inline double distance_below(const NearbyTriangle& s, const Point3& p) {
  return s.off < beyond_all ? lowered(lowered(distance(p, s.triangle)) - s.off) : 0;
}

struct PosedCandidate {
  std::uint32_t item, slot;
  double distance;
};

/// The k nearest, in order.  A triangle that may be near, as one of this slot was before, is offered first where k is
/// 1; a number that is no slot is no guess.
template <class Mesh, class Watch = Unwatched>
std::vector<PosedCandidate> nearest_posed(const PosedMeshOf<Mesh>& mesh, const Point3& p, std::size_t k,
                                          std::uint32_t guess = no_slot, Watch watch = {}) {
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
  double limit = beyond_all;
  const std::uint32_t offered = k == 1 && guess < mesh.bvh.slots() ? guess : no_slot;
  if (offered != no_slot) {
    watch.triangle();
    found.push_back({mesh.bvh.number(guess), guess, query::distance(mesh.triangle(guess), p)});
    limit = square_above(found.back().distance);
  }
  descend_nearer_first(mesh.bvh.tree, limit, bound, [&](std::uint32_t first, std::uint32_t count, double& now) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      if (slot == offered) continue;
      const PosedTriangle triangle = mesh.triangle(slot);
      if (square_below(point, around(triangle)) > now) continue;
      if (found.size() == k && distance_below(NearbyTriangle(triangle), p) > raised(found.back().distance)) continue;
      watch.triangle();
      const PosedCandidate candidate{mesh.bvh.number(slot), slot, query::distance(triangle, p)};
      if (found.size() == k && !nearer(candidate, found.back())) continue;
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

/// The nearest pair of nodes always; once two triangles meet, only those that do and come first.
template <class Watch = Unwatched>
class PosedClosestSearch {
 public:
  struct Candidate {
    std::uint32_t a, b, slot_a, slot_b;
    double distance;
  };

  /// Of meshes that are not empty.
  PosedClosestSearch(const PosedMesh& a, const PosedMesh& b, Watch watch = {})
      : a_(a),
        b_(b),
        watch_(watch),
        nodes_a_(a.bvh.tree.nodes.view()),
        nodes_b_(b.bvh.tree.nodes.view()),
        wall_(a, b) {}

  /// A pair that may be near, as that of these slots was before; numbers that are no slots are no guess.
  void guess(std::uint32_t slot_a, std::uint32_t slot_b) {
    if (slot_a >= a_.bvh.triangles.size() || slot_b >= b_.bvh.triangles.size()) return;
    offer({a_.bvh.tree.items[slot_a], b_.bvh.tree.items[slot_b], slot_a, slot_b, 0}, true);
  }

  Candidate run() {
    push({0, 0});
    while (!later_.empty() && !(later_.top().bound > limit_)) {
      const NodePair pair = later_.top().pair;
      later_.pop();
      const BoxNode &a = nodes_a_[pair.a], &b = nodes_b_[pair.b];
      if (a.is_leaf() && b.is_leaf()) {
        leaves(a, b);
      } else {
        const auto larger = [&](const BoxNode& x, const BoxNode& y) {  // a guess
          const auto size = [](const Aabb3& box) {
            return std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
          };
          return size(around(a_, x)) < size(around(b_, y)) ? Descend::second : Descend::first;
        };
        replace_pair(nodes_a_, nodes_b_, larger, pair, [&](NodePair next) { push(next); });
      }
    }
    settle();
    return best_;
  }

 private:
  void push(NodePair pair) {
    watch_.node();
    const double bound = square_below(around(a_, nodes_a_[pair.a]), around(b_, nodes_b_[pair.b]));
    if (!(bound > limit_)) later_.push({bound, pair});
  }

  void leaves(const BoxNode& a, const BoxNode& b) {
    for (std::uint32_t i = a.link; i < a.link + a.count; ++i) {
      const Aabb3 box = around(a_.triangle(i));
      const NearbyTriangle near(a_.triangle(i));
      for (std::uint32_t k = b.link; k < b.link + b.count; ++k) {
        const double bound = square_below(box, around(b_.triangle(k)));
        if (bound > limit_) continue;
        const Candidate pair{a_.bvh.tree.items[i], b_.bvh.tree.items[k], i, k, 0};
        if (wall_.stops(i, k)) {
          if (comes_first(pair)) stopped_.push_back(pair);
        } else if (!(distance_below(near, NearbyTriangle(b_.triangle(k))) > raised(best_.distance))) {
          offer(pair, bound == 0);
        }
      }
    }
  }

  [[nodiscard]] bool comes_first(const Candidate& c) const { return c.a != best_.a ? c.a < best_.a : c.b < best_.b; }

  /// What a wall stopped is no nearer than the best: of these the first that is as near.
  void settle() {
    const auto by_numbers = [](const Candidate& x, const Candidate& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
    std::ranges::sort(stopped_, by_numbers);
    for (const Candidate& c : stopped_) {
      if (!comes_first(c)) return;
      const PosedTriangle s = a_.triangle(c.slot_a), t = b_.triangle(c.slot_b);
      if (distance_below(NearbyTriangle(s), NearbyTriangle(t)) > raised(best_.distance)) continue;
      watch_.triangle();
      if (query::distance(s, t) != best_.distance || compare_exactly(s, t) != 0) continue;
      best_ = {c.a, c.b, c.slot_a, c.slot_b, best_.distance};
      return;
    }
  }

  void offer(Candidate candidate, bool may_meet) {
    const bool first = comes_first(candidate);
    if (meet_ && !first) return;
    watch_.triangle();
    const PosedTriangle s = a_.triangle(candidate.slot_a), t = b_.triangle(candidate.slot_b);
    if (may_meet && query::relate(s, t) != Relation::disjoint) {
      best_ = candidate;
      meet_ = true;
      limit_ = 0;
      forget_wall();
    }
    if (meet_) return;
    candidate.distance = query::distance(s, t);
    if (found_) {
      const bool as_near = candidate.distance == best_.distance;
      if (as_near && !wall_.is_built()) {
        wall_.build(best_.slot_a, best_.slot_b);
        if (wall_.stops(candidate.slot_a, candidate.slot_b)) {
          if (first) stopped_.push_back(candidate);
          return;
        }
      }
      const auto order = as_near ? compare_exactly(s, t) : candidate.distance <=> best_.distance;
      if (order > 0 || (order == 0 && !first)) return;
      if (order < 0) forget_wall();
    }
    best_ = candidate;
    found_ = true;
    limit_ = square_above(candidate.distance);
  }

  void forget_wall() {
    wall_.clear();
    stopped_.clear();
    best_square_.reset();
  }

  /// With the best, of distances that round alike.
  [[nodiscard]] std::partial_ordering compare_exactly(const PosedTriangle& s, const PosedTriangle& t) {
    const PosedTriangle best_s = a_.triangle(best_.slot_a), best_t = b_.triangle(best_.slot_b);
    const auto features = query::quick_features(s, t), best = query::quick_features(best_s, best_t);
    const auto same = [&](std::size_t i, const PosedTriangle& one, const PosedTriangle& other) {
      return near_feature(one.shape, (*features)[i]) == near_feature(other.shape, (*best)[i]);
    };
    if (features && best && same(0, s, best_s) && same(1, t, best_t)) return std::partial_ordering::equivalent;
    if (!best_square_) best_square_ = query::squared_distance_exact(best_s, best_t);
    return query::squared_distance_exact(s, t) <=> *best_square_;
  }

  const PosedMesh &a_, &b_;
  Watch watch_;
  std::span<const BoxNode> nodes_a_, nodes_b_;
  PairQueue later_;
  double limit_ = beyond_all;
  NearWall wall_;                        // of the best
  std::vector<Candidate> stopped_;       // by it, and before the best
  std::optional<Rational> best_square_;  // where it had to be known
  Candidate best_{0, 0, 0, 0, beyond_all};
  bool found_ = false, meet_ = false;
};

template <class Candidate>
ClosestTriangles posed_pair_found(const PosedMesh& a, const PosedMesh& b, const Candidate& found) {
  return {found.a, found.b, query::closest_points(a.triangle(found.slot_a), b.triangle(found.slot_b))};
}

}  // namespace plumb::space
