// Eigen has no predicates; these are what people write with it.
#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "bench/rivals/chart_rival.hpp"
#include "bench/rivals/closest_pairs_rival.hpp"
#include "bench/rivals/closest_rival.hpp"

namespace plumb::bench {
namespace {

template <int Dimension, std::size_t N>
auto points_of(const std::array<double, N>& q) {
  using Point = Eigen::Matrix<double, Dimension, 1>;
  std::array<Point, N / Dimension> points;
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = Point(&q[i * Dimension]);
  return points;
}

double sign(double x) { return lab::trial::as_answer(sign_of_number(x)); }

/// Of the differences from the last point, each with its square at the end where `Lifted`.
template <int Dimension, bool Lifted, std::size_t Points>
double determinant(const std::array<Eigen::Matrix<double, Dimension, 1>, Points>& p) {
  constexpr int size = static_cast<int>(Points) - 1;
  Eigen::Matrix<double, size, size> m;
  for (int row = 0; row < size; ++row) {
    const Eigen::Matrix<double, Dimension, 1> d = p[static_cast<std::size_t>(row)] - p[Points - 1];
    m.row(row).template head<Dimension>() = d;
    if constexpr (Lifted) m(row, size - 1) = d.squaredNorm();
  }
  return sign(m.determinant());
}

Point3 point(const double* x) { return {x[0], x[1], x[2]}; }

}  // namespace

void add_eigen(Rivals& all) {
  using P2 = Eigen::Vector2d;
  using P3 = Eigen::Vector3d;
  const std::string by_determinant = "Eigen's determinant of differences";
  join<6>(all, "orient2d", "eigen", by_determinant, points_of<2, 6>, determinant<2, false, 3>);
  join<12>(all, "orient3d", "eigen", by_determinant, points_of<3, 12>, determinant<3, false, 4>);
  join<8>(all, "incircle", "eigen", by_determinant, points_of<2, 8>, determinant<2, true, 4>);
  join<15>(all, "insphere", "eigen", by_determinant, points_of<3, 15>, determinant<3, true, 5>);
  join<6>(all, "orient2d", "eigen-plane", "Eigen's Hyperplane through two points, its signed distance", points_of<2, 6>,
          [](const std::array<P2, 3>& p) {
            return sign(Eigen::Hyperplane<double, 2>::Through(p[0], p[1]).signedDistance(p[2]));
          });
  join<12>(all, "orient3d", "eigen-plane", "Eigen's Hyperplane through three points, its signed distance",
           points_of<3, 12>, [](const std::array<P3, 4>& p) {
             return sign(Eigen::Hyperplane<double, 3>::Through(p[0], p[1], p[2]).signedDistance(p[3]));
           });
  using Box = Eigen::AlignedBox3d;
  join<12>(
      all, "box-box", "eigen", "Eigen's AlignedBox::intersects",
      [](const std::array<double, 12>& q) {
        return std::pair{Box(P3(&q[0]), P3(&q[3])), Box(P3(&q[6]), P3(&q[9]))};
      },
      [](const std::pair<Box, Box>& q) { return q.first.intersects(q.second); });
  join<9>(
      all, "point-box-distance", "eigen", "Eigen's AlignedBox::exteriorDistance",
      [](const std::array<double, 9>& q) {
        return std::pair{P3(&q[0]), Box(P3(&q[3]), P3(&q[6]))};
      },
      [](const std::pair<P3, Box>& q) { return q.second.exteriorDistance(q.first); });
  join<12>(
      all, "point-triangle-distance", "eigen", "Eigen's LDLT on the normal equations, or the nearest edge",
      [](const std::array<double, 12>& q) {
        return std::pair{point(&q[0]), Triangle3{point(&q[3]), point(&q[6]), point(&q[9])}};
      },
      [](const std::pair<Point3, Triangle3>& q) { return nearest_by_eigen(q.second, q.first).distance; });
  join<12>(
      all, "segment-segment-distance", "eigen", "parameters clamped, in Eigen's vectors",
      [](const std::array<double, 12>& q) {
        return std::pair{Segment3{point(&q[0]), point(&q[3])}, Segment3{point(&q[6]), point(&q[9])}};
      },
      [](const std::pair<Segment3, Segment3>& q) { return segments_in_eigen(q.first, q.second); });
}

}  // namespace plumb::bench
