// Bent polygons: found, measured, and refused where that is asked.
#include "plumb/surface/planar/planarity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plumb/arith/error.hpp"
#include "plumb/surface/planar/triangulate.hpp"

namespace plumb {
namespace {

/// A triangle, a flat square, and two squares of which one corner is lifted.
PolygonMesh some_squares(double lift) {
  PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, lift}, {3, 0, 0}, {3, 1, 2 * lift}},
                   {0, 1, 2, 0, 1, 2, 3, 1, 4, 5, 2, 4, 6, 7, 5},
                   {0, 3, 7, 11, 15}};
  return mesh;
}

TEST(Planarity, BentFacesAreFoundAndMeasured) {
  EXPECT_TRUE(bent_faces(some_squares(0)).empty());
  const PolygonMesh mesh = some_squares(0.5);
  const auto bent = bent_faces(mesh);
  ASSERT_EQ(bent.size(), 2U);
  EXPECT_EQ(bent[0].face, 2U);
  EXPECT_EQ(bent[1].face, 3U);
  for (const BentFace& f : bent) {
    std::vector<Point3> corners;
    for (std::uint32_t k = mesh.first[f.face]; k < mesh.first[f.face + 1]; ++k)
      corners.push_back(mesh.vertices[mesh.corners[k]]);
    EXPECT_TRUE(f.width.squared == least_width(corners).squared);
    EXPECT_LT(f.width.width, 0.5);
    EXPECT_EQ(bent_faces(mesh, f.width.width).size(), f.face == 3 ? 1U : 0U) << "the second is thinner";
  }
  EXPECT_TRUE(bent_faces(mesh, 0.5).empty());
}

TEST(Planarity, EqualIsThinEnough) {
  PolygonMesh mesh{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {0, 1, 2, 3}, {0, 4}};  // 2 thick
  EXPECT_TRUE(bent_faces(mesh, 2).empty());
  EXPECT_EQ(bent_faces(mesh, std::nextafter(2, 0)).size(), 1U);
  EXPECT_EQ(triangulate_planar(mesh, 2).triangles, triangulate(mesh).triangles);
  try {
    triangulate_planar(mesh, 1);
    FAIL() << "it is thicker";
  } catch (const InvalidShape& e) {
    EXPECT_NE(std::string(e.what()).find("face 0 is not planar, but 2 thick"), std::string::npos) << e.what();
  }
}

TEST(Planarity, NewellsNormal) {
  const std::vector<Point3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  EXPECT_EQ(newell_normal(square), (Vector3{0, 0, 8}));
  const std::vector<Point3> bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
  EXPECT_EQ(newell_normal(bow), (Vector3{0, 0, 0}));
  std::vector<Point3> far;
  for (const Point3& p : square) far.push_back({p.x + 0x1p52, p.y, p.z + 0x1p-1000 * p.x});
  EXPECT_EQ(newell_normal(far), (Vector3{-8 * 0x1p-1000, 0, 8}));
}

TEST(Planarity, RefusesWhatIsNone) {
  const PolygonMesh mesh = some_squares(1);
  EXPECT_THROW(bent_faces(mesh, -1), InvalidShape);
  EXPECT_THROW(bent_faces(mesh, NAN), NonFinite);
  EXPECT_THROW(bent_faces({{{0, 0, 0}}, {0, 0, 1}, {0, 3}}), InvalidShape);
  EXPECT_THROW(newell_normal(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}}), InvalidShape);
}

}  // namespace
}  // namespace plumb
