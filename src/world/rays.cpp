// Rays: bodies whose boxes are hit, the nearer first as a rule; parameters that round alike are compared as they are.
#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

#include "plumb/query/ray/hits.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/parts.hpp"
#include "world/part_questions.hpp"
#include "world/state.hpp"

namespace plumb {
namespace {

using world::about_body, world::Placed, world::WorldBody;

constexpr double beyond_all = std::numeric_limits<double>::infinity();

/// Asks bodies of a world where a ray hits them.
class RayQuestion {
 public:
  RayQuestion(const std::vector<std::optional<WorldBody>>& bodies, const MovingBoxes& boxes, const AnyRay& ray)
      : bodies_(bodies), boxes_(boxes), ray_(ray) {}

  [[nodiscard]] std::optional<WorldHit> of(const BodyHandle& handle) const {
    if (!plumb::hits(ray_, boxes_.box(handle))) return {};  // the index has wider ones
    const WorldBody& body = *bodies_[handle.slot];
    if (body.proxy && !world::is_hit(*body.proxy, ray_)) return {};
    return about_body("CollisionWorld::first_hit", body.options.user_id, [&] {
      std::optional<WorldHit> best;
      for (std::uint32_t i = 0; i < body.placed.size(); ++i) {
        const auto hit = world::first_hit(body.placed[i], ray_);
        if (!hit) continue;
        const WorldHit found{body.options.user_id, handle, {i, hit->triangle}, hit->hit};
        if (!best || is_earlier(found, *best)) best = found;
      }
      return best;
    });
  }
  /// By exact parameters, then by user ids and handles; of one body by its parts.
  [[nodiscard]] bool is_before(const WorldHit& p, const WorldHit& q) const {
    if (is_earlier(p, q)) return true;
    return !is_earlier(q, p) && std::tie(p.user_id, p.body) < std::tie(q.user_id, q.body);
  }

 private:
  [[nodiscard]] bool is_earlier(const WorldHit& p, const WorldHit& q) const {
    if (p.hit.t != q.hit.t) return p.hit.t < q.hit.t;
    return (exact(p) <=> exact(q)) < 0;
  }
  [[nodiscard]] RayParameter exact(const WorldHit& h) const {
    return world::hit_parameter(bodies_[h.body.slot]->placed[h.part.part], h.part.triangle, ray_);
  }

  const std::vector<std::optional<WorldBody>>& bodies_;
  const MovingBoxes& boxes_;
  const AnyRay& ray_;
};

}  // namespace

std::optional<WorldHit> CollisionWorld::first_hit(const AnyRay& ray, std::uint32_t mask) const {
  const State& s = *state_;
  const RayQuestion ask(s.bodies, s.boxes, ray);
  std::optional<WorldHit> best;
  s.boxes.visit_along(ray, [&](const BodyHandle& handle) {
    if ((s.bodies[handle.slot]->options.group & mask) != 0) {
      const auto found = ask.of(handle);
      if (found && (!best || ask.is_before(*found, *best))) best = found;
    }
    return best ? best->hit.t : beyond_all;
  });
  return best;
}

bool CollisionWorld::any_hit(const AnyRay& ray, std::uint32_t mask) const {
  const State& s = *state_;
  bool is_any = false;
  s.boxes.visit_along(ray, [&](const BodyHandle& handle) {
    const WorldBody& body = *s.bodies[handle.slot];
    is_any = is_any ||
             ((body.options.group & mask) != 0 && (!body.proxy || world::is_hit(*body.proxy, ray)) &&
              about_body("CollisionWorld::any_hit", body.options.user_id, [&] {
                return std::ranges::any_of(body.placed, [&](const Placed& part) { return world::is_hit(part, ray); });
              }));
    return is_any ? -beyond_all : beyond_all;
  });
  return is_any;
}

std::vector<WorldHit> CollisionWorld::hits(const AnyRay& ray, std::uint32_t mask) const {
  const State& s = *state_;
  const RayQuestion ask(s.bodies, s.boxes, ray);
  std::vector<WorldHit> all;
  s.boxes.visit_along(ray, [&](const BodyHandle& handle) {
    if ((s.bodies[handle.slot]->options.group & mask) != 0) {
      if (const auto found = ask.of(handle)) all.push_back(*found);
    }
    return beyond_all;
  });
  std::sort(all.begin(), all.end(), [&](const WorldHit& p, const WorldHit& q) { return ask.is_before(p, q); });
  return all;
}

void CollisionWorld::first_hit(std::span<const AnyRay> rays, std::span<std::optional<WorldHit>> out,
                               std::uint32_t mask) const {
  if (rays.size() != out.size()) {
    throw UnequalLengths("CollisionWorld::first_hit: " + std::to_string(rays.size()) + " rays, but " +
                         std::to_string(out.size()) + " answers");
  }
  space::for_blocks(state_->options.execution, rays.size(), 16, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) out[i] = first_hit(rays[i], mask);
  });
}

}  // namespace plumb
