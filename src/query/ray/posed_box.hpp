// Where does a ray as given first hit a box under a pose?  The image is never made: its six halfspaces are.
//
// Laws: those of query/ray/posed.hpp; nothing is told of a box or a pose whose three axes have no volume, nor of other
// figures, nor of a ray that is posed.
// Source: RTCD 4.4, 5.3.3.
// Cost: some hundred operations where doubles tell the signs, some microseconds by integers.
#pragma once

#include <optional>

#include "plumb/query/body/posed.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb::query {

/// Is nothing where it is not told; an answer says whether there is a hit.
std::optional<std::optional<Hit>> first_hit_of_box(const PosedView& ray, const PosedView& figure);
std::optional<std::optional<RayParameter>> first_parameter_of_box(const PosedView& ray, const PosedView& figure);

}  // namespace plumb::query
