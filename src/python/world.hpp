// How does Python name what is in a world?  A body by an integer: the generation of its handle above, the slot below.
//
// Source: none.
// Cost: none.
#pragma once

#include "plumb/world/world.hpp"
#include "python/figure_answers.hpp"

namespace plumb::python {

using World = py::class_<CollisionWorld>;

inline std::uint64_t number_of(const BodyHandle& h) { return (std::uint64_t{h.generation} << 32) | h.slot; }
inline BodyHandle handle_of(std::uint64_t n) {
  return {static_cast<std::uint32_t>(n & 0xffffffff), static_cast<std::uint32_t>(n >> 32)};
}
inline py::tuple told_part(const BodyPart& p) { return py::make_tuple(p.part, p.triangle); }

RigidPose rigid_in(const py::object& turn, const py::object& translation, std::string_view function);
ProxyKind proxy_in(const std::string& given, const char* function);

/// What moves along, turns and is hit (world_motion.cpp).
void add_world_motion(World& world);
/// Proxies, and filters of the caller's (world_plan.cpp).
void add_world_plan(World& world);

}  // namespace plumb::python
