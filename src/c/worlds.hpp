// What does the handle of a world hold, and how is what is in a world named and told in C?
//
// Laws: a body is named by a number: the generation of its handle above, the slot below.
// Source: none.
// Cost: none.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "c/figures.hpp"
#include "c/handles.hpp"
#include "plumb/world/world.hpp"

/// The world, and what of it is told by pointers.
struct plumb_world {
  explicit plumb_world(const plumb::CollisionWorldOptions& options) : world(options), has_contacts(options.contacts) {}

  plumb::CollisionWorld world;
  bool has_contacts;
  std::vector<plumb_world_pair> begun, kept, ended, pairs;
  std::vector<plumb_world_contact> contacts;
  std::vector<plumb_corner> corners;
  std::vector<plumb_world_corner> begun_corners, ended_corners;
};

namespace plumb::c {

inline plumb_body number_of(const BodyHandle& h) { return (std::uint64_t{h.generation} << 32) | h.slot; }
inline BodyHandle handle_of(plumb_body n) {
  return {static_cast<std::uint32_t>(n & 0xffffffff), static_cast<std::uint32_t>(n >> 32)};
}
inline plumb_part told_part(const BodyPart& p) { return {p.part, p.triangle}; }
inline plumb_feature told_feature(const Feature& f) { return {static_cast<std::int32_t>(f.kind), f.index}; }

inline plumb_world_pair told(const WorldPair& p) {
  return {p.id_a, p.id_b, number_of(p.a), number_of(p.b), static_cast<std::int32_t>(p.relation)};
}
inline plumb_world_near told(const WorldNear& n) {
  return {n.user_id, number_of(n.body), told_part(n.part), n.distance};
}
inline plumb_world_near_pair told(const WorldNearPair& p) {
  return {p.id_a, p.id_b, number_of(p.a), number_of(p.b), told_part(p.part_a), told_part(p.part_b), p.distance};
}
inline plumb_body told(const BodyHandle& h) { return number_of(h); }

inline plumb_world_corner told(const WorldCorner& k) {
  return {k.id_a,
          k.id_b,
          number_of(k.a),
          number_of(k.b),
          told_part(k.part_a),
          told_part(k.part_b),
          told_feature(k.id.a),
          told_feature(k.id.b)};
}

inline plumb_world_hit told(const WorldHit& h) {
  plumb_world_hit to{h.user_id, number_of(h.body), told_part(h.part), h.hit.t, {}, {}};
  copy(to.point, h.hit.point), copy(to.normal, h.hit.normal);
  return to;
}
inline plumb_world_cast told(const WorldCast& k) {
  return {k.user_id,
          number_of(k.body),
          told_part(k.part),
          k.contact.time,
          told_feature(k.contact.feature_a),
          told_feature(k.contact.feature_b)};
}
inline plumb_world_impact told(const WorldImpact& i) {
  return {i.id_a,
          i.id_b,
          number_of(i.a),
          number_of(i.b),
          told_part(i.part_a),
          told_part(i.part_b),
          i.contact.time,
          told_feature(i.contact.feature_a),
          told_feature(i.contact.feature_b),
          i.rank};
}
inline plumb_world_span told(const WorldContactSpan& s) {
  return {s.id_a, s.id_b, number_of(s.a), number_of(s.b), s.span.from, s.span.to, s.is_certain};
}

inline plumb_cast_span told(const WorldCastSpan& s) {
  return {s.user_id, number_of(s.body), s.span.from, s.span.to, s.is_certain};
}

template <class Item>
auto all_told(const std::vector<Item>& items) {
  std::vector<decltype(told(items.front()))> all;
  all.reserve(items.size());
  for (const Item& item : items) all.push_back(told(item));
  return all;
}

/// The first of them, as many as there is room for.
template <class Item, class Told>
void write_first(const std::vector<Item>& items, Told* to, std::size_t capacity, std::size_t* count) {
  for (std::size_t i = 0; i < std::min(capacity, items.size()); ++i) to[i] = told(items[i]);
  *count = items.size();
}
template <class Item, class Told>
void write_found(const std::optional<Item>& item, int* found, Told* to) {
  if (item) *to = told(*item);
  *found = item ? 1 : 0;
}

}  // namespace plumb::c
