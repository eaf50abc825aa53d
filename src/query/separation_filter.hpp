// Do they surely stay farther apart than a distance while they move?  Directions in plain doubles.
//
// Laws: yes is certain; no says nothing.  The differences between vertices of the two figures are linear in time and
// in the places within both figures, so they lie in the hull of those at time 0 and 1: where all of these reach
// beyond the distance along one direction, whatever direction that is, the figures never come that near.
// Tried are the axes, and the normals of the figures at both times.  A difference that is rounded to more than a double
// is more than it, so along the axes nothing else is to be bounded.
// Source: RTCD 5.2.1, 5.5, 11.2.  Cost: some 100 ns.
#pragma once

#include "query/contact_filter.hpp"

namespace plumb::query::moving {

bool surely_apart(const ContactQuestion& question, double separation);

}  // namespace plumb::query::moving
