// When does a mesh that has been posed and moves along a line first meet another, which may be posed as well?
//
//   if (const auto hit = first_contact({part, turn}, {0, 0, -10}, table)) use(hit->contact.time, hit->a, hit->b);
//
// Laws: those of translating_mesh.hpp, of the exact images (plumb/space/bvh/posed_mesh.hpp).  The vector is one of the
// world; MotionAlong::mesh_a has a's pose map it, exactly, as it maps a's vertices, which b under a matrix of its own
// excludes where a's is rigid (InvalidShape).  So two meshes under one pose,
// and a vector that it maps along with them, have the contact and the time that they have without it, where its matrix
// is regular.
// A pose or a vector that is NaN or infinite throws NonFinite ("first_contact: a.pose.translation.x is nan, ...").
// Source: RTCD 3.2, 4.2.6, 5.5.2, 6.3.2, 6.3.3.
// Cost: under one regular pose that of the meshes without it.  Else a box for each node that is looked at, and some
// microseconds for each pair of triangles whose boxes meet before the first contact, tens where they meet in several
// features at once.  Bounded by n^2 log n operations, on integers as long as the exponents' span: each pair at most,
// and their order by time.
#pragma once

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/moving/translating_mesh.hpp"

namespace plumb {

/// Which coordinates a motion is given in.
enum class MotionAlong : unsigned char { world, mesh_a };

std::optional<MeshContact> first_contact(const PosedMesh& a, const Vector3& by, const PosedMesh& b,
                                         MotionAlong along = MotionAlong::world);

std::optional<Root> first_contact_time(const PosedMesh& a, const Vector3& by, const PosedMesh& b,
                                       MotionAlong along = MotionAlong::world);

}  // namespace plumb
