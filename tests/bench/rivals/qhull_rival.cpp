#include "bench/rivals/qhull_rival.hpp"

#include <vector>

#include "bench/rivals/qhull_calls.hpp"

namespace plumb::bench {
namespace {

std::size_t vertices(int dimension, const std::vector<double>& coordinates) {
  std::size_t count = 0;
  with_qhull(dimension, coordinates.data(), coordinates.size() / static_cast<std::size_t>(dimension), "qhull ",
             [&](const qhT& state) { count = static_cast<std::size_t>(state.num_vertices); });
  return count;
}

}  // namespace

std::size_t qhull_vertices(std::span<const Point2> points) {
  std::vector<double> coordinates;
  coordinates.reserve(2 * points.size());
  for (const Point2& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
  return vertices(2, coordinates);
}

std::size_t qhull_vertices(std::span<const Point3> points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  return vertices(3, coordinates);
}

}  // namespace plumb::bench
