#include "space/bvh/surface_pieces.hpp"

#include <algorithm>

#include "plumb/arith/interval.hpp"
#include "plumb/figure/sphere/fits.hpp"

namespace plumb::space {
namespace {

/// Around (a + b) / 2 of all a and b in these.
Aabb3 middle_box(const Aabb3& a, const Aabb3& b) {
  const auto middle = [](double a_low, double a_high, double b_low, double b_high) {
    const Interval half(0.5);
    return half * Interval(a_low, a_high) + half * Interval(b_low, b_high);
  };
  const Interval x = middle(a.min.x, a.max.x, b.min.x, b.max.x), y = middle(a.min.y, a.max.y, b.min.y, b.max.y),
                 z = middle(a.min.z, a.max.z, b.min.z, b.max.z);
  return {{x.lower, y.lower, z.lower}, {x.upper, y.upper, z.upper}};
}

double rough_length(const Aabb3& a, const Aabb3& b) {
  const double x = a.min.x / 2 - b.min.x / 2, y = a.min.y / 2 - b.min.y / 2, z = a.min.z / 2 - b.min.z / 2;
  return std::max({x < 0 ? -x : x, y < 0 ? -y : y, z < 0 ? -z : z});
}

/// Across the longest edge, by a guess: any will do.
std::array<SurfacePiece, 2> cut_in_two(const SurfacePiece& piece) {
  const auto& c = piece.corners;
  std::size_t from = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (rough_length(c[i], c[(i + 1) % 3]) > rough_length(c[from], c[(from + 1) % 3])) from = i;
  }
  const std::size_t to = (from + 1) % 3, other = (from + 2) % 3;
  const Aabb3 middle = middle_box(c[from], c[to]);
  return {{{{c[from], middle, c[other]}}, {{middle, c[to], c[other]}}}};
}

}  // namespace

void add_corners(const Aabb3& box, std::vector<Point3>& points) {
  if (box.min == box.max) return points.push_back(box.min);
  for (unsigned i = 0; i < 8; ++i) {
    points.push_back({(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                      (i & 4) != 0 ? box.max.z : box.min.z});
  }
}

std::vector<Point3> SurfacePiece::points() const {
  std::vector<Point3> all;
  for (const Aabb3& corner : corners) add_corners(corner, all);
  return all;
}

CoveredPieces covered_pieces(const Bvh& mesh, double radius, int most_halvings) {
  struct Later {
    SurfacePiece piece;
    int halvings;
  };
  CoveredPieces covered;
  std::vector<Later> later;
  // By number, so that the pieces depend on no tree.
  std::vector<std::uint32_t> slots(mesh.triangles.size());
  for (std::uint32_t s = 0; s < slots.size(); ++s) slots[s] = s;
  std::ranges::sort(slots, {}, [&](std::uint32_t s) { return mesh.tree.items[s]; });
  for (const std::uint32_t slot : slots) {
    const auto [a, b, c] = mesh.triangle(slot);
    later.push_back({{{Aabb3{a, a}, Aabb3{b, b}, Aabb3{c, c}}}, 0});
    while (!later.empty()) {
      const auto [piece, halvings] = later.back();
      later.pop_back();
      const std::vector<Point3> points = piece.points();
      const Sphere3 sphere = fit_sphere_ritter(points);
      if (sphere.radius <= radius || halvings == most_halvings) {
        covered.pieces.push_back(piece);
        covered.spheres.push_back(sphere);
        continue;
      }
      const auto [first, second] = cut_in_two(piece);
      later.push_back({second, halvings + 1});
      later.push_back({first, halvings + 1});
    }
  }
  return covered;
}

}  // namespace plumb::space
