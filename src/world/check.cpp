// What a world keeps is held against what it is about: slots, boxes, near pairs and answers, by asking again.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>

#include "plumb/figure/aabb/relation.hpp"
#include "world/part_contacts.hpp"
#include "world/part_questions.hpp"
#include "world/state.hpp"

namespace plumb {
namespace world {

/// The sentences that a world is told by.
class Complaints {
 public:
  /// Says what does not hold; words and numbers in turn.
  template <class... Words>
  void expect(bool holds, const Words&... words) {
    if (holds) return;
    std::string text;
    (add(text, words), ...);
    all_.push_back(std::move(text));
  }
  [[nodiscard]] std::vector<std::string> all() && { return std::move(all_); }

 private:
  static void add(std::string& text, const char* word) { text += word; }
  static void add(std::string& text, std::uint64_t number) { text += std::to_string(number); }
  std::vector<std::string> all_;
};

}  // namespace world

namespace {

using world::Complaints, world::NearPair, world::Placed, world::WorldBody;

/// The six half spaces around a box, as far as doubles go.
std::vector<Aabb3> outside_of(const Aabb3& b) {
  constexpr double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const Aabb3 all{{-most, -most, -most}, {most, most, most}};
  std::vector<Aabb3> outside;
  for (double Point3::*x : {&Point3::x, &Point3::y, &Point3::z}) {
    Aabb3 below = all, above = all;
    below.max.*x = std::nextafter(b.min.*x, -infinity);
    above.min.*x = std::nextafter(b.max.*x, infinity);
    if (std::isfinite(below.max.*x)) outside.push_back(below);
    if (std::isfinite(above.min.*x)) outside.push_back(above);
  }
  return outside;
}

bool are_one_contact(const WorldContact& a, const WorldContact& b) {
  return a.a == b.a && a.b == b.b && a.part_a == b.part_a && a.part_b == b.part_b && a.manifold == b.manifold;
}

auto place_in_order(const WorldContact& c) { return std::tie(c.id_a, c.id_b, c.a, c.b, c.part_a, c.part_b); }

template <class Item, class Before>
bool ascends(const std::vector<Item>& items, const Before& before) {
  return std::adjacent_find(items.begin(), items.end(), [&](const Item& p, const Item& q) { return !before(p, q); }) ==
         items.end();
}

using CornerName = std::tuple<BodyHandle, BodyHandle, BodyPart, BodyPart, ContactId>;
CornerName name_of(const WorldCorner& c) { return {c.a, c.b, c.part_a, c.part_b, c.id}; }

}  // namespace

/// Asks what must hold, one part after the other.
class CollisionWorld::Inspection {
 public:
  Inspection(const State& state, std::size_t samples) : s_(state), samples_(samples) {}

  std::vector<std::string> run() {
    look_at_slots();
    look_at_boxes();
    look_at_near_pairs();
    look_at_pairs();
    look_at_contacts();
    return std::move(complaints_).all();
  }

 private:
  template <class... Words>
  void expect(bool holds, const Words&... words) {
    complaints_.expect(holds, words...);
  }
  [[nodiscard]] std::uint64_t id(std::uint32_t slot) const { return s_.bodies[slot]->options.user_id; }
  /// Stands as it did at the last commit.
  [[nodiscard]] bool is_as_committed(const BodyHandle& h) const {
    return s_.boxes.contains(h) && s_.bodies[h.slot] && s_.is_changed[h.slot] == 0;
  }
  [[nodiscard]] bool are_as_committed(const WorldPair& p) const { return is_as_committed(p.a) && is_as_committed(p.b); }

  /// Only the slots whose body can be asked about are kept.
  void look_at_slots() {
    std::set<std::uint32_t> changed(s_.changed.begin(), s_.changed.end());
    expect(changed.size() == s_.changed.size(), "a slot is listed twice as changed");
    expect(s_.is_changed.size() == s_.bodies.size(), "marks of change are ", s_.is_changed.size(), ", slots ",
           s_.bodies.size());
    std::size_t bodies = 0;
    for (std::uint32_t slot = 0; slot < s_.bodies.size(); ++slot) {
      expect(slot >= s_.is_changed.size() || (s_.is_changed[slot] != 0) == changed.contains(slot), "slot ", slot,
             " is marked as changed and not listed, or listed and not marked");
      if (!s_.bodies[slot]) continue;
      ++bodies;
      const BodyHandle& h = s_.bodies[slot]->handle;
      const bool is_its_own = h.slot == slot && s_.boxes.contains(h);
      expect(is_its_own, "body ", id(slot), " in slot ", slot, " has the handle of slot ", h.slot, ", generation ",
             h.generation, ", which names no box of its own");
      if (is_its_own) slots_.push_back(slot);
    }
    expect(bodies == s_.boxes.size(), "bodies are ", bodies, ", boxes ", s_.boxes.size());
    for (const HandlePair& p : s_.allowed) {
      expect(p.a <= p.b && s_.boxes.contains(p.a) && s_.boxes.contains(p.b), "a collision is allowed of slots ",
             p.a.slot, " and ", p.b.slot, ", of which one has no such body");
    }
    const std::size_t step = samples_ == 0 ? 0 : std::max<std::size_t>(1, (slots_.size() + samples_ - 1) / samples_);
    for (std::size_t i = 0; step != 0 && i < slots_.size(); i += step) sampled_.push_back(slots_[i]);
  }

  [[nodiscard]] const Aabb3& box(std::uint32_t slot) const { return s_.boxes.box(s_.bodies[slot]->handle); }

  void look_at_boxes() {
    for (const std::uint32_t slot : sampled_) {
      const WorldBody& body = *s_.bodies[slot];
      expect(body.placed.size() == body.parts.size() && !body.placed.empty(), "body ", id(slot), " has ",
             body.parts.size(), " parts, of which ", body.placed.size(), " stand somewhere");
      for (std::size_t i = 0; i < std::min(body.placed.size(), body.parts.size()); ++i) {
        const Aabb3 again = world::box_of(world::placed(body.parts[i], body.pose));
        expect(again == world::box_of(body.placed[i]), "part ", i, " of body ", id(slot),
               " stands elsewhere than its pose says");
      }
      for (const Aabb3& outside : outside_of(box(slot))) {
        const bool is_in = std::ranges::none_of(body.placed, [&](const Placed& p) { return world::meet(p, outside); });
        expect(is_in, "body ", id(slot), " is not within its box");
      }
      std::vector<BodyHandle> expected;
      for (const std::uint32_t other : slots_) {
        if (relate(box(slot), box(other)) != Relation::disjoint) expected.push_back(s_.bodies[other]->handle);
      }
      expect(s_.boxes.in_box(box(slot)) == expected, "the index of boxes and asking each differ by the box of body ",
             id(slot));
    }
  }

  void look_at_near_pairs() {
    const auto is_ordered = [](const NearPair& p, const NearPair& q) { return world::comes_before(p.pair, q.pair); };
    expect(ascends(s_.near, is_ordered), "pairs whose boxes overlap are not in order, or told twice");
    if (s_.is_near_lost) return;  // what they are is known after the next commit
    const auto is_near = [&](const WorldPair& p) {
      return std::binary_search(s_.near.begin(), s_.near.end(), NearPair{p}, is_ordered);
    };
    for (const std::uint32_t slot : sampled_) {
      for (const std::uint32_t other : slots_) {
        const BodyHandle a = s_.bodies[slot]->handle, b = s_.bodies[other]->handle;
        if (slot == other || !is_as_committed(a) || !is_as_committed(b)) continue;
        const auto pair = s_.pair_of(a, b);
        const bool expected = pair && relate(box(slot), box(other)) != Relation::disjoint;
        expect(expected == (pair && is_near(*pair)), "bodies ", id(slot), " and ", id(other),
               expected ? " have boxes that overlap, and are not near" : " are near, and their boxes are apart");
      }
    }
  }

  void look_at_pairs() {
    expect(ascends(s_.pairs, world::comes_before), "pairs are not in order, or told twice");
    std::vector<WorldPair> told;
    std::set_union(s_.events.begun.begin(), s_.events.begun.end(), s_.events.kept.begin(), s_.events.kept.end(),
                   std::back_inserter(told), world::comes_before);
    expect(told == s_.pairs, "what has begun and is kept is not what meets");
    expect(told.size() == s_.events.begun.size() + s_.events.kept.size(), "a pair has begun and is kept");
    expect(ascends(s_.events.ended, world::comes_before), "pairs that have ended are not in order, or told twice");
    for (const WorldPair& p : s_.events.ended) {
      expect(!is_told(p), "bodies ", p.id_a, " and ", p.id_b, " have ended to meet, and meet");
    }
    for (const NearPair& p : s_.near) {
      if (!p.is_known || !are_as_committed(p.pair)) continue;
      const bool meets = p.pair.relation != Relation::disjoint;
      expect(meets == is_told(p.pair), "bodies ", p.pair.id_a, " and ", p.pair.id_b,
             meets ? " meet and are not told" : " are told and do not meet");
      if (!is_sampled(p.pair)) continue;
      expect(relation_of_parts(s_.bodies[p.pair.a.slot]->placed, s_.bodies[p.pair.b.slot]->placed) == p.pair.relation,
             "bodies ", p.pair.id_a, " and ", p.pair.id_b, " are otherwise than what is kept of them when asked again");
    }
    for (const WorldPair& p : s_.pairs) {
      expect(p.relation != Relation::disjoint, "bodies ", p.id_a, " and ", p.id_b, " are told as a pair and apart");
    }
  }
  /// One of both is; slots ascend.
  [[nodiscard]] bool is_sampled(const WorldPair& p) const {
    return std::ranges::binary_search(sampled_, p.a.slot) || std::ranges::binary_search(sampled_, p.b.slot);
  }
  [[nodiscard]] bool is_told(const WorldPair& p) const {
    return std::binary_search(s_.pairs.begin(), s_.pairs.end(), p, world::comes_before);
  }

  void look_at_contacts() {
    if (!s_.options.contacts) return;
    expect(ascends(s_.contacts,
                   [](const WorldContact& p, const WorldContact& q) { return place_in_order(p) < place_in_order(q); }),
           "contacts are not in order, or told twice");
    std::set<CornerName> corners;
    for (const WorldContact& c : s_.contacts) {
      for (const ContactCorner& k : c.manifold.corners) corners.insert({c.a, c.b, c.part_a, c.part_b, k.id});
    }
    for (const WorldCorner& c : s_.contact_events.begun) {
      expect(corners.contains(name_of(c)), "a corner of bodies ", c.id_a, " and ", c.id_b,
             " has begun, and is none of their contacts");
    }
    for (const WorldCorner& c : s_.contact_events.ended) {
      expect(!corners.contains(name_of(c)), "a corner of bodies ", c.id_a, " and ", c.id_b, " has ended, and is there");
    }
    for (const NearPair& p : s_.near) {
      if (!p.is_known || !are_as_committed(p.pair) || !is_sampled(p.pair)) continue;
      std::vector<WorldContact> again;
      world::add_contacts(p.pair, *s_.bodies[p.pair.a.slot], *s_.bodies[p.pair.b.slot], again);
      const auto is_before = [&](const WorldContact& c) {
        return std::tie(c.id_a, c.id_b, c.a, c.b) < world::order_of(p.pair);
      };
      const auto is_not_behind = [&](const WorldContact& c) {
        return std::tie(c.id_a, c.id_b, c.a, c.b) <= world::order_of(p.pair);
      };
      const auto from = std::partition_point(s_.contacts.begin(), s_.contacts.end(), is_before);
      const auto to = std::partition_point(from, s_.contacts.end(), is_not_behind);
      expect(std::equal(again.begin(), again.end(), from, to, are_one_contact), "contacts of bodies ", p.pair.id_a,
             " and ", p.pair.id_b, " are others when asked again");
    }
  }

  const State& s_;
  std::size_t samples_;
  std::vector<std::uint32_t> slots_, sampled_;
  Complaints complaints_;
};

std::vector<std::string> CollisionWorld::check(std::size_t samples) const { return Inspection(*state_, samples).run(); }

}  // namespace plumb
