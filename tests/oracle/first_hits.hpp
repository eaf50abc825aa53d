// Does a ray, a segment or a line hit it, by CGAL's own statements?
//
// Laws: exact for all finite doubles.  Nothing is answered where CGAL asks for a figure that is not degenerate.
// Source: CGAL's manual, "2D and 3D Linear Geometry Kernel".
// Cost: some 10 us a question.
#pragma once

#include <optional>

#include "plumb/query/ray/ray.hpp"

namespace plumb::oracle {

std::optional<bool> is_hit(const AnyRay& ray, const Triangle3& triangle);
std::optional<bool> is_hit(const AnyRay& ray, const Tetrahedron3& tetrahedron);
std::optional<bool> is_hit(const AnyRay& ray, const Aabb3& box);
std::optional<bool> is_hit(const AnyRay& ray, const Sphere3& sphere);
std::optional<bool> is_hit(const AnyRay& ray, const Plane3& plane);

}  // namespace plumb::oracle
