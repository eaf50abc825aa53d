#include "plumb/figure/obb/fits.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "figure/hull/canonical_hull.hpp"
#include "figure/hull/local_points.hpp"
#include "figure/measures/principal_axes.hpp"
#include "figure/obb/box_search.hpp"
#include "figure/obb/calipers.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb {
namespace {

using namespace figure::frame;
using figure::CanonicalHull;

void require_points(std::string_view function, std::span<const Point3> points) {
  figure::require_finite_points(function, "points", points);
  if (points.empty()) throw InvalidShape(std::string(function).append(": no points; give at least one"));
}

CanonicalHull hull_of(std::span<const Point3> points) { return {"convex_hull", convex_hull(points), points}; }

// Faces as fans.
std::vector<TriangleMesh::Triangle> triangles_of(const Hull3& hull) {
  std::vector<TriangleMesh::Triangle> triangles;
  if (hull.dimension < 2) return triangles;
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) triangles.push_back({face[0], face[i], face[i + 1]});
  }
  return triangles;
}

// The smallest rectangle around points seen along the first axis, whose direction is kept.
FoundBox around(const std::array<Vector3, 3>& axes, std::span<const Vector3> points) {
  const auto& [d, u, v] = axes;
  std::vector<Point2> seen;
  seen.reserve(points.size());
  double least = 2, most = -2;
  for (const Vector3& p : points) {
    seen.push_back({dot(p, u), dot(p, v)});
    least = std::min(least, dot(p, d));
    most = std::max(most, dot(p, d));
  }
  std::vector<Vector2> polygon;
  for (const std::uint32_t i : convex_hull(seen).vertices) polygon.push_back({seen[i].x, seen[i].y});
  const Calipers c = smallest_rectangle(polygon);
  const Vector3 along = plus(times(u, c.direction.x), times(v, c.direction.y));
  return {{d, along, cross(d, along)}, polygon.size() > 2 ? c.area * (most - least) : 0};
}

// Around the principal axis, the best of several.
std::array<Vector3, 3> turned(const std::array<Vector3, 3>& axes, std::span<const Vector3> points, PrincipalAxis kept) {
  FoundBox best{axes, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < 3; ++k) {
    if (kept != PrincipalAxis::best && static_cast<std::size_t>(kept) != k) continue;
    const FoundBox box = around({axes[k], axes[(k + 1) % 3], axes[(k + 2) % 3]}, points);
    if (box.volume < best.volume) best = box;
  }
  return best.axes;
}

// A direction of the upper half of the cube's faces and its neighbors, a step away each.
class Directions {
 public:
  explicit Directions(const HullModel& model) : model_(model) {}

  void try_direction(int side, double u, double v) {
    const Vector3 d = side == 0 ? Vector3{1, u, v} : side == 1 ? Vector3{v, 1, u} : Vector3{u, v, 1};
    const FoundBox box = box_along(model_, d);
    if (box.volume >= best_.volume) return;
    best_ = box;
    side_ = side, u_ = u, v_ = v;
  }
  /// False when no neighbor is better.
  bool step(double by) {
    const int side = side_;
    const double u = u_, v = v_, before = best_.volume;
    for (const auto& [du, dv] : {std::pair{by, 0.0}, std::pair{-by, 0.0}, std::pair{0.0, by}, std::pair{0.0, -by},
                                 std::pair{by, by}, std::pair{-by, -by}, std::pair{by, -by}, std::pair{-by, by}})
      try_direction(side, u + du, v + dv);
    return best_.volume < before;
  }
  [[nodiscard]] const FoundBox& best() const { return best_; }

 private:
  const HullModel& model_;
  FoundBox best_{{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, std::numeric_limits<double>::infinity()};
  int side_ = 0;
  double u_ = 0, v_ = 0;
};

}  // namespace

Obb3 fit_obb_principal(std::span<const Point3> points) {
  require_points("fit_obb_principal", points);
  return fit_obb(principal_axes(localized(points)), points);
}

Obb3 fit_obb_hull_vertices(std::span<const Point3> points) {
  require_points("fit_obb_hull_vertices", points);
  const auto vertices = hull_of(points).vertices;
  return fit_obb(principal_axes(localized(vertices)), vertices);
}

Obb3 fit_obb_hull_surface(std::span<const Point3> points) {
  require_points("fit_obb_hull_surface", points);
  const auto [vertices, hull] = hull_of(points);
  return fit_obb(principal_axes_of_surface(localized(vertices), triangles_of(hull)), vertices);
}

Obb3 fit_obb_surface(std::span<const Point3> vertices, std::span<const TriangleMesh::Triangle> triangles) {
  figure::require_finite_points("fit_obb_surface", "vertices", vertices);
  if (vertices.empty()) throw InvalidShape("fit_obb_surface: no vertices; give at least one");
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (std::ranges::max(triangles[i]) < vertices.size()) continue;
    throw InvalidShape(std::string("fit_obb_surface: triangle ")
                           .append(std::to_string(i))
                           .append(" names a vertex beyond the last one; give indices below ")
                           .append(std::to_string(vertices.size())));
  }
  return fit_obb(principal_axes_of_surface(localized(vertices), triangles), vertices);
}

Obb3 fit_obb_around_principal(std::span<const Point3> points, PrincipalAxis kept) {
  require_points("fit_obb_around_principal", points);
  const auto [vertices, hull] = hull_of(points);
  const auto local = localized(vertices);
  return fit_obb(turned(principal_axes_of_surface(local, triangles_of(hull)), local, kept), vertices);
}

Obb3 fit_obb_brute_force(std::span<const Point3> points, const BruteForceObbOptions& options) {
  require_points("fit_obb_brute_force", points);
  if (options.orientations < 1 || options.refinements < 0)
    throw InvalidShape("fit_obb_brute_force: options; give at least one orientation and no negative refinements");
  const auto [vertices, hull] = hull_of(points);
  if (hull.dimension < 3) return minimum_obb(vertices, hull);  // in the plane the smallest costs less
  const HullModel model(hull, vertices);
  Directions directions(model);
  const double apart = 2.0 / options.orientations;
  for (int side = 0; side < 3; ++side) {
    for (int i = 0; i < options.orientations; ++i) {
      for (int j = 0; j < options.orientations; ++j)
        directions.try_direction(side, (i + 0.5) * apart - 1, (j + 0.5) * apart - 1);
    }
  }
  constexpr int most_steps = 8;  // at one size: the best direction is seldom as many away
  double step = apart / 2;
  for (int k = 0; k < options.refinements; ++k, step /= 2) {
    for (int moved = 0; moved < most_steps && directions.step(step); ++moved) continue;
  }
  return fit_obb(directions.best().axes, vertices);
}

}  // namespace plumb
