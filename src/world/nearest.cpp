// Distances: bodies whose boxes may be near enough; distances that round alike are compared as they are.
#include <algorithm>
#include <limits>
#include <tuple>

#include "plumb/arith/error.hpp"
#include "world/part_questions.hpp"
#include "world/state.hpp"

namespace plumb {
namespace {

using world::about_body, world::WorldBody;

/// Asks bodies of a world how far they are from a figure.
class DistanceQuestion {
 public:
  DistanceQuestion(const std::vector<std::optional<WorldBody>>& bodies, const AnyFigure& figure)
      : bodies_(bodies), figure_(figure) {}

  [[nodiscard]] WorldNear of(const BodyHandle& handle) const {
    const WorldBody& body = *bodies_[handle.slot];
    return about_body("CollisionWorld::nearest", body.options.user_id, [&] {
      std::optional<WorldNear> best;
      for (std::uint32_t i = 0; i < body.placed.size(); ++i) {
        const auto [triangle, d] = world::distance_to(body.placed[i], figure_);
        const WorldNear found{body.options.user_id, handle, {i, triangle}, d};
        if (!best || is_nearer(found, *best)) best = found;
      }
      return *best;
    });
  }
  [[nodiscard]] bool is_before(const WorldNear& p, const WorldNear& q) const {
    if (is_nearer(p, q)) return true;
    return !is_nearer(q, p) && std::tie(p.user_id, p.body) < std::tie(q.user_id, q.body);
  }
  [[nodiscard]] bool is_within(const WorldNear& p, double distance) const {
    if (p.distance != distance) return p.distance < distance;
    return compare(exact(p), distance) != Sign::positive;
  }

 private:
  [[nodiscard]] bool is_nearer(const WorldNear& p, const WorldNear& q) const {
    if (p.distance != q.distance) return p.distance < q.distance;
    return compare(exact(p), exact(q)) == Sign::negative;
  }
  [[nodiscard]] ExactDistance exact(const WorldNear& n) const {
    return world::exact_distance_to(bodies_[n.body.slot]->placed[n.part.part], n.part.triangle, figure_);
  }

  const std::vector<std::optional<WorldBody>>& bodies_;
  const AnyFigure& figure_;
};

}  // namespace

std::vector<WorldNear> CollisionWorld::nearest(const AnyFigure& figure, std::size_t k, std::uint32_t mask) const {
  const State& s = *state_;
  const DistanceQuestion ask(s.bodies, figure);
  const auto is_before = [&](const WorldNear& p, const WorldNear& q) { return ask.is_before(p, q); };
  std::vector<WorldNear> best;
  if (k == 0) return best;
  const double all = std::numeric_limits<double>::infinity();
  s.boxes.visit_near(world::box_of_figure(figure), all, [&](const BodyHandle& handle) {
    if ((s.bodies[handle.slot]->options.group & mask) != 0) {
      const WorldNear found = ask.of(handle);
      best.insert(std::upper_bound(best.begin(), best.end(), found, is_before), found);
      if (best.size() > k) best.pop_back();
    }
    return best.size() == k ? best.back().distance : all;
  });
  return best;
}

std::vector<WorldNear> CollisionWorld::within(const AnyFigure& figure, double distance, std::uint32_t mask) const {
  const State& s = *state_;
  if (distance != distance) throw NonFinite("CollisionWorld::within: distance is nan; give a number");
  const DistanceQuestion ask(s.bodies, figure);
  std::vector<WorldNear> all;
  s.boxes.visit_near(world::box_of_figure(figure), distance, [&](const BodyHandle& handle) {
    if ((s.bodies[handle.slot]->options.group & mask) != 0) {
      const WorldNear found = ask.of(handle);
      if (ask.is_within(found, distance)) all.push_back(found);
    }
    return distance;
  });
  std::sort(all.begin(), all.end(), [&](const WorldNear& p, const WorldNear& q) { return ask.is_before(p, q); });
  return all;
}

}  // namespace plumb
