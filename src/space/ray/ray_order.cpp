#include "space/ray/ray_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "query/ray/batch_lanes.hpp"

namespace plumb::space {
namespace {

// Guesses of what is worth while.
constexpr std::size_t least_sorted = 64, sampled = 16;
constexpr double cells = 256;        // on the longer side
constexpr double most_between = 32;  // triangles for each ray

/// A byte's bits, each before a zero.
std::uint16_t spread(unsigned x) {
  x = (x | x << 4) & 0x0f0fu;
  x = (x | x << 2) & 0x3333u;
  return static_cast<std::uint16_t>((x | x << 1) & 0x5555u);
}

/// Where the line of a ray passes the plane at `middle` across an axis: its two other coordinates.
std::array<double, 2> place_of(const AnyRay& ray, std::size_t axis, double middle) {
  query::BatchRay line;
  query::put_batch_ray(ray, line);
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double t = (middle - line.origin[axis]) / line.direction[axis];
  const auto at = [&](std::size_t k) { return line.origin[k] + t * line.direction[k]; };
  return {at(u), at(v)};
}

std::array<double, 3> line_way(const AnyRay& ray) {
  const query::BatchRay r = query::batch_ray(ray);
  return {r.direction[0], r.direction[1], r.direction[2]};
}

/// The axis along which the first one goes most, if those that are looked at go the same way along it.
std::optional<std::size_t> main_axis(std::span<const AnyRay> rays) {
  const auto first = line_way(rays[0]);
  const auto longest = std::ranges::max_element(first, {}, [](double x) { return std::abs(x); });
  const auto axis = static_cast<std::size_t>(longest - first.begin());
  for (std::size_t i = 0; i < sampled; ++i) {
    const auto way = line_way(rays[i * (rays.size() - 1) / (sampled - 1)]);
    if ((way[axis] < 0) != (first[axis] < 0)) return {};
  }
  return axis;
}

/// As of those that fill a rectangle, however it lies; of a row each has a square.
double area_of_each(std::span<const std::array<double, 2>> places) {
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (const auto& p : places) {
    const double u = p[0] - places[0][0], v = p[1] - places[0][1];
    x += u, y += v, xx += u * u, yy += v * v, xy += u * v;
  }
  const auto n = static_cast<double>(places.size());
  xx -= x * x / n, yy -= y * y / n, xy -= x * y / n;
  return 12 / (n * n) * std::max(std::sqrt(std::max(xx * yy - xy * xy, 0.0)), (xx + yy) / n);
}

/// The area of the box's shadow on a plane across an axis.
double shadow_of(const Aabb3& box, const std::array<double, 3>& way, std::size_t axis) {
  const std::array size{box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z};
  double area = 0;
  for (std::size_t k = 0; k < 3; ++k) area += std::abs(way[k]) * (size[(k + 1) % 3] * size[(k + 2) % 3]);
  return area / std::abs(way[axis]);
}

}  // namespace

RayOrder order_of(std::span<const AnyRay> rays, const Aabb3& box, std::size_t triangles) {
  RayOrder all;
  std::vector<std::uint16_t>& order = all.order;
  order.resize(rays.size());
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  if (rays.empty()) return all;
  const auto axis = main_axis(rays);
  if (!axis) return all;
  std::vector<std::array<double, 2>> places(rays.size());
  std::array<double, 2> low{}, high{};
  const double middle = 0.5 * std::array{box.min.x, box.min.y, box.min.z}[*axis] +
                        0.5 * std::array{box.max.x, box.max.y, box.max.z}[*axis];
  for (std::size_t i = 0; i < rays.size(); ++i) {
    places[i] = place_of(rays[i], *axis, middle);
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = i == 0 ? places[i][k] : std::min(low[k], places[i][k]);
      high[k] = i == 0 ? places[i][k] : std::max(high[k], places[i][k]);
    }
  }
  const double side = std::max(high[0] - low[0], high[1] - low[1]);
  const double between =
      static_cast<double>(triangles) * area_of_each(places) / shadow_of(box, line_way(rays[0]), *axis);
  all.are_near = !(between > most_between);
  if (!all.are_near || rays.size() < least_sorted) return all;
  if (!(side > 0 && side < std::numeric_limits<double>::infinity())) return all;
  const auto cell = [&](double x, double from) {
    const double c = (x - from) * (cells / side);
    return c > 0 ? static_cast<unsigned>(std::min(c, cells - 1)) : 0u;
  };
  std::vector<std::uint16_t> codes(rays.size()), sorted(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    codes[i] = static_cast<std::uint16_t>(spread(cell(places[i][0], low[0])) | spread(cell(places[i][1], low[1])) << 1);
  for (const unsigned shift : {0u, 8u}) {
    std::array<std::uint16_t, 257> from{};
    for (const std::uint16_t i : order) ++from[(codes[i] >> shift & 255u) + 1];
    std::partial_sum(from.begin(), from.end(), from.begin());
    for (const std::uint16_t i : order) sorted[from[codes[i] >> shift & 255u]++] = i;
    order.swap(sorted);
  }
  return all;
}

}  // namespace plumb::space
