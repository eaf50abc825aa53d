#include "plumb/figure/generated.hpp"

#include <string>

#include "plumb/figure/hull3.hpp"

namespace plumb::generated {

namespace {

std::vector<Point2> points2(std::span<const double> numbers) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.push_back({numbers[i], numbers[i + 1]});
  return points;
}

std::vector<Point3> points3(std::span<const double> numbers) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return points;
}

}  // namespace

void demand(std::span<const double> numbers, degenerate::ShapeKind kind, int dimension) {
  const std::size_t size = degenerate::shape_size(kind, dimension);
  const auto stride = static_cast<std::size_t>(dimension);
  if (size != 0 ? numbers.size() == size : !numbers.empty() && numbers.size() % stride == 0) return;
  throw InvalidShape(
      std::to_string(numbers.size())
          .append(" numbers are no ")
          .append(degenerate::name_of(kind))
          .append("; give ")
          .append(size != 0 ? std::to_string(size) : std::string("a multiple of ").append(std::to_string(dimension))));
}

Polygon2 polygon2(std::span<const double> numbers) { return {points2(numbers)}; }
Polygon3 polygon3(std::span<const double> numbers) { return {points3(numbers)}; }

KDop2 k_dop2(std::span<const double> numbers) { return fit_k_dop(points2(numbers), k_dop_directions2(8)); }
KDop3 k_dop3(std::span<const double> numbers) { return fit_k_dop(points3(numbers), 14); }

ConvexPolyhedron3 polyhedron(std::span<const double> numbers) {
  const std::vector<Point3> points = points3(numbers);
  return convex_polyhedron(convex_hull(points), points);
}

}  // namespace plumb::generated
