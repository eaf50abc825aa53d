// Affine basis: how many dimensions has the difference of two bodies, and which of its points span it?
//
// Laws: 1 to 4 points, which are affinely independent, exactly; every difference of corners is in their affine hull.
// Those that are named are taken before others.
// Cost: a few signs a corner, until there are four.
#pragma once

#include <span>
#include <vector>

#include "query/penetration/difference.hpp"

namespace plumb::query::parting {

std::vector<Ends> affine_basis(const Difference& d, std::span<const Ends> named);

/// Of those that are named alone.
std::vector<Ends> affine_basis_among(const Difference& d, std::span<const Ends> named);

}  // namespace plumb::query::parting
