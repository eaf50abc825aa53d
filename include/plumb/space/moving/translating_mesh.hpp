// Shape cast, time of impact: when does a mesh that moves along a line first meet another, and with which triangle?
//
//   if (const auto hit = first_contact(part, {0, 0, -10}, table)) use(hit->contact.time, hit->a, hit->b);
//   first_contact({part, turn}, {0, 0, -10}, {table, pose})             // of meshes that have been posed before
//
// a moves by a vector during time [0, 1]; b stands still.  (Where both move, only the difference of their motions
// counts.)
// Laws: (1) nothing where no triangle of a meets one of b at any time of [0, 1]; touching is meeting, also in passing.
// (2) The time is the first at which any two do, exactly; of all pairs that meet then the first by a, then b.  (3) The
// contact is that of first_contact(Translating{triangle a, by}, triangle b): its time is rounded down, never late
// (query/time_of_impact/translating_contact.hpp); first_contact_time is it unrounded.  (4) Surfaces are asked about: a
// mesh within a closed one meets it when it reaches the surface.  (5) The answer depends on the meshes alone, not on
// their trees.  An empty mesh meets nothing; triangles without area are the segments and points that they are.
// (6) Under poses the triangles are the exact images (space/bvh/posed_mesh.hpp), and the vector is one of the world;
// MotionAlong::mesh_a has a's pose map it, exactly, as it maps a's vertices, which b under a matrix of its own excludes
// where a's is rigid (InvalidShape).  So two meshes under one regular pose, and a vector that it maps along with them,
// have the contact and the time that they have without it.
// A vector that is NaN or infinite throws NonFinite.
// Source: RTCD 3.2, 4.2.6, 5.5.2, 6.3.2, 6.3.3.
// Cost: branch and bound over pairs of nodes, always those whose boxes can meet first; a contact of two triangles for
// each pair whose boxes meet before the first contact does.  Of many that land flat at once few are asked: along an
// axis whole nodes are left out, else each corner's side of the plane is looked at once.  Under poses that differ a box
// for each node that is looked at, and some microseconds for each pair of triangles, tens where several features meet at
// once.  Bounded by n^2 log n
// operations, on integers as long as the exponents' span: each pair at most, and their order by time.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/arith/root.hpp"
#include "plumb/query/time_of_impact/motion.hpp"
#include "plumb/space/bvh/mesh_view.hpp"

namespace plumb {

struct MeshContact {
  std::uint32_t a, b;  // triangles, by their numbers in the meshes
  Contact contact;
  friend bool operator==(const MeshContact&, const MeshContact&) = default;
};

/// Which coordinates a motion is given in.
enum class MotionAlong : unsigned char { world, mesh_a };

std::optional<MeshContact> first_contact(const BvhView& a, const Vector3& by, const BvhView& b,
                                         MotionAlong along = MotionAlong::world);

std::optional<Root> first_contact_time(const BvhView& a, const Vector3& by, const BvhView& b,
                                       MotionAlong along = MotionAlong::world);

}  // namespace plumb
