// Ray cast in a BSP tree of solid leaves: where does a ray, a segment or a line first meet the boundary of the solid, and
// which face is there?
//
//   if (const auto hit = first_hit(tree, Ray3{eye, direction})) ...    // hit->face, hit->hit.t, .point, .normal
//   hit->leaf, hit->from_inside
//
// Laws: (1) exact: the place is the first that both a solid leaf and one that is not have on their closed borders.
// (2) So of meshes whose faces all have the solid on one side alone the answer is that of first_hit of their Bvh
// (space/ray/mesh_ray.hpp), also at vertices, along edges and in the planes of faces: the face is the lowest number
// that holds the place, `hit` what query/ray/ray.hpp says of it.  Faces without area are not named, sheets with the
// solid, or nothing, on both sides are not hit.  (3) `leaf` is a solid leaf that has the place, `from_inside` whether the
// ray is in the solid before it; what begins on the boundary hits it there, from outside.
// A tree without solid leaves throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 8.4.2.
// Cost: an interval of the parameter for each plane that is passed, exact signs where intervals overlap; the numbers of the
// hit.  Bounded by n^2 signs for n nodes, on integers as long as the exponents' span.
#pragma once

#include <optional>

#include "plumb/query/ray/ray.hpp"
#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb {

struct BspHit {
  std::uint32_t face;
  Hit hit;
  std::uint32_t leaf;
  bool from_inside;
};

std::optional<BspHit> first_hit(const BspTree& tree, const AnyRay& ray);
bool any_hit(const BspTree& tree, const AnyRay& ray);

}  // namespace plumb
