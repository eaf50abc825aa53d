// Bounding volume (OBB), principal axes: which oriented box fits well, for less work than the smallest one?
//
// Laws: (1) every box contains all points exactly: half extents are rounded up.  (2) The axes are orthonormal up to
// rounding.  (3) The result depends on the points alone, bit for bit where the hull is asked for; fit_obb_principal and
// fit_obb_surface depend on their order by rounding.  None is the least: where a fit chooses, it does as doubles measure.
// Any points will do: equal, collinear, coplanar, of any magnitude.  No points throw InvalidShape; NaN and infinities
// throw NonFinite; a box that doubles cannot hold throws BeyondDoubles.
// Source: RTCD 4.4.3, 4.4.4, 4.4.5; Gottschalk 2000 for the continuous covariance.
// Cost: linear in the points; those that ask for the hull cost the hull.  Bounded by n operations for each set of axes,
// of which a fixed number are tried, and by the hull.
#pragma once

#include <span>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

/// Along the principal axes of the points: clusters of points turn it.
Obb3 fit_obb_principal(std::span<const Point3> points);

/// Along the principal axes of the hull's vertices: points inside do not turn it.
Obb3 fit_obb_hull_vertices(std::span<const Point3> points);

/// Along the principal axes of the hull's surface, as if it were of sheet metal: neither points inside nor clusters of
/// them turn it.
Obb3 fit_obb_hull_surface(std::span<const Point3> points);

/// Along the principal axes of the surface of a mesh.  Throws InvalidShape for an index beyond the vertices.
Obb3 fit_obb_surface(std::span<const Point3> vertices, std::span<const TriangleMesh::Triangle> triangles);

enum class PrincipalAxis : unsigned char { longest, middle, shortest, best };

/// Keeps one principal axis of the hull's surface; the others lie along the smallest rectangle around the points seen
/// along it (RTCD 4.4.4).
Obb3 fit_obb_around_principal(std::span<const Point3> points, PrincipalAxis kept = PrincipalAxis::best);

struct BruteForceObbOptions {
  int orientations = 16;  // along each side of a face of the cube of directions
  int refinements = 30;   // of which each halves the step around the best direction
};

/// Of directions spread over the sphere the one whose box, turned about it as far as it gets, is smallest; then in ever
/// smaller steps around the best (RTCD 4.4.5).
Obb3 fit_obb_brute_force(std::span<const Point3> points, const BruteForceObbOptions& options = {});

}  // namespace plumb
