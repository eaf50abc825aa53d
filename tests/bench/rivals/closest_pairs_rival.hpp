// What others do for the closest points of segments and triangles: plain doubles, Eigen's vectors, CGAL's kernel of
// doubles, each as commonly written.
#pragma once

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench {

struct PlainClosest {
  Point3 on_a, on_b;
  double square;
};

/// As commonly written: parameters clamped one after the other, parallel ones told by an epsilon.
PlainClosest segments_in_doubles(const Segment3& p, const Segment3& q);
PlainClosest lines_in_doubles(const Line3& p, const Line3& q);
/// The nearest of all pairs of edges, of ends and the face; no distance where the segment crosses the triangle.
PlainClosest segment_triangle_in_doubles(const Segment3& s, const Triangle3& t);
/// The like; edges first, done as soon as the third corners are on the outside.
PlainClosest triangles_in_doubles(const Triangle3& p, const Triangle3& q);
struct PlainClosest2 {
  Point2 on_a, on_b;
  double square;
};
PlainClosest2 segments_in_doubles(const Segment2& p, const Segment2& q);

double segments_in_eigen(const Segment3& p, const Segment3& q);

double segments_in_cgal(const Segment3& p, const Segment3& q);
double lines_in_cgal(const Line3& p, const Line3& q);
double triangles_in_cgal(const Triangle3& p, const Triangle3& q);

}  // namespace plumb::bench
