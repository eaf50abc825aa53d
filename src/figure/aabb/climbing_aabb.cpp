#include "plumb/figure/aabb/climbing_aabb.hpp"

#include <unordered_set>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/image_order.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

// The vertex that lies farthest by the order.  Neighbors that lie equally far are kept in a list, and are
// climbed from in turn: a vertex inside an edge or a face may have no better neighbor where its edge or face has.
template <class Order>
std::uint32_t climb(const ConvexPolyhedron3& polyhedron, std::uint32_t from, Order order) {
  const auto& vertices = polyhedron.mesh.vertices;
  std::vector<std::uint32_t> level{from};
  std::unordered_set<std::uint32_t> seen;
  const auto farther = [&](std::uint32_t vertex) {  // a neighbor that lies so; those of the same level are noted
    for (const std::uint32_t next : polyhedron.neighbors_of(vertex)) {
      const Sign s = order(vertices[next], vertices[vertex]);
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

Aabb3 ClimbingAabb::operator()(PoseView pose) {
  figure::require_sound("ClimbingAabb", pose);
  const figure::CertainPose moved(pose);
  const figure::ImageOrder order(moved);
  std::array<Point3, 6> found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (order.is_level(axis)) continue;
    const auto climbed = [&](std::uint32_t from, bool down) {
      return climb(*polyhedron_, from,
                   [&](const Point3& p, const Point3& q) { return down ? order(axis, q, p) : order(axis, p, q); });
    };
    extremal_[axis] = climbed(extremal_[axis], true);
    extremal_[axis + 3] = climbed(extremal_[axis + 3], false);
  }
  for (std::size_t i = 0; i < 6; ++i) found[i] = polyhedron_->mesh.vertices[extremal_[i]];
  return fit_aabb(found, pose);
}

}  // namespace plumb
