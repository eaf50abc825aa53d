// libccd's functions by the C signatures of `plumb fuzz --list`.
#include "bench/rivals/ccd_calls.hpp"

using namespace plumb::bench::libccd;

extern "C" {

int ccd_gjk_triangle_triangle(const double* a, const double* b) {
  return meet(ccdGJKIntersect, corners<3>(a), corners<3>(b));
}
int ccd_mpr_triangle_triangle(const double* a, const double* b) {
  return meet(ccdMPRIntersect, corners<3>(a), corners<3>(b));
}
int ccd_gjk_obb_obb(const double* a, const double* b) { return meet(ccdGJKIntersect, box(a), box(b)); }
int ccd_mpr_obb_obb(const double* a, const double* b) { return meet(ccdMPRIntersect, box(a), box(b)); }
}
