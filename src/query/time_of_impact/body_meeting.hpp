// Time of impact: when do two bodies that move along lines first meet, and with which features?  Of any kinds that have
// vertices, edges and faces.
//
// Laws: those of query/time_of_impact/translating_contact.hpp, of numbers that doubles do not tell quickly.
// Source: RTCD 5.5.2 to 5.5.7.
// Cost: some microseconds where running errors tell which features meet first; some tens where several meet at once,
// hundreds where no axis tells the time.
#pragma once

#include <optional>
#include <string_view>
#include <tuple>

#include "plumb/arith/root.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/time_of_impact/motion.hpp"
#include "query/time_of_impact/moving_body.hpp"

namespace plumb::query {

struct BodyMotion {
  PosedView shape;
  const Vector3* by;
  const std::array<Vector3, 3>* columns = nullptr;  // of a matrix that maps `by`, where there is one
  double radius = 0;                                // within which of the shape all is meant, under a rigid pose
};

/// How shapes lie to one another at time 0.
using StartRelation = Relation (*)(const BodyMotion& a, const BodyMotion& b);

/// Of features that meet at once those of the lowest rank are told.
inline auto rank(const Feature& a, const Feature& b) {
  return std::tuple(static_cast<int>(a.kind) + static_cast<int>(b.kind), a.kind, a.index, b.kind, b.index);
}

/// Of two motions, that of errors in their numbers.
std::optional<Root> body_contact_time(std::string_view function, const BodyMotion& a, const BodyMotion& b,
                                      StartRelation at_start);
std::optional<Contact> body_contact(std::string_view function, const BodyMotion& a, const BodyMotion& b,
                                    StartRelation at_start);
/// Both of them.
struct FirstMeeting {
  Root time;
  Feature of_a, of_b;
};
std::optional<FirstMeeting> first_meeting(std::string_view function, const BodyMotion& a, const BodyMotion& b,
                                          StartRelation at_start);
bool bodies_meet(std::string_view function, const BodyMotion& a, const BodyMotion& b, StartRelation at_start);

}  // namespace plumb::query
