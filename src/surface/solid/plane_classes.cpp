#include "surface/solid/plane_classes.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "surface/planar/triangles.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/topology/disjoint_sets.hpp"

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

template <class T>
void make_ascend(std::vector<T>& list) {
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

PlaneClasses find_plane_classes(const FacePool& pool, const Bvh& bvh, PointTable& table) {
  const auto faces = static_cast<std::uint32_t>(pool.mesh.triangles.size());
  if (faces == 0) return {};
  DisjointSets sets(faces);
  std::vector<std::uint8_t> is_cut(faces);
  std::vector<TrianglePair> across;
  for (const TrianglePair& pair : intersecting_pairs(bvh)) {
    if (is_coplanar(pool, pair)) {
      sets.unite(pair.a, pair.b);
      is_cut[pair.a] = is_cut[pair.b] = 1;
    } else {
      across.push_back(pair);
    }
  }
  const std::vector<Intersection3> common = intersections(bvh, bvh, across);
  struct Chord {
    std::uint32_t face;
    std::array<std::uint32_t, 2> ends;
  };
  std::vector<Chord> chords;
  const auto is_corner = [&](std::uint32_t face, std::uint32_t point) {
    return std::ranges::find(pool.mesh.triangles[face], point) != pool.mesh.triangles[face].end();
  };
  for (std::size_t i = 0; i < across.size(); ++i) {
    const std::vector<ExactPoint3>& ends = common[i].vertices;
    if (ends.empty()) continue;
    const std::uint32_t from = table.number_of(named_alike(ends.front()));
    const std::uint32_t to = ends.size() == 1 ? from : table.number_of(named_alike(ends.back()));
    for (const std::uint32_t face : {across[i].a, across[i].b}) {
      if (is_corner(face, from) && is_corner(face, to)) continue;  // a corner or an edge
      chords.push_back({face, {std::min(from, to), std::max(from, to)}});
      is_cut[face] = 1;
    }
  }
  PlaneClasses found;
  std::vector<std::uint32_t> class_of(faces, none);
  for (std::uint32_t f = 0; f < faces; ++f) {
    if (is_cut[f] == 0) {
      found.whole.push_back(f);
      continue;
    }
    const std::uint32_t first = sets.find(f);  // the smallest of them
    if (first == f) {
      class_of[f] = static_cast<std::uint32_t>(found.cut.size());
      found.cut.emplace_back();
    }
    class_of[f] = class_of[first];
    found.cut[class_of[f]].faces.push_back(f);
  }
  for (const auto& [face, ends] : chords) {
    PlaneClass& of = found.cut[class_of[face]];
    if (ends[0] == ends[1])
      of.points.push_back(ends[0]);
    else
      of.chords.push_back(ends);
  }
  for (PlaneClass& c : found.cut) {
    make_ascend(c.chords);
    make_ascend(c.points);
  }
  return found;
}

}  // namespace plumb::surface
