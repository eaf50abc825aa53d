// Of many planes with one normal: which does each triangle reach, and on which side of each lies a vertex?
//
// Laws: sides are exact.  Along one normal a point lies above planes up to an offset and below those beyond another, so
// that a binary search by exact signs knows all its sides.
// Source: Minetto et al. 2017, with any normal.  Cost: a side for each vertex and bit of the number of planes, then the
// triangles of each plane, one by one; eight bytes a vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "surface/section/cut_plane.hpp"

namespace plumb::surface {

/// The planes, by their places, of each normal in the order of their offsets; one by three points alone.
std::vector<std::vector<std::uint32_t>> planes_by_normal(std::span<const AnyPlane3> planes);

class PlaneSweep {
 public:
  /// Planes of one normal in the order of their offsets, or a single one.
  PlaneSweep(const TriangleMesh& mesh, std::span<const CutPlane* const> planes);

  /// Those with a corner above the plane or in it and one below or in it, in ascending order.
  [[nodiscard]] const std::vector<std::uint32_t>& triangles(std::size_t plane) const { return triangles_[plane]; }
  /// That of CutPlane::side.
  [[nodiscard]] Sign side(std::uint32_t vertex, std::size_t plane) const {
    const Rank& at = ranks_[vertex];
    return plane < at.above ? Sign::positive : plane < at.up_to ? Sign::zero : Sign::negative;
  }

 private:
  /// A vertex lies above the first planes, then in some, and below the rest.
  struct Rank {
    std::uint32_t above, up_to;
  };

  std::vector<Rank> ranks_;
  std::vector<std::vector<std::uint32_t>> triangles_;
};

}  // namespace plumb::surface
