// Continuous self-collision of a mesh that moves from under one pose to under another: which parts meet, when first?
//
//   for (const MotionContact& c : contacts_in_motion({cloth, pose_now, pose_next})) resolve(c);
//
// At time t in [0, 1] vertex i is at (1 - t) P + t Q, of which P is the image of mesh.from[i] under the one pose, Q that
// of mesh.to[i] under the other, in between along a line.  The two poses may be the same, and of different kinds.
// Laws: those of motion_contacts.hpp, of the exact images, which are not rounded.  So under one pose at both times
// contacts are those without it, and at the same times, where its matrix is regular and no separation is asked for.
// The mesh must outlive the PosedMovingMesh.
// A pose that is NaN or infinite throws NonFinite ("first_contact: mesh.from.translation.x is nan, ...").
// Source: RTCD 3.2, 4.2.6, 5.5, 6.3.3; Provot 1997.
// Cost: under one regular pose, without a separation, that of the mesh without it.  Else two boxes for each node
// and vertex, a microsecond for each pair whose boxes meet, and tens for each that meets or nearly does; with
// a separation ten times as many.  Bounded by n^2 contacts of pairs, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/moving/motion_contacts.hpp"

namespace plumb {

struct PosedMovingMesh {
  const MovingMesh& mesh;
  MeshPose from, to;

  PosedMovingMesh(const MovingMesh& m, const Pose& at_0, const Pose& at_1) : mesh(m), from(at_0), to(at_1) {}
  PosedMovingMesh(const MovingMesh& m, const MeshPose& at_0, const MeshPose& at_1) : mesh(m), from(at_0), to(at_1) {}
  PosedMovingMesh(MovingMesh&&, const MeshPose&, const MeshPose&) = delete;  // which would not live
};

std::vector<MotionContact> contacts_in_motion(const PosedMovingMesh& mesh, const MotionContactOptions& options = {},
                                              std::vector<MotionContact> rows = {});

std::vector<MotionContact> contacts_by_time(const PosedMovingMesh& mesh, const MotionContactOptions& options = {},
                                            std::vector<MotionContact> rows = {});

std::optional<MotionContact> first_contact(const PosedMovingMesh& mesh, const MotionContactOptions& options = {});

}  // namespace plumb
