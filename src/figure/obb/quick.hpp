// Separating axis test: do doubles prove how an oriented box lies to another one, or to one with the axes of space?
//
// Laws: an answer is that of real arithmetic.  Plain doubles have none for what is near to zero; pairs of doubles, and
// doubles on a lattice of few bits, tell that too, as a rule: touching, stacked, parallel.  What is not finite or
// beyond 2^107 gets none, nor does a first box whose axes lie in a plane.  An axis-aligned box that is empty is one of
// negative extent here: who asks has looked.
// Source: RTCD 4.4.1; docs/proof.md, "Tracked errors".
// Cost: 10 to 35 ns, four lanes at a time where the machine has them; near_relation 60 to 200; twice that elsewhere.
#pragma once

#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

std::optional<Relation> quick_relation(const Obb3& a, const Obb3& b);
std::optional<Relation> quick_relation(const Aabb3& a, const Obb3& b);

/// For what that leaves.
std::optional<Relation> near_relation(const Obb3& a, const Obb3& b);
std::optional<Relation> near_relation(const Aabb3& a, const Obb3& b);

}  // namespace plumb
