// Is a cell without notches convex, and which are its faces?
//
// Law: what is told is convex: every corner is in every face's plane or below it, exactly; where the boundary of a
// closed set lies in planes that have nothing of it above, the set is what lies below all of them.
// Source: Minkowski's theorem of support.
// Cost: a sign for each corner and face.
#pragma once

#include <variant>

#include "plumb/surface/parts/convex_parts.hpp"
#include "surface/parts/cut_cell.hpp"

namespace plumb::surface {

/// A plane with something of the cell above it and below.
struct DividingPlane {
  std::uint32_t plane;
};

std::variant<ConvexPart, DividingPlane> whole_faces(CutSpace& space, const CutCell& cell);

}  // namespace plumb::surface
