// How often do meshes wind around what is beside a facet?  One query for facets that are connected.
//
// Laws: exact, by a line from the facet (surface/solid/line_from_facet.hpp).
// Source: RTCD 5.4.3.
// Cost: a descent of the tree, and some exact signs for each triangle that the line may pass.
#pragma once

#include "plumb/space/bvh/bvh.hpp"
#include "surface/solid/facet_list.hpp"

namespace plumb::surface {

struct WindingBeside {
  bool is_above;                       // or below the facet
  std::vector<std::int32_t> windings;  // around each mesh
};

class OutsideWinding {
 public:
  /// The tree is the pool's.
  OutsideWinding(const FacePool& pool, const Bvh& bvh, const FacetList& list, const PointTable& table);
  [[nodiscard]] WindingBeside beside(std::uint32_t facet) const;

 private:
  const FacePool& pool_;
  const Bvh& bvh_;
  const FacetList& list_;
  const PointTable& table_;
};

}  // namespace plumb::surface
