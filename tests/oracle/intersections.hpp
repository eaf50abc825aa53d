// What do two figures have in common, by CGAL's exact intersections?
//
// Laws: exact for all finite doubles; the vertices are CGAL's, in rational coordinates, sorted.  Nothing is answered
// where CGAL asks for a figure that is not degenerate, or for common sets that go on forever.  Of triangles and boxes
// of the plane CGAL 5.5 tells corners of the box that are outside of the triangle: it is not asked.
// Source: CGAL's manual, "2D and 3D Linear Geometry Kernel".
// Cost: some 100 us a question.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumb/figure.hpp"

namespace plumb::oracle {

/// Every vertex as its coordinates, quotients in lowest terms, one after the other: {"1/3", "2"}.
using CommonVertices = std::optional<std::vector<std::vector<std::string>>>;

CommonVertices common_vertices(const Segment2& a, const Segment2& b);
CommonVertices common_vertices(const Line2& a, const Triangle2& b);
CommonVertices common_vertices(const Segment2& a, const Triangle2& b);
CommonVertices common_vertices(const Triangle2& a, const Triangle2& b);
CommonVertices common_vertices(const Segment2& a, const Aabb2& b);

CommonVertices common_vertices(const Segment3& a, const Segment3& b);
CommonVertices common_vertices(const Line3& a, const Plane3& b);
CommonVertices common_vertices(const Segment3& a, const Triangle3& b);
CommonVertices common_vertices(const Line3& a, const Triangle3& b);
CommonVertices common_vertices(const Segment3& a, const Aabb3& b);
CommonVertices common_vertices(const Plane3& a, const Triangle3& b);
CommonVertices common_vertices(const Plane3& a, const Tetrahedron3& b);
CommonVertices common_vertices(const Plane3& a, const Aabb3& b);
CommonVertices common_vertices(const Triangle3& a, const Triangle3& b);
CommonVertices common_vertices(const Triangle3& a, const Aabb3& b);
CommonVertices common_vertices(const Triangle3& a, const Tetrahedron3& b);

/// Where three planes meet in one point.
CommonVertices common_vertices(const Plane3& a, const Plane3& b, const Plane3& c);

}  // namespace plumb::oracle
