// Moving ball, box, capsule or convex polyhedron against a BSP tree of solid leaves: when does it first touch the solid,
// and which face?
//
//   if (const auto touch = first_touch(tree, Translating{Sphere3{{0, 0, 5}, 0.5}, {0, 0, -9}})) ...
//   touch->face, touch->contact.time, .feature_a, .feature_b; touch->within
//
// The faces are asked themselves.  Planes that are moved outward by what the shape reaches, and planes that bevel edges,
// would bound more than the sum of solid and shape, at the corners and where the shape is round.
// Laws: (1) exact: the first time of [0, 1] at which the closed shape and the closed solid have a point in common, in
// passing too; nothing where there is none.  (2) Where the shape begins within the solid and touches no face, `within` is
// true, the time is 0, and there is no face.  (3) Else the face is the lowest number of those that are met at that
// time, and the contact that of first_contact(moving, triangle), of more corners the triangles around the first one
// (query/time_of_impact/translating_contact.hpp): its time is rounded down, never late.  Faces without area are not
// named.  Sheets with the solid, or nothing, on both sides are met as well.
// A tree without solid leaves, a shape that is none and an empty polyhedron throw InvalidShape, NaN and infinity
// NonFinite.
// Source: RTCD 8.4.3.
// Cost: a sign for each corner of the box that the shape sweeps and each plane that it meets; a contact for each face
// there whose box meets that box.  Bounded by n^2 signs and contacts for n shapes and n nodes, on integers as long as the
// exponents' span.
#pragma once

#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/query/time_of_impact/motion.hpp"
#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb {

struct BspTouch {
  std::uint32_t face;  // none: 0xffffffff
  Contact contact;
  bool within;
};

std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<Sphere3>& moving);
std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<Capsule3>& moving);
std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<Aabb3>& moving);
std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<ConvexPolyhedron3>& moving);

}  // namespace plumb
