// Do numbers cross the border to Eigen and back unchanged?
#include "plumb/figure/basic/eigen.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plumb/figure/obb/fits.hpp"

namespace plumb {
namespace {

TEST(EigenTest, GoesThereAndBack) {
  const Point3 p{0x1p-1074, -0.0, 1e308};
  EXPECT_EQ(point3(to_eigen(p)), p);
  EXPECT_TRUE(std::signbit(point3(to_eigen(p)).y));
  EXPECT_EQ(vector3(to_eigen(Vector3{1, 2, 3})), (Vector3{1, 2, 3}));
  EXPECT_EQ(point2(to_eigen(Point2{1, 2})), (Point2{1, 2}));
  EXPECT_EQ(vector2(to_eigen(Vector2{1, 2})), (Vector2{1, 2}));
  EXPECT_EQ(point3(Eigen::Vector3f(0.1F, 0.2F, 0.3F)), (Point3{0.1F, 0.2F, 0.3F}));  // floats widen
  EXPECT_EQ(point3(Eigen::Vector3d(1, 2, 3) * 2), (Point3{2, 4, 6}));                // an expression
  const Pose turn{{Vector3{0, 1, 0}, Vector3{-1, 0, 0}, Vector3{0, 0, 1}}, {7, 8, 9}};
  EXPECT_EQ(pose(to_eigen(turn)), turn);
  const Rotation q{0.5, -1, 0x1p-1074, 3};  // not of length one, and left so
  EXPECT_EQ(rotation(to_eigen(q)), q);
  EXPECT_EQ(rotation(Eigen::Quaternionf(0.5f, 1, 2, 3)), (Rotation{0.5, 1, 2, 3}));
  EXPECT_EQ(pose(Eigen::Isometry3f::Identity()).columns[1], (Vector3{0, 1, 0}));
  EXPECT_EQ(point3(to_eigen(turn) * Eigen::Vector3d(1, 0, 0)), (Point3{7, 9, 9}));
}

TEST(EigenTest, SeesPointsAsColumns) {
  const std::vector<Point3> points{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(as_eigen(points).col(1), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(points3(as_eigen(points)), points);
  EXPECT_EQ(points3(Eigen::MatrixXd(as_eigen(points))), points);
  EXPECT_EQ(as_eigen(std::span<const Point3>()).cols(), 0);
  EXPECT_EQ(fit_obb_principal(points3(as_eigen(points))), fit_obb_principal(points));
}

}  // namespace
}  // namespace plumb
