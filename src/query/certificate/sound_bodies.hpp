// Are these two bodies, polyhedra that are what they say among them?
//
// Laws: those of query/separation/convex_body.hpp; a ConvexPolyhedron3 is checked (figure/basic/polyhedron.hpp),
// whoever filled it in.
// Source: RTCD 9.1.
// Cost: that of check_polyhedron.
#pragma once

#include <array>
#include <string>

#include "plumb/figure/basic/polyhedron.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query {

inline std::array<Body, 2> sound_bodies(std::string_view function, const BodyView& a, const BodyView& b) {
  std::array<Body, 2> bodies = bodies_of(function, a, b);
  const bool alike = bodies[0].corners.polyhedron() != nullptr && bodies[1].corners.polyhedron() != nullptr;
  for (std::size_t i = 0; i < 2; ++i) {
    if (const ConvexPolyhedron3* p = bodies[i].corners.polyhedron()) {
      const std::string_view name = !alike ? "polyhedron" : i == 0 ? "a" : "b";
      check_polyhedron(*p, std::string(function).append(": ").append(name));
    }
  }
  return bodies;
}

}  // namespace plumb::query
