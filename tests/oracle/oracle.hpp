// What is the true sign?  Two judges that share nothing with the stages under test.
//
// Laws: both are exact for all finite doubles, subnormals and the largest included.  The rational judge runs the
// formula of predicates/ over GMP's rationals: it proves the evaluation.  CGAL states each predicate on its own, over
// its exact rational kernel: it proves the statement.  Signs follow our convention (predicates.hpp).
// Source: RTCD 3.1.6; CGAL's manual, "2D and 3D Linear Geometry Kernel".
// Cost: 2 to 50 us a sign.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "plumb/arith/sign.hpp"

namespace plumb::oracle {

/// The formula of that name over rationals.  Throws std::invalid_argument for a name that the manifest does not hold.
Sign rational_sign(std::string_view predicate, std::span<const double> coordinates);

/// CGAL's answer; nothing for a predicate that CGAL does not have.
std::optional<Sign> cgal_sign(std::string_view predicate, std::span<const double> coordinates);

/// CGAL's answer for a function that composes formulas, by a name of its own (tests/certify/faces_test.cpp).
std::optional<Sign> face_by_cgal(std::string_view face, std::span<const double> coordinates);

}  // namespace plumb::oracle
