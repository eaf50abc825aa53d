// Have two meshes been moved alike, so that a question about both is the question without poses?  And which of two posed
// boxes is to be divided?
//
// Source: RTCD 3.2, 6.3.3.
// Cost: a determinant.
#pragma once

#include <algorithm>

#include "plumb/predicates.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb::space {

/// Then it maps one to one, and what is in common has an image of its own.
inline bool is_regular(const Pose& pose) {
  const auto point = [](const Vector3& v) { return Point3{v.x, v.y, v.z}; };
  const auto& c = pose.columns;
  return orient3d(point(c[0]), point(c[1]), point(c[2]), Point3{0, 0, 0}) != Sign::zero;
}

/// Is it the question without poses?
template <class Mesh>
bool are_moved_alike(const char* function, const PosedMeshOf<Mesh>& a, const PosedMeshOf<Mesh>& b) {
  require_pose(function, "a", a.pose);
  require_pose(function, "b", b.pose);
  return a.pose == b.pose && is_regular(a.pose);
}

/// The same of one mesh and itself.
template <class Mesh>
bool is_moved_regularly(const char* function, const PosedMeshOf<Mesh>& mesh) {
  require_pose(function, "mesh", mesh.pose);
  return is_regular(mesh.pose);
}

/// Which of two posed boxes is to be descended; a guess.
inline Descend larger_posed(const Aabb3& a, const Aabb3& b) {
  const auto size = [](const Aabb3& x) { return std::max({x.max.x - x.min.x, x.max.y - x.min.y, x.max.z - x.min.z}); };
  return size(a) < size(b) ? Descend::second : Descend::first;
}

}  // namespace plumb::space
