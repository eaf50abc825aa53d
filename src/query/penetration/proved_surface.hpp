// Expanding polytope (EPA): does a surface that was guessed prove which planes around a difference are nearest to the
// origin?
//
// The triangles are closed and have the origin on their inner side, all of them: so every ray from it meets one, no
// nearer than the triangle's plane.  What is nearer than all of these planes is within the difference.  Where the
// nearest planes have nothing of the difference before them, they are its own nearest ones.  Where the origin lies in
// some of the planes, and the difference is on the inner side of these, they are all of its planes through the origin:
// a point that is near and on the inner side of these is on the inner side of all, and so within.
// Laws: signs are exact; that the surface is convex is not asked.  What it does not prove is not told.
// Source: van den Bergen 2001; RTCD 9.3.8.
// Cost: some 40 operations a triangle in running errors, and a sign for each corner beside a nearest one.
#pragma once

#include "query/penetration/guessed_surface.hpp"
#include "query/penetration/search.hpp"

namespace plumb::query::parting {

/// Of a difference that the origin is in, and four of its points that are not in one plane.
std::optional<NearestPlanes> proved_planes(const Difference& d, const std::array<Ends, 4>& start);

}  // namespace plumb::query::parting
