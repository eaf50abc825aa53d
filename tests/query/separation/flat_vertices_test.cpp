// Vertices inside of a flat part of a polyhedron: whose neighbors are all level, also on its far side.
#include <gtest/gtest.h>

#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/query/separation/separation.hpp"
#include "query/separation/exact_corners.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb {
namespace {

/// A cube with its top in four triangles around vertex 0.
ConvexPolyhedron3 cube() {
  return convex_polyhedron(
      TriangleMesh{{{1, 1, 2}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}},
                   {{0, 5, 6},
                    {0, 6, 7},
                    {0, 7, 8},
                    {0, 8, 5},
                    {1, 3, 2},
                    {1, 4, 3},
                    {1, 2, 6},
                    {1, 6, 5},
                    {2, 3, 7},
                    {2, 7, 6},
                    {3, 4, 8},
                    {3, 8, 7},
                    {4, 1, 5},
                    {4, 5, 8}}});
}

TEST(FlatVertices, AreNoNearestOnesOnTheFarSide) {
  const ConvexPolyhedron3 solid = cube();
  const Segment3 below{{1, 1, -1}, {1, 1, -4}}, above{{1, 1, 3}, {1, 1, 5}};
  EXPECT_EQ(closest_points(solid, below).distance, 1);
  EXPECT_EQ(closest_points(solid, below).on_a, (Point3{1, 1, 0}));
  EXPECT_EQ(closest_points(solid, above).on_a, (Point3{1, 1, 2}));
  const auto a = query::CoreCorners::of(query::view_of(solid)), b = query::CoreCorners::of(query::view_of(below));
  query::DifferenceCorners from_the_top;
  from_the_top.add({0, 0});
  const auto proved = query::proved_nearest(*a, *b, from_the_top);
  ASSERT_TRUE(proved);
  EXPECT_NE(proved->corners.ends[0][0], 0U);
  EXPECT_FALSE(proved->meets);
}

}  // namespace
}  // namespace plumb
