// What of each mesh lies in one plane?  Its triangles there become as few as bound the same.
//
// Laws: (1) every mesh winds around each point that is on no face as often as before: what neighbors in one plane make up
// is what their rings wind around in it, so often.  (2) Neighbors over an edge of exactly two faces of a mesh, which the
// mesh has as often and turned alike, are one polygon where they lie in one plane, decided exactly.  (3) Vertices go that
// no ring of their mesh passes, or all of them straight between the same two neighbors.  (4) A new face is used by its
// mesh alone; its source is the least triangle of its polygon that turns as the mesh winds.  Polygons that would not have
// fewer triangles stay.  (5) What comes of it depends on the points alone, as the pool does.
// Source: RTCD 12.4, 12.5.1.
// Cost: a sign or two an edge; n log n expected for polygons that are triangulated anew.
#pragma once

#include "surface/solid/face_pool.hpp"

namespace plumb::surface {

FacePool join_coplanar_faces(FacePool pool);

}  // namespace plumb::surface
