// Which points of the difference of two bodies was the last answer found by?  A guess, from frame to frame.
//
// Of bodies that overlap these are the corners of the facet that they leave by and one point far behind it: a surface that
// begins there has its nearest facet at once.  Of others they are the nearest points' corners.
// Laws: what is guessed is proved before it is told; corners that the bodies have not are left out.
// Source: van den Bergen 2001, 2004 (frame coherence).
// Cost: a determinant; of what is kept a farthest corner.
#pragma once

#include "plumb/query/penetration/penetration.hpp"
#include "query/penetration/parted.hpp"

namespace plumb::query::parting {

DifferenceCorners guess_of(const Difference& d, const ContactCache* cache);
void keep(ContactCache* cache, const DifferenceCorners& corners);
/// What bodies that overlap leave by; nothing is kept of other ways.
void keep(ContactCache* cache, const Difference& d, const Parting& p);

/// Where four corners are guessed, and prove it.
std::optional<Parting> parted_as_before(const Difference& d, const DifferenceCorners& guess);

}  // namespace plumb::query::parting
