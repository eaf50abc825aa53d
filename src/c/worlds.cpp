// Worlds: bodies that come and go, which of them meet, and what is near.
#include "c/worlds.hpp"

#include <string>

using namespace plumb;
using c::all_told, c::figure_of, c::guarded, c::handle_of, c::need, c::need_size, c::number_of, c::rigid_of,
    c::told_feature, c::told_part, c::write_first;

namespace {

AnyBody under(const AnyBody& body, const plumb_rigid3* pose) {
  return pose == nullptr ? body : body.under(rigid_of(*pose));
}

AnyBody body_of(const plumb_figure* figures, std::size_t count) {
  need(figures, count, "figures");
  if (count == 1) return AnyBody(figure_of(figures, "figures"));
  std::vector<AnyBody> parts;
  for (std::size_t i = 0; i < count; ++i) parts.emplace_back(figure_of(figures + i, "figures"));
  return AnyBody::compound(parts);
}

BodyOptions options_of(const plumb_body_options* given) {
  if (given == nullptr) return {};
  need_size(given, "options");
  return {given->group, given->mask, given->user_id, given->margin, given->is_static != 0};
}

void keep_contacts(plumb_world& w) {
  std::vector<plumb_corner> corners;
  std::vector<plumb_world_contact> contacts;
  for (const WorldContact& k : w.world.contacts()) {
    const ContactManifold& m = k.manifold;
    plumb_world_contact to{k.id_a,
                           k.id_b,
                           number_of(k.a),
                           number_of(k.b),
                           told_part(k.part_a),
                           told_part(k.part_b),
                           static_cast<std::int32_t>(m.relation),
                           {},
                           m.distance,
                           nullptr,
                           m.corners.size()};
    c::copy(to.normal, m.normal);
    contacts.push_back(to);
    for (const ContactCorner& corner : m.corners) {
      plumb_corner& at = corners.emplace_back();
      c::copy(at.on_a, corner.on_a), c::copy(at.on_b, corner.on_b);
      at.distance = corner.distance;
      at.feature_a = told_feature(corner.id.a), at.feature_b = told_feature(corner.id.b);
    }
  }
  std::size_t next = 0;
  for (plumb_world_contact& k : contacts) k.corners = corners.data() + next, next += k.corner_count;
  const WorldContactEvents& events = w.world.contact_events();
  std::vector<plumb_world_corner> begun = all_told(events.begun), ended = all_told(events.ended);
  w.corners = std::move(corners), w.contacts = std::move(contacts);
  w.begun_corners = std::move(begun), w.ended_corners = std::move(ended);
}

}  // namespace

extern "C" {

plumb_status plumb_world_create(const plumb_world_options* options, plumb_world** world) {
  return guarded("plumb_world_create", [&] {
    need(world, "world");
    CollisionWorldOptions by;
    if (options != nullptr) {
      need_size(options, "options");
      by.contacts = options->contacts != 0;
      by.execution = options->one_thread != 0 ? Execution::serial : Execution::parallel;
    }
    *world = new plumb_world(by);
  });
}

void plumb_world_destroy(plumb_world* world) { delete world; }

plumb_status plumb_world_add(plumb_world* world, const plumb_figure* figures, std::size_t count,
                             const plumb_rigid3* pose, const plumb_body_options* options, plumb_body* body) {
  return guarded("plumb_world_add", [&] {
    need(world, "world");
    need(body, "body");
    *body = number_of(world->world.add(under(body_of(figures, count), pose), options_of(options)));
  });
}

plumb_status plumb_world_add_mesh(plumb_world* world, const plumb_mesh* mesh, const plumb_rigid3* pose,
                                  const plumb_body_options* options, plumb_body* body) {
  return guarded("plumb_world_add_mesh", [&] {
    need(world, "world");
    need(mesh, "mesh");
    need(body, "body");
    *body = number_of(world->world.add(under(AnyBody(SharedMesh(mesh->mesh)), pose), options_of(options)));
  });
}

plumb_status plumb_world_move(plumb_world* world, plumb_body body, const plumb_rigid3* pose) {
  return guarded("plumb_world_move", [&] {
    need(world, "world");
    need(pose, "pose");
    world->world.move(handle_of(body), rigid_of(*pose));
  });
}

plumb_status plumb_world_replace(plumb_world* world, plumb_body body, const plumb_figure* figures, std::size_t count) {
  return guarded("plumb_world_replace", [&] {
    need(world, "world");
    world->world.replace(handle_of(body), body_of(figures, count));
  });
}

plumb_status plumb_world_remove(plumb_world* world, plumb_body body) {
  return guarded("plumb_world_remove", [&] {
    need(world, "world");
    world->world.remove(handle_of(body));
  });
}

plumb_status plumb_world_contains(const plumb_world* world, plumb_body body, int* answer) {
  return guarded("plumb_world_contains", [&] {
    need(world, "world");
    need(answer, "answer");
    *answer = world->world.contains(handle_of(body)) ? 1 : 0;
  });
}

plumb_status plumb_world_size(const plumb_world* world, std::size_t* count) {
  return guarded("plumb_world_size", [&] {
    need(world, "world");
    need(count, "count");
    *count = world->world.size();
  });
}

plumb_status plumb_world_allow_collision(plumb_world* world, plumb_body a, plumb_body b, int allowed) {
  return guarded("plumb_world_allow_collision", [&] {
    need(world, "world");
    world->world.allow_collision(handle_of(a), handle_of(b), allowed != 0);
  });
}

plumb_status plumb_world_set_filter(plumb_world* world, int (*keeps)(plumb_body a, plumb_body b, void* user),
                                    void* user) {
  return guarded("plumb_world_set_filter", [&] {
    need(world, "world");
    if (keeps == nullptr) return world->world.clear_filter();
    world->world.set_filter([keeps, user](const BodyHandle& a, const BodyHandle& b) {
      return keeps(number_of(a), number_of(b), user) != 0;
    });
  });
}

plumb_status plumb_world_commit(plumb_world* world, plumb_world_events* events) {
  return guarded("plumb_world_commit", [&] {
    need(world, "world");
    if (events != nullptr) need_size(events, "events");
    const WorldEvents& now = world->world.commit();
    world->begun = all_told(now.begun), world->kept = all_told(now.kept), world->ended = all_told(now.ended);
    world->pairs = all_told(world->world.pairs());
    if (world->has_contacts) keep_contacts(*world);
    if (events == nullptr) return;
    c::write(events, plumb_world_events{0, world->begun.data(), world->kept.data(), world->ended.data(),
                                        world->begun.size(), world->kept.size(), world->ended.size()});
  });
}

plumb_status plumb_world_pairs(const plumb_world* world, const plumb_world_pair** pairs, std::size_t* count) {
  return guarded("plumb_world_pairs", [&] {
    need(world, "world");
    need(pairs, "pairs");
    need(count, "count");
    *pairs = world->pairs.data(), *count = world->pairs.size();
  });
}

plumb_status plumb_world_contacts(const plumb_world* world, const plumb_world_contact** contacts, std::size_t* count) {
  return guarded("plumb_world_contacts", [&] {
    need(world, "world");
    need(contacts, "contacts");
    need(count, "count");
    static_cast<void>(world->world.contacts());  // refuses where none are kept
    *contacts = world->contacts.data(), *count = world->contacts.size();
  });
}

plumb_status plumb_world_corner_events(const plumb_world* world, plumb_corner_events* events) {
  return guarded("plumb_world_corner_events", [&] {
    need(world, "world");
    need_size(events, "events");
    static_cast<void>(world->world.contact_events());  // refuses where none are kept
    c::write(events, plumb_corner_events{0, world->begun_corners.data(), world->ended_corners.data(),
                                         world->begun_corners.size(), world->ended_corners.size()});
  });
}

plumb_status plumb_world_check(const plumb_world* world, std::size_t samples, char* text, std::size_t capacity,
                               std::size_t* length) {
  return guarded("plumb_world_check", [&] {
    need(world, "world");
    need(text, capacity, "text");
    need(length, "length");
    std::string all;
    for (const std::string& sentence : world->world.check(samples)) all += (all.empty() ? "" : "\n") + sentence;
    if (all.size() < capacity) std::memcpy(text, all.c_str(), all.size() + 1);
    *length = all.size();
  });
}

plumb_status plumb_world_overlaps(const plumb_world* world, const plumb_figure* figure, std::uint32_t mask,
                                  plumb_body* bodies, std::size_t capacity, std::size_t* count) {
  return guarded("plumb_world_overlaps", [&] {
    need(world, "world");
    need(bodies, capacity, "bodies");
    need(count, "count");
    write_first(world->world.overlaps(figure_of(figure, "figure"), mask), bodies, capacity, count);
  });
}

plumb_status plumb_world_nearest(const plumb_world* world, const plumb_figure* figure, std::size_t k,
                                 std::uint32_t mask, plumb_world_near* near_bodies, std::size_t* count) {
  return guarded("plumb_world_nearest", [&] {
    need(world, "world");
    need(near_bodies, k, "near_bodies");
    need(count, "count");
    write_first(world->world.nearest(figure_of(figure, "figure"), k, mask), near_bodies, k, count);
  });
}

plumb_status plumb_world_within(const plumb_world* world, const plumb_figure* figure, double distance,
                                std::uint32_t mask, plumb_world_near* near_bodies, std::size_t capacity,
                                std::size_t* count) {
  return guarded("plumb_world_within", [&] {
    need(world, "world");
    need(near_bodies, capacity, "near_bodies");
    need(count, "count");
    write_first(world->world.within(figure_of(figure, "figure"), distance, mask), near_bodies, capacity, count);
  });
}

plumb_status plumb_world_nearest_pairs(const plumb_world* world, std::size_t k, double within,
                                       plumb_world_near_pair* pairs, std::size_t* count) {
  return guarded("plumb_world_nearest_pairs", [&] {
    need(world, "world");
    need(pairs, k, "pairs");
    need(count, "count");
    write_first(world->world.nearest_pairs(k, within), pairs, k, count);
  });
}

}  // extern "C"
