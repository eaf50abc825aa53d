// Time of impact, swept test: when do two convex figures that move along lines first meet?
//
//   first_contact(Translating{Sphere3{{0, 0, 0}, 1}, {10, 0, 0}}, Translating{wall, {0, 0, 0}})
//
// Each is a Point3, Segment3, Triangle3, Aabb3, Obb3, ConvexPolyhedron3, Sphere3, Capsule3 or Plane3 (of which at most
// one), moving by a vector during time [0, 1]; one of the two may stand still and be given as it is.
// Laws: (1) they meet exactly when at some time of [0, 1] the closed sets have a common point; touching is meeting,
// also in passing.  (2) first_contact_time is that first time, exactly: a root of a polynomial of degree 2 at most. (3)
// first_contact has it rounded down, never late and within 1 ulp, and the features that meet there: of all that do
// those of the lowest dimensions taken together, then those of the lowest numbers of the first figure, then of the
// second; {interior, 0} for both where they overlap from the start.  A ball as a whole is {face, 0}, a capsule's ends
// are vertices and the rest edge 0.  (4) Only the difference of the motions counts; swapping the figures swaps the
// features, but where several meet at once.  (5) Degenerate figures are the sets that they are; an empty box
// meets nothing, nor does a plane of the normal zero that holds no point.  NaN and infinity throw NonFinite, a negative
// radius and a polyhedron without faces throw InvalidShape, all by name.
// Source: RTCD 5.5.2, 5.5.3, 5.5.4, 5.5.5, 5.5.6, 5.5.7 and 5.5.8.
// Cost: 10 to 150 ns for what misses, without allocation, up to a microsecond where there is a time; some microseconds
// for polyhedra and where doubles do not tell.  Bounded by n^2 pairs of features for n corners of both, on integers as
// long as the exponents' span.
#pragma once

#include <concepts>
#include <optional>

#include "plumb/arith/root.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/time_of_impact/motion.hpp"

namespace plumb {

/// What first_contact takes in straight motion.
template <class Shape>
concept MovesStraight =
    std::same_as<Shape, Point3> || std::same_as<Shape, Segment3> || std::same_as<Shape, Triangle3> ||
    std::same_as<Shape, Aabb3> || std::same_as<Shape, Obb3> || std::same_as<Shape, ConvexPolyhedron3> ||
    std::same_as<Shape, Sphere3> || std::same_as<Shape, Capsule3> || std::same_as<Shape, Plane3>;

/// Two of these, not both planes.
template <class A, class B>
concept MovingPair = MovesStraight<A> && MovesStraight<B> && !(std::same_as<A, Plane3> && std::same_as<B, Plane3>);

template <class A, class B>
requires MovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b);
template <class A, class B>
requires MovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b);
template <class A, class B>
requires MovingPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b);

}  // namespace plumb
