// The ray as the mesh sees it, by the mesh's wide tree (space/ray/seen_ray.hpp).  Where it is not seen: posed boxes that
// the ray hits, nearer ones first where the first hit is asked for; triangles by their exact images.
#include "plumb/space/ray/posed_ray.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "plumb/arith/interval.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "query/ray/numbers.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/ray/hit_search.hpp"
#include "space/ray/nearest_hit.hpp"
#include "space/ray/ray_order.hpp"
#include "space/ray/seen_ray.hpp"

namespace plumb {
namespace space {
namespace {

constexpr std::size_t posed_rays_of_part = 64;

bool may_hit(const AnyRay& ray, const Aabb3& box) { return !is_bounded(box) || hits(ray, box); }

/// At most the parameter at which the ray, which hits it, enters the box.
double entry_below(const AnyRay& ray, const Aabb3& box) {
  const auto on = [&](double origin, double along, double end, double low, double high) {
    const Interval from(origin);
    const Interval way = ray.kind == AnyRay::Kind::segment ? Interval(end) - from : Interval(along);
    return quotient(Interval(low, high) - from, way).lower;
  };
  const auto& [o, d, e] = std::tie(ray.origin, ray.direction, ray.end);
  const double least = ray.kind == AnyRay::Kind::line ? -Interval::infinity : 0;
  return std::min(most_parameter,
                  std::max({least, on(o.x, d.x, e.x, box.min.x, box.max.x), on(o.y, d.y, e.y, box.min.y, box.max.y),
                            on(o.z, d.z, e.z, box.min.z, box.max.z)}));
}

/// visit(slot) of each triangle whose leaf the ray may hit.
template <class Mesh, class Visit>
void visit_posed(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, const Visit& visit) {
  descend(
      mesh.bvh.tree, [&](const BoxNode& node) { return may_hit(ray, around(mesh, node)); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          if (visited(visit, slot) == Descent::stop) return Descent::stop;
        }
        return Descent::go_on;
      });
}

/// The sign of the exact parameter of one triangle that is hit minus that of another.
template <class Mesh>
std::strong_ordering parameter_order(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule, std::size_t a,
                                     std::size_t b) {
  return *query::first_hit_parameter(ray, mesh.triangle(a), rule) <=>
         *query::first_hit_parameter(ray, mesh.triangle(b), rule);
}

struct PosedHit {
  std::uint32_t number, slot;
  Hit hit;
};

template <class Mesh>
std::optional<NumberedHit> first_posed_hit(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
  struct Triangles {
    const AnyRay& ray;
    const PosedMeshOf<Mesh>& mesh;
    HitRule rule;
    [[nodiscard]] auto hit(std::uint32_t slot) const { return query::first_hit(ray, mesh.triangle(slot), rule); }
    [[nodiscard]] auto parameter(std::uint32_t slot) const {
      return *query::first_hit_parameter(ray, mesh.triangle(slot), rule);
    }
    [[nodiscard]] std::uint32_t number(std::uint32_t slot) const { return mesh.bvh.number(slot); }
  };
  return nearest_hit(mesh.bvh.tree, Triangles{ray, mesh, rule}, [&](const BoxNode& node) {
    const Aabb3 box = around(mesh, node);
    if (!is_bounded(box)) return -Interval::infinity;
    return hits(ray, box) ? entry_below(ray, box) : Interval::infinity;
  });
}

template <class Mesh>
bool any_posed_hit(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
  bool found = false;
  visit_posed(ray, mesh, [&](std::uint32_t slot) {
    found = query::hits(ray, mesh.triangle(slot), rule);
    return found ? Descent::stop : Descent::go_on;
  });
  return found;
}

template <class Mesh>
std::vector<NumberedHit> ordered_posed_hits(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
  std::vector<PosedHit> all;
  visit_posed(ray, mesh, [&](std::uint32_t slot) {
    if (const auto hit = query::first_hit(ray, mesh.triangle(slot), rule))
      all.push_back({mesh.bvh.number(slot), slot, *hit});
  });
  std::ranges::sort(all, [&](const PosedHit& a, const PosedHit& b) {
    if (a.hit.t != b.hit.t) return a.hit.t < b.hit.t;
    const auto order = parameter_order(ray, mesh, rule, a.slot, b.slot);
    return order < 0 || (order == 0 && a.number < b.number);
  });
  std::vector<NumberedHit> ordered;
  for (const PosedHit& h : all) {  // an item may be in several slots
    if (ordered.empty() || ordered.back().index != h.number) ordered.push_back({h.number, h.hit});
  }
  return ordered;
}

template <class Mesh>
std::size_t counted_posed_hits(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
  std::vector<std::uint32_t> numbers;
  visit_posed(ray, mesh, [&](std::uint32_t slot) {
    if (query::hits(ray, mesh.triangle(slot), rule)) numbers.push_back(mesh.bvh.number(slot));
  });
  std::ranges::sort(numbers);
  return static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
}

// The same questions by each way: what is looked for, and the answer where the ray is not seen.
struct AsksFirst {
  using Search = FirstHit;
  static auto answer(const Search& s) { return s.first(); }
  template <class Mesh>
  static auto unseen(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
    return first_posed_hit(ray, mesh, rule);
  }
};
struct AsksNumber {
  using Search = FirstHit;
  static auto answer(const Search& s) { return s.first_number(); }
  template <class Mesh>
  static std::optional<std::uint32_t> unseen(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
    const auto hit = first_posed_hit(ray, mesh, rule);
    return hit ? std::optional(hit->index) : std::nullopt;
  }
};
struct AsksAny {
  using Search = AnyHit;
  static auto answer(const Search& s) { return s.found(); }
  template <class Mesh>
  static auto unseen(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
    return any_posed_hit(ray, mesh, rule);
  }
};
struct AsksAll {
  using Search = OrderedHits;
  static auto answer(Search& s) { return s.in_order(); }
  template <class Mesh>
  static auto unseen(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
    return ordered_posed_hits(ray, mesh, rule);
  }
};
struct AsksCount {
  using Search = CountedHits;
  static auto answer(Search& s) { return s.count(); }
  template <class Mesh>
  static auto unseen(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
    return counted_posed_hits(ray, mesh, rule);
  }
};

template <class Mesh>
void require_posed_shot(const char* function, const AnyRay& ray, const PosedMeshOf<Mesh>& mesh) {
  if (!query::is_sound(ray)) query::require_ray(function, ray);
  require_pose(function, "mesh", mesh.pose);
}

template <class Asks, class Mesh>
auto shoot(const char* function, const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule) {
  require_posed_shot(function, ray, mesh);
  const auto seen = Sight(mesh)(ray);
  if (!seen) return Asks::unseen(ray, mesh, rule);
  typename Asks::Search search(ray, *seen, mesh, rule);
  const RayTask task = search.task(seen->slabs);
  visit_triangles(mesh.bvh, {&task, 1});
  return Asks::answer(search);
}

/// put(i, the answer along rays[i]); a part's rays descend together.
template <class Asks, class Mesh, class Put>
void shoot_all(const char* function, std::span<const AnyRay> rays, const PosedMeshOf<Mesh>& mesh, std::size_t places,
               const ManyRays& options, const Put& put) {
  if (places != rays.size()) {
    throw UnequalLengths(std::string(function) + ": out has " + std::to_string(places) + " items, rays has " +
                         std::to_string(rays.size()));
  }
  require_pose(function, "mesh", mesh.pose);
  const Sight sight(mesh);
  const auto [min, max] = mesh.bvh.tree.box();
  const Aabb3 box = around(mesh, BoxNode{min, 0, max, 0});
  const std::size_t parts = blocks_of(rays.size(), posed_rays_of_part);
  for_parts(function, options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t from = part * posed_rays_of_part, to = std::min(rays.size(), from + posed_rays_of_part);
    const auto asked = rays.subspan(from, to - from);
    for (const AnyRay& ray : asked) {
      if (!query::is_sound(ray)) query::require_ray(function, ray);
    }
    const auto [order, are_near] = order_of(asked, box, mesh.bvh.slots());
    std::vector<SeenRay> seen;
    std::vector<typename Asks::Search> searches;
    std::vector<std::size_t> numbers;
    std::vector<RayTask> tasks;
    seen.reserve(to - from);  // what refers to them stays
    searches.reserve(to - from);
    for (const std::uint16_t k : order) {
      const std::size_t i = from + k;
      if (const auto one = sight(rays[i])) {
        const SeenRay& kept = seen.emplace_back(*one);
        tasks.push_back(searches.emplace_back(rays[i], kept, mesh, options.rule).task(kept.slabs));
        numbers.push_back(i);
      } else {
        put(i, Asks::unseen(rays[i], mesh, options.rule));
      }
    }
    visit_triangles(mesh.bvh, tasks, are_near);
    for (std::size_t i = 0; i < searches.size(); ++i) put(numbers[i], Asks::answer(searches[i]));
  });
}

}  // namespace
}  // namespace space

// Each question of the mesh's tree in its usual and in its compact form.
#define PLUMB_POSED_RAYS(Mesh)                                                                                      \
  std::optional<NumberedHit> first_hit(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                         \
    return space::shoot<space::AsksFirst>("first_hit", ray, mesh, rule);                                            \
  }                                                                                                                 \
  std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                  \
    return space::shoot<space::AsksNumber>("first_triangle", ray, mesh, rule);                                      \
  }                                                                                                                 \
  bool hits(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                                                    \
    return space::shoot<space::AsksAny>("hits", ray, mesh, rule);                                                   \
  }                                                                                                                 \
  std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const Mesh& mesh, HitRule rule,                          \
                                        std::vector<NumberedHit> rows) {                                            \
    const std::vector<NumberedHit> hits = space::shoot<space::AsksAll>("ordered_hits", ray, mesh, rule);            \
    rows.assign(hits.begin(), hits.end());                                                                          \
    return rows;                                                                                                    \
  }                                                                                                                 \
  std::size_t count_hits(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                                       \
    return space::shoot<space::AsksCount>("count_hits", ray, mesh, rule);                                           \
  }                                                                                                                 \
  void first_hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::optional<NumberedHit>> out,        \
                  const ManyRays& options) {                                                                        \
    space::shoot_all<space::AsksFirst>("first_hits", rays, mesh, out.size(), options,                               \
                                       [&](std::size_t i, const auto& hit) { out[i] = hit; });                      \
  }                                                                                                                 \
  void first_triangles(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::uint32_t> out,                \
                       const ManyRays& options) {                                                                   \
    space::shoot_all<space::AsksNumber>("first_triangles", rays, mesh, out.size(), options,                         \
                                        [&](std::size_t i, const auto& n) { out[i] = n.value_or(no_triangle); });   \
  }                                                                                                                 \
  void hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::uint8_t> out, const ManyRays& options) { \
    space::shoot_all<space::AsksAny>("hits", rays, mesh, out.size(), options, [&](std::size_t i, bool found) {      \
      out[i] = static_cast<std::uint8_t>(found ? 1 : 0);                                                            \
    });                                                                                                             \
  }                                                                                                                 \
  void ordered_hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::vector<NumberedHit>> out,        \
                    const ManyRays& options) {                                                                      \
    space::shoot_all<space::AsksAll>("ordered_hits", rays, mesh, out.size(), options,                               \
                                     [&](std::size_t i, auto&& all) { out[i] = std::move(all); });                  \
  }                                                                                                                 \
  void count_hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::size_t> out,                       \
                  const ManyRays& options) {                                                                        \
    space::shoot_all<space::AsksCount>("count_hits", rays, mesh, out.size(), options,                               \
                                       [&](std::size_t i, std::size_t n) { out[i] = n; });                          \
  }
PLUMB_POSED_RAYS(PosedMesh)
PLUMB_POSED_RAYS(PosedCompactMesh)
#undef PLUMB_POSED_RAYS

}  // namespace plumb
