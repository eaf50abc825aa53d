#include "surface/solid/plane_classes.hpp"

#include <algorithm>
#include <tuple>

#include "plumb/predicates.hpp"
#include "plumb/space/bvh/build.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "surface/planar/triangles.hpp"
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

bool comes_before(const Point3& l, const Point3& r) { return std::tie(l.x, l.y, l.z) < std::tie(r.x, r.y, r.z); }

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

std::vector<PlaneClass> find_plane_classes(const FacePool& pool, PointTable& table) {
  const auto faces = static_cast<std::uint32_t>(pool.mesh.triangles.size());
  DisjointSets sets(faces);
  std::vector<TrianglePair> across;
  std::vector<Intersection3> common;
  if (faces != 0) {
    const Bvh bvh = build_bvh(pool.mesh);
    for (const TrianglePair& pair : intersecting_pairs(bvh)) {
      if (is_coplanar(pool, pair))
        sets.unite(pair.a, pair.b);
      else
        across.push_back(pair);
    }
    common = intersections(bvh, bvh, across);
  }
  std::vector<PlaneClass> classes;
  std::vector<std::uint32_t> class_of(faces, none);
  for (std::uint32_t f = 0; f < faces; ++f) {
    const std::uint32_t first = sets.find(f);  // the smallest of them
    if (first == f) {
      class_of[f] = static_cast<std::uint32_t>(classes.size());
      classes.emplace_back();
    }
    class_of[f] = class_of[first];
    classes[class_of[f]].faces.push_back(f);
  }
  const auto is_corner = [&](std::uint32_t face, std::uint32_t point) {
    return std::ranges::find(pool.mesh.triangles[face], point) != pool.mesh.triangles[face].end();
  };
  const auto is_edge = [&](std::uint32_t face, const std::array<std::uint32_t, 2>& chord) {
    return is_corner(face, chord[0]) && is_corner(face, chord[1]);
  };
  for (std::size_t i = 0; i < across.size(); ++i) {
    const std::vector<ExactPoint3>& ends = common[i].vertices;
    if (ends.empty()) continue;
    const std::uint32_t from = table.number_of(named_alike(ends.front()));
    const std::uint32_t to = ends.size() == 1 ? from : table.number_of(named_alike(ends.back()));
    const std::array<std::uint32_t, 2> chord{std::min(from, to), std::max(from, to)};
    for (const std::uint32_t face : {across[i].a, across[i].b}) {
      PlaneClass& of = classes[class_of[face]];
      if (from == to) {
        if (!is_corner(face, from)) of.points.push_back(from);
      } else if (!is_edge(face, chord)) {
        of.chords.push_back(chord);
      }
    }
  }
  for (PlaneClass& c : classes) {
    make_ascend(c.chords);
    make_ascend(c.points);
  }
  return classes;
}

}  // namespace plumb::surface
