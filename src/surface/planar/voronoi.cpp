#include "plumb/surface/planar/voronoi.hpp"

namespace plumb {
namespace {

ExactPoint2 center_of(const Point2& a, const Point2& b, const Point2& c) {
  const Rational ax = a.x, ay = a.y;
  const Rational bx = Rational(b.x) - ax, by = Rational(b.y) - ay, cx = Rational(c.x) - ax, cy = Rational(c.y) - ay;
  const Rational b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const Rational twice_turn = Rational(2) * (bx * cy - by * cx);
  return RationalPoint2{ax + (b2 * cy - c2 * by) / twice_turn, ay + (c2 * bx - b2 * cx) / twice_turn};
}

}  // namespace

std::vector<ExactPoint2> voronoi_vertices(std::span<const Point2> points, const PlanarTriangulation& triangulation) {
  std::vector<ExactPoint2> centers;
  centers.reserve(triangulation.triangles.size());
  for (const auto& [a, b, c] : triangulation.triangles) centers.push_back(center_of(points[a], points[b], points[c]));
  return centers;
}

}  // namespace plumb
