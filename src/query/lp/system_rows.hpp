// Linear systems, public and in GMP's numbers.
//
// Laws: InvalidShape for rows of unequal lengths, by the function and the number of the row.
// Source: none.
// Cost: a copy.
#pragma once

#include <string_view>

#include "arith/exact_number.hpp"
#include "arith/rational_lp.hpp"
#include "plumb/query/lp/linear_proof.hpp"

namespace plumb::query {

std::vector<Rational> to_rationals(std::span<const mpq_class> all);
arith::RationalVector to_mpq(std::span<const Rational> all);

/// Of so many variables.
arith::Constraints constraints_of(std::string_view function, const LinearSystem& system, std::size_t dimension);

}  // namespace plumb::query
