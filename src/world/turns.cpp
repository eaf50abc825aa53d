// Bodies that turn: of each pair whose ways may cross, interval halving by the distances of what stands at a time.
#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

#include "plumb/arith/error.hpp"
#include "plumb/query/time_of_impact/moving_distance.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "world/part_questions.hpp"
#include "world/state.hpp"
#include "world/turning.hpp"

namespace plumb {
namespace {

using world::about_body, world::Placed, world::WorldBody;

std::vector<Placed> placed_by(const WorldBody& body, const AnyPose& pose) {
  std::vector<Placed> all;
  all.reserve(body.parts.size());
  for (const AnyBody::Part& part : body.parts) all.push_back(world::placed(part, pose));
  return all;
}

Aabb3 box_of_all(const std::vector<Placed>& placed) {
  Aabb3 box = world::box_of(placed[0]);
  for (const Placed& part : placed) box = world::joined(box, world::box_of(part));
  return box;
}

/// A body, and how it turns, if it does.
struct TurnedBody {
  const WorldBody& body;
  const world::Turning* turning;
};
/// Where it is near to at a time; `room` keeps what does not stand where the body does.
struct Nearby {
  std::vector<Placed> room{};
  const std::vector<Placed>* placed = nullptr;
  double off = 0;
};
Nearby nearby(const TurnedBody& b, double t) {
  if (b.turning == nullptr) return {{}, &b.body.placed, 0};
  const world::NearbyPose near = b.turning->at(t);
  return {placed_by(b.body, near.pose), nullptr, near.off};
}
const std::vector<Placed>& placed_of(const Nearby& n) { return n.placed != nullptr ? *n.placed : n.room; }

double least_distance(const std::vector<Placed>& a, const std::vector<Placed>& b) {
  double least = Interval::infinity;
  for (const Placed& p : a) {
    for (const Placed& q : b) least = std::min(least, world::distance_of_parts(p, q).distance);
  }
  return least;
}

/// What first_contact_span asks.
class TurningPair {
 public:
  TurningPair(const TurnedBody& a, const TurnedBody& b) : a_(a), b_(b) {}

  [[nodiscard]] double distance_at(double t) const {
    const Nearby a = nearby(a_, t), b = nearby(b_, t);
    if (!(a.off + b.off < Interval::infinity)) return 0;
    return query::surely_apart(least_distance(placed_of(a), placed_of(b)), a.off, b.off);
  }
  [[nodiscard]] double speed_between(double from, double to) const {
    const auto speed = [&](const TurnedBody& b) {
      return Interval(b.turning == nullptr ? 0.0 : b.turning->speed_between(from, to));
    };
    return (speed(a_) + speed(b_)).upper;
  }
  /// That they stand there exactly makes it certain.
  [[nodiscard]] bool surely_meet_at(double t) const {
    const Nearby a = nearby(a_, t), b = nearby(b_, t);
    if (a.off > 0 || b.off > 0) return false;
    return std::ranges::any_of(placed_of(a), [&](const Placed& p) {
      return std::ranges::any_of(placed_of(b),
                                 [&](const Placed& q) { return world::relation(p, q) != Relation::disjoint; });
    });
  }

 private:
  TurnedBody a_, b_;
};

struct FoundSpan {
  TimeSpan span;
  bool is_certain;
};
std::optional<FoundSpan> span_of(const TurnedBody& a, const TurnedBody& b, const HalvingOptions& options) {
  const TurningPair motion(a, b);
  if (motion.surely_meet_at(0)) return FoundSpan{{0, 0}, true};
  const auto span = first_contact_span(motion, options);
  if (!span) return {};
  return FoundSpan{*span, motion.surely_meet_at(span->to)};
}

void require_resolution(const char* function, double resolution) {
  if (!(resolution > 0)) throw Error(std::string(function) + ": the resolution must be above zero");
}

RigidPose rigid_pose_of(const AnyPose& pose) {
  if (std::holds_alternative<std::monostate>(pose)) return {};
  if (const auto* rigid = std::get_if<RigidPose>(&pose)) return *rigid;
  throw UnevenPose("it stands under a chain of poses; move it to a RigidPose first");
}

struct TurnsOfBodies {
  std::vector<std::optional<world::Turning>> of;  // by slot
  std::vector<std::uint32_t> slots;
  std::vector<Aabb3> ways;  // of these
};

}  // namespace

std::vector<WorldContactSpan> CollisionWorld::first_contact_spans(std::span<const BodyTurn> turns,
                                                                  const HalvingOptions& options) const {
  const State& s = *state_;
  constexpr const char* function = "CollisionWorld::first_contact_spans";
  require_resolution(function, options.resolution);
  TurnsOfBodies all;
  all.of.resize(s.bodies.size());
  for (const BodyTurn& turn : turns) {
    const WorldBody& body = s.body(function, turn.body);
    about_body(function, body.options.user_id, [&] {
      if (all.of[turn.body.slot]) throw InvalidShape("it is named twice; give each body one turn");
      static_cast<void>(placed_by(body, turn.to));  // throws where it is no pose
      all.of[turn.body.slot].emplace(rigid_pose_of(body.pose), turn.to, box_of_all(placed_by(body, {})));
    });
  }
  for (std::uint32_t slot = 0; slot < s.bodies.size(); ++slot) {
    if (!s.bodies[slot]) continue;
    const Aabb3 box = box_of_all(s.bodies[slot]->placed);
    all.slots.push_back(slot), all.ways.push_back(all.of[slot] ? all.of[slot]->way(box) : box);
  }
  std::vector<WorldPair> pairs;
  for (const BoxPair& p : plumb::overlapping_pairs(all.ways, BroadPhaseOptions{true, Execution::serial})) {
    const std::uint32_t a = all.slots[p.a], b = all.slots[p.b];
    if (!all.of[a] && !all.of[b]) continue;
    if (const auto pair = s.pair_of(s.handle(a), s.handle(b))) pairs.push_back(*pair);
  }
  std::sort(pairs.begin(), pairs.end(), world::comes_before);
  std::vector<WorldContactSpan> told;
  for (const WorldPair& p : pairs) {
    if (!s.is_admitted(p)) continue;
    const auto turned = [&](const BodyHandle& h) {
      return TurnedBody{*s.bodies[h.slot], all.of[h.slot] ? &*all.of[h.slot] : nullptr};
    };
    about_body(function, p.id_a, [&] {
      about_body("and", p.id_b, [&] {
        const auto found = span_of(turned(p.a), turned(p.b), options);
        if (found) told.push_back({p.id_a, p.id_b, p.a, p.b, found->span, found->is_certain});
      });
    });
  }
  std::sort(told.begin(), told.end(), [](const WorldContactSpan& p, const WorldContactSpan& q) {
    return std::tie(p.span.from, p.span.to, p.id_a, p.id_b, p.a, p.b) <
           std::tie(q.span.from, q.span.to, q.id_a, q.id_b, q.a, q.b);
  });
  return told;
}

std::vector<WorldCastSpan> CollisionWorld::contact_spans_along(const AnyFigure& figure, const RigidPose& to,
                                                               std::uint32_t mask, double resolution) const {
  const State& s = *state_;
  constexpr const char* function = "CollisionWorld::contact_spans_along";
  require_resolution(function, resolution);
  WorldBody moving{{{figure.under({}), {}}}, figure.pose(), {}, {}, {}, {}, {}};
  const auto turning =
      world::about([&] { return std::string(function) + ": figure"; },
                   [&] {
                     moving.placed = placed_by(moving, moving.pose);
                     static_cast<void>(placed_by(moving, to));  // throws where it is no pose
                     return world::Turning(rigid_pose_of(moving.pose), to, box_of_all(placed_by(moving, {})));
                   });
  std::vector<WorldCastSpan> told;
  for (const BodyHandle& handle : s.boxes.in_box(turning.way(box_of_all(moving.placed)))) {
    const WorldBody& body = *s.bodies[handle.slot];
    if ((body.options.group & mask) == 0) continue;
    const auto found = about_body(function, body.options.user_id, [&] {
      return span_of({moving, &turning}, {body, nullptr}, {.resolution = resolution});
    });
    if (found) told.push_back({body.options.user_id, handle, found->span, found->is_certain});
  }
  std::sort(told.begin(), told.end(), [](const WorldCastSpan& p, const WorldCastSpan& q) {
    return std::tie(p.span.from, p.span.to, p.user_id, p.body) < std::tie(q.span.from, q.span.to, q.user_id, q.body);
  });
  return told;
}

}  // namespace plumb
