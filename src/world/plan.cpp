// Which proxies pay is found by descent: each body in turn takes the kind of which the fewest questions are left, until no
// body gains.  It begins twice, with none and with the tightest of all.
#include "plumb/world/plan.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "plumb/figure/aabb/relation.hpp"
#include "plumb/query/variant/questions.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "space/bvh/parts.hpp"
#include "world/state.hpp"

namespace plumb {
namespace world {
namespace {

/// Those of a mesh that are near to another, by where they begin along x.
std::vector<Aabb3> boxes_near(const PlacedMesh& mesh, const Aabb3& other) {
  std::vector<Aabb3> boxes;
  for (const std::uint32_t t : mesh.near(other)) boxes.push_back(box_of_figure(mesh.triangle(t)));
  std::ranges::sort(boxes, {}, [](const Aabb3& b) { return b.min.x; });
  return boxes;
}

/// How many pairs overlap of which the first begins before the second does along x, or where it does?
std::size_t overlaps_from(const std::vector<Aabb3>& first, const std::vector<Aabb3>& second, bool with_equal) {
  std::size_t sum = 0;
  for (const Aabb3& a : first) {
    const auto from_x = [](const Aabb3& b) { return b.min.x; };
    auto b = with_equal ? std::ranges::lower_bound(second, a.min.x, {}, from_x)
                        : std::ranges::upper_bound(second, a.min.x, {}, from_x);
    for (; b != second.end() && b->min.x <= a.max.x; ++b) sum += intersects(a, *b) ? 1 : 0;
  }
  return sum;
}

std::size_t questions_of_parts(const Placed& a, const Placed& b) {
  const auto *p = std::get_if<PlacedMesh>(&a), *q = std::get_if<PlacedMesh>(&b);
  if (p == nullptr && q == nullptr) return 1;
  if (p == nullptr) return q->near(box_of(a)).size();
  if (q == nullptr) return p->near(box_of(b)).size();
  const std::vector<Aabb3> of_p = boxes_near(*p, q->box()), of_q = boxes_near(*q, p->box());
  return overlaps_from(of_p, of_q, true) + overlaps_from(of_q, of_p, false);
}
std::size_t questions_of_bodies(const WorldBody& a, const WorldBody& b) {
  std::size_t sum = 0;
  for (const Placed& p : a.placed)
    for (const Placed& q : b.placed) sum += questions_of_parts(p, q);
  return sum;
}

bool is_one_figure(const WorldBody& body) {
  return body.placed.size() == 1 && std::holds_alternative<AnyFigure>(body.placed[0]);
}

/// A figure that holds the body and is no proxy: itself, or its box.
AnyFigure around(const WorldBody& body) {
  return is_one_figure(body) ? std::get<AnyFigure>(body.placed[0]) : AnyFigure(body.box);
}

bool are_apart(const AnyFigure& a, const AnyFigure& b) { return relation(a, b) == Relation::disjoint; }

/// What a body may take, by kinds, where it stands; what it takes without a proxy is always there.
struct Candidate {
  const WorldBody* body;
  std::vector<std::optional<AnyFigure>> figures;
  std::vector<std::size_t> pairs{};  // that it is in
  std::size_t taken = 0;
};

struct CandidatePair {
  std::size_t a, b;  // of candidates
  std::size_t questions;
  /// Are these proxies apart?  Nothing before it is asked.
  std::array<std::array<std::optional<bool>, proxy_kinds>, proxy_kinds> known{};
};

class Descent {
 public:
  Descent(std::vector<Candidate> candidates, std::vector<CandidatePair> pairs)
      : candidates_(std::move(candidates)), pairs_(std::move(pairs)) {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      candidates_[pairs_[i].a].pairs.push_back(i);
      candidates_[pairs_[i].b].pairs.push_back(i);
    }
  }

  /// How many questions are left.
  std::size_t begin_with_none() {
    for (Candidate& c : candidates_) c.taken = 0;
    return descend();
  }
  std::size_t begin_with_tightest() {
    for (Candidate& c : candidates_) {
      c.taken = c.figures.size() - 1;
      while (!c.figures[c.taken]) --c.taken;
    }
    return descend();
  }
  [[nodiscard]] const std::vector<Candidate>& candidates() const { return candidates_; }
  [[nodiscard]] BodyPlan told(std::size_t i) {
    const Candidate& c = candidates_[i];
    BodyPlan plan{c.body->handle, c.body->options.user_id, static_cast<ProxyKind>(c.taken), c.pairs.size(), 0, 0};
    for (const std::size_t p : c.pairs) plan.told_apart += is_told_apart(pairs_[p]) ? 1 : 0;
    if (c.taken != 0) plan.saved = questions(i, 0) - questions(i, c.taken);
    return plan;
  }

 private:
  std::size_t descend() {
    for (bool gains = true; gains;) {
      gains = false;
      for (std::size_t i = 0; i < candidates_.size(); ++i) gains |= take_best(i);
    }
    std::size_t sum = 0;
    for (CandidatePair& p : pairs_) sum += questions(p, candidates_[p.a].taken, candidates_[p.b].taken);
    return sum;
  }
  /// Of kinds that are alike good the plainest.
  bool take_best(std::size_t i) {
    std::size_t best = candidates_[i].taken, least = questions(i, best);
    for (std::size_t kind = 0; kind < candidates_[i].figures.size(); ++kind) {
      if (!candidates_[i].figures[kind]) continue;
      const std::size_t now = questions(i, kind);
      if (now < least || (now == least && kind < best)) best = kind, least = now;
    }
    return std::exchange(candidates_[i].taken, best) != best;
  }
  /// In all pairs of a body, if it takes this kind.
  std::size_t questions(std::size_t i, std::size_t kind) {
    std::size_t sum = 0;
    for (const std::size_t p : candidates_[i].pairs) {
      CandidatePair& pair = pairs_[p];
      sum += questions(pair, pair.a == i ? kind : candidates_[pair.a].taken,
                       pair.b == i ? kind : candidates_[pair.b].taken);
    }
    return sum;
  }
  std::size_t questions(CandidatePair& pair, std::size_t of_a, std::size_t of_b) {
    if (of_a == 0 && of_b == 0) return pair.questions;
    return 1 + (is_apart(pair, of_a, of_b) ? 0 : pair.questions);
  }
  bool is_apart(CandidatePair& pair, std::size_t of_a, std::size_t of_b) {
    std::optional<bool>& known = pair.known[of_a][of_b];
    if (!known) known = are_apart(*candidates_[pair.a].figures[of_a], *candidates_[pair.b].figures[of_b]);
    return *known;
  }
  bool is_told_apart(CandidatePair& pair) {
    const std::size_t of_a = candidates_[pair.a].taken, of_b = candidates_[pair.b].taken;
    return (of_a != 0 || of_b != 0) && is_apart(pair, of_a, of_b);
  }

  std::vector<Candidate> candidates_;
  std::vector<CandidatePair> pairs_;
};

void add_proxies(Candidate& to) {
  const WorldBody& body = *to.body;
  about_body("plan", body.options.user_id, [&] {
    for (std::size_t kind = 1; kind < proxy_kinds; ++kind) {
      const auto proxy = proxy_of(AnyBody::of(body.parts, {}), static_cast<ProxyKind>(kind));
      to.figures.push_back(proxy ? std::optional(std::get<AnyFigure>(placed({*proxy, {}}, body.pose))) : std::nullopt);
    }
  });
}

}  // namespace

bool are_apart_by_proxies(const WorldBody& a, const WorldBody& b) {
  if (!a.proxy && !b.proxy) return false;
  return are_apart(a.proxy ? *a.proxy : around(a), b.proxy ? *b.proxy : around(b));
}

}  // namespace world

WorldPlan plan(const CollisionWorld& world, const WorldPlanOptions& options) {
  using world::WorldBody;
  const CollisionWorld::State& s = *world.state_;
  std::vector<const WorldBody*> bodies;
  for (const auto& body : s.bodies)
    if (body) bodies.push_back(&*body);
  std::ranges::sort(bodies, [](const WorldBody* a, const WorldBody* b) {
    return std::tie(a->options.user_id, a->handle) < std::tie(b->options.user_id, b->handle);
  });
  std::vector<Aabb3> boxes;
  for (const WorldBody* body : bodies) boxes.push_back(s.boxes.box(body->handle));
  std::vector<world::CandidatePair> pairs;
  for (const BoxPair& p : overlapping_pairs(boxes)) {
    const auto pair = s.pair_of(bodies[p.a]->handle, bodies[p.b]->handle);
    if (pair && s.is_admitted(*pair)) pairs.push_back({p.a, p.b, 1, {}});
  }
  space::for_parts("plan", s.options.execution, {}, pairs.size(), [&](std::size_t i) {
    pairs[i].questions = world::questions_of_bodies(*bodies[pairs[i].a], *bodies[pairs[i].b]);
  });

  WorldPlan told;
  std::vector<world::Candidate> candidates;
  for (const WorldBody* body : bodies) candidates.push_back({body, {world::around(*body)}});
  for (const world::CandidatePair& p : pairs) {
    told.questions_without += p.questions;
    for (const std::size_t i : {p.a, p.b}) {  // what is one figure is asked as soon as its proxy
      const bool may_pay = p.questions > 1 && !world::is_one_figure(*bodies[i]);
      if (may_pay && candidates[i].figures.size() == 1) world::add_proxies(candidates[i]);
    }
  }
  world::Descent descent(std::move(candidates), std::move(pairs));
  const std::size_t from_tightest = descent.begin_with_tightest();
  told.questions_with = descent.begin_with_none();
  if (from_tightest < told.questions_with) told.questions_with = descent.begin_with_tightest();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (descent.candidates()[i].figures.size() > 1) told.bodies.push_back(descent.told(i));
  if (!boxes.empty()) told.index = choose_index(boxes, {.moving_share = options.moving_share});
  return told;
}

void adopt(CollisionWorld& world, const WorldPlan& taken) {
  for (const BodyPlan& b : taken.bodies) world.set_proxy(b.body, b.proxy);
}

}  // namespace plumb
