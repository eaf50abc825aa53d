// Which predicates are there?  One line each; tests, fuzzing, the program's `sign` command and the reference follow
// from this list.  How to add one: docs/add_a_predicate.md.
#pragma once

#include <plumb/predicates/in_sphere.hpp>
#include <plumb/predicates/orient.hpp>

// X(formula)
#define PLUMB_PREDICATES(X) \
  X(Orient2d)               \
  X(Orient3d)               \
  X(InCircle)               \
  X(InSphere)
