// Which faces of a pool meet?  Pairs that lie in one plane, and what pairs of two planes have in common.
//
// Laws: (1) faces of one plane that have a point in common beyond shared vertices and edges are told; if corners are no
// doubles, others of one plane may be told too.  (2) What faces of two planes have in common is told by numbers of its
// ends; equal ends are a point.  Pairs that have nothing but shared vertices and edges in common are not told.
// Source: Zhou et al. 2016.
// Cost: that of intersecting_pairs and intersections where all corners are doubles; else that of overlapping_pairs and
// some signs for each pair of boxes.
#pragma once

#include <array>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "surface/solid/face_pool.hpp"
#include "surface/solid/point_table.hpp"

namespace plumb::surface {

struct FaceContacts {
  using Numbers = std::array<std::uint32_t, 2>;
  struct Across {
    Numbers faces, ends;
  };
  std::vector<Numbers> coplanar;
  std::vector<Across> across;
};

/// Puts the points that are constructed in the table; the tree is the pool's.
FaceContacts find_face_contacts(const FacePool& pool, const Bvh& bvh, PointTable& table);

/// The same for any pool.
FaceContacts find_held_contacts(const FacePool& pool, PointTable& table);

}  // namespace plumb::surface
