#include "plumb/certify/bounded_points.hpp"

#include <cmath>
#include <string>

namespace plumb {
namespace {

template <std::size_t N, class Point>
Bounds<N> bounds(std::span<const Point> points) {
  Bounds<N> box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, N> x = coordinates(points[i]);
    for (std::size_t k = 0; k < N; ++k) {
      if (!std::isfinite(x[k])) {
        throw_non_finite(std::string("point ").append(std::to_string(i)), std::array{static_cast<int>(N)}, x);
      }
      box.least[k] = i == 0 ? x[k] : std::min(box.least[k], x[k]);
      box.largest[k] = i == 0 ? x[k] : std::max(box.largest[k], x[k]);
    }
  }
  return box;
}

}  // namespace

Bounds<2> bounds_of(std::span<const Point2> points) { return bounds<2>(points); }
Bounds<3> bounds_of(std::span<const Point3> points) { return bounds<3>(points); }

void throw_no_such_point(std::string_view formula, std::span<const std::size_t> numbers, std::size_t count) {
  std::size_t i = 0;
  while (i + 1 < numbers.size() && numbers[i] < count) ++i;
  throw NoSuchPoint(std::string(formula)
                        .append(": argument ")
                        .append(1, static_cast<char>('a' + i % 26))
                        .append(" is point ")
                        .append(std::to_string(numbers[i]))
                        .append(" of ")
                        .append(std::to_string(count))
                        .append(", which are counted from 0"));
}

}  // namespace plumb
