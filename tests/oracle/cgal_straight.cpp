// Squared distances of straight shapes, over rationals.
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include "oracle/cgal_figures.hpp"
#include "oracle/straight.hpp"
#include "plumb/arith/big.hpp"

namespace plumb::oracle {
namespace {

template <class A, class B>
Rational square(const A& a, const B& b) {
  const Number square = CGAL::squared_distance(of(a), of(b));
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
