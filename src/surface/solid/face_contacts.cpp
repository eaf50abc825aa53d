#include "surface/solid/face_contacts.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
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
    const std::uint32_t from = table.number_of(named_alike(ends.front()));
    const std::uint32_t to = ends.size() == 1 ? from : table.number_of(named_alike(ends.back()));
    found.across.push_back({{across[i].a, across[i].b}, {std::min(from, to), std::max(from, to)}});
  }
  return found;
}

}  // namespace plumb::surface
