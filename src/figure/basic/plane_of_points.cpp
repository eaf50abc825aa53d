#include "figure/basic/plane_of_points.hpp"

#include <string>

#include "plumb/arith/error.hpp"

namespace plumb {

void require_planar(std::string_view function, std::string_view name, const PlaneOfPoints& plane) {
  if (plane.dimension < 3) return;
  throw InvalidShape(std::string(function)
                         .append(": the ")
                         .append(name)
                         .append(" is not planar: its vertex ")
                         .append(std::to_string(plane.off))
                         .append(" is off the plane of the vertices ")
                         .append(std::to_string(plane.span[0]))
                         .append(", ")
                         .append(std::to_string(plane.span[1]))
                         .append(" and ")
                         .append(std::to_string(plane.span[2]))
                         .append("; triangulate it"));
}

}  // namespace plumb
