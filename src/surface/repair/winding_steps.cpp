// Orientation: triangles of a component that agree, and closed shells that are not inside out.
#include <algorithm>

#include "plumb/surface/shells.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/repair/steps.hpp"
#include "surface/topology/windings.hpp"

namespace plumb::surface {
namespace {

using Points = std::array<Point3, 3>;

/// A triangle's points, in an order that no numbering changes.
Points sorted_points(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  Points points{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
  std::ranges::sort(points, comes_before);
  return points;
}

void turn(TriangleMesh::Triangle& t) { std::swap(t[1], t[2]); }

}  // namespace

void orientation_step(RepairWork& work) {
  TriangleMesh& mesh = work.mesh;
  const Windings windings = find_windings(mesh, find_edges(mesh));
  struct Component {
    std::uint32_t first = 0, triangles = 0, against = 0;
    std::uint32_t least = 0;  // where half are against: the triangle that is not to be turned
  };
  std::vector<Component> components(windings.components.count);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Component& c = components[windings.components.of[t]];
    if (c.triangles++ == 0) c.first = t;
    c.against += windings.against[t];
  }
  for (Component& c : components) c.least = c.first;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Component& c = components[windings.components.of[t]];
    if (2 * c.against != c.triangles) continue;
    if (std::ranges::lexicographical_compare(sorted_points(mesh, t), sorted_points(mesh, c.least), comes_before))
      c.least = t;
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Component& c = components[i];
    if (windings.orientable[i] == 0) {
      work.note(ChangeKind::one_sided, mesh.triangles[c.first][0], c.triangles);
    } else if (c.against != 0) {
      work.note(ChangeKind::turned_triangles, mesh.triangles[c.first][0], std::min(c.against, c.triangles - c.against));
    }
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t i = windings.components.of[t];
    const Component& c = components[i];
    if (windings.orientable[i] == 0) continue;
    const bool first_stays =
        2 * c.against != c.triangles ? 2 * c.against < c.triangles : windings.against[c.least] == 0;
    if ((windings.against[t] == 0) != first_stays) turn(mesh.triangles[t]);
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
