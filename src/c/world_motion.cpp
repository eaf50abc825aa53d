// Worlds: what rays hit, and what is met on the way.
#include "c/worlds.hpp"

using namespace plumb;
using c::figure_of, c::guarded, c::handle_of, c::need, c::rigid_of, c::write_first, c::write_found;

namespace {

AnyRay ray_of(const plumb_figure* given) {
  const AnyFigure figure = figure_of(given, "ray");
  if (const auto* r = get_if<Ray3>(figure)) return *r;
  if (const auto* s = get_if<Segment3>(figure)) return *s;
  if (const auto* l = get_if<Line3>(figure)) return *l;
  throw c::InvalidArgument("ray is no line, ray or segment of space that stands as it is");
}

}  // namespace

extern "C" {

plumb_status plumb_world_first_hit(const plumb_world* world, const plumb_figure* ray, std::uint32_t mask, int* found,
                                   plumb_world_hit* hit) {
  return guarded("plumb_world_first_hit", [&] {
    need(world, "world");
    need(found, "found");
    need(hit, "hit");
    write_found(world->world.first_hit(ray_of(ray), mask), found, hit);
  });
}

plumb_status plumb_world_any_hit(const plumb_world* world, const plumb_figure* ray, std::uint32_t mask, int* answer) {
  return guarded("plumb_world_any_hit", [&] {
    need(world, "world");
    need(answer, "answer");
    *answer = world->world.any_hit(ray_of(ray), mask) ? 1 : 0;
  });
}

plumb_status plumb_world_hits(const plumb_world* world, const plumb_figure* ray, std::uint32_t mask,
                              plumb_world_hit* hits, std::size_t capacity, std::size_t* count) {
  return guarded("plumb_world_hits", [&] {
    need(world, "world");
    need(hits, capacity, "hits");
    need(count, "count");
    write_first(world->world.hits(ray_of(ray), mask), hits, capacity, count);
  });
}

plumb_status plumb_world_first_contact(const plumb_world* world, const plumb_figure* figure, const double* by,
                                       std::uint32_t mask, int* found, plumb_world_cast* cast) {
  return guarded("plumb_world_first_contact", [&] {
    need(world, "world");
    need(by, "by");
    need(found, "found");
    need(cast, "cast");
    write_found(world->world.first_contact(figure_of(figure, "figure"), {by[0], by[1], by[2]}, mask), found, cast);
  });
}

plumb_status plumb_world_contacts_along(const plumb_world* world, const plumb_figure* figure, const double* by,
                                        std::uint32_t mask, plumb_world_cast* casts, std::size_t capacity,
                                        std::size_t* count) {
  return guarded("plumb_world_contacts_along", [&] {
    need(world, "world");
    need(by, "by");
    need(casts, capacity, "casts");
    need(count, "count");
    const Vector3 way{by[0], by[1], by[2]};
    write_first(world->world.contacts_along(figure_of(figure, "figure"), way, mask), casts, capacity, count);
  });
}

plumb_status plumb_world_first_contacts(const plumb_world* world, const plumb_body_motion* motions,
                                        std::size_t motion_count, plumb_world_impact* impacts, std::size_t capacity,
                                        std::size_t* count) {
  return guarded("plumb_world_first_contacts", [&] {
    need(world, "world");
    need(motions, motion_count, "motions");
    need(impacts, capacity, "impacts");
    need(count, "count");
    std::vector<BodyMotion> all;
    for (std::size_t i = 0; i < motion_count; ++i) {
      const plumb_body_motion& m = motions[i];
      all.push_back({handle_of(m.body), {m.by[0], m.by[1], m.by[2]}});
    }
    write_first(world->world.first_contacts(all), impacts, capacity, count);
  });
}

plumb_status plumb_world_first_contact_spans(const plumb_world* world, const plumb_body_turn* turns,
                                             std::size_t turn_count, double resolution, plumb_world_span* spans,
                                             std::size_t capacity, std::size_t* count) {
  return guarded("plumb_world_first_contact_spans", [&] {
    need(world, "world");
    need(turns, turn_count, "turns");
    need(spans, capacity, "spans");
    need(count, "count");
    std::vector<BodyTurn> all;
    for (std::size_t i = 0; i < turn_count; ++i) all.push_back({handle_of(turns[i].body), rigid_of(turns[i].to)});
    write_first(resolution == 0 ? world->world.first_contact_spans(all)
                                : world->world.first_contact_spans(all, {.resolution = resolution}),
                spans, capacity, count);
  });
}

plumb_status plumb_world_contact_spans_along(const plumb_world* world, const plumb_figure* figure,
                                             const plumb_rigid3* to, std::uint32_t mask, double resolution,
                                             plumb_cast_span* spans, std::size_t capacity, std::size_t* count) {
  return guarded("plumb_world_contact_spans_along", [&] {
    need(world, "world");
    need(to, "to");
    need(spans, capacity, "spans");
    need(count, "count");
    const AnyFigure moving = figure_of(figure, "figure");
    const RigidPose last = rigid_of(*to);
    write_first(resolution == 0 ? world->world.contact_spans_along(moving, last, mask)
                                : world->world.contact_spans_along(moving, last, mask, resolution),
                spans, capacity, count);
  });
}

}  // extern "C"
