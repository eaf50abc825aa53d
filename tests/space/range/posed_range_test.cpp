// Are the triangles of moved meshes that meet a shape those of the exactly moved triangles?
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/range/range_search.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;

template <class Shape>
void expect_those_of_the_posed_mesh(std::uint64_t start) {
  long compared = 0, met = 0, all = 0;
  shape_cases::on_shapes(start, battery::fitting(70), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(15), m.below(20));
    const Pose pose = integer_pose(m);
    const auto posed = exact_mesh(mesh, pose);
    if (!posed) return;
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = 2}), there = build_bvh(*posed);
    const std::array shapes{m.shape<Shape>(), m.shape<Shape>()};
    std::vector<std::vector<std::uint32_t>> each;
    for (const Shape& shape : shapes) {
      const auto found = meeting({bvh, pose}, shape);
      ASSERT_EQ(found, meeting(there, shape)) << m.about();
      each.push_back(found);
      met += static_cast<long>(found.size()), all += static_cast<long>(mesh.triangles.size());
    }
    EXPECT_EQ(meeting({bvh, pose}, std::span<const Shape>(shapes)), each) << m.about();
    ++compared;
  });
  EXPECT_GT(compared, battery::fitting(30));
  if (battery::reaches_rare) {
    EXPECT_GT(met, all / 20);
    EXPECT_LT(met, all);
  }
}

TEST(PosedRange, OfBoxes) { expect_those_of_the_posed_mesh<Aabb3>(1731); }
TEST(PosedRange, OfOrientedBoxes) { expect_those_of_the_posed_mesh<Obb3>(1732); }
TEST(PosedRange, OfBalls) { expect_those_of_the_posed_mesh<Sphere3>(1733); }
TEST(PosedRange, OfCapsules) { expect_those_of_the_posed_mesh<Capsule3>(1734); }
TEST(PosedRange, OfSegments) { expect_those_of_the_posed_mesh<Segment3>(1735); }
TEST(PosedRange, OfHalfspaces) { expect_those_of_the_posed_mesh<Halfspace3>(1736); }
TEST(PosedRange, OfConvexRegions) { expect_those_of_the_posed_mesh<HalfspaceIntersection3>(1737); }

template <class Shape>
void expect_those_of_each_triangle(Material& m, const TriangleMesh& mesh, const Bvh& bvh, const Pose& pose) {
  const auto shape = m.shape<Shape>();
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (query::intersects(posed_triangle(mesh, i, pose), shape)) expected.push_back(i);
  }
  EXPECT_EQ(meeting({bvh, pose}, shape), expected) << m.about();
}

TEST(PosedRange, UnderAnyPoseIsThatOfEachTriangle) {
  shape_cases::on_shapes(1738, battery::fitting(40), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(15), m.below(15));
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = 1});
    const Pose pose = any_pose(m);
    expect_those_of_each_triangle<Aabb3>(m, mesh, bvh, pose);
    expect_those_of_each_triangle<Obb3>(m, mesh, bvh, pose);
    expect_those_of_each_triangle<Sphere3>(m, mesh, bvh, pose);
    expect_those_of_each_triangle<Capsule3>(m, mesh, bvh, pose);
    expect_those_of_each_triangle<Segment3>(m, mesh, bvh, pose);
    expect_those_of_each_triangle<Halfspace3>(m, mesh, bvh, pose);
    expect_those_of_each_triangle<HalfspaceIntersection3>(m, mesh, bvh, pose);
  });
}

TEST(PosedRange, RefusesWhatIsNone) {
  const Bvh bvh = build_bvh(meshes::repeated(2));
  Pose pose = identity_pose;
  pose.columns[2].y = NAN;
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)meeting({bvh, pose}, Sphere3{{0, 0, 0}, 1});
            }),
            "meeting: mesh.pose.columns[2].y is nan, not a real number; give a finite double");
  EXPECT_THROW((void)meeting(PosedMesh(bvh), Sphere3{{0, 0, 0}, -1}), InvalidShape);
}

}  // namespace
}  // namespace plumb
