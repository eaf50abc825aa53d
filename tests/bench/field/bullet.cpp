// Bullet's functions by the C signatures of `plumb fuzz --list`, each as bullet_calls.hpp says.
#include <LinearMath/btConvexHullComputer.h>

#include "bench/rivals/bullet_calls.hpp"

namespace bullet = plumb::bench::bullet;

extern "C" {

int bullet_box_box(const double* a, const double* b) {
  return TestAabbAgainstAabb2(bullet::point(a), bullet::point(a + 3), bullet::point(b), bullet::point(b + 3));
}

int bullet_obb_obb(const double* a, const double* b) { return bullet::meet(bullet::box(a), bullet::box(b)); }

int bullet_triangle_triangle(const double* a, const double* b) {
  return bullet::meet(bullet::triangle(a), bullet::triangle(b));
}

double bullet_convex_distance(const double* a, std::size_t n, const double* b, std::size_t m) {
  return bullet::gap(bullet::Cloud(a, n).shape(), bullet::Cloud(b, m).shape());
}

/// btConvexHullComputer, each of its faces as a fan.  Two faces are Bullet's hull of points in one plane.
std::size_t bullet_hull(const double* points, std::size_t n, std::size_t* triangles, std::size_t capacity) {
  btConvexHullComputer hull;
  hull.compute(points, 3 * sizeof(double), static_cast<int>(n), 0, 0);
  if (hull.faces.size() <= 2) return 0;
  std::size_t count = 0;
  const auto original = [&](int vertex) { return static_cast<std::size_t>(hull.original_vertex_index[vertex]); };
  for (int f = 0; f < hull.faces.size(); ++f) {
    const btConvexHullComputer::Edge* const first = &hull.edges[hull.faces[f]];
    for (const auto* e = first->getNextEdgeOfFace(); e->getTargetVertex() != first->getSourceVertex();
         e = e->getNextEdgeOfFace()) {
      if (count < capacity) {
        triangles[3 * count] = original(first->getSourceVertex());
        triangles[3 * count + 1] = original(e->getSourceVertex());
        triangles[3 * count + 2] = original(e->getTargetVertex());
      }
      ++count;
    }
  }
  return count;
}
}
