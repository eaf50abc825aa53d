// Which triangles of two meshes, one of them moving along a line, meet first?  Branch and bound over pairs of nodes,
// those that can meet first first; equal times exactly.
//
// What a wall stops (contact_walls.hpp) cannot meet earlier than the first pair as yet, so it waits until that is known
// to be as early as any, and is then asked in the order of its numbers: the first that meets as early is the answer.
// Law: the pair is the first by a, then b, of those that meet at the first time.
// Source: RTCD 5.5.2, 6.3.2, 6.3.3.
// Cost: a bound for each pair of nodes, a contact for each pair of triangles that no wall stops and whose boxes meet
// before the first contact; the lowest numbers below all nodes where pairs have to wait.
#pragma once

#include <algorithm>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "plumb/arith/root.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/moving/contact_walls.hpp"
#include "space/moving/entry_time.hpp"

namespace plumb::space {

/// A scene says where nodes and triangles are, which of two nodes is to be divided, and when two slots' triangles meet.
template <class Scene>
class TranslatingSearch {
 public:
  struct Found {
    std::uint32_t a, b, slot_a, slot_b;
    double time;  // rounded down, so that times in order are so exactly
  };

  explicit TranslatingSearch(const Scene& scene)
      : scene_(scene),
        as_(scene.a().bvh.tree.nodes.view()),
        bs_(scene.b().bvh.tree.nodes.view()),
        walls_(scene.a(), scene.by(), scene.b()) {}

  std::optional<Found> run() {
    if (as_.empty() || bs_.empty()) return {};
    push({0, 0});
    while (!at_start_ && !later_.empty() && !(later_.top().entry > limit())) {
      const NodePair pair = later_.top().pair;
      later_.pop();
      const BoxNode &a = as_[pair.a], &b = bs_[pair.b];
      if (walls_.stop(scene_.box_a(a), scene_.box_b(b))) {
        stopped_nodes_.push_back(pair);
      } else if (a.is_leaf() && b.is_leaf()) {
        leaves(a, b, [&](const Found& c, const Aabb3& s, const Aabb3& t, double entry) {
          if (at_start_ || walls_.stop(s, t) || walls_.stop(c.slot_a, c.slot_b)) {
            if (comes_first(c)) stopped_.push_back(c);
          } else {
            offer(c, entry == 0);
          }
        });
      } else {
        scene_.replace(pair, [&](NodePair next) { push(next); });
      }
    }
    settle();
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

  /// What is later than this is too late.
  [[nodiscard]] double limit() const { return best_ ? best_->time : 1; }

  [[nodiscard]] double entry_of(const BoxNode& a, const BoxNode& b) const {
    return entry_below(scene_.box_a(a), scene_.velocity(), scene_.box_b(b));
  }
  void push(NodePair pair) {
    const double entry = entry_of(as_[pair.a], bs_[pair.b]);
    if (!(entry > limit())) later_.push({entry, pair});
  }

  /// take(pair, boxes, entry) of the triangles of two leaves that are not too late.
  template <class Take>
  void leaves(const BoxNode& a, const BoxNode& b, const Take& take) {
    const auto &items_a = scene_.a().bvh.tree.items, &items_b = scene_.b().bvh.tree.items;
    for (std::uint32_t i = a.link; i < a.link + a.count; ++i) {
      const Aabb3 s = scene_.triangle_box_a(i);
      for (std::uint32_t k = b.link; k < b.link + b.count; ++k) {
        const Aabb3 t = scene_.triangle_box_b(k);
        const double entry = entry_below(s, scene_.velocity(), t);
        if (!(entry > limit())) take(Found{items_a[i], items_b[k], i, k, 0}, s, t, entry);
      }
    }
  }

  [[nodiscard]] bool comes_first(const Found& c) const {
    return !best_ || (c.a != best_->a ? c.a < best_->a : c.b < best_->b);
  }

  void offer(Found c, bool may_meet) {
    if (may_meet && scene_.relate(c.slot_a, c.slot_b) != Relation::disjoint) {
      best_ = c;
      at_start_ = true;
      forget_stopped();
      return;
    }
    const auto contact = scene_.contact(c.slot_a, c.slot_b);
    if (!contact || contact->time > limit()) return;
    c.time = contact->time;
    if (best_ && c.time == best_->time) {
      if (!best_exact_) know_exactly(*scene_.time(best_->slot_a, best_->slot_b));
      const bool first = comes_first(c);
      if (walls_.stop(c.slot_a, c.slot_b)) {
        if (first) stopped_.push_back(c);
        return;
      }
      if (!first && *best_exact_ == Rational(c.time)) return;  // c is no earlier than its time
      const Root exact = *scene_.time(c.slot_a, c.slot_b);
      const auto order = exact <=> *best_exact_;
      if (order > 0 || (order == 0 && !first)) return;
      best_ = c;
      if (order == 0) return;
      forget_stopped();
      know_exactly(exact);
    } else {
      best_ = c;
      best_exact_.reset();
      walls_.clear();
      forget_stopped();
    }
  }

  /// Later than the best, as none that a wall stopped is earlier than the best was.
  void forget_stopped() {
    stopped_.clear();
    stopped_nodes_.clear();
  }
  void know_exactly(const Root& time) {
    best_exact_ = time;
    if (const auto rational = time.rational()) {
      walls_.build(best_->slot_a, best_->slot_b, *rational, scene_.exact_boxes(best_->slot_a, best_->slot_b));
    }
  }

  /// In the order of the numbers: nodes by the lowest below them.
  struct Stopped {
    std::uint32_t a, b;
    bool is_nodes;
    std::uint32_t at_a, at_b;  // nodes or slots
  };
  struct NamedLater {
    bool operator()(const Stopped& x, const Stopped& y) const { return x.a != y.a ? x.a > y.a : x.b > y.b; }
  };
  static std::vector<std::uint32_t> lowest_below(const BoxTree& tree) {
    const std::span<const BoxNode> nodes = tree.nodes.view();
    std::vector<std::uint32_t> lowest(nodes.size());
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const BoxNode& n = nodes[i];
      const auto of_leaf = [&] {
        const auto from = tree.items.view().begin() + n.link;
        return *std::min_element(from, from + n.count);
      };
      lowest[i] = n.is_leaf() ? of_leaf() : std::min(lowest[i + 1], lowest[i + n.link]);
    }
    return lowest;
  }

  void settle() {
    std::vector<Stopped> all;
    for (const Found& c : stopped_) {
      if (comes_first(c)) all.push_back({c.a, c.b, false, c.slot_a, c.slot_b});
    }
    std::vector<std::uint32_t> lowest_a, lowest_b;
    if (at_start_) {  // what still waits is no earlier than time 0
      for (; !later_.empty() && later_.top().entry == 0; later_.pop()) stopped_nodes_.push_back(later_.top().pair);
    }
    if (!stopped_nodes_.empty()) {
      lowest_a = lowest_below(scene_.a().bvh.tree);
      lowest_b = lowest_below(scene_.b().bvh.tree);
    }
    const auto nodes = [&](NodePair p) { return Stopped{lowest_a[p.a], lowest_b[p.b], true, p.a, p.b}; };
    for (const NodePair pair : stopped_nodes_) all.push_back(nodes(pair));
    std::priority_queue<Stopped, std::vector<Stopped>, NamedLater> queue({}, std::move(all));
    while (!queue.empty() && comes_first({queue.top().a, queue.top().b, 0, 0, 0})) {
      const Stopped next = queue.top();
      queue.pop();
      if (!next.is_nodes) {
        if (!meets_as_early(next.at_a, next.at_b)) continue;
        best_ = Found{next.a, next.b, next.at_a, next.at_b, best_->time};
        return;
      }
      const BoxNode &a = as_[next.at_a], &b = bs_[next.at_b];
      if (a.is_leaf() && b.is_leaf()) {
        leaves(a, b, [&](const Found& c, const Aabb3&, const Aabb3&, double) {
          if (comes_first(c)) queue.push({c.a, c.b, false, c.slot_a, c.slot_b});
        });
      } else {
        scene_.replace({next.at_a, next.at_b}, [&](NodePair pair) {
          if (!(entry_of(as_[pair.a], bs_[pair.b]) > limit())) queue.push(nodes(pair));
        });
      }
    }
  }

  /// Of a pair that is no earlier.
  [[nodiscard]] bool meets_as_early(std::uint32_t slot_a, std::uint32_t slot_b) const {
    if (at_start_) return scene_.relate(slot_a, slot_b) != Relation::disjoint;
    const auto contact = scene_.contact(slot_a, slot_b);
    return contact && contact->time == best_->time && *scene_.time(slot_a, slot_b) == *best_exact_;
  }

  const Scene& scene_;
  std::span<const BoxNode> as_, bs_;
  ContactWalls walls_;
  std::priority_queue<WaitingPair, std::vector<WaitingPair>, EntersLater> later_;
  std::vector<NodePair> stopped_nodes_;
  std::vector<Found> stopped_;
  std::optional<Found> best_;
  std::optional<Root> best_exact_;  // where it had to be known
  bool at_start_ = false;           // they meet at time 0
};

}  // namespace plumb::space
