// Which predicates are there?  One line each; tests, fuzzing, the program's `sign` command and the reference follow
// from this list.  How to add one: docs/add_a_predicate.md.
//
// The lists are by subject.  Each is compiled by itself (src/certify/catalog_*.cpp), and PLUMB_PREDICATES holds them
// all.
#pragma once

#include <plumb/predicates/direction.hpp>
#include <plumb/predicates/in_sphere.hpp>
#include <plumb/predicates/orient.hpp>

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

#define PLUMB_PREDICATES(X) \
  PLUMB_CLASSICS(X)         \
  PLUMB_DIRECTIONS(X)
