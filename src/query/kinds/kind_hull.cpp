#include "query/kinds/kind_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/arith/big.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/predicates.hpp"

namespace plumb::degenerate {

namespace {

std::vector<Point3> points_of(std::span<const double> numbers) {
  std::vector<Point3> points;
  for (std::size_t i = 1; i + 2 < numbers.size(); i += 3) {
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return points;
}

Judgment wrong(std::string_view sort) { return {Verdict::wrong, sort}; }

/// Every directed edge once, and its reverse.
bool closes(const std::vector<TriangleMesh::Triangle>& triangles) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  }
  std::ranges::sort(edges);
  if (std::ranges::adjacent_find(edges) != edges.end()) return false;
  return std::ranges::all_of(edges, [&](const auto& e) {
    return std::ranges::binary_search(edges, std::array{e[1], e[0]});
  });
}

TriangleMesh mesh_of(const Hull3& hull, const std::vector<Point3>& points) {
  TriangleMesh mesh{points, {}};
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    mesh.triangles.push_back({face[0], face[1], face[2]});
  }
  return mesh;
}

BigDyadic six_volumes(const TriangleMesh& mesh) {
  BigDyadic sum;
  for (const auto& t : mesh.triangles) {
    const auto [a, b, c] = std::array{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    const auto minor = [](double p, double q, double r, double s) {
      return BigDyadic(p) * BigDyadic(q) - BigDyadic(r) * BigDyadic(s);
    };
    sum = sum + BigDyadic(a.x) * minor(b.y, c.z, b.z, c.y) + BigDyadic(a.y) * minor(b.z, c.x, b.x, c.z) +
          BigDyadic(a.z) * minor(b.x, c.y, b.y, c.x);
  }
  return sum;
}

/// Whether they enclose the same volume, of which one is a multiple of the other.
bool enclose_the_same(const TriangleMesh& a, const TriangleMesh& b) {
  const double volume = signed_volume(a);
  if (volume != signed_volume(b)) return false;
  return std::isnormal(volume) || (six_volumes(a) - six_volumes(b)).sign() == Sign::zero;
}

}  // namespace

Answer call_hull(ForeignFunction function, std::span<const Passed> passed) {
  constexpr std::size_t guards = 64, unused = 0xA5A5A5A5A5A5A5A5;
  const std::size_t n = passed[0].count, capacity = 2 * n;
  std::vector<std::size_t> triangles(3 * capacity + guards, unused);
  const std::size_t count = reinterpret_cast<HullFunction>(function)(passed[0].numbers, n, triangles.data(), capacity);
  if (std::ranges::any_of(std::span(triangles).subspan(3 * capacity), [](std::size_t x) { return x != unused; })) {
    return Answer(Outcome::crashed, "wrote beyond its capacity");
  }
  if (count == std::numeric_limits<std::size_t>::max()) return std::numeric_limits<double>::quiet_NaN();
  Answer answer;
  if (count > capacity) {
    answer.numbers = {static_cast<double>(count)};  // which is no triangle: too many
  } else {
    for (std::size_t i = 0; i < 3 * count; ++i) answer.numbers.push_back(static_cast<double>(triangles[i]));
  }
  return answer;
}

Answer exact_hull(std::span<const double> numbers) {
  const Hull3 hull = convex_hull(points_of(numbers), {.triangulate = true});
  Answer answer;
  if (hull.dimension == 3) answer.numbers.assign(hull.corners.begin(), hull.corners.end());
  return answer;
}

Judgment judge_hull(std::span<const double> numbers, const Answer& given) {
  const std::vector<Point3> points = points_of(numbers);
  const Hull3 hull = convex_hull(points, {.triangulate = true});
  if (given.numbers.size() % 3 != 0) return wrong("more triangles than its capacity");
  if (hull.dimension < 3) return given.numbers.empty() ? Judgment{} : wrong("triangles for points of one plane");
  if (given.numbers.empty()) return wrong("no triangles");

  TriangleMesh mesh{points, {}};
  for (std::size_t i = 0; i < given.numbers.size(); i += 3) {
    TriangleMesh::Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double index = given.numbers[i + k];
      if (!(index >= 0 && index < static_cast<double>(points.size())) || index != std::trunc(index))
        return wrong("an index beyond the points");
      const Point3& corner = points[static_cast<std::size_t>(index)];
      t[k] = static_cast<std::uint32_t>(std::ranges::find(points, corner) - points.begin());
    }
    mesh.triangles.push_back(t);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    bool any_below = false;
    for (const Point3& p : points) {
      const Sign side = orient3d(points[a], points[b], points[c], p);
      if (side == Sign::negative) return wrong("a point outside of a triangle");
      any_below = any_below || side == Sign::positive;
    }
    if (!any_below) return wrong("a triangle without area");
  }
  if (!closes(mesh.triangles)) return wrong("triangles that do not close");
  if (!enclose_the_same(mesh, mesh_of(hull, points))) return wrong("a face covered twice");
  return {};
}

}  // namespace plumb::degenerate
