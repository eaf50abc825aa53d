// Directions that a body may move along: are they such?
//
// Laws: at least one, finite, of a length above zero; else InvalidShape or NonFinite by name.
// Source: RTCD 11.2.
// Cost: a comparison a number.
#pragma once

#include <span>
#include <string>

#include "plumb/arith/point.hpp"

namespace plumb::query {

/// `is_list`: the argument is called directions, else direction.
void require_directions(const std::string& function, std::span<const Vector3> all, bool is_list);

}  // namespace plumb::query
