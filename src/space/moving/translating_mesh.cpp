// Branch and bound over pairs of nodes, those that can meet first first; equal times exactly.
#include "plumb/space/moving/translating_mesh.hpp"

#include <algorithm>
#include <queue>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "plumb/query/overlap/triangle.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/moving/entry_time.hpp"

namespace plumb {
namespace space {
namespace {

/// Whose boxes meet from such a share of the time on, waits to be asked in order: a guess, of when, not of what.
constexpr double about_as_late = 1 - 0x1p-50;

class TranslatingSearch {
 public:
  struct Found {
    std::uint32_t a, b;
    Triangle3 s, t;
    double time;  // rounded down, so that times in order are so exactly
  };

  TranslatingSearch(const Bvh& a, const Vector3& by, const Bvh& b)
      : a_(a), b_(b), as_(a.tree.nodes.view()), bs_(b.tree.nodes.view()), by_(by) {}

  std::optional<Found> run() {
    if (as_.empty() || bs_.empty()) return {};
    push({0, 0});
    while (!later_.empty() && !(later_.top().entry > limit())) {
      const NodePair pair = later_.top().pair;
      later_.pop();
      const BoxNode &a = as_[pair.a], &b = bs_[pair.b];
      if (a.is_leaf() && b.is_leaf()) {
        leaves(a, b);
      } else {
        replace_pair(as_, bs_, descend_larger{}, pair, [&](NodePair next) { push(next); });
      }
    }
    settle_ties();
    return best_;
  }

 private:
  struct WaitingPair {
    double entry;
    NodePair pair;
  };
  struct EntersLater {
    bool operator()(const WaitingPair& x, const WaitingPair& y) const {
      return x.entry != y.entry     ? x.entry > y.entry
             : x.pair.a != y.pair.a ? x.pair.a > y.pair.a
                                    : x.pair.b > y.pair.b;  // in the order of the slots
    }
  };

  struct LeafPair {
    std::uint32_t a, b, slot_a, slot_b;
  };

  /// What is later than this is too late.
  [[nodiscard]] double limit() const { return best_ ? best_->time : 1; }

  static Aabb3 box_of(const Bvh& mesh, const BoxNode& n) {
    if (mesh.tree.frame.exponent() != 0) return mesh.tree.frame.outside(n.box());
    return {{n.min[0], n.min[1], n.min[2]}, {n.max[0], n.max[1], n.max[2]}};
  }

  void push(NodePair pair) {
    const double entry = entry_below(box_of(a_, as_[pair.a]), by_, box_of(b_, bs_[pair.b]));
    if (!(entry > limit())) later_.push({entry, pair});
  }

  void leaves(const BoxNode& a, const BoxNode& b) {
    for (std::uint32_t i = a.link; i < a.link + a.count; ++i) {
      const Aabb3 box = box_around(a_.triangles[i], a_.vertices.view());
      for (std::uint32_t k = b.link; k < b.link + b.count; ++k) {
        const double entry = entry_below(box, by_, box_around(b_.triangles[k], b_.vertices.view()));
        if (entry > limit()) continue;
        const LeafPair pair{a_.tree.items[i], b_.tree.items[k], i, k};
        if (best_ && entry > 0 && entry >= limit() * about_as_late) {
          ties_.push_back(pair);
        } else {
          offer(pair, entry == 0);
        }
      }
    }
  }

  /// What lands flat meets in many pairs at once, of which each takes long: those whose boxes meet as late as the best
  /// pair does are asked in their order, and only as long as they may come before it.
  void settle_ties() {
    std::ranges::sort(ties_, [](const LeafPair& x, const LeafPair& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    for (const LeafPair& pair : ties_) {
      const Aabb3 s = box_around(a_.triangles[pair.slot_a], a_.vertices.view());
      const Aabb3 t = box_around(b_.triangles[pair.slot_b], b_.vertices.view());
      if (entry_below(s, by_, t) > limit()) continue;
      if (!comes_first(pair)) {
        if (!best_exact_) best_exact_ = exact_time(*best_);
        if (*best_exact_ <= exact_entry(s, by_, t)) continue;
      }
      offer(pair, false);
    }
  }

  [[nodiscard]] bool comes_first(const LeafPair& c) const {
    return !best_ || (c.a != best_->a ? c.a < best_->a : c.b < best_->b);
  }

  void offer(const LeafPair& pair, bool may_meet) {
    const bool first = comes_first(pair);
    if (meet_ && !first) return;
    Found c{pair.a, pair.b, a_.triangle(pair.slot_a), b_.triangle(pair.slot_b), 0};
    if (may_meet && relate(c.s, c.t) != Relation::disjoint) {  // from now on only pairs that do and come first
      best_ = c;
      meet_ = true;
    }
    if (meet_) return;
    const auto contact = first_contact(Translating<Triangle3>{c.s, by_}, c.t);
    if (!contact || contact->time > limit()) return;
    c.time = contact->time;
    std::optional<Root> exact;
    if (best_ && c.time == best_->time) {
      if (!best_exact_) best_exact_ = exact_time(*best_);
      if (!first && *best_exact_ == Rational(c.time)) return;  // c is no earlier than its time
      exact = exact_time(c);
      const auto order = *exact <=> *best_exact_;
      if (order > 0 || (order == 0 && !first)) return;
    }
    best_ = c;
    best_exact_ = exact;
  }

  [[nodiscard]] std::optional<Root> exact_time(const Found& c) const {
    return first_contact_time(Translating<Triangle3>{c.s, by_}, c.t);
  }

  const Bvh &a_, &b_;
  std::span<const BoxNode> as_, bs_;
  Vector3 by_;
  std::priority_queue<WaitingPair, std::vector<WaitingPair>, EntersLater> later_;
  std::vector<LeafPair> ties_;
  std::optional<Found> best_;
  std::optional<Root> best_exact_;  // where it had to be known
  bool meet_ = false;               // at time 0
};

}  // namespace
}  // namespace space

std::optional<MeshContact> first_contact(const Bvh& a, const Vector3& by, const Bvh& b) {
  require_finite_parts("first_contact", {"by"}, by);
  const auto found = space::TranslatingSearch(a, by, b).run();
  if (!found) return {};
  return MeshContact{found->a, found->b, *first_contact(Translating<Triangle3>{found->s, by}, found->t)};
}

std::optional<Root> first_contact_time(const Bvh& a, const Vector3& by, const Bvh& b) {
  require_finite_parts("first_contact_time", {"by"}, by);
  const auto found = space::TranslatingSearch(a, by, b).run();
  if (!found) return {};
  return first_contact_time(Translating<Triangle3>{found->s, by}, found->t);
}

}  // namespace plumb
