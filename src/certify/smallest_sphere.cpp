#include "plumb/certify/smallest_sphere.hpp"

#include "certify/finite.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

Sign of_diameter(const Point2& a, const Point2& b, const Point2& p) { return in_smallest_circle(a, b, p); }
Sign of_diameter(const Point3& a, const Point3& b, const Point3& p) { return in_smallest_sphere(a, b, p); }

// Of three collinear points: the sphere through the two that differ, if no more do.
template <class Point>
Sign of_equal_points(const Point& a, const Point& b, const Point& c, const Point& p) {
  if (a == b || b == c) return of_diameter(a, c, p);
  return a == c ? of_diameter(a, b, p) : Sign::zero;
}

}  // namespace

Sign in_smallest_circle(const Point2& a, const Point2& b, const Point2& p) {
  return sign_of(predicates::InSmallestCircle{}, a, b, p);
}
Sign in_smallest_sphere(const Point3& a, const Point3& b, const Point3& p) {
  return sign_of(predicates::InSmallestSphere2{}, a, b, p);
}

Sign in_smallest_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& p) {
  require_finite("in_smallest_circle", a, b, c, p);
  const Sign turn = sign_of(predicates::Orient2d{}, a, b, c);
  if (turn == Sign::zero) return of_equal_points(a, b, c, p);
  return turn * sign_of(predicates::InCircle{}, a, b, c, p);
}

Sign in_smallest_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  const Sign s = sign_of(predicates::InSmallestSphere3{}, a, b, c, p);
  return s == Sign::zero && collinear(a, b, c) ? of_equal_points(a, b, c, p) : s;
}

}  // namespace plumb
