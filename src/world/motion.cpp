// What moves along vectors: bodies whose boxes it sweeps, by the exact times at which it comes to them.
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "world/part_questions.hpp"
#include "world/state.hpp"

namespace plumb {
namespace {

using world::about_body, world::PartInMotion, world::PartTime, world::Placed, world::WorldBody;

constexpr Vector3 at_rest{0, 0, 0};

/// The first time of two lists of parts, and which parts these are.
struct FirstTime {
  std::uint32_t part_a, part_b;
  PartTime time;
};
struct PartsInMotion {
  const std::vector<Placed>& parts;
  Vector3 by;
  [[nodiscard]] PartInMotion at(std::uint32_t i) const { return {parts[i], by}; }
};
Root exact_time(const PartsInMotion& a, const PartsInMotion& b, const FirstTime& t) {
  return world::contact_time(a.at(t.part_a), b.at(t.part_b), t.time);
}
std::optional<FirstTime> first_time(const PartsInMotion& a, const PartsInMotion& b) {
  std::optional<FirstTime> best;
  for (std::uint32_t i = 0; i < a.parts.size(); ++i) {
    for (std::uint32_t j = 0; j < b.parts.size(); ++j) {
      const auto found = world::first_contact(a.at(i), b.at(j));
      if (!found) continue;
      const FirstTime next{i, j, *found};
      const double t = found->contact.time;
      const bool is_before = !best || t < best->time.contact.time ||
                             (t == best->time.contact.time && exact_time(a, b, next) < exact_time(a, b, *best));
      if (is_before) best = next;
    }
  }
  return best;
}

/// Sorts by times, exactly where they round alike, and else by `rest`; calls ranked(item, rank) of each.
template <class Item, class Time, class Exact, class Rest, class Ranked>
void sort_by_time(std::vector<Item>& all, const Time& time, const Exact& exact, const Rest& rest,
                  const Ranked& ranked) {
  std::sort(all.begin(), all.end(), [&](const Item& p, const Item& q) { return time(p) < time(q); });
  std::size_t rank = 0;
  for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
    while (to < all.size() && time(all[to]) == time(all[from])) ++to;
    std::vector<std::pair<Root, Item>> alike;
    for (std::size_t i = from; i < to && to - from > 1; ++i) alike.emplace_back(exact(all[i]), all[i]);
    std::sort(alike.begin(), alike.end(), [&](const auto& p, const auto& q) {
      if (p.first != q.first) return p.first < q.first;
      return rest(p.second) < rest(q.second);
    });
    for (std::size_t i = from; i < to; ++i) {
      if (to - from > 1) all[i] = alike[i - from].second;
      if (i > from && alike[i - from].first != alike[i - from - 1].first) ++rank;
      ranked(all[i], rank);
    }
    ++rank;
  }
}

void require_motion(const char* function, const Vector3& by) {
  figure::require_finite_parts<Vector3>(function, {"by"}, by);
}

}  // namespace

std::vector<WorldCast> CollisionWorld::contacts_along(const AnyFigure& figure, const Vector3& by,
                                                      std::uint32_t mask) const {
  const State& s = *state_;
  require_motion("CollisionWorld::contacts_along", by);
  const Aabb3 box = world::box_of_figure(figure);
  const std::vector<Placed> moving{figure};
  std::vector<WorldCast> all;
  for (const BodyHandle& handle : s.boxes.in_box(world::swept(box, by))) {
    const WorldBody& body = *s.bodies[handle.slot];
    if ((body.options.group & mask) == 0) continue;
    const auto first = about_body("CollisionWorld::contacts_along", body.options.user_id, [&] {
      return first_time({moving, by}, {body.placed, at_rest});
    });
    if (!first) continue;
    all.push_back({body.options.user_id, handle, {first->part_b, first->time.triangle_b}, first->time.contact});
  }
  const auto exact = [&](const WorldCast& c) {
    const FirstTime t{0, c.part.part, {0, c.part.triangle, c.contact}};
    return exact_time({moving, by}, {s.bodies[c.body.slot]->placed, at_rest}, t);
  };
  sort_by_time(
      all, [](const WorldCast& c) { return c.contact.time; }, exact,
      [](const WorldCast& c) { return std::tie(c.user_id, c.body); }, [](WorldCast&, std::size_t) {});
  return all;
}

std::optional<WorldCast> CollisionWorld::first_contact(const AnyFigure& figure, const Vector3& by,
                                                       std::uint32_t mask) const {
  const std::vector<WorldCast> all = contacts_along(figure, by, mask);
  if (all.empty()) return {};
  return all.front();
}

std::vector<WorldImpact> CollisionWorld::first_contacts(std::span<const BodyMotion> motions) const {
  const State& s = *state_;
  constexpr const char* function = "CollisionWorld::first_contacts";
  std::vector<Vector3> by(s.bodies.size(), at_rest);
  std::vector<std::uint8_t> moves(s.bodies.size(), 0);
  for (const BodyMotion& m : motions) {
    const std::uint64_t id = s.body(function, m.body).options.user_id;
    about_body(function, id, [&] {
      require_motion("its motion", m.by);
      if (moves[m.body.slot] != 0) throw InvalidShape("it is named twice; give each body one motion");
    });
    by[m.body.slot] = m.by, moves[m.body.slot] = 1;
  }
  std::vector<std::uint32_t> slots;
  std::vector<Aabb3> ways;
  for (std::uint32_t slot = 0; slot < s.bodies.size(); ++slot) {
    if (!s.bodies[slot]) continue;
    Aabb3 box = world::box_of(s.bodies[slot]->placed[0]);
    for (const Placed& part : s.bodies[slot]->placed) box = world::joined(box, world::box_of(part));
    slots.push_back(slot), ways.push_back(world::swept(box, by[slot]));
  }
  std::vector<WorldPair> pairs;
  for (const BoxPair& p : plumb::overlapping_pairs(ways, BroadPhaseOptions{true, Execution::serial})) {
    if (moves[slots[p.a]] == 0 && moves[slots[p.b]] == 0) continue;
    if (const auto pair = s.pair_of(s.handle(slots[p.a]), s.handle(slots[p.b]))) pairs.push_back(*pair);
  }
  std::sort(pairs.begin(), pairs.end(), world::comes_before);
  std::vector<WorldImpact> all;
  const auto moving = [&](const BodyHandle& h) { return PartsInMotion{s.bodies[h.slot]->placed, by[h.slot]}; };
  for (const WorldPair& p : pairs) {
    if (!s.is_admitted(p)) continue;
    const auto first = about_body(function, p.id_a, [&] {
      return about_body("and", p.id_b, [&] { return first_time(moving(p.a), moving(p.b)); });
    });
    if (!first) continue;
    all.push_back({p.id_a,
                   p.id_b,
                   p.a,
                   p.b,
                   {first->part_a, first->time.triangle_a},
                   {first->part_b, first->time.triangle_b},
                   first->time.contact,
                   0});
  }
  const auto exact = [&](const WorldImpact& c) {
    const FirstTime t{c.part_a.part, c.part_b.part, {c.part_a.triangle, c.part_b.triangle, c.contact}};
    return exact_time(moving(c.a), moving(c.b), t);
  };
  sort_by_time(
      all, [](const WorldImpact& c) { return c.contact.time; }, exact,
      [](const WorldImpact& c) { return std::tie(c.id_a, c.id_b, c.a, c.b); },
      [](WorldImpact& c, std::size_t rank) { c.rank = rank; });
  return all;
}

}  // namespace plumb
