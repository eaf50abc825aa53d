#include "surface/solid/plane_classes.hpp"

#include <algorithm>

#include "surface/planar/triangles.hpp"
#include "surface/solid/face_contacts.hpp"
#include "surface/topology/disjoint_sets.hpp"

namespace plumb::surface {
namespace {

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
  const FaceContacts contacts = find_face_contacts(pool, bvh, table);
  for (const auto& [f, g] : contacts.coplanar) {
    sets.unite(f, g);
    is_cut[f] = is_cut[g] = 1;
  }
  struct Chord {
    std::uint32_t face;
    std::array<std::uint32_t, 2> ends;
  };
  std::vector<Chord> chords;
  const auto is_corner = [&](std::uint32_t face, std::uint32_t point) {
    return std::ranges::find(pool.mesh.triangles[face], point) != pool.mesh.triangles[face].end();
  };
  for (const auto& [pair, ends] : contacts.across) {
    for (const std::uint32_t face : pair) {
      if (is_corner(face, ends[0]) && is_corner(face, ends[1])) continue;  // a corner or an edge
      chords.push_back({face, ends});
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
