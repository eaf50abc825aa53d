#include "figure/measures/principal_axes.hpp"

#include <Eigen/Dense>

namespace plumb::figure::frame {
namespace {

Eigen::Vector3d eigen(const Vector3& v) { return {v.x, v.y, v.z}; }

// Each column's sign is made to follow from the matrix alone: its largest entry is positive.
std::array<Vector3, 3> axes_of(const Eigen::Matrix3d& covariance) {
  const double most = covariance.cwiseAbs().maxCoeff();
  if (!(most > 0)) return orthonormal({Vector3{}, Vector3{}, Vector3{}});
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / most);
  std::array<Vector3, 3> axes{};
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d v = solver.eigenvectors().col(2 - k);
    Eigen::Index at = 0;
    v.cwiseAbs().maxCoeff(&at);
    if (v(at) < 0) v = -v;
    axes[static_cast<std::size_t>(k)] = {v(0), v(1), v(2)};
  }
  return orthonormal(axes);
}

}  // namespace

std::array<Vector3, 3> principal_axes(std::span<const Vector3> points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Vector3& p : points) mean += eigen(p);
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Vector3& p : points) {
    const Eigen::Vector3d d = eigen(p) - mean;
    sum += d * d.transpose();
  }
  return axes_of(sum);
}

// Over a triangle p, q, r of area w and centroid m the integral of x x^T is w / 12 (9 m m^T + p p^T + q q^T + r r^T).
std::array<Vector3, 3> principal_axes_of_surface(std::span<const Vector3> vertices,
                                                 std::span<const TriangleMesh::Triangle> triangles) {
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  double total = 0;
  for (const auto& t : triangles) {
    const Eigen::Vector3d p = eigen(vertices[t[0]]), q = eigen(vertices[t[1]]), r = eigen(vertices[t[2]]);
    const double area = (q - p).cross(r - p).norm() / 2;
    const Eigen::Vector3d m = (p + q + r) / 3;
    second += area / 12 * (9 * m * m.transpose() + p * p.transpose() + q * q.transpose() + r * r.transpose());
    first += area * m;
    total += area;
  }
  if (!(total > 0)) return principal_axes(vertices);  // no area: what there is are points and lines
  return axes_of(second - first * first.transpose() / total);
}

}  // namespace plumb::figure::frame
