// Expanding polytope (EPA): does a surface that was guessed prove which planes around a difference are nearest to the
// origin?
//
// The triangles are closed and have the origin on their inner side, all of them: so every ray from it meets one, no
// nearer than the triangle's plane.  What is nearer than all of these planes is within the difference.  Where the
// nearest planes have nothing of the difference before them, they are its own nearest ones.  Where the origin lies in
// some of the planes, and the difference is on the inner side of these, they are all of its planes through the origin:
// a point that is near and on the inner side of these is on the inner side of all, and so within.
// Laws: signs are exact; that the surface is convex is not asked, nor whether the origin is within before it is proved.
// What it does not prove is not told.
// Source: van den Bergen 2001.
// Cost: 5 operations a triangle that is farther than the nearest for certain (query/penetration/triangle_plane.hpp); of
// others some 40 in running errors, and a sign for each corner beside a nearest one.
#pragma once

#include "query/penetration/search.hpp"

namespace plumb::query::parting {

/// Of a difference that has the origin inside, or on its boundary; nothing where that is not proved.
std::optional<NearestPlanes> proved_planes(const Difference& d);
/// From four of its points that are not in one plane.
std::optional<NearestPlanes> proved_planes(const Difference& d, const std::array<Ends, 4>& start);

}  // namespace plumb::query::parting
