#include "plumb/space/ray/mesh_ray.hpp"

#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/ray/ray_slabs.hpp"
#include "query/ray/hit_order.hpp"
#include "query/ray/numbers.hpp"
#include "space/ray/leaf_hits.hpp"

namespace plumb {
namespace {

constexpr double beyond_all = std::numeric_limits<double>::infinity();

/// A triangle that is hit, between these parameters.
struct SlotHit {
  std::uint32_t slot;
  double least, most;
};

struct RayOnMesh {
  const AnyRay& ray;
  const Bvh& bvh;
  HitRule rule;
  RaySlabs slabs{ray, bvh.tree};
  space::LeafHits leaf{ray, bvh, rule};
  std::span<const std::uint32_t> items = bvh.tree.items.view();

  /// As the slabs say; what lies below the node is fetched ahead.
  [[nodiscard]] double bound(const BoxNode& node) const {
    leaf.fetch(node);
    return slabs(node);
  }

  [[nodiscard]] bool is_before(const SlotHit& a, const SlotHit& b) const {
    if (a.most < b.least) return true;
    if (b.most < a.least) return false;
    const Sign order = query::compare_hits(ray, leaf.triangle(a.slot), leaf.triangle(b.slot), rule);
    return order == Sign::negative || (order == Sign::zero && items[a.slot] < items[b.slot]);
  }

  /// The slot of the first hit.
  std::optional<std::uint32_t> first() {
    SlotHit best{0, beyond_all, beyond_all};
    std::vector<SlotHit> others;  // which may be before the best
    bool found = false;
    double limit = slabs.limit();
    const auto bound_of = [&](const BoxNode& node) { return bound(node); };
    descend_nearer_first(bvh.tree, limit, bound_of, [&](std::uint32_t from, std::uint32_t count, double& now) {
      leaf.with_parameters(from, count, [&](std::uint32_t slot, double least, double most) {
        SlotHit hit{slot, least, most};
        if (found && hit.least > best.most) return Descent::go_on;
        if (!found || hit.most < best.most) {
          std::swap(hit, best);
          now = std::min(now, slabs.limit_at(best.most));
        }
        if (found && !(hit.least > best.most)) others.push_back(hit);
        found = true;
        return Descent::go_on;
      });
    });
    if (!found) return {};
    const double end = best.most;
    for (const SlotHit& other : others) {
      if (!(other.least > end) && is_before(other, best)) best = other;
    }
    return best.slot;
  }

  /// Calls visit(leaf's slots) for all leaves that the ray may hit something in.
  template <class Visit>
  Descent leaves(const Visit& visit) {
    const double limit = slabs.limit();
    return descend(
        bvh.tree, [&](const BoxNode& node) { return !(bound(node) > limit); }, visit);
  }

  bool any() {
    return leaves([&](std::uint32_t from, std::uint32_t count) {
             return leaf.hit(from, count, [](std::uint32_t) { return Descent::stop; });
           }) == Descent::stop;
  }

  // An item may be in several slots.
  std::size_t count() {
    std::vector<std::uint32_t> all;
    leaves([&](std::uint32_t from, std::uint32_t count) {
      return leaf.hit(from, count, [&](std::uint32_t slot) {
        all.push_back(items[slot]);
        return Descent::go_on;
      });
    });
    std::sort(all.begin(), all.end());
    return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
  }

  std::vector<NumberedHit> ordered() {
    std::vector<SlotHit> all;
    leaves([&](std::uint32_t from, std::uint32_t count) {
      return leaf.with_parameters(from, count, [&](std::uint32_t slot, double least, double most) {
        all.push_back({slot, least, most});
        return Descent::go_on;
      });
    });
    std::sort(all.begin(), all.end(), [&](const SlotHit& a, const SlotHit& b) { return is_before(a, b); });
    std::vector<NumberedHit> hits;
    for (const SlotHit& hit : all) {
      if (hits.empty() || hits.back().index != items[hit.slot])
        hits.push_back({items[hit.slot], *first_hit(ray, leaf.triangle(hit.slot), rule)});
    }
    return hits;
  }

  std::optional<NumberedHit> first_with_numbers() {
    const auto slot = first();
    if (!slot) return {};
    return NumberedHit{items[*slot], *first_hit(ray, leaf.triangle(*slot), rule)};
  }
  std::optional<std::uint32_t> first_number() {
    const auto slot = first();
    if (!slot) return {};
    return items[*slot];
  }
};

void require_sound(std::string_view function, const AnyRay& ray) {
  if (!query::is_sound(ray)) [[unlikely]]
    query::require_ray(function, ray);
}

}  // namespace

std::optional<NumberedHit> first_hit(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  require_sound("first_hit", ray);
  return RayOnMesh{ray, bvh, rule}.first_with_numbers();
}
std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  require_sound("first_triangle", ray);
  return RayOnMesh{ray, bvh, rule}.first_number();
}
bool hits(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  require_sound("hits", ray);
  return RayOnMesh{ray, bvh, rule}.any();
}
std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  require_sound("ordered_hits", ray);
  return RayOnMesh{ray, bvh, rule}.ordered();
}
std::size_t count_hits(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  require_sound("count_hits", ray);
  return RayOnMesh{ray, bvh, rule}.count();
}

}  // namespace plumb
