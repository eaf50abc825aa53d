// Triangles without area, and slivers: left out, and the neighbor at the longest edge divided at the corner on it.
#include <algorithm>

#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/direction.hpp"
#include "surface/repair/divide_edges.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/topology/between.hpp"
#include "surface/topology/mesh_corner.hpp"

namespace plumb::surface {
namespace {

/// The corner opposite to the longest edge; of equally long ones that which comes first.
std::size_t farthest_corner(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const auto at = [&](std::size_t k) -> const Point3& { return mesh.vertices[t[k % 3]]; };
  std::size_t best = 0;
  for (const std::size_t k : {1U, 2U}) {
    const Sign longer = compare_distance(at(k + 1), at(k + 2), at(best + 1), at(best + 2));
    if (longer == Sign::positive || (longer == Sign::zero && comes_before(at(k), at(best)))) best = k;
  }
  return best;
}

/// The corner on the longest edge, or by it; 3 where there is none.
std::size_t corner_on_edge(const TriangleMesh& mesh, const TriangleMesh::Triangle& t, const RepairStep& step) {
  const std::size_t k = farthest_corner(mesh, t);
  const Point3 &p = mesh.vertices[t[k]], &a = mesh.vertices[t[(k + 1) % 3]], &b = mesh.vertices[t[(k + 2) % 3]];
  const bool is_on = step.kind == RepairKind::degenerate
                         ? is_strictly_between(a, p, b)
                         : angle_sign(p, a, b) == Sign::positive && angle_sign(p, b, a) == Sign::positive &&
                               compare_distance_to_segment(a, b, p, step.tolerance) != Sign::positive;
  return is_on ? k : 3;
}

bool is_flat(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  return collinear(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
}

EdgeDivision division_at(const TriangleMesh::Triangle& t, std::size_t k) {
  const std::uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
  return {{std::min(a, b), std::max(a, b)}, t[k]};
}

}  // namespace

void flat_triangles_step(RepairWork& work) {
  struct Flat {
    TriangleMesh::Triangle triangle;
    EdgeDivision division;
  };
  std::vector<Flat> flat;  // with a corner on the opposite edge
  std::vector<std::uint8_t> marked(work.mesh.triangles.size());
  for (std::uint32_t t = 0; t < marked.size(); ++t) {
    const TriangleMesh::Triangle& corners = work.mesh.triangles[t];
    const bool degenerate = work.step.kind == RepairKind::degenerate;
    if (degenerate && !is_flat(work.mesh, corners)) continue;
    const std::size_t k = names_a_vertex_twice(corners) ? 3 : corner_on_edge(work.mesh, corners, work.step);
    if (k == 3 && !degenerate) continue;  // an edge that is short is to be welded
    marked[t] = 1;
    if (k < 3) {
      flat.push_back({corners, division_at(corners, k)});
    } else {
      work.note(ChangeKind::flat_triangle, corners[0]);
    }
  }
  work.leave_out(marked);
  std::vector<EdgeDivision> divisions, refused;
  for (const Flat& f : flat) divisions.push_back(f.division);
  // An edge may come to be only when another is divided, which may go on as long as there are edges.
  const OnEdge on_edge = work.step.kind == RepairKind::degenerate ? OnEdge::exactly : OnEdge::nearly;
  for (std::size_t rounds = divisions.size(); rounds > 0; --rounds) {
    const std::size_t before = work.changes.size();
    const Divided divided = divide_edges(work, divisions, on_edge);
    refused.insert(refused.end(), divided.refused.begin(), divided.refused.end());
    std::erase_if(divisions, [&](const EdgeDivision& d) { return std::ranges::binary_search(divided.refused, d); });
    if (work.changes.size() == before) break;
  }
  std::ranges::sort(refused);
  for (const Flat& f : flat) {
    const bool stays = std::ranges::binary_search(refused, f.division);
    if (stays) work.mesh.triangles.push_back(f.triangle);
    work.note(stays ? ChangeKind::kept_flat : ChangeKind::flat_triangle, f.division.vertex);
  }
}

}  // namespace plumb::surface
