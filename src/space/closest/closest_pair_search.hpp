// Branch and bound over pairs of nodes for the nearest pair of triangles, the nearer pairs first; ties exactly.
//
// Leaves are told apart by a way that separates their vertices: a normal, or that from one to the other of the closest
// points that are known as yet.  Where any of equally near pairs will do, what is exactly as near as the best is left out.
// Laws: (1) a guess changes no distance: what is offered first is offered as any other is.  (2) Of equally near pairs the
// first by numbers is found where `first` is set, else any.
// Source: RTCD 4.6.1, 5.1.10, 6.3.2, 9.5.
// Cost: a bound for each pair that a pair of nodes is replaced by, some operations a vertex for each pair of leaves that
// may be nearer, a distance for each pair of triangles of which these say too little.
#pragma once

#include <algorithm>
#include <compare>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/arith/exact_distance.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/watch.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"
#include "space/closest/near_patches.hpp"
#include "space/closest/near_sources.hpp"
#include "space/closest/near_wall.hpp"

namespace plumb::space {

template <class Source, class Watch = Unwatched>
class ClosestSearch {
 public:
  struct Candidate {
    std::uint32_t a, b, slot_a, slot_b;  // numbers, and where they are
    double distance;
  };

  /// The meshes must not be empty.
  ClosestSearch(Source& a, Source& b, const ClosestPairOptions& options = {}, Watch watch = {})
      : a_(a),
        b_(b),
        watch_(watch),
        first_(options.first),
        near_a_(a),
        near_b_(b),
        slack_(raised(2 * reach_along_ways(std::max(largest_in(a), largest_in(b))))),
        wall_(a, b),
        best_{0, 0, 0, 0, options.within} {
    if (options.within < beyond_all) limit_ = square_above_exact(options.within), need_ = options.within;
  }

  /// A pair that may be near, as that of these slots was before; numbers that are no slots are no guess.
  void guess(std::uint32_t slot_a, std::uint32_t slot_b) {
    if (slot_a < a_.bvh().slots() && slot_b < b_.bvh().slots()) offer(slot_a, slot_b, true);
  }

  std::optional<Candidate> run() {
    push({0, 0});
    while (!later_.empty() && !done_) {
      const auto [bound, pair] = later_.back();
      later_.pop_back();
      if (bound > limit_) continue;
      const auto a = a_.places()[pair.a];
      const auto b = b_.places()[pair.b];
      if (is_as_far(bound, a.box, b.box)) continue;
      NearPatch *const p = near_a_[pair.a], *const q = near_b_[pair.b];
      if (p != nullptr && q != nullptr && are_apart(*p, *q)) continue;
      if (a.is_leaf() && b.is_leaf()) {
        leaves(*p, *q);
      } else {
        const std::size_t before = later_.size();
        const auto larger = [](const auto& x, const auto& y) { return larger_posed(x.box, y.box); };
        replace_pair(a_.places(), b_.places(), larger, pair, [&](NodePair next) { push(next); });
        if (later_.size() == before + 2) nearer_last(later_[before], later_[before + 1]);
      }
    }
    offer_waiting();
    settle();
    return found_ ? std::optional(best_) : std::nullopt;
  }
  /// Is a pair within the distance?
  bool finds_any() {
    stops_at_any_ = true;
    return run().has_value();
  }

 private:
  using Features = std::array<NearFeature<Point3>, 2>;
  struct Later {
    double bound;
    NodePair pair;
  };

  struct Waiting {
    double least;
    std::uint32_t slot_a, slot_b;
  };

  static double largest_in(const Source& source) {
    const Aabb3 box = source.places()[0].box;
    return std::max(magnitude(box.min), magnitude(box.max));
  }

  void push(NodePair pair) {
    watch_.node();
    const double bound = square_below(a_.places()[pair.a].box, b_.places()[pair.b].box);
    if (!(bound > limit_)) later_.push_back({bound, pair});
  }

  /// Puts the nearer pair last, by its boxes or else their middles; a guess.
  void nearer_last(Later& x, Later& y) const {
    const auto apart = [&](NodePair pair) {
      const Aabb3 a = a_.places()[pair.a].box, b = b_.places()[pair.b].box;
      const auto square = [](double low, double high, double from, double to) {
        const double d = (from + to) - (low + high);
        return d * d;
      };
      return square(a.min.x, a.max.x, b.min.x, b.max.x) + square(a.min.y, a.max.y, b.min.y, b.max.y) +
             square(a.min.z, a.max.z, b.min.z, b.max.z);
    };
    if (x.bound < y.bound || (x.bound == y.bound && apart(x.pair) < apart(y.pair))) std::swap(x, y);
  }

  /// Is what lies in these boxes no nearer than the best, exactly?  Asked where any pair will do and some have tied.
  [[nodiscard]] bool is_as_far(double bound, const Aabb3& a, const Aabb3& b) const {
    return bound >= nearly_tied_ && exact_square_below(a, b) >= tied_;
  }

  void leaves(NearPatch& p, NearPatch& q) {
    if (!first_ && are_walled_off(p, q)) return;
    const double off = raised(a_.off() + b_.off()), least = apart_from();
    const Vector3 way = shorter_than_one(between_middles(p, q));
    lows_.clear();
    for (std::uint32_t k = 0; k < q.slots; ++k) lows_.push_back(near_b_.along(q, k, way).low);
    for (std::uint32_t i = 0; i < p.slots; ++i) {
      const Aabb3& box = near_a_.box(p, i);
      const double high = near_a_.along(p, i, way).high;
      for (std::uint32_t k = 0; k < q.slots; ++k) {
        if (lowered(lows_[k] - high) > least) continue;
        const Aabb3& other = near_b_.box(q, k);
        const double bound = square_below(box, other);
        if (bound > limit_ || is_as_far(bound, box, other)) continue;
        if (is_stopped(p.slot + i, q.slot + k)) continue;
        const Triangle3 s = near_a_.triangle(p, i), t = near_b_.triangle(q, k);
        if (query::quick_comparison(s, t, raised(need_ + off)) == Sign::positive) continue;
        look_at(p.slot + i, q.slot + k, s, t, off);
        if (done_) return;
      }
    }
  }

  /// By the wall, which has one on either side; kept where it may come first.
  bool is_stopped(std::uint32_t slot_a, std::uint32_t slot_b) {
    if (!wall_.stops(slot_a, slot_b)) return false;
    if (first_ && comes_first(candidate(slot_a, slot_b))) stopped_.push_back(candidate(slot_a, slot_b));
    return true;
  }
  /// By doubles that are off by so much: whether the exact triangles are asked, and when.
  void look_at(std::uint32_t slot_a, std::uint32_t slot_b, const Triangle3& s, const Triangle3& t, double off) {
    if (meet_ || !(off < beyond_all)) return offer(slot_a, slot_b, true);  // an image may be beyond all doubles
    const double d = plumb::distance(s, t), least = lowered(lowered(d) - off), most = raised(raised(d) + off);
    if (!(least > 0)) return offer(slot_a, slot_b, true);
    if (least > need_) return;
    if (most < need_) {
      const Closest closest = closest_points(s, t);
      look_along(closest.on_a, closest.on_b);
      need_ = most, limit_ = square_above_exact(most);
      if (stops_at_any_) {
        found_ = done_ = true;
        return;
      }
    }
    waiting_.push_back({least, slot_a, slot_b});
    if (waiting_.size() < Source::most_waiting) return;
    std::erase_if(waiting_, [&](const Waiting& w) { return w.least > need_; });
    if (waiting_.size() >= Source::most_waiting) offer_waiting();
  }
  /// The nearest first: the others are farther then, or as near, which a wall knows of many at once.
  void offer_waiting() {
    std::ranges::sort(waiting_, {}, &Waiting::least);
    std::size_t offered = 0;
    for (const auto& [least, slot_a, slot_b] : waiting_) {
      if (least > need_ || done_) break;
      if (offered >= Source::offers_before_wall && found_ && !meet_) build_wall();
      if (is_stopped(slot_a, slot_b)) continue;
      offer(slot_a, slot_b, false);
      ++offered;
    }
    waiting_.clear();
  }

  static Vector3 between_middles(const NearPatch& p, const NearPatch& q) {
    return {q.middle.x - p.middle.x, q.middle.y - p.middle.y, q.middle.z - p.middle.z};
  }
  /// So far apart along a way, by doubles, is what is farther than the best, for certain.
  [[nodiscard]] double apart_from() const { return raised(raised(need_ + slack_) + raised(a_.off() + b_.off())); }

  /// Farther than the best, for certain.
  [[nodiscard]] bool are_apart(NearPatch& p, NearPatch& q) const {
    const double least = apart_from();
    if (!(least < beyond_all)) return false;
    const auto beyond = [&](const Stretch& s, const Stretch& t) { return lowered(t.low - s.high) > least; };
    const auto beside = [&](const Stretch& s, const Stretch& t) { return beyond(s, t) || beyond(t, s); };
    if (beyond(near_a_.along(p, way_, way_number_), near_b_.along(q, way_, way_number_))) return true;
    const Vector3 way = shorter_than_one(between_middles(p, q));
    return beyond(near_a_.along(p, way), near_b_.along(q, way)) || beside(p.along_normal, near_b_.along(q, p.normal)) ||
           beside(near_a_.along(p, q.normal), q.along_normal);
  }
  /// No nearer than the best, for its wall has one on either side.
  [[nodiscard]] bool are_walled_off(NearPatch& p, NearPatch& q) {
    if (!wall_.is_built()) return false;
    const auto known = [&](NearPatch& patch, const auto& is_beyond) {
      if (patch.wall == wall_number_) return patch.is_beyond;
      patch.wall = wall_number_, patch.is_beyond = true;
      for (std::uint32_t i = 0; patch.is_beyond && i < patch.slots; ++i) patch.is_beyond = is_beyond(patch.slot + i);
      return patch.is_beyond;
    };
    return known(p, [&](std::uint32_t slot) { return wall_.is_behind_slot(slot); }) &&
           known(q, [&](std::uint32_t slot) { return wall_.is_ahead_slot(slot); });
  }

  [[nodiscard]] Candidate candidate(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return {a_.bvh().number(slot_a), b_.bvh().number(slot_b), slot_a, slot_b, 0};
  }
  [[nodiscard]] bool comes_first(const Candidate& c) const { return c.a != best_.a ? c.a < best_.a : c.b < best_.b; }

  void offer(std::uint32_t slot_a, std::uint32_t slot_b, bool may_meet) {
    Candidate now = candidate(slot_a, slot_b);
    const bool comes_before = first_ && comes_first(now);
    if (meet_ && !comes_before) return;
    watch_.triangle();
    const auto s = a_.triangle(slot_a);
    const auto t = b_.triangle(slot_b);
    if (may_meet && Source::meet(s, t)) {  // from now on only pairs that do and come first
      best_ = now;
      found_ = meet_ = true;
      limit_ = need_ = 0;
      forget_ties();
      done_ = !first_ || stops_at_any_;
      return;
    }
    if (meet_) return;
    now.distance = Source::distance(s, t);
    if (found_) {
      const auto order =
          now.distance != best_.distance ? now.distance <=> best_.distance : compare_with_best(now, comes_before, s, t);
      if (order > 0 || (order == 0 && !comes_before)) return;
      if (order < 0) forget_ties();
    } else if (now.distance > best_.distance || (now.distance == best_.distance && !is_within(s, t))) {
      return;
    }
    best_ = now;
    found_ = true;
    done_ = stops_at_any_;
    limit_ = std::min(limit_, square_above(now.distance)), need_ = std::min(need_, raised(now.distance));
  }

  /// The distance rounds to the one that was asked for.
  template <class Triangle>
  [[nodiscard]] bool is_within(const Triangle& s, const Triangle& t) const {
    return !(best_.distance < beyond_all) ||
           compare(ExactDistance{Source::square(s, t)}, best_.distance) != Sign::positive;
  }

  void look_along(const Point3& p, const Point3& q) {
    way_ = shorter_than_one({q.x - p.x, q.y - p.y, q.z - p.z});
    ++way_number_;
  }

  /// What a wall stopped is no nearer than the best: of these the first that is as near.
  void settle() {
    const auto by_numbers = [](const Candidate& x, const Candidate& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
    std::ranges::sort(stopped_, by_numbers);
    for (const Candidate& c : stopped_) {
      if (!comes_first(c)) return;
      const auto s = a_.triangle(c.slot_a);
      const auto t = b_.triangle(c.slot_b);
      if (Source::are_beyond(s, t, need_)) continue;
      watch_.triangle();
      if (Source::distance(s, t) != best_.distance) continue;
      if (!have_best_features(s, t) && Source::square(s, t) != square_of_best()) continue;
      best_ = {c.a, c.b, c.slot_a, c.slot_b, best_.distance};
      return;
    }
  }

  void forget_ties() {
    wall_.clear();
    stopped_.clear();
    best_square_.reset();
    best_features_.reset();
    nearly_tied_ = tied_ = beyond_all;
  }

  /// Compares distances that round alike.
  template <class Triangle>
  [[nodiscard]] std::partial_ordering compare_with_best(const Candidate& now, bool comes_before, const Triangle& s,
                                                        const Triangle& t) {
    if (have_best_features(s, t)) return std::partial_ordering::equivalent;
    if (!wall_.is_built()) {
      build_wall();
      if (wall_.stops(now.slot_a, now.slot_b)) {
        if (comes_before) stopped_.push_back(now);
        return std::partial_ordering::greater;
      }
    }
    return Source::square(s, t) <=> square_of_best();
  }
  void build_wall() {
    if (wall_.is_built()) return;
    wall_.build(best_.slot_a, best_.slot_b);
    ++wall_number_;
    if (first_ || !Source::has_exact_boxes) return;
    constexpr double nearly = 1 - 0x1p-40;  // a guess of where the exact bound is worth its time
    tied_ = square_of_best().rounded(Rounding::up);
    nearly_tied_ = tied_ * nearly;
  }
  /// Those of the best pair that hold its closest points, and so its distance.
  template <class Triangle>
  [[nodiscard]] bool have_best_features(const Triangle& s, const Triangle& t) {
    const auto kept = [](const Triangle& u, const Triangle& v) -> std::optional<Features> {
      const auto features = Source::features(u, v);
      if (!features) return {};
      return Features{near_feature(Source::as_given(u), (*features)[0]),
                      near_feature(Source::as_given(v), (*features)[1])};
    };
    if (!best_features_) best_features_ = kept(a_.triangle(best_.slot_a), b_.triangle(best_.slot_b));
    return best_features_ && kept(s, t) == best_features_;
  }
  [[nodiscard]] const Rational& square_of_best() {
    if (!best_square_) best_square_ = Source::square(a_.triangle(best_.slot_a), b_.triangle(best_.slot_b));
    return *best_square_;
  }

  Source &a_, &b_;
  Watch watch_;
  bool first_, stops_at_any_ = false;
  NearPatches<Source> near_a_, near_b_;
  double slack_;
  std::vector<Later> later_;
  std::vector<double> lows_;
  std::vector<Waiting> waiting_;                   // pairs that may be the nearest
  double limit_ = beyond_all, need_ = beyond_all;  // no less than the square of the least distance, and than it
  Vector3 way_{0, 0, 0};                           // from one of the closest points to the other
  std::uint32_t way_number_ = 0;
  NearWall<Source> wall_;  // of the best, once another rounds alike
  std::uint32_t wall_number_ = 0;
  std::vector<Candidate> stopped_;  // by it, and before the best
  std::optional<Rational> best_square_;
  std::optional<Features> best_features_;
  double nearly_tied_ = beyond_all, tied_ = beyond_all;  // no less than the square, where some have tied
  Candidate best_;
  bool found_ = false, meet_ = false, done_ = false;
};

template <class Source>
ClosestTriangles closest_pair_found(const Source& a, const Source& b,
                                    const typename ClosestSearch<Source>::Candidate& found) {
  return {found.a, found.b, Source::closest(a.triangle(found.slot_a), b.triangle(found.slot_b))};
}

}  // namespace plumb::space
