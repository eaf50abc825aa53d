// Which predicates are there?  One line each; tests, fuzzing, the program's `sign` command and the reference follow
// from this list.  How to add one: docs/add_a_predicate.md.
//
// The lists are by subject.  Each is compiled by itself (src/certify/catalog_*.cpp), and PLUMB_PREDICATES holds them
// all.
#pragma once

#include "plumb/predicates/cross_products.hpp"
#include "plumb/predicates/determinant.hpp"
#include "plumb/predicates/direction.hpp"
#include "plumb/predicates/distance.hpp"
#include "plumb/predicates/in_sphere.hpp"
#include "plumb/predicates/line_distance.hpp"
#include "plumb/predicates/line_triangle.hpp"
#include "plumb/predicates/moving_points.hpp"
#include "plumb/predicates/orient.hpp"
#include "plumb/predicates/plane_distance.hpp"
#include "plumb/predicates/power.hpp"
#include "plumb/predicates/radical.hpp"
#include "plumb/predicates/ray_order.hpp"
#include "plumb/predicates/separating_axis.hpp"
#include "plumb/predicates/smallest_sphere.hpp"

// X(formula)

// The four that meshes and hulls are made with.  They have every stage, and the tests try them hardest.
#define PLUMB_CLASSICS(X) \
  X(Orient2d)             \
  X(Orient3d)             \
  X(InCircle)             \
  X(InSphere)

// predicates/direction.hpp
#define PLUMB_DIRECTIONS(X) \
  X(OrderOnAxis)            \
  X(OrderAlongDirection2d)  \
  X(OrderAlongDirection3d)  \
  X(OrderAlongLine2d)       \
  X(OrderAlongLine3d)       \
  X(Dot2d)                  \
  X(Dot3d)                  \
  X(Angle2d)                \
  X(Angle3d)                \
  X(Cross2d)                \
  X(CrossX)                 \
  X(CrossY)                 \
  X(CrossZ)                 \
  X(OrientX)                \
  X(OrientY)                \
  X(OrientZ)

// predicates/distance.hpp, predicates/line_distance.hpp, predicates/plane_distance.hpp
#define PLUMB_DISTANCES(X)   \
  X(CompareDistance2d)       \
  X(CompareDistance3d)       \
  X(CompareDistanceFrom2d)   \
  X(CompareDistanceFrom3d)   \
  X(DistanceAgainst2d)       \
  X(DistanceAgainst3d)       \
  X(SignedLineDistance)      \
  X(LineDistanceSum)         \
  X(CompareLineDistance)     \
  X(LineDistanceAgainst2d)   \
  X(LineDistanceAgainst3d)   \
  X(ComparePointLine2d)      \
  X(ComparePointLine3d)      \
  X(CompareLineLine2d)       \
  X(CompareLineLine3d)       \
  X(SideOfLine)              \
  X(SideOfPlane)             \
  X(NormalDistanceAgainst2d) \
  X(NormalDistanceAgainst3d) \
  X(SignedPlaneDistance)     \
  X(PlaneDistanceSum)        \
  X(PlaneDistanceAgainst)    \
  X(ComparePointPlane)       \
  X(CompareLinePlane)        \
  X(ComparePlanePlane)

// predicates/smallest_sphere.hpp, predicates/power.hpp
#define PLUMB_SPHERES(X) \
  X(InSmallestCircle)    \
  X(InSmallestSphere2)   \
  X(InSmallestSphere3)   \
  X(PowerCircle)         \
  X(PowerSphere)         \
  X(ComparePower2d)      \
  X(ComparePower3d)      \
  X(PowerProduct2d)      \
  X(PowerProduct3d)

// predicates/determinant.hpp
#define PLUMB_DETERMINANTS(X) \
  X(Determinant2)             \
  X(Determinant3)             \
  X(Determinant4)             \
  X(Determinant5)

// predicates/line_triangle.hpp, predicates/ray_order.hpp
#define PLUMB_RAYS(X) \
  X(LineEdge)         \
  X(OrientSeenFrom)   \
  X(OrientSeenAlong)  \
  X(RayOrder)         \
  X(SegmentOrder)     \
  X(RayAgainst)       \
  X(SegmentAgainst)

// predicates/cross_products.hpp, predicates/separating_axis.hpp, predicates/moving_points.hpp
#define PLUMB_CROSS_PRODUCTS(X) \
  X(DotOfCrosses)               \
  X(CoplanarSide)               \
  X(OrderAlongCross)            \
  X(BoxGap)                     \
  X(CoplanarityMiddle)

// predicates/radical.hpp
#define PLUMB_RADICALS(X) \
  X(RadicalNorm)          \
  X(RadicalPairPart)      \
  X(RadicalPairNorm)

#define PLUMB_PREDICATES(X) \
  PLUMB_CLASSICS(X)         \
  PLUMB_DIRECTIONS(X)       \
  PLUMB_DISTANCES(X)        \
  PLUMB_SPHERES(X)          \
  PLUMB_DETERMINANTS(X)     \
  PLUMB_RAYS(X)             \
  PLUMB_CROSS_PRODUCTS(X)   \
  PLUMB_RADICALS(X)
