// How far apart are two straight shapes, by CGAL?
//
// Law: the square is exact, for shapes that are not degenerate.
// Source: CGAL's manual, "2D and 3D Linear Geometry Kernel".
// Cost: 20 us to 2 ms a question.
#pragma once

#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::oracle {

Rational squared_distance(const Line2& a, const Line2& b);
Rational squared_distance(const Line2& a, const Ray2& b);
Rational squared_distance(const Line2& a, const Segment2& b);
Rational squared_distance(const Ray2& a, const Segment2& b);
Rational squared_distance(const Segment2& a, const Segment2& b);
Rational squared_distance(const Line2& a, const Triangle2& b);
Rational squared_distance(const Ray2& a, const Triangle2& b);
Rational squared_distance(const Segment2& a, const Triangle2& b);
Rational squared_distance(const Triangle2& a, const Triangle2& b);
Rational squared_distance(const Line3& a, const Line3& b);
Rational squared_distance(const Line3& a, const Ray3& b);
Rational squared_distance(const Line3& a, const Segment3& b);
Rational squared_distance(const Ray3& a, const Ray3& b);
Rational squared_distance(const Ray3& a, const Segment3& b);
Rational squared_distance(const Segment3& a, const Segment3& b);
Rational squared_distance(const Triangle3& a, const Triangle3& b);

}  // namespace plumb::oracle
