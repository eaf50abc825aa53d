#include "surface/repair/loop_filling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"
#include "plumb/surface/planar/triangulate.hpp"

namespace plumb::surface {
namespace {

constexpr double none_known = std::numeric_limits<double>::infinity();

/// Guessed areas of triangles on a loop's corners, in units of a power of two.
class GuessedAreas {
 public:
  GuessedAreas(std::span<const Point3> points, std::span<const std::uint32_t> loop) : points_(points), loop_(loop) {
    double largest = 0;
    for (const std::uint32_t v : loop)
      for (const double x : {points[v].x, points[v].y, points[v].z}) largest = std::max(largest, std::fabs(x));
    exponent_ = largest == 0 ? 0 : std::ilogb(largest) + 1;
    for (const std::uint32_t v : loop)
      scaled_.push_back({std::ldexp(points[v].x, -exponent_), std::ldexp(points[v].y, -exponent_),
                         std::ldexp(points[v].z, -exponent_)});
  }
  /// Infinite where the corners are exactly on one line.
  [[nodiscard]] double operator()(std::size_t i, std::size_t j, std::size_t k) const {
    if (collinear(points_[loop_[i]], points_[loop_[j]], points_[loop_[k]])) return none_known;
    const Point3 &a = scaled_[i], &b = scaled_[j], &c = scaled_[k];
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    return std::sqrt(x * x + y * y + z * z);
  }

 private:
  std::span<const Point3> points_;
  std::span<const std::uint32_t> loop_;
  int exponent_ = 0;
  std::vector<Point3> scaled_;
};

bool is_in_one_plane(std::span<const Point3> points, std::span<const std::uint32_t> loop) {
  const auto at = [&](std::size_t i) -> const Point3& { return points[loop[i]]; };
  std::size_t j = 1, k = 2;
  while (j + 1 < loop.size() && at(j) == at(0)) ++j;
  for (k = j + 1; k < loop.size() && collinear(at(0), at(j), at(k));) ++k;
  if (k >= loop.size()) return false;
  return std::ranges::all_of(loop,
                             [&](std::uint32_t v) { return orient3d(at(0), at(j), at(k), points[v]) == Sign::zero; });
}

}  // namespace

std::optional<Filling> planar_filling(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                      const TakenDiagonal& is_taken) {
  if (!is_in_one_plane(points, loop)) return {};
  Filling filling;
  if (!triangulate_face(points, loop, filling)) return {};
  const auto is_side = [&](std::uint32_t a, std::uint32_t b) {
    const auto at = static_cast<std::size_t>(std::ranges::find(loop, a) - loop.begin());
    return loop[(at + 1) % loop.size()] == b;
  };
  for (const auto& t : filling) {
    if (collinear(points[t[0]], points[t[1]], points[t[2]])) return {};
    for (std::size_t k = 0; k < 3; ++k)
      if (!is_side(t[k], t[(k + 1) % 3]) && is_taken(t[k], t[(k + 1) % 3])) return {};
  }
  return filling;
}

std::optional<Filling> little_area_filling(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                           const TakenDiagonal& is_taken) {
  const std::size_t n = loop.size();
  const GuessedAreas area(points, loop);
  std::vector<std::size_t> before(n), after(n);
  for (std::size_t i = 0; i < n; ++i) before[i] = (i + n - 1) % n, after[i] = (i + 1) % n;
  std::vector<double> size(n);
  std::set<std::pair<double, std::size_t>> ears;
  std::size_t left = n;
  const auto look_at = [&](std::size_t i) {
    ears.erase({size[i], i});
    const bool may_be = left == 3 || !is_taken(loop[before[i]], loop[after[i]]);
    size[i] = may_be ? area(before[i], i, after[i]) : none_known;
    if (size[i] < none_known) ears.insert({size[i], i});
  };
  for (std::size_t i = 0; i < n; ++i) size[i] = none_known;
  for (std::size_t i = 0; i < n; ++i) look_at(i);
  Filling filling;
  while (left > 2) {
    if (ears.empty()) return {};
    const std::size_t i = ears.begin()->second;
    ears.erase(ears.begin());
    filling.push_back({loop[before[i]], loop[i], loop[after[i]]});
    after[before[i]] = after[i], before[after[i]] = before[i];
    if (--left > 2) look_at(before[i]), look_at(after[i]);
    if (left == 3) look_at(after[after[i]]);
  }
  return filling;
}

}  // namespace plumb::surface
