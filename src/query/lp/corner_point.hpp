// Cramer's rule: where do two lines or three planes meet?  In rational numbers, and rounded once.
//
// Laws: exact; the normals must be independent.  Infinite where the nearest double would be.
// Source: RTCD 3.1.4, 5.4.5; Ziv 1991.
// Cost: some 300 ns rounded, in pairs of doubles; microseconds where they leave a choice, and exact.
#pragma once

#include <gmpxx.h>

#include "query/lp/corner.hpp"

namespace plumb::query {

template <std::size_t D>
Numbers<D> nearest_corner(const std::array<typename LpOf<D>::Halfspace, D>& planes);

template <std::size_t D>
std::array<mpq_class, D> exact_corner(const std::array<typename LpOf<D>::Halfspace, D>& planes);

}  // namespace plumb::query
