// Continuous collision detection: do they surely come as near as a distance while they move, or surely not?  Plain
// doubles.
//
// Laws: yes and no are certain; unsure says nothing.  The differences between points of the two figures are linear in
// time and in the places within both figures, so during a piece of time they lie in the hull of those of vertices at
// its ends: where all of these reach beyond the distance along one direction, whatever direction that is, the figures
// do not come that near then.  Tried is the direction between the points that are nearest in the middle of the piece;
// where these are near enough the answer is yes, else the piece is halved.
// Source: RTCD 5.1.9, 5.2.1, 5.5.1, 11.2.
// Cost: some 100 ns a piece; one where they stay apart, few near a contact; a few us for a time.
#pragma once

#include <string_view>

#include "plumb/query/time_of_impact/motion.hpp"
#include "query/time_of_impact/contact_filter.hpp"

namespace plumb::query::moving {

/// Throws by the name options.separation.
void require_separation(std::string_view function, double separation);

ContactVerdict separation_filter(const ContactQuestion& question, double separation);

/// The first time of a yes, rounded down, and the features.
struct NearContact {
  ContactVerdict verdict = ContactVerdict::unsure;
  Contact contact{};
};
NearContact first_near_contact(const ContactQuestion& question, double separation);

}  // namespace plumb::query::moving
