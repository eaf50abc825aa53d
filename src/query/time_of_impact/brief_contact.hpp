// Time of impact: do they meet while they move, and when first, where doubles do not tell?  Integers that stand on the
// stack.
//
// Laws: those of query/time_of_impact/continuous_contact.hpp, without separation; or unsure, where integers get too
// long (arith/brief_integer.hpp): exact_contact.hpp has no such limit. Contacts are at roots of the cubic that tells
// when four points are in one plane; there the signs of the projections' sides tell whether they meet.  Of points that
// are in one plane the whole time the first contact is at time 0, or else at a root of a side, because just before it a
// side told them apart.  Where projections along all axes are flat, all of it is on one line then, and coordinates
// tell.
// Source: RTCD 5.5; Brochu, Edwards and Bridson 2012 for what exactness asks.
// Cost: a microsecond or two; nothing is allocated.
#pragma once

#include <optional>

#include "plumb/query/time_of_impact/motion.hpp"
#include "query/time_of_impact/contact_filter.hpp"
#include "query/time_of_impact/contact_wanted.hpp"

namespace plumb::query::moving {

/// Of finite coordinates.  Of a yes the time, rounded down, and the features, where `when` is wanted.
struct BriefContact {
  ContactVerdict verdict = ContactVerdict::unsure;
  Contact contact{};
};
BriefContact brief_contact(const ContactQuestion& question, ContactWanted wanted);

}  // namespace plumb::query::moving
