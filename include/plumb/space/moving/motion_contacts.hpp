// Continuous self-collision: which parts of a mesh meet while its vertices move linearly, and when first?
//
//   for (const MotionContact& c : contacts_in_motion(cloth)) resolve(c);    // vertices on triangles, edges on edges
//   first_contact(cloth)                                                    // the first in time
//   contacts_in_motion({cloth, pose_now, pose_next})                        // from under one pose to under another
//
// Asked are every vertex that a triangle names against every triangle that does not name it, and every two edges
// without a common vertex: what collision handling of cloth and solids asks.  To ask two meshes, put them into one.
// Laws: (1) contacts_in_motion gives exactly the pairs of which first_contact(Moving, Moving) is a contact, each with
// it (query/time_of_impact/continuous_contact.hpp): none is missed, none invented.  They ascend by pair, a, b;
// contacts_by_time gives the same by their exact times, equal ones by pair, a, b.  (2) first_contact is the first of
// contacts_by_time.  (3) Vertices at the same place with different numbers are different: seams that are not welded are
// in contact at time 0.  (4) With a separation, contact is being that near.  (5) The answers depend on the motion
// alone: not on the trees, execution or number of threads.  (6) A mesh without triangles has none; triangles without
// area are the segments and points that they are.  (7) Under poses vertex i is at (1 - t) P + t Q, of which P is the exact
// image of mesh.from[i] under the one, Q that of mesh.to[i] under the other.  So under one regular pose at both times
// contacts are those without it, and at the same times, where it is rigid or no separation is asked for.
// A pose that is none throws as space/bvh/posed_mesh.hpp says.  A separation that is NaN or infinite throws NonFinite,
// a negative one InvalidShape.  progress may stop the search.
// Source: RTCD 3.2, 4.2.6, 5.5, 6.3.3; Provot 1997.
// Cost: a comparison of boxes for each pair of nodes that may meet, then that of continuous_contact.hpp for each pair
// whose boxes meet; some 20 us for each of those whose times round alike where these are to be told apart.  Under poses
// that differ two boxes for each node and vertex, a microsecond for each pair whose boxes meet, and tens for each that
// meets or nearly does; with a separation ten times as many.  Bounded by
// n^2 contacts of pairs, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/bvh/progress.hpp"
#include "plumb/space/moving/moving_mesh.hpp"

namespace plumb {

enum class ContactPair : unsigned char { vertex_triangle, edge_edge };

struct MotionContact {
  ContactPair pair;
  std::uint32_t a, b;  // a vertex and a triangle by their numbers; or two of mesh.edges, a < b
  Contact contact;
  friend bool operator==(const MotionContact&, const MotionContact&) = default;
};

struct MotionContactOptions {
  double separation = 0;  // how near counts as contact
  Execution execution = Execution::parallel;
  Progress progress = {};
};

/// A mesh in motion, as it was given or from one pose to another; the mesh must outlive it.
struct MovingMeshView {
  const MovingMesh& mesh;
  MeshPose from, to;

  MovingMeshView(const MovingMesh& m, const Pose& at_0 = identity_pose, const Pose& at_1 = identity_pose)  // NOLINT
      : mesh(m), from(at_0), to(at_1) {}
  MovingMeshView(const MovingMesh& m, const MeshPose& at_0, const MeshPose& at_1) : mesh(m), from(at_0), to(at_1) {}
};

std::vector<MotionContact> contacts_in_motion(const MovingMeshView& mesh, const MotionContactOptions& options = {},
                                              std::vector<MotionContact> rows = {});

std::vector<MotionContact> contacts_by_time(const MovingMeshView& mesh, const MotionContactOptions& options = {},
                                            std::vector<MotionContact> rows = {});

std::optional<MotionContact> first_contact(const MovingMeshView& mesh, const MotionContactOptions& options = {});

}  // namespace plumb
