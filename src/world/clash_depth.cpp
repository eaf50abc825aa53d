#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/query/penetration/penetration.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "world/clash_solids.hpp"

namespace plumb::world {
namespace {

/// Does the mesh wind around what it winds around everywhere alike?
bool winds_alike(const Arrangement& of_both, std::size_t part) {
  std::int32_t all = 0;
  for (std::size_t r = 0; r < of_both.regions(); ++r) {
    const std::int32_t winding = of_both.windings_of(r)[part];
    if (winding == 0) continue;
    if (winding * winding != 1 || (all != 0 && winding != all)) return false;
    all = winding;
  }
  return true;
}

/// Corners of the inner part's facets that are in the outer one; what is cut in its surface is not deep.
std::vector<Point3> corners_inside(const Arrangement& of_both, std::uint32_t inner_number) {
  const std::uint32_t outer_number = 1 - inner_number;
  std::vector<std::uint8_t> is_in(of_both.vertices.size());
  for (std::size_t f = 0; f < of_both.facets.size(); ++f) {
    const auto sources = of_both.sources_of(f);
    if (std::ranges::any_of(sources, [&](const FacetSource& s) { return s.face.mesh == outer_number; })) continue;
    if (of_both.windings_of(of_both.sides[f].above)[outer_number] == 0) continue;
    for (const std::uint32_t v : of_both.facets[f]) is_in[v] = 1;
  }
  std::vector<Point3> points;
  for (std::size_t v = 0; v < is_in.size(); ++v)
    if (const auto* p = std::get_if<Point3>(&of_both.vertices[v].as()); is_in[v] != 0 && p != nullptr)
      points.push_back(*p);
  return points;
}

/// How far from the surface of the outer part the deepest of these is in it: rounded down.
double deepest(const ClashPart& outer, std::span<const Point3> corners) {
  double most = 0;
  for (const Point3& p : corners) most = std::max(most, closest_on_mesh(outer.bvh(), p)->distance);
  return std::max(0.0, std::nextafter(most, 0.0));
}

}  // namespace

void measure_in_common(const ClashPart& a, const ClashPart& b, const InCommon& common,
                       const std::array<bool, 2>& winds_alike, Clash& clash) {
  clash.volume = exact_volume(common.border).rounded();
  const ClashPart::Hull &of_a = a.hull(), &of_b = b.hull();
  const auto parting = penetration(VertexHull3{of_a.corners}, VertexHull3{of_b.corners});
  if (!parting) return;  // hulls of what meets meet
  ClashDepth& depth = clash.depth.emplace();
  depth.direction = parting->direction;
  // A solid fills its hull where their volumes are equal.
  if (winds_alike[0] && of_a.has_volume_of_part && winds_alike[1] && of_b.has_volume_of_part) {
    depth.lower = depth.upper = parting->depth;
    return;
  }
  depth.upper = std::nextafter(parting->depth, std::numeric_limits<double>::infinity());
  depth.lower = std::min(depth.upper, std::max(deepest(b, common.corners[0]), deepest(a, common.corners[1])));
}

void measure_solids(const ClashPart& a, const ClashPart& b, const Arrangement& of_both, Clash& clash) {
  const InCommon common{solid_where(of_both, [](auto winding) { return winding[0] != 0 && winding[1] != 0; }),
                        {corners_inside(of_both, 0), corners_inside(of_both, 1)}};
  measure_in_common(a, b, common, {winds_alike(of_both, 0), winds_alike(of_both, 1)}, clash);
}

}  // namespace plumb::world
