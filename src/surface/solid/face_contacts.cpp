#include "surface/solid/face_contacts.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "surface/planar/triangles.hpp"
#include "surface/repair/point_order.hpp"

namespace plumb::surface {
namespace {

bool is_coplanar(const FacePool& pool, const TrianglePair& pair) {
  const auto [a, b, c] = pool.points_of(pair.a);
  const auto& corners = pool.mesh.triangles[pair.a];
  for (const std::uint32_t v : pool.mesh.triangles[pair.b]) {
    if (std::ranges::find(corners, v) != corners.end()) continue;
    if (orient3d(a, b, c, pool.mesh.vertices[v]) != Sign::zero) return false;
  }
  return true;
}

/// Faces that share an edge see where it passes a third one alike, so that equal points are seen to be equal.
ExactPoint3 named_alike(const ExactPoint3& p) {
  const auto* given = std::get_if<LinePlanePoint3>(&p.as());
  if (given == nullptr) return p;
  std::array<Point3, 2> line{given->p, given->q};
  std::array<Point3, 3> plane{given->a, given->b, given->c};
  std::ranges::sort(line, comes_before);
  std::ranges::sort(plane, comes_before);
  return LinePlanePoint3{line[0], line[1], plane[0], plane[1], plane[2]};
}

/// The number of a point that is passed to the table, which learns which edge of either face it is on.
std::uint32_t noted_number(const FacePool& pool, const TrianglePair& pair, const ExactPoint3& point,
                           PointTable& table) {
  ExactPoint3 named = named_alike(point);
  std::array<std::uint32_t, 2> edge{none, none};
  if (const auto* made = std::get_if<LinePlanePoint3>(&named.as())) {
    for (const std::uint32_t face : {pair.a, pair.b}) {
      for (const std::uint32_t v : pool.mesh.triangles[face]) {
        if (pool.mesh.vertices[v] == made->p) edge[0] = v;
        if (pool.mesh.vertices[v] == made->q) edge[1] = v;
      }
    }
  }
  const std::uint32_t number = table.number_of(std::move(named));
  if (edge[0] != none && edge[1] != none) table.note_line(number, edge);
  return number;
}

}  // namespace

FaceContacts find_face_contacts(const FacePool& pool, const Bvh& bvh, PointTable& table) {
  if (!pool.held.empty()) return find_held_contacts(pool, table);
  FaceContacts found;
  std::vector<TrianglePair> across;
  for (const TrianglePair& pair : intersecting_pairs(bvh)) {
    if (is_coplanar(pool, pair))
      found.coplanar.push_back({pair.a, pair.b});
    else
      across.push_back(pair);
  }
  const std::vector<Intersection3> common = intersections(bvh, bvh, across);
  for (std::size_t i = 0; i < across.size(); ++i) {
    const std::vector<ExactPoint3>& ends = common[i].vertices;
    if (ends.empty()) continue;
    const std::uint32_t from = noted_number(pool, across[i], ends.front(), table);
    const std::uint32_t to = ends.size() == 1 ? from : noted_number(pool, across[i], ends.back(), table);
    found.across.push_back({{across[i].a, across[i].b}, {std::min(from, to), std::max(from, to)}});
  }
  return found;
}

}  // namespace plumb::surface
