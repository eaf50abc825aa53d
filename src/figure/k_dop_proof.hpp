// Is there a point inside a k-DOP, or none in it at all?  A guess in plain doubles, and its proof by exact signs.
//
// The guess: the greatest slack that all halfspaces can have at once, by the simplex method on the dual program.  Its
// proofs: a point with slack everywhere, or, for n dimensions, n + 1 halfspaces without a common point: their normals
// combine to zero with factors of one sign (the cofactors of their matrix), their limits to a negative number (its
// determinant).
// Laws: what is answered is true; nothing is answered where neither proof holds, as for sets without interior.
// Source: Farkas' lemma; RTCD 9.4.  Cost: about a microsecond.
#pragma once

#include <optional>

#include "plumb/figure/k_dop.hpp"

namespace plumb::figure {

/// True: some point is inside.  False: the set is empty.
std::optional<bool> has_inner_point(const KDop2& k_dop);
std::optional<bool> has_inner_point(const KDop3& k_dop);

}  // namespace plumb::figure
