// What does a part of a body answer alone: where a ray hits it, how far it is, and when a figure that moves comes to it?
//
// Laws: an answer is that of the figure, of a mesh that of the triangle that is first or nearest, of several the one of
// the lowest number; numbers are rounded once, and what is exact is asked for where they are equal.
// Source: RTCD 2.4.
// Cost: that of the questions.
#pragma once

#include <optional>

#include "plumb/arith/exact_distance.hpp"
#include "plumb/arith/root.hpp"
#include "world/placed.hpp"

namespace plumb::world {

/// The triangle is 0 of a figure.
struct PartHit {
  std::uint32_t triangle;
  Hit hit;
};
std::optional<PartHit> first_hit(const Placed& part, const AnyRay& ray);
/// The exact parameter, where there is a hit.
RayParameter hit_parameter(const Placed& part, std::uint32_t triangle, const AnyRay& ray);
bool is_hit(const Placed& part, const AnyRay& ray);

struct PartDistance {
  std::uint32_t triangle;
  double distance;
};
PartDistance distance_to(const Placed& part, const AnyFigure& figure);
ExactDistance exact_distance_to(const Placed& part, std::uint32_t triangle, const AnyFigure& figure);

struct PartsDistance {
  std::uint32_t triangle_a, triangle_b;
  double distance;
};
PartsDistance distance_of_parts(const Placed& a, const Placed& b);
ExactDistance exact_distance_of_parts(const Placed& a, std::uint32_t triangle_a, const Placed& b,
                                      std::uint32_t triangle_b);

/// What moves by a vector during time [0, 1].
struct PartInMotion {
  const Placed& part;
  Vector3 by;
};
struct PartTime {
  std::uint32_t triangle_a, triangle_b;
  Contact contact;
};
std::optional<PartTime> first_contact(const PartInMotion& a, const PartInMotion& b);
/// The exact time of that.
Root contact_time(const PartInMotion& a, const PartInMotion& b, const PartTime& of);

/// All places of it, rounded outward.
Aabb3 swept(const Aabb3& box, const Vector3& by);

}  // namespace plumb::world
