// What is the sign of the determinant of these doubles, exactly?  Of 2, 3, 4 and 5 rows.
//
// Laws: swapping two rows or columns flips the sign, transposing keeps it; zero exactly when the rows are dependent.
// An entry that is NaN or infinite throws NonFinite, naming it ("determinant3: b.y", the second row's second entry, or,
// beyond three rows, "coordinate 7", counted from 0 row by row).
// Source: RTCD 3.1.3.
// Cost: a call and the filter (docs/predicates.md).
#pragma once

#include <array>
#include <cstddef>

#include "plumb/arith/sign.hpp"

namespace plumb {

/// Rows of N entries.
template <std::size_t N>
using Rows = std::array<std::array<double, N>, N>;

Sign determinant_sign(const Rows<2>& rows);
Sign determinant_sign(const Rows<3>& rows);
Sign determinant_sign(const Rows<4>& rows);
Sign determinant_sign(const Rows<5>& rows);

}  // namespace plumb
