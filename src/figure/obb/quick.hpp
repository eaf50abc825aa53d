// Separating axis test: do plain doubles prove how an oriented box lies to another one, or to one with the axes of
// space?
//
// Laws: an answer is that of real arithmetic; whatever is near to zero, not finite, or beyond 2^107 gets none.  An
// axis-aligned box that is empty is one of negative extent here: who asks has looked.
// Source: RTCD 4.4.1.
// Cost: 10 to 20 ns, four lanes at a time where the machine has them; twice that elsewhere.
#pragma once

#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

std::optional<Relation> quick_relation(const Obb3& a, const Obb3& b);
std::optional<Relation> quick_relation(const Aabb3& a, const Obb3& b);

}  // namespace plumb
