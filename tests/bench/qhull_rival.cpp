#include "bench/qhull_rival.hpp"

#include <cstdio>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace plumb::bench {
namespace {

std::size_t vertices(int dimension, std::vector<coordT> coordinates) {
  static std::FILE* const nowhere = std::fopen("/dev/null", "w");
  qhT state;
  qh_zero(&state, nowhere);
  char command[] = "qhull ";
  const int failed = qh_new_qhull(&state, dimension, static_cast<int>(coordinates.size()) / dimension,
                                  coordinates.data(), False, command, nowhere, nowhere);
  const std::size_t count = failed != 0 ? 0 : static_cast<std::size_t>(state.num_vertices);
  int left = 0, total = 0;
  qh_freeqhull(&state, qh_ALL);
  qh_memfreeshort(&state, &left, &total);
  return count;
}

}  // namespace

std::size_t qhull_vertices(std::span<const Point2> points) {
  std::vector<coordT> coordinates;
  coordinates.reserve(2 * points.size());
  for (const Point2& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
  return vertices(2, std::move(coordinates));
}

std::size_t qhull_vertices(std::span<const Point3> points) {
  std::vector<coordT> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  return vertices(3, std::move(coordinates));
}

}  // namespace plumb::bench
