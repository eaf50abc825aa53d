#include "plumb/figure/hull/hull3.hpp"

#include "figure/basic/finite_parts.hpp"
#include "figure/hull/hull3_faces.hpp"
#include "figure/hull/hull3_interior.hpp"
#include "figure/hull/hull3_methods.hpp"
#include "figure/hull/hull3_start.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/polyhedron.hpp"

namespace plumb {
namespace {

using namespace figure::hull3;

Extents extents_of(std::span<const Point3> points) {
  Extents e{points.front(), points.front()};
  for (const Point3& p : points) {
    e.min = {std::min(e.min.x, p.x), std::min(e.min.y, p.y), std::min(e.min.z, p.z)};
    e.max = {std::max(e.max.x, p.x), std::max(e.max.y, p.y), std::max(e.max.z, p.z)};
  }
  return e;
}

}  // namespace

Hull3 convex_hull(std::span<const Point3> points, HullOptions options) {
  if (points.size() > std::size_t{1} << 29) {
    throw InvalidShape(std::string("convex_hull: ")
                           .append(std::to_string(points.size()))
                           .append(" points; give at most 2^29, whose faces can be counted in 32 bits"));
  }
  figure::require_finite_points("convex_hull", "points", points);
  if (points.empty()) return {};
  const Extents extents = extents_of(points);
  std::vector<Node> nodes = outer_nodes(points, extents, options.all_boundary_points);
  const Start start = find_start(nodes);
  if (start.dimension < 3) {
    std::array<Point3, 3> span{};
    for (std::size_t i = 0; i < 3 && start.simplex[i] != none; ++i) span[i] = nodes[start.simplex[i]].point;
    return flat_hull(points, start.dimension, span, options);
  }
  Surface surface(std::move(nodes), extents);
  (options.method == HullMethod::quickhull ? grow_quickhull : grow_incrementally)(surface, start.simplex,
                                                                                  options.all_boundary_points);
  return options.all_boundary_points ? faces_with_all_points(surface, points.size(), options.triangulate)
                                     : faces_of(surface, points.size(), options);
}

ConvexPolyhedron3 convex_polyhedron(const Hull3& hull, std::span<const Point3> points) {
  if (hull.dimension < 3) {
    throw InvalidShape(std::string("convex_polyhedron: the hull has dimension ")
                           .append(std::to_string(hull.dimension))
                           .append("; give one of dimension 3"));
  }
  PolygonMesh mesh;
  for (const std::uint32_t v : hull.vertices) {
    if (v >= points.size()) throw InvalidShape("convex_polyhedron: the hull names a point beyond the last one given");
    mesh.vertices.push_back(points[v]);
  }
  mesh.first = hull.first;
  for (const std::uint32_t c : hull.corners) {
    const auto at = std::ranges::lower_bound(hull.vertices, c);
    if (at == hull.vertices.end() || *at != c) {
      throw InvalidShape("convex_polyhedron: a face of the hull has a corner that is none of its vertices");
    }
    mesh.corners.push_back(static_cast<std::uint32_t>(at - hull.vertices.begin()));
  }
  return convex_polyhedron(std::move(mesh));
}

}  // namespace plumb
