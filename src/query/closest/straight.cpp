// A point against points, lines, rays and segments: an end, or the foot of the perpendicular.
#include "plumb/certify/direction.hpp"
#include "plumb/certify/sign_of.hpp"
#include "query/closest/answers.hpp"

namespace plumb {
namespace query {
namespace {

constexpr Feature whole{FeatureKind::edge, 0}, origin{FeatureKind::vertex, 0};

/// Does p lie ahead of the origin, in the direction?
Sign ahead(const Vector2& direction, const Point2& from, const Point2& p) {
  return sign_of(predicates::OrderAlongDirection2d{}, p, from, direction);
}
Sign ahead(const Vector3& direction, const Point3& from, const Point3& p) {
  return sign_of(predicates::OrderAlongDirection3d{}, p, from, direction);
}

}  // namespace

template <class Point>
struct NearestOfPoint {
  static Feature feature(const Point&, const Point&) { return origin; }
  template <class T>
  static Foot<T> foot(const Point& a, const Point& p, const Feature&) {
    return foot_on_point(vec<T>(a), vec<T>(p));
  }
};
template <>
struct Nearest<Point2> : NearestOfPoint<Point2> {};
template <>
struct Nearest<Point3> : NearestOfPoint<Point3> {};

template <class Line, class Point>
struct NearestOfLine {
  static Feature feature(const Line& s, const Point&) {
    return s.direction == decltype(s.direction){} ? origin : whole;
  }
  template <class T>
  static Foot<T> foot(const Line& s, const Point& p, const Feature& f) {
    if (f == origin) return foot_on_point(vec<T>(s.point), vec<T>(p));
    return foot_on_line(vec<T>(s.point), vec<T>(s.direction), vec<T>(p));
  }
};
template <>
struct Nearest<Line2> : NearestOfLine<Line2, Point2> {};
template <>
struct Nearest<Line3> : NearestOfLine<Line3, Point3> {};

template <class Ray, class Point>
struct NearestOfRay {
  static Feature feature(const Ray& s, const Point& p) {
    return ahead(s.direction, s.origin, p) == Sign::positive ? whole : origin;
  }
  template <class T>
  static Foot<T> foot(const Ray& s, const Point& p, const Feature& f) {
    if (f == origin) return foot_on_point(vec<T>(s.origin), vec<T>(p));
    return foot_on_line(vec<T>(s.origin), vec<T>(s.direction), vec<T>(p));
  }
};
template <>
struct Nearest<Ray2> : NearestOfRay<Ray2, Point2> {};
template <>
struct Nearest<Ray3> : NearestOfRay<Ray3, Point3> {};

template <class Segment, class Point>
struct NearestOfSegment {
  static Feature feature(const Segment& s, const Point& p) { return voronoi_region(s, p); }
  template <class T>
  static Foot<T> foot(const Segment& s, const Point& p, const Feature& f) {
    if (f.kind == FeatureKind::vertex) return foot_on_point(vec<T>(f.index == 0 ? s.a : s.b), vec<T>(p));
    const Vec<T> a = vec<T>(s.a);
    return foot_on_line(a, vec<T>(s.b) - a, vec<T>(p));
  }
};
template <>
struct Nearest<Segment2> : NearestOfSegment<Segment2, Point2> {};
template <>
struct Nearest<Segment3> : NearestOfSegment<Segment3, Point3> {};

namespace {

template <class Shape>
double parameter_of(const Shape& s, const PointOf<Shape>& p) {
  require("closest_parameter", s, p);
  const Feature f = Nearest<Shape>::feature(s, p);
  if (f.kind == FeatureKind::vertex) return f.index;
  const auto exactly = [&] { return Nearest<Shape>::template foot<BigDyadic>(s, p, f); };
  return rounded_part(Nearest<Shape>::template foot<Ball>(s, p, f), ExactFoot(exactly));
}

}  // namespace
}  // namespace query

double closest_parameter(const Line2& line, const Point2& p) { return query::parameter_of(line, p); }
double closest_parameter(const Line3& line, const Point3& p) { return query::parameter_of(line, p); }
double closest_parameter(const Ray2& ray, const Point2& p) { return query::parameter_of(ray, p); }
double closest_parameter(const Ray3& ray, const Point3& p) { return query::parameter_of(ray, p); }
double closest_parameter(const Segment2& segment, const Point2& p) { return query::parameter_of(segment, p); }
double closest_parameter(const Segment3& segment, const Point3& p) { return query::parameter_of(segment, p); }

PLUMB_CLOSEST_FLAT(Closest2, Point2, Point2)
PLUMB_CLOSEST_FLAT(Closest2, Point2, Line2)
PLUMB_CLOSEST_FLAT(Closest2, Point2, Ray2)
PLUMB_CLOSEST_FLAT(Closest2, Point2, Segment2)
PLUMB_CLOSEST_FLAT(Closest, Point3, Point3)
PLUMB_CLOSEST_FLAT(Closest, Point3, Line3)
PLUMB_CLOSEST_FLAT(Closest, Point3, Ray3)
PLUMB_CLOSEST_FLAT(Closest, Point3, Segment3)

}  // namespace plumb
