#include "plumb/figure/aabb/climbing_aabb.hpp"

#include <unordered_set>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

// The vertex that lies farthest along the direction.  Neighbors that lie equally far are kept in a list, and are
// climbed from in turn: a vertex inside an edge or a face may have no better neighbor where its edge or face has.
std::uint32_t climb(const ConvexPolyhedron3& polyhedron, std::uint32_t from, const Vector3& direction) {
  if (direction == Vector3{0, 0, 0}) return from;
  const auto& vertices = polyhedron.mesh.vertices;
  std::vector<std::uint32_t> level{from};
  std::unordered_set<std::uint32_t> seen;
  const auto farther = [&](std::uint32_t vertex) {  // a neighbor that lies so; those of the same level are noted
    for (const std::uint32_t next : polyhedron.neighbors_of(vertex)) {
      const Sign s = sign_of(predicates::OrderAlongDirection3d{}, vertices[next], vertices[vertex], direction);
      if (s == Sign::positive) return next;
      if (s == Sign::zero && next != from && seen.insert(next).second) level.push_back(next);
    }
    return vertex;
  };
  // Ends, for each vertex that is begun with anew is farther, exactly, and a level holds each vertex once.
  for (std::size_t i = 0; i < level.size();) {
    const std::uint32_t next = farther(level[i]);
    if (next == level[i]) {
      ++i;
    } else {
      from = next;
      level.assign(1, from);
      seen.clear();
      i = 0;
    }
  }
  return from;
}

}  // namespace

ClimbingAabb::ClimbingAabb(const ConvexPolyhedron3& polyhedron) : polyhedron_(&polyhedron), extremal_{} {
  const PolygonMesh& mesh = polyhedron.mesh;
  if (mesh.corners.empty()) throw InvalidShape("ClimbingAabb: the polyhedron has no faces; give at least one");
  figure::require_finite_points("ClimbingAabb", "polyhedron.mesh.vertices", std::span<const Point3>(mesh.vertices));
  extremal_.fill(mesh.corners[0]);
}

Aabb3 ClimbingAabb::operator()(const Pose& pose) {
  const auto& [c, t] = pose;
  figure::require_sound("ClimbingAabb", pose);
  const std::array rows{Vector3{c[0].x, c[1].x, c[2].x}, Vector3{c[0].y, c[1].y, c[2].y},
                        Vector3{c[0].z, c[1].z, c[2].z}};
  std::array<Point3, 6> found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vector3& row = rows[axis];
    extremal_[axis] = climb(*polyhedron_, extremal_[axis], {-row.x, -row.y, -row.z});
    extremal_[axis + 3] = climb(*polyhedron_, extremal_[axis + 3], row);
  }
  for (std::size_t i = 0; i < 6; ++i) found[i] = polyhedron_->mesh.vertices[extremal_[i]];
  return fit_aabb(found, pose);
}

}  // namespace plumb
