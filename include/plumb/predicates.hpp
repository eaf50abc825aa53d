// Orientation and in-circle tests: on which side, and inside or outside?  The signs of the four classic predicates,
// exact for every finite double.
//
// Laws: (1) swapping two of the points that span the line, plane, circle or sphere flips the sign; an even permutation
//       keeps it.  (2) Zero exactly when the points are collinear, coplanar, cocircular or cospherical (or lower).
//       (3) Powers of two and translations that round nothing change nothing.  (4) The same input gives the same sign
//       on every compiler, instruction set and thread.
// Constructed and posed points are taken as well (certify/implicit.hpp), and points with an index under symbolic
// perturbation, of which no sign is zero (certify/perturbed.hpp).
// Beside them: orders, angles, distances, smallest spheres, powers, determinants, rays,
// planes in space, separating axes, radicals, moving points (docs/predicates.md).
// A coordinate that is NaN or infinite throws NonFinite, naming it; nothing else throws for points as given.
// Apart, because they cost every reader time: the exceptions (arith/error.hpp), check_environment
// (certify/environment.hpp), the vectors that batches take (certify/instruction_set.hpp); what is derived from a formula
// (certify/formula.hpp), in words (certify/bound_report.hpp) and as a claim to be proved (certify/proof_script.hpp);
// points whose numbers are bounded (certify/bounded_points.hpp); decisions of many signs (certify/world.hpp,
// certify/certainly.hpp), their bounds in words (certify/judged_bounds.hpp) and as claims (certify/judged_proofs.hpp);
// signs whose cost is known beforehand (certify/plan.hpp, certify/kernel.hpp, certify/lattice_point.hpp), decisions that
// are counted (certify/decision.hpp) or checked (certify/checked.hpp), and CGAL's kernel over ours
// (certify/cgal_kernel.hpp, certify/cgal_signs.hpp).
// Source: RTCD 3.1.6, 11.2.
// Cost: 1.5 to 2 times the plain formula where floating point suffices; tens of nanoseconds on degenerate input
// (docs/measurements.md).
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/certify/accepted.hpp"
#include "plumb/certify/answered.hpp"
#include "plumb/certify/batch.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/constructed.hpp"
#include "plumb/certify/coplanar.hpp"
#include "plumb/certify/cross_products.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/determinant_sign.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/certify/implicit.hpp"
#include "plumb/certify/line_triangle.hpp"
#include "plumb/certify/moving_points.hpp"
#include "plumb/certify/perturbed.hpp"
#include "plumb/certify/power.hpp"
#include "plumb/certify/radical.hpp"
#include "plumb/certify/ray_order.hpp"
#include "plumb/certify/separating_axis.hpp"
#include "plumb/certify/side.hpp"
#include "plumb/certify/side_of_plane.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/certify/signs_of.hpp"
#include "plumb/certify/smallest_sphere.hpp"
#include "plumb/predicates/standard.hpp"

namespace plumb {

/// Positive when a, b, c turn counterclockwise; zero when collinear.
template <int = 0>
PLUMB_CHECKABLE inline Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return sign_of(predicates::Orient2d{}, a, b, c);
}

/// Positive when d lies below the plane of a, b, c, where 'above' sees them counterclockwise; zero when coplanar.
template <int = 0>
PLUMB_CHECKABLE inline Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of(predicates::Orient3d{}, a, b, c, d);
}

/// For counterclockwise a, b, c positive when d is inside their circle; zero when cocircular (or all collinear).
template <int = 0>
PLUMB_CHECKABLE inline Sign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of(predicates::InCircle{}, a, b, c, d);
}

/// For orient3d(a, b, c, d) > 0 positive when e is inside their sphere; zero when cospherical (or all coplanar).
template <int = 0>
PLUMB_CHECKABLE inline Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                     const Point3& e) {
  return sign_of(predicates::InSphere{}, a, b, c, d, e);
}

}  // namespace plumb
