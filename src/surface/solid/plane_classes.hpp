// Which faces lie in one plane and meet, and where do others cut them?  All that is in common, by numbers of points.
//
// Laws: (1) faces that lie in one plane and have a point in common beyond shared vertices are of one class; every face
// is of one.  (2) What a face of another plane has in common with one of the class is a chord of it, or a point.  (3)
// Classes ascend by their first faces, and hold their faces, chords and points ascending.
// Source: Zhou et al. 2016.
// Cost: that of intersecting_pairs and intersections.
#pragma once

#include <array>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "surface/solid/face_pool.hpp"
#include "surface/solid/point_table.hpp"

namespace plumb::surface {

struct PlaneClass {
  std::vector<std::uint32_t> faces;
  std::vector<std::array<std::uint32_t, 2>> chords;
  std::vector<std::uint32_t> points;
};

struct PlaneClasses {
  std::vector<std::uint32_t> whole;  // faces that nothing cuts, each a class of its own
  std::vector<PlaneClass> cut;
};

/// Puts the points that are constructed in the table; the tree is the pool's.
PlaneClasses find_plane_classes(const FacePool& pool, const Bvh& bvh, PointTable& table);

}  // namespace plumb::surface
