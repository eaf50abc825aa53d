#include "plumb/query/ray/parity.hpp"

#include <algorithm>
#include <vector>

#include "figure/basic/mesh_input.hpp"
#include "query/body/figure_input.hpp"
#include "query/ray/crossings.hpp"

namespace plumb {
namespace {

/// Nothing for a point on a triangle.
std::optional<query::Crossings> crossings(std::string_view function, const TriangleMesh& mesh, const Point3& p) {
  query::require_figure(function, "p", p);
  require_mesh(function, mesh);
  query::Crossings found;
  for (const auto& t : mesh.triangles) {
    const Triangle3 triangle{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    if (!found.take(triangle, p)) return {};
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
