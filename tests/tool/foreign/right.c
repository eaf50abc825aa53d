/* Predicates that are right: those of the classic library. */
#include "plumb/classic.h"

double right_orient3d(const double *a, const double *b, const double *c, const double *d) {
  return orient3d(a, b, c, d);
}
