#include "surface/solid/outside_winding.hpp"

#include "plumb/space/range/range_search.hpp"
#include "surface/solid/line_from_facet.hpp"

namespace plumb::surface {

OutsideWinding::OutsideWinding(const FacePool& pool, const Bvh& bvh, const FacetList& list, const PointTable& table)
    : pool_(pool), bvh_(bvh), list_(list), table_(table) {}

WindingBeside OutsideWinding::beside(std::uint32_t facet) const {
  const NumberedPoints points = table_.points();
  const LineFromFacet line(points, list_.facets[facet], list_.plane_of_facet(facet));
  WindingBeside found{line.starts_above(), std::vector<std::int32_t>(pool_.meshes)};
  for (const std::uint32_t face : meeting(bvh_, line.box())) {
    const int winding = line.winding_of(points, pool_.mesh.triangles[face]);
    if (winding == 0) continue;
    for (const FacetSource& use : pool_.uses_of(face))
      if (!pool_.is_sheet(use.face.mesh)) found.windings[use.face.mesh] += use.opposite ? -winding : winding;
  }
  return found;
}

}  // namespace plumb::surface
