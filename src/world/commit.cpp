// What has changed since the last commit is asked again, on all threads, and told beside what has not.
#include <algorithm>
#include <exception>
#include <iterator>
#include <limits>
#include <utility>

#include "plumb/arith/error.hpp"
#include "space/bvh/parts.hpp"
#include "world/part_contacts.hpp"
#include "world/state.hpp"

namespace plumb {
namespace {

using world::about_body, world::comes_before, world::NearPair, world::WorldBody;

bool may_meet(const BodyOptions& a, const BodyOptions& b) {
  return (a.group & b.mask) != 0 && (b.group & a.mask) != 0 && !(a.is_static && b.is_static);
}

bool near_comes_before(const NearPair& p, const NearPair& q) { return comes_before(p.pair, q.pair); }

WorldEvents events_between(const std::vector<WorldPair>& before, const std::vector<WorldPair>& now) {
  WorldEvents events;
  auto old = before.begin();
  for (const WorldPair& p : now) {
    while (old != before.end() && comes_before(*old, p)) events.ended.push_back(*old++);
    const bool is_kept = old != before.end() && !comes_before(p, *old);
    (is_kept ? events.kept : events.begun).push_back(p);
    if (is_kept) ++old;
  }
  events.ended.insert(events.ended.end(), old, before.end());
  return events;
}

auto place_of(const WorldContact& c) { return std::tie(c.id_a, c.id_b, c.a, c.b, c.part_a, c.part_b); }

void add_corners(const WorldContact& of, std::vector<WorldCorner>& to) {
  for (const ContactCorner& c : of.manifold.corners) {
    to.push_back({of.id_a, of.id_b, of.a, of.b, of.part_a, of.part_b, c.id});
  }
}
/// Of one place; corners ascend by their names.
void add_differences(const WorldContact& before, const WorldContact& now, WorldContactEvents& to) {
  const auto &p = before.manifold.corners, &q = now.manifold.corners;
  std::size_t i = 0, j = 0;
  const auto corner = [](const WorldContact& of, const ContactId& id) {
    return WorldCorner{of.id_a, of.id_b, of.a, of.b, of.part_a, of.part_b, id};
  };
  while (i < p.size() || j < q.size()) {
    if (j == q.size() || (i < p.size() && p[i].id < q[j].id)) {
      to.ended.push_back(corner(before, p[i++].id));
    } else if (i == p.size() || q[j].id < p[i].id) {
      to.begun.push_back(corner(now, q[j++].id));
    } else {
      ++i, ++j;
    }
  }
}
WorldContactEvents events_between(const std::vector<WorldContact>& before, const std::vector<WorldContact*>& now) {
  WorldContactEvents events;
  auto old = before.begin();
  for (const WorldContact* at : now) {
    const WorldContact& c = *at;
    for (; old != before.end() && place_of(*old) < place_of(c); ++old) add_corners(*old, events.ended);
    if (old != before.end() && place_of(*old) == place_of(c)) {
      add_differences(*old++, c, events);
    } else {
      add_corners(c, events.begun);
    }
  }
  for (; old != before.end(); ++old) add_corners(*old, events.ended);
  return events;
}

/// What was asked anew, in the order of the pairs.
struct AskedPairs {
  std::vector<Relation> relations;
  std::vector<std::vector<WorldContact>> contacts;  // block by block
};

constexpr std::size_t pairs_in_block = 32;

AskedPairs asked_pairs(const std::vector<WorldPair>& pairs, const std::vector<std::optional<WorldBody>>& bodies,
                       const CollisionWorldOptions& options) {
  AskedPairs asked{std::vector<Relation>(pairs.size(), Relation::disjoint), {}};
  const std::size_t blocks = space::blocks_of(pairs.size(), pairs_in_block);
  asked.contacts.resize(blocks);
  std::vector<std::exception_ptr> thrown(blocks);
  const auto ask = [&](std::size_t i, std::vector<WorldContact>& contacts) {
    const WorldPair& p = pairs[i];
    const WorldBody &a = *bodies[p.a.slot], &b = *bodies[p.b.slot];
    const bool may_touch_apart = options.contacts && (a.options.margin != 0 || b.options.margin != 0);
    if (!may_touch_apart && world::are_apart_by_proxies(a, b)) return;  // disjoint, and without contacts
    about_body("CollisionWorld::commit", p.id_a, [&] {
      about_body("and", p.id_b, [&] {
        const auto told = options.contacts ? world::add_contacts(p, a, b, contacts) : std::nullopt;
        asked.relations[i] = told ? *told : world::relation_of_parts(a.placed, b.placed);
      });
    });
  };
  const Execution execution = blocks < 2 ? Execution::serial : options.execution;
  space::for_blocks(execution, pairs.size(), pairs_in_block, [&](std::size_t block, std::size_t from, std::size_t to) {
    try {
      if (options.contacts) asked.contacts[block].reserve(to - from);
      for (std::size_t i = from; i < to; ++i) ask(i, asked.contacts[block]);
    } catch (...) {
      thrown[block] = std::current_exception();
    }
  });
  for (const std::exception_ptr& e : thrown) {
    if (e) std::rethrow_exception(e);  // of the first pair, on any number of threads
  }
  return asked;
}

/// Those of pairs that were asked anew, and else those of before, in the order of the pairs; neither is copied.
class MergedContacts {
 public:
  MergedContacts(std::vector<WorldContact>& before, AskedPairs& asked) : before_(before), asked_(asked) {}

  void add(const WorldPair& pair, bool is_asked) {
    const auto is_of = [&](const WorldContact& c) { return c.a == pair.a && c.b == pair.b; };
    while (old_ < before_.size() &&
           std::tie(before_[old_].id_a, before_[old_].id_b, before_[old_].a, before_[old_].b) < world::order_of(pair)) {
      ++old_;
    }
    for (; old_ < before_.size() && is_of(before_[old_]); ++old_) {
      if (!is_asked) all_.push_back(&before_[old_]);
    }
    if (!is_asked) return;
    for (WorldContact* c = next(); c != nullptr && is_of(*c); c = next()) all_.push_back(c), ++in_block_;
  }
  [[nodiscard]] const std::vector<WorldContact*>& all() const { return all_; }

 private:
  WorldContact* next() {
    while (block_ < asked_.contacts.size() && in_block_ == asked_.contacts[block_].size()) ++block_, in_block_ = 0;
    return block_ < asked_.contacts.size() ? &asked_.contacts[block_][in_block_] : nullptr;
  }

  std::vector<WorldContact>& before_;
  AskedPairs& asked_;
  std::vector<WorldContact*> all_;
  std::size_t old_ = 0, block_ = 0, in_block_ = 0;
};

}  // namespace

std::optional<WorldPair> CollisionWorld::State::pair_of(const BodyHandle& a, const BodyHandle& b) const {
  const BodyOptions &p = bodies[a.slot]->options, &q = bodies[b.slot]->options;
  if (!may_meet(p, q)) return {};
  const bool swaps = std::tie(q.user_id, b) < std::tie(p.user_id, a);
  return swaps ? WorldPair{q.user_id, p.user_id, b, a, Relation::disjoint}
               : WorldPair{p.user_id, q.user_id, a, b, Relation::disjoint};
}

void CollisionWorld::State::update_near() {
  const auto all_of = [&](const std::vector<HandlePair>& handles) {
    std::vector<NearPair> all;
    for (const HandlePair& p : handles) {
      if (const auto pair = pair_of(p.a, p.b)) all.push_back({*pair});
    }
    std::sort(all.begin(), all.end(), near_comes_before);
    return all;
  };
  const bool was_lost = std::exchange(is_near_lost, true);
  const BoxPairChanges& changes = boxes.changes();
  if (was_lost) {
    near = all_of(boxes.overlapping_pairs());
  } else {
    std::vector<HandlePair> lost = changes.lost;
    std::sort(lost.begin(), lost.end());
    const auto is_lost = [&](const NearPair& p) {
      const HandlePair of =
          p.pair.a.slot < p.pair.b.slot ? HandlePair{p.pair.a, p.pair.b} : HandlePair{p.pair.b, p.pair.a};
      return std::binary_search(lost.begin(), lost.end(), of);
    };
    if (!lost.empty()) std::erase_if(near, is_lost);
    if (!changes.added.empty()) {
      const std::vector<NearPair> added = all_of(changes.added);
      std::vector<NearPair> all;
      all.reserve(near.size() + added.size());
      std::merge(near.begin(), near.end(), added.begin(), added.end(), std::back_inserter(all), near_comes_before);
      near = std::move(all);
    }
  }
  is_near_lost = false;
  for (NearPair& p : near) {
    if (is_changed[p.pair.a.slot] != 0 || is_changed[p.pair.b.slot] != 0) p.is_known = false;
  }
}

std::vector<std::size_t> CollisionWorld::State::admitted() const {
  std::vector<std::size_t> places;
  places.reserve(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (is_admitted(near[i].pair)) places.push_back(i);
  }
  return places;
}

const WorldEvents& CollisionWorld::commit() {
  State& s = *state_;
  s.update_near();
  const std::vector<std::size_t> places = s.admitted();
  std::vector<WorldPair> to_ask;
  for (const std::size_t i : places) {
    if (!s.near[i].is_known) to_ask.push_back(s.near[i].pair);
  }
  AskedPairs asked = asked_pairs(to_ask, s.bodies, s.options);

  std::vector<NearPair> near = s.near;
  std::vector<WorldPair> now;
  now.reserve(places.size());
  MergedContacts merged(s.contacts, asked);
  std::size_t place = 0, next = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    NearPair& p = near[i];
    const bool is_admitted = place < places.size() && places[place] == i;
    if (is_admitted) {
      ++place;
      const bool is_asked = !p.is_known;
      if (is_asked) p.pair.relation = asked.relations[next++];
      if (p.pair.relation != Relation::disjoint) now.push_back(p.pair);
      if (s.options.contacts) merged.add(p.pair, is_asked);
    }
    p.is_known = is_admitted;  // contacts of the others are not kept
  }
  WorldEvents events = events_between(s.pairs, now);
  WorldContactEvents contact_events = events_between(s.contacts, merged.all());
  s.contacts_room.clear();
  s.contacts_room.reserve(merged.all().size());

  // Nothing throws from here on.
  for (WorldContact* c : merged.all()) s.contacts_room.push_back(std::move(*c));
  std::swap(s.contacts, s.contacts_room);
  s.near = std::move(near);
  s.pairs = std::move(now);
  s.events = std::move(events);
  s.contact_events = std::move(contact_events);
  for (const std::uint32_t slot : s.changed) s.is_changed[slot] = 0;
  s.changed.clear();
  return s.events;
}

const std::vector<WorldContact>& CollisionWorld::contacts() const {
  if (!state_->options.contacts) {
    throw Unsupported("CollisionWorld::contacts: this world keeps none; make it with {.contacts = true}");
  }
  return state_->contacts;
}
const WorldContactEvents& CollisionWorld::contact_events() const {
  static_cast<void>(contacts());
  return state_->contact_events;
}

}  // namespace plumb
