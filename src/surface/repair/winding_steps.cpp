// Orientation: triangles of a component that agree, and closed shells that are not inside out.
#include <algorithm>

#include "figure/basic/lists_by_number.hpp"
#include "plumb/surface/topology/shells.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/repair/steps.hpp"
#include "surface/topology/windings.hpp"

namespace plumb::surface {
namespace {

using Points = std::array<Point3, 3>;

constexpr auto no_vertex = static_cast<std::uint32_t>(-1);

bool points_before(const Points& s, const Points& t) {
  return std::ranges::lexicographical_compare(s, t, comes_before);
}

/// The points of some triangles, each turned or not, in an order that no numbering changes.
std::vector<Points> sorted_points(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles,
                                  std::span<const std::uint8_t> against, std::uint8_t turned) {
  std::vector<Points> all;
  for (const std::uint32_t t : triangles) {
    auto corners = mesh.triangles[t];
    if (against[t] == turned) std::swap(corners[1], corners[2]);
    begin_with_first(mesh.vertices, corners);
    all.push_back({mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]});
  }
  std::ranges::sort(all, points_before);
  return all;
}

void turn(TriangleMesh::Triangle& t) { std::swap(t[1], t[2]); }

}  // namespace

void orientation_step(RepairWork& work) {
  TriangleMesh& mesh = work.mesh;
  const Windings windings = find_windings(mesh, find_edges(mesh));
  const figure::ListsByNumber components(windings.components.of, windings.components.count);
  for (std::uint32_t c = 0; c < windings.components.count; ++c) {
    const auto triangles = components[c];
    std::size_t against = 0;
    for (const std::uint32_t t : triangles) against += windings.against[t];
    if (windings.orientable[c] == 0) {
      work.note(ChangeKind::one_sided, mesh.triangles[triangles[0]][0], triangles.size());
      continue;
    }
    if (against == 0) continue;
    std::uint8_t turned = 2 * against <= triangles.size() ? 1 : 0;  // those that are against, or the others
    if (2 * against == triangles.size() &&
        std::ranges::lexicographical_compare(sorted_points(mesh, triangles, windings.against, 0),
                                             sorted_points(mesh, triangles, windings.against, 1), points_before))
      turned = 0;
    std::uint32_t first = no_vertex;  // of those that are turned
    for (const std::uint32_t t : triangles) {
      if (windings.against[t] != turned) continue;
      turn(mesh.triangles[t]);
      for (const std::uint32_t v : mesh.triangles[t])
        if (first == no_vertex || comes_before(mesh.vertices[v], mesh.vertices[first])) first = v;
    }
    work.note(ChangeKind::turned_triangles, first, std::min(against, triangles.size() - against));
  }
}

void outward_step(RepairWork& work) {
  const Shells found = find_shells(work.mesh, {.execution = work.execution});
  for (const Shell& s : found.shells)
    if (s.inside_out()) work.note(ChangeKind::turned_shell, work.mesh.triangles[s.first_triangle][0], s.triangles);
  for (std::uint32_t t = 0; t < work.mesh.triangles.size(); ++t)
    if (found.shell_of[t] != no_shell && found.shells[found.shell_of[t]].inside_out()) turn(work.mesh.triangles[t]);
}

}  // namespace plumb::surface
