// Where do the parts of two bodies touch?  A contact of each two parts, of a mesh one for each triangle.
//
// Laws: contacts ascend by part and triangle; of kinds that contact() has no answer for there is none.  What contact() says
// does not depend on a cache, so none is kept.
// Source: plumb/query/contact/contact.hpp.
// Cost: that of contact() for each two parts and triangles whose boxes are near.
#pragma once

#include <optional>
#include <vector>

#include "world/state.hpp"

namespace plumb::world {

/// The contacts of a pair are put behind those of others.  Tells as well what relate() would, where a contact says it:
/// of two boxes, balls or capsules that have an inside.
std::optional<Relation> add_contacts(const WorldPair& pair, const WorldBody& a, const WorldBody& b,
                                     std::vector<WorldContact>& to);

}  // namespace plumb::world
