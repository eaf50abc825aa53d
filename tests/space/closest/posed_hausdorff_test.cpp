// Does the Hausdorff distance of moved meshes lie between the two numbers, for their exact images?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/space/closest/hausdorff.hpp"
#include "query/closest/posed_triangle.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;
using ::testing::HasSubstr;

const HausdorffOptions coarse{.relative = 0.125, .of_size = 0, .most_pieces = 200};

TEST(PosedHausdorff, IsThatOfTheExactlyPosedMesh) {
  long compared = 0, same = 0;
  shape_cases::on_shapes(1731, battery::fitting(250), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const Pose pose_a = integer_pose(m), pose_b = pose_like(m, pose_a);
    const auto posed_a = exact_mesh(mesh_a, pose_a), posed_b = exact_mesh(mesh_b, pose_b);
    if (!posed_a || !posed_b) return;
    const Bvh a = build_bvh(mesh_a), b = build_bvh(mesh_b);
    const HausdorffDistance found = hausdorff_from({a, pose_a}, {b, pose_b}, coarse);
    const HausdorffDistance there = hausdorff_from(build_bvh(*posed_a), build_bvh(*posed_b), coarse);
    ASSERT_LE(found.least, there.most) << m.about();
    ASSERT_LE(there.least, found.most) << m.about();
    ASSERT_TRUE(!found.is_within || found.most - found.least <= 0.125 * found.most) << m.about();
    ++compared;
    same += found == there ? 1 : 0;
  });
  EXPECT_GT(compared, battery::fitting(100));
  EXPECT_GT(same * 2, compared);  // images that doubles hold are not rounded
}

// Of the vertices of a the exact distance from the exactly posed triangles of b is known.
TEST(PosedHausdorff, IsNoLessThanThatOfAnyVertex) {
  shape_cases::on_shapes(1732, battery::fitting(150), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const Pose pose = any_pose(m);
    const Bvh a = build_bvh(mesh_a), b = build_bvh(mesh_b);
    const HausdorffDistance h = hausdorff_from(a, {b, pose}, coarse);
    ASSERT_LE(h.least, h.most) << m.about();
    ASSERT_TRUE(std::isfinite(h.least)) << m.about();
    const auto square_from_b = [&](const Point3& p) {
      std::optional<Rational> least;
      for (std::uint32_t k = 0; k < mesh_b.triangles.size(); ++k) {
        Rational square = query::squared_distance_exact(posed_triangle(mesh_b, k, pose), p);
        if (!least || square < *least) least = std::move(square);
      }
      return *least;
    };
    for (const auto& corners : mesh_a.triangles) {
      for (const std::uint32_t v : corners) {
        const Rational square = square_from_b(mesh_a.vertices[v]);
        if (std::isfinite(h.most)) {
          ASSERT_LE(square, Rational(h.most) * Rational(h.most)) << m.about();
        }
        if (h.point == mesh_a.vertices[v]) {
          ASSERT_GE(square, Rational(h.least) * Rational(h.least)) << m.about();
        }
      }
    }
  });
}

TEST(PosedHausdorff, OfOneMeshUnderOnePoseIsZero) {
  const Bvh ring = build_bvh(meshes::ring(8));
  shape_cases::on_shapes(1733, 5, [&](Material& m) {
    const Pose pose = turn(m);
    const HausdorffDistance h = hausdorff_distance({ring, pose}, {ring, pose});
    EXPECT_EQ(h.least, 0) << m.about();
    EXPECT_EQ(h.most, 0) << m.about();
    EXPECT_TRUE(h.is_within) << m.about();
    Pose away = pose;
    away.translation.z += 0x1p-20;
    const HausdorffDistance moved = hausdorff_distance({ring, pose}, {ring, away});
    EXPECT_LE(moved.most, 0x1p-20 * 1.01) << m.about();  // every point has its own image that near
  });
}

TEST(PosedHausdorff, ReachesBeyondTheDoubles) {
  const double most = std::numeric_limits<double>::max();
  const Bvh unit = build_bvh(TriangleMesh{{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {{0, 1, 2}}});
  Pose right = identity_pose, left = identity_pose;
  right.columns[0].x = right.translation.x = most;
  left.columns[0].x = left.translation.x = -most;
  const HausdorffDistance h = hausdorff_distance({unit, right}, {unit, left});  // four times the largest double
  EXPECT_EQ(h.least, most);
  EXPECT_EQ(h.most, INFINITY);
  EXPECT_TRUE(std::isinf(h.point.x));
  // The images are beyond the doubles; their distance is not.
  Pose lower = right;
  lower.translation.z = 0x1p1000;
  const HausdorffDistance near = hausdorff_distance({unit, right}, {unit, lower});
  EXPECT_LE(near.least, 0x1p1000);
  EXPECT_GE(near.most, 0x1p1000);
  EXPECT_LE(near.most, 0x1.01p1000);
  EXPECT_TRUE(near.is_within);
}

TEST(PosedHausdorff, RefusesWhatIsNone) {
  const Bvh unit = build_bvh(meshes::repeated(2)), nothing = build_bvh(TriangleMesh{});
  Pose pose = identity_pose;
  pose.translation.y = NAN;
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)hausdorff_from({unit, pose}, unit);
            }),
            "hausdorff_from: a.pose.translation.y is nan, not a real number; give a finite double");
  EXPECT_THAT(text_of<NonFinite>([&] { (void)hausdorff_distance(unit, {unit, pose}); }), HasSubstr(": b.pose."));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)hausdorff_from({nothing, identity_pose}, {unit, identity_pose});
              }),
              HasSubstr("hausdorff_from: a is empty"));
}

}  // namespace
}  // namespace plumb
