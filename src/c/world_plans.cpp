// Worlds: what may be asked in place of a body first, and terrains.
#include "c/worlds.hpp"
#include "plumb/world/heightfield.hpp"
#include "plumb/world/plan.hpp"

using namespace plumb;
using c::guarded, c::handle_of, c::need, c::need_size, c::number_of;

namespace {

ProxyKind proxy_of_number(int given) {
  c::need_choice(given, PLUMB_PROXY_HULL, "proxy");
  return static_cast<ProxyKind>(given);
}

plumb_body_plan told_body(const BodyPlan& b) {
  return {number_of(b.body), b.user_id, b.pairs, b.told_apart, b.saved, static_cast<std::int32_t>(b.proxy)};
}

}  // namespace

extern "C" {

plumb_status plumb_world_set_proxy(plumb_world* world, plumb_body body, int proxy) {
  return guarded("plumb_world_set_proxy", [&] {
    need(world, "world");
    world->world.set_proxy(handle_of(body), proxy_of_number(proxy));
  });
}

plumb_status plumb_world_proxy(const plumb_world* world, plumb_body body, int* proxy) {
  return guarded("plumb_world_proxy", [&] {
    need(world, "world");
    need(proxy, "proxy");
    *proxy = static_cast<int>(world->world.options(handle_of(body)).proxy);
  });
}

plumb_status plumb_world_plan(const plumb_world* world, plumb_body_plan* bodies, std::size_t capacity,
                              std::size_t* count, plumb_plan_report* report) {
  return guarded("plumb_world_plan", [&] {
    need(world, "world");
    need(bodies, capacity, "bodies");
    need(count, "count");
    if (report != nullptr) need_size(report, "report");
    const WorldPlan made = plan(world->world);
    for (std::size_t i = 0; i < std::min(capacity, made.bodies.size()); ++i) bodies[i] = told_body(made.bodies[i]);
    *count = made.bodies.size();
    if (report != nullptr) c::write(report, plumb_plan_report{0, made.questions_without, made.questions_with});
  });
}

plumb_status plumb_world_adopt(plumb_world* world, const plumb_body_plan* bodies, std::size_t count) {
  return guarded("plumb_world_adopt", [&] {
    need(world, "world");
    need(bodies, count, "bodies");
    WorldPlan taken;
    for (std::size_t i = 0; i < count; ++i) {
      BodyPlan& body = taken.bodies.emplace_back();
      body.body = handle_of(bodies[i].body);
      body.proxy = proxy_of_number(bodies[i].proxy);
    }
    adopt(world->world, taken);
  });
}

plumb_status plumb_heightfield_mesh(const double* heights, std::size_t columns, std::size_t rows, const double* spacing,
                                    const double* origin, plumb_mesh** mesh) {
  return guarded("plumb_heightfield_mesh", [&] {
    need(mesh, "mesh");
    if (columns != 0 && rows > SIZE_MAX / sizeof(double) / columns) throw InvalidShape("columns and rows are too many");
    need(heights, columns * rows, "heights");
    Heightfield field;
    field.columns = columns;
    field.heights.assign(heights, heights + columns * rows);
    if (spacing != nullptr) field.spacing = {spacing[0], spacing[1]};
    if (origin != nullptr) field.origin = {origin[0], origin[1], origin[2]};
    *mesh = new plumb_mesh{mesh_of(field)};
  });
}

}  // extern "C"
