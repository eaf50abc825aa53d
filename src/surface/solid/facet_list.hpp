// What is an arrangement while it is built: facets with their planes, sources and numbers of points.
//
// Laws: a facet turns counterclockwise seen from above its plane; sides are numbered 2 f above facet f, 2 f + 1 below.
// Going from above a face of the pool to below, the winding number of a mesh grows by the face's uses in it.
// Source: Zhou et al. 2016.
// Cost: none.
#pragma once

#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "surface/planar/triangles.hpp"
#include "surface/solid/plane_pieces.hpp"

namespace plumb::surface {

struct FacetList {
  std::vector<TurnedPlane> planes;  // of what is divided
  std::vector<TriangleMesh::Triangle> facets;
  std::vector<std::uint32_t> plane_of;  // or none, of a face that nothing cuts
  std::vector<CoveringFace> covers;
  std::vector<std::uint32_t> first_cover{0};

  [[nodiscard]] TurnedPlane plane_of_facet(std::size_t facet) const {
    return plane_of[facet] != none ? planes[plane_of[facet]] : TurnedPlane{facets[facet]};
  }
  [[nodiscard]] std::span<const CoveringFace> covers_of(std::size_t facet) const {
    return std::span(covers).subspan(first_cover[facet], first_cover[facet + 1] - first_cover[facet]);
  }
};

constexpr std::uint32_t above(std::uint32_t facet) { return 2 * facet; }
constexpr std::uint32_t below(std::uint32_t facet) { return 2 * facet + 1; }

/// A face that nothing cuts is a facet that turns as the face does.
FacetList divide_planes(const FacePool& pool, PointTable& table, const PlaneClasses& classes);

/// The set of each side: those that lie in one cell and are connected around edges.  Sets are numbered as they come.
struct SideSets {
  std::vector<std::uint32_t> of;  // of each side
  std::uint32_t count = 0;
};
SideSets join_sides(const FacetList& list, const PointTable& table);

/// Each set winds so often around each mesh of the pool, as in Arrangement::windings; the tree is the pool's.
std::vector<std::int32_t> windings_of_sets(const FacePool& pool, const Bvh& bvh, const FacetList& list,
                                           const PointTable& table, const SideSets& sets);

}  // namespace plumb::surface
