// Continuous collision tests as cloth solvers commonly have them: rivals of query/time_of_impact/continuous_contact.hpp.
#pragma once

#include <array>

#include "plumb/arith/point.hpp"

namespace plumb::bench {

/// In plain double, with the customary tolerances: a vertex and a triangle, or two edges.
bool plain_contact(bool vertex_face, const std::array<Point3, 4>& at_0, const std::array<Point3, 4>& at_1);

}  // namespace plumb::bench
