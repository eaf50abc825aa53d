// Which of two distances is the larger, exactly?  Distances of points from points, lines, segments and planes.
//
// Laws: (1) the sign of the first distance minus the second; swapping the two flips it.  (2) Shapes are closed sets: a
// line through two equal points is that point, a plane through collinear ones that line; the distance from what is
// nearest.  (3) A number compared with may be negative, and is then below every distance.  (4) Signed distances are
// zero where the line or plane is not spanned by its points.
// A coordinate that is NaN or infinite throws NonFinite, naming the argument.
// Source: RTCD 5.1.1, 5.1.2, 5.1.2.1.
// Cost: a call and the filter of one or two formulas (docs/predicates.md); a segment first asks where its nearest point
// is, by two signs of degree 2.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

/// |ab| against |cd|.
Sign compare_distance(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign compare_distance(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// |ab| against |ac|: positive when c is the nearer one to a.
Sign compare_distance(const Point2& a, const Point2& b, const Point2& c);
Sign compare_distance(const Point3& a, const Point3& b, const Point3& c);

/// |ab| against a number.
Sign compare_distance(const Point2& a, const Point2& b, double distance);
Sign compare_distance(const Point3& a, const Point3& b, double distance);

/// From the line ab: the distance of c against that of d.
Sign compare_distance_to_line(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign compare_distance_to_line(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// From the line ab: the distance of c against a number.
Sign compare_distance_to_line(const Point2& a, const Point2& b, const Point2& c, double distance);
Sign compare_distance_to_line(const Point3& a, const Point3& b, const Point3& c, double distance);

/// The distance of c from the line ab against that of f from the line de.
Sign compare_distance_to_lines(const Point2& a, const Point2& b, const Point2& c,  //
                               const Point2& d, const Point2& e, const Point2& f);
Sign compare_distance_to_lines(const Point3& a, const Point3& b, const Point3& c,  //
                               const Point3& d, const Point3& e, const Point3& f);

/// From the line ab, positive to its left: the signed distance of c against that of d.
Sign compare_signed_distance_to_line(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// From the segment ab: the distance of c against that of d.
Sign compare_distance_to_segment(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign compare_distance_to_segment(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// From the segment ab: the distance of c against a number.
Sign compare_distance_to_segment(const Point2& a, const Point2& b, const Point2& c, double distance);
Sign compare_distance_to_segment(const Point3& a, const Point3& b, const Point3& c, double distance);

/// The distance of c from the segment ab against that of f from the segment de.
Sign compare_distance_to_segments(const Point2& a, const Point2& b, const Point2& c,  //
                                  const Point2& d, const Point2& e, const Point2& f);
Sign compare_distance_to_segments(const Point3& a, const Point3& b, const Point3& c,  //
                                  const Point3& d, const Point3& e, const Point3& f);

/// From the plane abc: the distance of d against that of e.
Sign compare_distance_to_plane(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);

/// From the plane abc: the distance of d against a number.
Sign compare_distance_to_plane(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double distance);

/// The distance of d from the plane abc against that of h from the plane efg.
Sign compare_distance_to_planes(const Point3& a, const Point3& b, const Point3& c, const Point3& d,  //
                                const Point3& e, const Point3& f, const Point3& g, const Point3& h);

/// From the plane abc, positive on the side that sees a, b, c counterclockwise: the signed distance of d against that
/// of e.
Sign compare_signed_distance_to_plane(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                      const Point3& e);

}  // namespace plumb
