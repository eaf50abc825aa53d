// The nearest pairs: each body asks what is near it, no farther than the worst of the pairs that are kept.
#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

#include "plumb/arith/error.hpp"
#include "world/part_questions.hpp"
#include "world/state.hpp"

namespace plumb {
namespace {

using world::about_body, world::WorldBody;

template <class Pair>
auto near_place(const Pair& p) {
  return std::tie(p.id_a, p.id_b, p.a, p.b);
}

/// A pair of bodies, and its exact distance once it has been asked for.
struct RankedPair {
  WorldNearPair pair;
  mutable std::optional<ExactDistance> exact{};
};

/// Asks pairs of bodies of a world how far apart they are.
class PairQuestion {
 public:
  explicit PairQuestion(const std::vector<std::optional<WorldBody>>& bodies) : bodies_(bodies) {}

  [[nodiscard]] RankedPair of(const WorldPair& p) const {
    const auto &a = bodies_[p.a.slot]->placed, &b = bodies_[p.b.slot]->placed;
    return about_body("CollisionWorld::nearest_pairs", p.id_a, [&] {
      return about_body("and", p.id_b, [&] {
        std::optional<RankedPair> best;
        for (std::uint32_t i = 0; i < a.size(); ++i) {
          for (std::uint32_t j = 0; j < b.size(); ++j) {
            const auto d = world::distance_of_parts(a[i], b[j]);
            RankedPair found{{p.id_a, p.id_b, p.a, p.b, {i, d.triangle_a}, {j, d.triangle_b}, d.distance}};
            if (!best || is_nearer(found, *best)) best = std::move(found);
          }
        }
        return *std::move(best);
      });
    });
  }
  /// Pairs ascend by exact distances, then in their order.
  [[nodiscard]] bool is_before(const RankedPair& p, const RankedPair& q) const {
    if (p.pair.distance != q.pair.distance) return p.pair.distance < q.pair.distance;
    const Sign sign = compare(exact(p), exact(q));
    return sign == Sign::zero ? near_place(p.pair) < near_place(q.pair) : sign == Sign::negative;
  }
  /// Nothing is nearer than what has a point in common.
  [[nodiscard]] bool is_behind_all(const WorldPair& p, const RankedPair& kept) const {
    return kept.pair.distance == 0 && near_place(kept.pair) < near_place(p) && compare(exact(kept), 0) == Sign::zero;
  }
  [[nodiscard]] bool is_within(const RankedPair& p, double distance) const {
    if (p.pair.distance != distance) return p.pair.distance < distance;
    return compare(exact(p), distance) != Sign::positive;
  }

 private:
  [[nodiscard]] bool is_nearer(const RankedPair& p, const RankedPair& q) const {
    if (p.pair.distance != q.pair.distance) return p.pair.distance < q.pair.distance;
    return compare(exact(p), exact(q)) == Sign::negative;
  }
  [[nodiscard]] const ExactDistance& exact(const RankedPair& r) const {
    const WorldNearPair& p = r.pair;
    if (!r.exact) {
      r.exact = world::exact_distance_of_parts(bodies_[p.a.slot]->placed[p.part_a.part], p.part_a.triangle,
                                               bodies_[p.b.slot]->placed[p.part_b.part], p.part_b.triangle);
    }
    return *r.exact;
  }

  const std::vector<std::optional<WorldBody>>& bodies_;
};

}  // namespace

std::vector<WorldNearPair> CollisionWorld::nearest_pairs(std::size_t k, double within) const {
  const State& s = *state_;
  if (within != within) throw NonFinite("CollisionWorld::nearest_pairs: within is nan; give a number");
  const PairQuestion ask(s.bodies);
  const auto is_before = [&](const RankedPair& p, const RankedPair& q) { return ask.is_before(p, q); };
  std::vector<RankedPair> best;
  const auto most = [&] { return best.size() < k ? within : std::min(within, best.back().pair.distance); };
  for (std::uint32_t slot = 0; k != 0 && slot < s.bodies.size(); ++slot) {
    if (!s.bodies[slot]) continue;
    const BodyHandle body = s.bodies[slot]->handle;
    s.boxes.visit_near(s.boxes.box(body), most(), [&](const BodyHandle& other) {
      if (other.slot <= slot) return most();  // was asked by the other, or is the body itself
      const auto pair = s.pair_of(body, other);
      if (!pair || (best.size() == k && ask.is_behind_all(*pair, best.back())) || !s.is_admitted(*pair)) return most();
      RankedPair found = ask.of(*pair);
      if (!ask.is_within(found, within)) return most();
      const auto at = std::upper_bound(best.begin(), best.end(), found, is_before);
      if (best.size() < k || at != best.end()) best.insert(at, std::move(found));
      if (best.size() > k) best.pop_back();
      return most();
    });
  }
  std::vector<WorldNearPair> told;
  told.reserve(best.size());
  for (const RankedPair& r : best) told.push_back(r.pair);
  return told;
}

}  // namespace plumb
