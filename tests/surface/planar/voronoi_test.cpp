// Voronoi vertices: as far from the corners of their triangles as from each other's, and no point nearer; exactly.
#include "plumb/surface/planar/voronoi.hpp"

#include <gtest/gtest.h>

#include "surface/planar/triangulation_laws.hpp"

namespace plumb {
namespace {

Rational squared_distance(const RationalPoint2& c, const Point2& p) {
  const Rational dx = c.x - Rational(p.x), dy = c.y - Rational(p.y);
  return dx * dx + dy * dy;
}

TEST(Voronoi, NoPointIsNearerThanTheCorners) {
  for (std::uint64_t round = 0; round < 60; ++round) {
    SCOPED_TRACE("Entropy(50, " + std::to_string(round) + ")");
    Entropy entropy(50, round);
    const Family family = round % 2 == 0 ? Family::grid : Family::wide;
    const auto points = points2(family, Degeneracy::cocircular, 3 + entropy.below(12), entropy);
    const PlanarTriangulation made = delaunay(points);
    const std::vector<ExactPoint2> centers = voronoi_vertices(points, made);
    ASSERT_EQ(centers.size(), made.triangles.size());
    for (std::size_t f = 0; f < centers.size(); ++f) {
      const RationalPoint2 center = rational_point(centers[f]);
      const Rational radius = squared_distance(center, points[made.triangles[f][0]]);
      for (const std::uint32_t corner : made.triangles[f]) EXPECT_EQ(squared_distance(center, points[corner]), radius);
      for (const Point2& p : points) EXPECT_GE(squared_distance(center, p), radius);
    }
  }
}

TEST(Voronoi, PointsOnOneCircleHaveOneCenter) {
  const std::vector<Point2> points{{5, 0}, {3, 4}, {0, 5}, {-4, 3}, {0, -5}};
  for (const ExactPoint2& center : voronoi_vertices(points, delaunay(points)))
    EXPECT_EQ(center, ExactPoint2(Point2{0, 0}));
}

}  // namespace
}  // namespace plumb
