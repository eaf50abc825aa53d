// How do Eigen's vectors and ours become one another?  The one header that includes Eigen; nothing else includes it.
//
//   plumb::Point3 p = plumb::point3(v);                      // from any 3 x 1 or 1 x 3 expression
//   std::vector<plumb::Point3> all = plumb::points3(matrix); // 3 x n: a point each column
//   Eigen::Isometry3d t = ...;  plumb::Pose pose = plumb::pose(t);
//
// Laws: numbers are copied bit by bit: there and back changes nothing; float widens exactly.  A matrix of another size
// does not compile, or fails Eigen's assertion where its size is dynamic.
// Source: Eigen 3.4's manual.
// Cost: a copy.  Nothing is searched.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "plumb/arith/pose.hpp"
#include "plumb/arith/rigid_pose.hpp"

namespace plumb {

inline Eigen::Vector2d to_eigen(const Point2& p) { return {p.x, p.y}; }
inline Eigen::Vector2d to_eigen(const Vector2& v) { return {v.x, v.y}; }
inline Eigen::Vector3d to_eigen(const Point3& p) { return {p.x, p.y, p.z}; }
inline Eigen::Vector3d to_eigen(const Vector3& v) { return {v.x, v.y, v.z}; }

/// The columns and the translation as an affine map.
inline Eigen::Affine3d to_eigen(const Pose& pose) {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  for (int k = 0; k < 3; ++k) map.linear().col(k) = to_eigen(pose.columns[static_cast<std::size_t>(k)]);
  map.translation() = to_eigen(pose.translation);
  return map;
}

/// The quaternion as it is.
inline Eigen::Quaterniond to_eigen(const Rotation& turn) { return {turn.w, turn.x, turn.y, turn.z}; }
template <class Derived>
Rotation rotation(const Eigen::QuaternionBase<Derived>& q) {
  return {static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
          static_cast<double>(q.z())};
}

namespace eigen {

template <class Result, class Derived>
Result two(const Eigen::MatrixBase<Derived>& v) {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Derived, 2);
  return {static_cast<double>(v(0)), static_cast<double>(v(1))};
}
template <class Result, class Derived>
Result three(const Eigen::MatrixBase<Derived>& v) {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Derived, 3);
  return {static_cast<double>(v(0)), static_cast<double>(v(1)), static_cast<double>(v(2))};
}

}  // namespace eigen

template <class Derived>
Point2 point2(const Eigen::MatrixBase<Derived>& v) {
  return eigen::two<Point2>(v);
}
template <class Derived>
Vector2 vector2(const Eigen::MatrixBase<Derived>& v) {
  return eigen::two<Vector2>(v);
}
template <class Derived>
Point3 point3(const Eigen::MatrixBase<Derived>& v) {
  return eigen::three<Point3>(v);
}
template <class Derived>
Vector3 vector3(const Eigen::MatrixBase<Derived>& v) {
  return eigen::three<Vector3>(v);
}

/// A point of each column.
template <class Derived>
std::vector<Point3> points3(const Eigen::MatrixBase<Derived>& matrix) {
  static_assert(Derived::RowsAtCompileTime == 3 || Derived::RowsAtCompileTime == Eigen::Dynamic,
                "points3: a matrix has a point in each column, hence three rows");
  eigen_assert(matrix.rows() == 3);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(matrix.cols()));
  for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
    points.push_back(
        {static_cast<double>(matrix(0, i)), static_cast<double>(matrix(1, i)), static_cast<double>(matrix(2, i))});
  }
  return points;
}

/// The points themselves as a matrix of three rows, not copied.
inline Eigen::Map<const Eigen::Matrix3Xd> as_eigen(std::span<const Point3> points) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  return {points.empty() ? nullptr : &points.front().x, 3, static_cast<Eigen::Index>(points.size())};
}

/// Of an affine or isometric map; a projective one has more than a pose holds, and does not compile.
template <class Scalar, int Mode, int Options>
Pose pose(const Eigen::Transform<Scalar, 3, Mode, Options>& map) {
  static_assert(Mode != Eigen::Projective, "pose: a projective map is none");
  Pose result{};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix<Scalar, 3, 1> column = map.linear().col(k);
    result.columns[static_cast<std::size_t>(k)] = vector3(column);
  }
  const Eigen::Matrix<Scalar, 3, 1> translation = map.translation();
  result.translation = vector3(translation);
  return result;
}

}  // namespace plumb
