// Which sides of two boxes face each other, and which corners have they in common?  By doubles whose errors are derived.
//
// Laws: what is told is exact; nothing where a sign is not certain, and of anything but boxes as they stand or under poses of
// doubles, each of whose edges has a length, and the normal of two of their axes.
// Source: query/contact/facing_sides.hpp.
// Cost: some 500 operations; no allocation.
#pragma once

#include "query/contact/contact_pair.hpp"

namespace plumb::query::touching {

/// Is it told?
bool match_boxes(const Pair& pair, Matched& m);

}  // namespace plumb::query::touching
