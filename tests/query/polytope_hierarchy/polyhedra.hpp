// Convex polyhedra of every size: of the clouds that have volume, with all that lies in their faces or without it, cut
// into triangles or not, and cones, whose apex is a neighbor of all.
#pragma once

#include <string>

#include "plumb/degenerate.hpp"
#include "plumb/figure.hpp"

namespace plumb::hierarchy_cases {

struct NamedPolyhedron {
  std::string name;
  ConvexPolyhedron3 polyhedron;
};

/// Nothing where the points are flat.
inline void add_hull(std::vector<NamedPolyhedron>& to, const std::string& name, const std::vector<Point3>& points,
                     const HullOptions& options) {
  const Hull3 hull = convex_hull(points, options);
  if (hull.dimension < 3) return;
  PolygonMesh mesh{{}, {}, hull.first};
  std::vector<std::uint32_t> number(points.size(), 0);
  for (const std::uint32_t v : hull.corners) {
    if (number[v] == 0) {
      mesh.vertices.push_back(points[v]);
      number[v] = static_cast<std::uint32_t>(mesh.vertices.size());
    }
    mesh.corners.push_back(number[v] - 1);
  }
  to.push_back({name + (options.all_boundary_points ? ", all points" : "") + (options.triangulate ? ", triangles" : ""),
                convex_polyhedron(std::move(mesh))});
}

inline std::vector<NamedPolyhedron> polyhedra_of(std::size_t n, std::uint64_t start) {
  std::vector<NamedPolyhedron> all;
  Entropy entropy(start, n);
  for (const Cloud cloud :
       {Cloud::ball, Cloud::sphere, Cloud::exact_sphere, Cloud::lattice, Cloud::facets, Cloud::prism, Cloud::moments}) {
    const std::vector<Point3> points = cloud3(cloud, n, entropy);
    for (const bool boundary : {false, true}) {
      for (const bool triangles : {false, true}) {
        add_hull(all, std::string(name_of(cloud)) + " of " + std::to_string(n), points,
                 {.triangulate = triangles, .all_boundary_points = boundary});
      }
    }
  }
  std::vector<Point3> cone(n + 1, Point3{0, 0, 3});
  for (std::size_t i = 0; i < n; ++i) {  // of a parabola: all are corners, exactly
    const double t = static_cast<double>(i);
    cone[i] = {t, t * t, 0};
  }
  add_hull(all, "cone of " + std::to_string(n), cone, {});
  return all;
}

}  // namespace plumb::hierarchy_cases
