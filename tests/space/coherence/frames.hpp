// How do meshes move from frame to frame?  In small steps, by leaps, into places where they are degenerate, and back.
#pragma once

#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb::frames {

using shape_cases::Material;

inline bool is_finite(const Point3& p) { return p.x - p.x == 0 && p.y - p.y == 0 && p.z - p.z == 0; }

/// The vertices of the next frame.
inline std::vector<Point3> next_vertices(Material& m, const std::vector<Point3>& now,
                                         const std::vector<Point3>& first) {
  std::vector<Point3> next = now;
  const auto moved = [&](Point3& p, double x, double y, double z) {
    const Point3 to{p.x + x, p.y + y, p.z + z};
    if (is_finite(to)) p = to;
  };
  switch (m.below(8)) {
    case 0:  // back to the start
      return first;
    case 1:  // all into a plane
      for (Point3& p : next) p.z = next[0].z;
      break;
    case 2:  // all at one point
      next.assign(now.size(), now[m.below(now.size())]);
      break;
    case 3:  // leaps
      for (Point3& p : next) p = m.point3();
      break;
    case 4:  // nothing moves
      break;
    case 5: {  // one bends
      Point3& p = next[m.below(next.size())];
      moved(p, m.number() / 4, m.number() / 4, m.number() / 4);
      break;
    }
    default: {  // a step along an axis
      const double by = m.number() / 8;
      const std::size_t axis = m.below(3);
      for (Point3& p : next) moved(p, axis == 0 ? by : 0, axis == 1 ? by : 0, axis == 2 ? by : 0);
    }
  }
  return next;
}

/// The pose of the next frame.
inline Pose next_pose(Material& m, const Pose& now) {
  const std::size_t kind = m.below(6);
  if (kind == 0) return identity_pose;
  if (kind == 1) return poses::any_pose(m);
  Pose next = now;
  if (kind == 2) return next;
  double& x = kind == 3 ? next.translation.x : kind == 4 ? next.translation.y : next.translation.z;
  const double to = x + m.number() / 8;
  if (to - to == 0) x = to;
  return next;
}

/// A ring of triangles about the z axis that passes another, in small steps.
inline TriangleMesh moved(TriangleMesh mesh, double x, double y) {
  for (Point3& p : mesh.vertices) p = {p.x + x, p.y + y, p.z};
  return mesh;
}

}  // namespace plumb::frames
