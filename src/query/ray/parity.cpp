// The ray along x, seen along x: a point in the plane of y and z, and triangles around it.
//
// orient2d(a, b, p) changes with the y of p as a.z - b.z, with its z as b.y - a.y.  p is moved in y by far more than in
// z, and in x by far more than in y, which is not seen; so the moved point is on no edge but of one whose ends are one
// point.  Where it is in a triangle and p is not on that, p is off the triangle's plane.
#include "plumb/query/ray/parity.hpp"

#include <algorithm>
#include <vector>

#include "figure/basic/mesh_input.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/predicates.hpp"
#include "query/body/figure_input.hpp"

namespace plumb {
namespace {

/// The side of the edge from a to b on which the moved p lies; zero only where a and b are seen as one point.
Sign moved_side(const Point3& a, const Point3& b, const Point3& p) {
  if (const Sign s = orient2d({a.y, a.z}, {b.y, b.z}, {p.y, p.z}); s != Sign::zero) return s;
  return a.z != b.z ? sign_of_number(a.z - b.z) : sign_of_number(b.y - a.y);
}

struct Range {
  double least, most;
  Range(double a, double b, double c) : least(std::min(std::min(a, b), c)), most(std::max(std::max(a, b), c)) {}
  [[nodiscard]] bool holds(double x) const { return least <= x && x <= most; }
};

struct Crossings {
  std::uint64_t count = 0;
  std::int64_t outward = 0;  // less those inward
};

/// Nothing for a point on a triangle.
std::optional<Crossings> crossings(std::string_view function, const TriangleMesh& mesh, const Point3& p) {
  query::require_figure(function, "p", p);
  require_mesh(function, mesh);
  Crossings found;
  for (const auto& t : mesh.triangles) {
    const Point3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Range y(a.y, b.y, c.y), z(a.z, b.z, c.z);
    if (!y.holds(p.y) || !z.holds(p.z)) continue;
    const Range x(a.x, b.x, c.x);
    if (x.most < p.x) continue;
    if (x.least <= p.x && contains(Triangle3{a, b, c}, p)) return {};
    const Sign way = moved_side(a, b, p);
    if (way == Sign::zero || moved_side(b, c, p) != way || moved_side(c, a, p) != way) continue;
    // The triangle turns counterclockwise, seen from where the ray goes, where it is left on the way out.
    if (x.least <= p.x && orient3d(a, b, c, p) != way) continue;
    ++found.count;
    found.outward += static_cast<int>(way);
  }
  return found;
}

/// The edges of all triangles, each as (lower end, upper end, passed upward).
std::vector<std::array<std::uint32_t, 3>> sorted_edges(std::string_view function, const TriangleMesh& mesh) {
  require_mesh(function, mesh);
  std::vector<std::array<std::uint32_t, 3>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1u : 0u});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Of each edge how often it is passed downward and upward.
template <class Allows>
bool all_edges(std::string_view function, const TriangleMesh& mesh, Allows allows) {
  const auto edges = sorted_edges(function, mesh);
  for (std::size_t i = 0; i < edges.size();) {
    std::array<std::size_t, 2> uses{};
    const std::size_t first = i;
    for (; i < edges.size() && edges[i][0] == edges[first][0] && edges[i][1] == edges[first][1]; ++i)
      ++uses[edges[i][2]];
    if (!allows(uses[0], uses[1])) return false;
  }
  return true;
}

}  // namespace

Location locate(const TriangleMesh& mesh, const Point3& p) {
  const auto found = crossings("locate", mesh, p);
  if (!found) return Location::boundary;
  return found->count % 2 == 1 ? Location::inside : Location::outside;
}

bool contains(const TriangleMesh& mesh, const Point3& p) { return locate(mesh, p) != Location::outside; }

std::optional<std::int64_t> winding_number(const TriangleMesh& mesh, const Point3& p) {
  const auto found = crossings("winding_number", mesh, p);
  if (!found) return {};
  return found->outward;
}

bool is_closed(const TriangleMesh& mesh) {
  return all_edges("is_closed", mesh, [](std::size_t down, std::size_t up) { return (down + up) % 2 == 0; });
}
bool is_oriented_closed(const TriangleMesh& mesh) {
  return all_edges("is_oriented_closed", mesh, [](std::size_t down, std::size_t up) { return down == up; });
}

}  // namespace plumb
