// Area, signed volume, centroid: how large is it, and where is its middle?  Areas, volumes, surface areas and
// centroids.
//
// Laws: (1) areas, volumes and centroids are the exact value rounded once to the nearest double; surface areas that are
// a sum of several roots, and all that contain pi, are within 1 ulp of it, and nearest but for rare doubt.
// (2) Infinite beyond all doubles; a centroid out there throws BeyondDoubles.  (3) A chain's signed area counts every
// place as often as the chain winds around it, positive counterclockwise; area is its magnitude: that of the set where
// the chain does not cross itself.  (4) Holes are taken off, whichever way they are wound.  (5) A polygon in space that
// is not planar has the area of its largest shadow.  (6) What has no area or volume (exactly) has the mean of its
// vertices for centroid.  (7) Flat solids have both their sides for surface, as if they were very thin.
// Volume and surface of oriented boxes in space are in figure/obb/obb.hpp, of k-DOPs in figure/k_dop/k_dop.hpp.
// NaN and infinity throw NonFinite; negative radii, fewer than three vertices, open meshes: InvalidShape.
// Source: RTCD 3.4, 3.7, 3.8; Steiner's formula for what is swept by a ball.
// Cost: linear, by pairs of doubles: some 50 ns a vertex of a polygon, 0.2 to 0.4 us a face of a mesh (which is looked
// through for open edges, by sorting), 0.1 to 0.5 us a solid; integers where these leave a doubt.  Bounded by n log n
// operations for n faces, on integers as long as the exponents' span.
#pragma once

#include <span>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

/// Positive where the corners turn counterclockwise.  With holes: of the outer chain's sign, less the holes' areas.
double signed_area(const Triangle2& triangle);
double signed_area(const Quadrilateral2& quadrilateral);
double signed_area(const Polygon2& polygon);
double signed_area(const HoledPolygon2& polygon);

double area(const Triangle2& triangle);
double area(const Triangle3& triangle);
double area(const Quadrilateral2& quadrilateral);
double area(const Quadrilateral3& quadrilateral);
double area(const Polygon2& polygon);
double area(const Polygon3& polygon);
double area(const HoledPolygon2& polygon);
double area(const HoledPolygon3& polygon);
double area(const Circle2& circle);
double area(const Capsule2& capsule);
double area(const Aabb2& box);
double area(const Obb2& box);
double area(const Rectangle3& rectangle);

/// Of the sign of orient3d(a, b, c, d): positive when d lies below the plane of a, b, c.
double signed_volume(const Tetrahedron3& tetrahedron);

/// Of a closed surface, positive where its faces are counterclockwise seen from outside: every edge, by place, is
/// passed as often one way as the other.  Faces of more than three corners count as fans about their first corner.
double signed_volume(const TriangleMesh& mesh);
double signed_volume(const PolygonMesh& mesh);

double volume(const Tetrahedron3& tetrahedron);
double volume(const TriangleMesh& mesh);
double volume(const PolygonMesh& mesh);
double volume(const ConvexPolyhedron3& polyhedron);
double volume(const Aabb3& box);
double volume(const AabbWidths3& box);
double volume(const AabbCenter3& box);
double volume(const Sphere3& sphere);
double volume(const Capsule3& capsule);
double volume(const Lozenge3& lozenge);
double volume(const Cylinder3& cylinder);
double volume(const Cone3& cone);
double volume(const Ellipsoid3& ellipsoid);
double volume(const SphericalCap3& cap);

double surface_area(const Tetrahedron3& tetrahedron);
double surface_area(const TriangleMesh& mesh);
double surface_area(const PolygonMesh& mesh);
double surface_area(const ConvexPolyhedron3& polyhedron);
double surface_area(const Aabb3& box);
double surface_area(const AabbWidths3& box);
double surface_area(const AabbCenter3& box);
double surface_area(const Sphere3& sphere);
double surface_area(const Capsule3& capsule);
double surface_area(const Lozenge3& lozenge);
double surface_area(const Cylinder3& cylinder);
double surface_area(const Cone3& cone);
double surface_area(const SphericalCap3& cap);

/// The mean of the points; of none, InvalidShape.
Point2 centroid(std::span<const Point2> points);
Point3 centroid(std::span<const Point3> points);

Point2 centroid(const Triangle2& triangle);
Point3 centroid(const Triangle3& triangle);
Point3 centroid(const Tetrahedron3& tetrahedron);

/// Of the area, every place counted as often as the chain winds around it.
Point2 centroid(const Quadrilateral2& quadrilateral);
Point3 centroid(const Quadrilateral3& quadrilateral);
Point2 centroid(const Polygon2& polygon);
Point3 centroid(const Polygon3& polygon);
Point2 centroid(const HoledPolygon2& polygon);
Point3 centroid(const HoledPolygon3& polygon);

/// Of the volume that the closed surface bounds.
Point3 centroid(const TriangleMesh& mesh);
Point3 centroid(const PolygonMesh& mesh);
Point3 centroid(const ConvexPolyhedron3& polyhedron);

}  // namespace plumb
