// On which side of a plane is a corner of a piece, or a point as given?
//
// Laws: exact; positive in front.  A corner on an edge as given lies strictly between the edge's ends: so where these
// are on one side, so is the corner, and no implicit point is asked.  What lies in a plane by its making (a vertex of
// the plane's face, a corner that the plane cut) is told without a sign.
// Source: RTCD 8.3.3; docs/implicit_points.md.
// Cost: a sign or two.
#pragma once

#include "plumb/predicates.hpp"
#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb::space {

inline double along_axis(const Point3& p, std::uint32_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Of coordinates as given.
inline Sign beyond(double x, double at) { return x > at ? Sign::positive : x < at ? Sign::negative : Sign::zero; }

inline bool is_axis_plane(std::uint32_t plane) { return (plane & BspCorner::axis_plane) == BspCorner::axis_plane; }
inline bool is_plane(std::uint32_t code) { return (code & BspCorner::face_plane) != 0; }
inline std::uint32_t number_of_plane(std::uint32_t plane) { return plane & ~BspCorner::axis_plane; }

/// In front of the plane of a node?
inline Sign node_side(const BspTree& tree, const BspNode& node, const Point3& p) {
  if (node.axis < 3) return beyond(along_axis(p, node.axis), node.at);
  const auto& [a, b, c] = tree.planes[number_of_plane(node.plane)];
  return -orient3d(a, b, c, p);
}

/// In front of a plane by its number?
Sign plane_side(const BspTree& tree, std::uint32_t plane, const Point3& p);
Sign corner_side(const BspTree& tree, std::uint32_t plane, std::uint32_t face, const BspCorner& corner);

}  // namespace plumb::space
