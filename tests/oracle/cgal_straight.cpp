// Squared distances of straight shapes, over rationals.
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include "oracle/cgal_kernel.hpp"
#include "oracle/straight.hpp"
#include "plumb/arith/big.hpp"

namespace plumb::oracle {
namespace {

Kernel::Point_2 cgal(const Point2& p) { return {Number(p.x), Number(p.y)}; }
Kernel::Point_3 cgal(const Point3& p) { return {Number(p.x), Number(p.y), Number(p.z)}; }
Kernel::Vector_2 cgal(const Vector2& v) { return {Number(v.x), Number(v.y)}; }
Kernel::Vector_3 cgal(const Vector3& v) { return {Number(v.x), Number(v.y), Number(v.z)}; }
Kernel::Line_2 cgal(const Line2& l) { return {cgal(l.point), cgal(l.direction)}; }
Kernel::Line_3 cgal(const Line3& l) { return {cgal(l.point), cgal(l.direction)}; }
Kernel::Ray_2 cgal(const Ray2& r) { return {cgal(r.origin), cgal(r.direction)}; }
Kernel::Ray_3 cgal(const Ray3& r) { return {cgal(r.origin), cgal(r.direction)}; }
Kernel::Segment_2 cgal(const Segment2& s) { return {cgal(s.a), cgal(s.b)}; }
Kernel::Segment_3 cgal(const Segment3& s) { return {cgal(s.a), cgal(s.b)}; }
Kernel::Triangle_2 cgal(const Triangle2& t) { return {cgal(t.a), cgal(t.b), cgal(t.c)}; }
Kernel::Triangle_3 cgal(const Triangle3& t) { return {cgal(t.a), cgal(t.b), cgal(t.c)}; }

template <class A, class B>
Rational square(const A& a, const B& b) {
  const Number square = CGAL::squared_distance(cgal(a), cgal(b));
  return Rational(BigRational{mpq_class(square.mpq())});
}

}  // namespace

Rational squared_distance(const Line2& a, const Line2& b) { return square(a, b); }
Rational squared_distance(const Line2& a, const Ray2& b) { return square(a, b); }
Rational squared_distance(const Line2& a, const Segment2& b) { return square(a, b); }
Rational squared_distance(const Ray2& a, const Segment2& b) { return square(a, b); }
Rational squared_distance(const Segment2& a, const Segment2& b) { return square(a, b); }
Rational squared_distance(const Line2& a, const Triangle2& b) { return square(a, b); }
Rational squared_distance(const Ray2& a, const Triangle2& b) { return square(a, b); }
Rational squared_distance(const Segment2& a, const Triangle2& b) { return square(a, b); }
Rational squared_distance(const Triangle2& a, const Triangle2& b) { return square(a, b); }
Rational squared_distance(const Line3& a, const Line3& b) { return square(a, b); }
Rational squared_distance(const Line3& a, const Ray3& b) { return square(a, b); }
Rational squared_distance(const Line3& a, const Segment3& b) { return square(a, b); }
Rational squared_distance(const Ray3& a, const Ray3& b) { return square(a, b); }
Rational squared_distance(const Ray3& a, const Segment3& b) { return square(a, b); }
Rational squared_distance(const Segment3& a, const Segment3& b) { return square(a, b); }
Rational squared_distance(const Triangle3& a, const Triangle3& b) { return square(a, b); }

}  // namespace plumb::oracle
