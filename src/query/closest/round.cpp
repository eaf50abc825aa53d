// Disks, balls and capsules: what is nearest of the core, and from there toward p by the radius.
#include "plumb/figure/containment/contains.hpp"
#include "query/closest/answers.hpp"

namespace plumb {
namespace query {

template <>
struct Nearest<Sphere3> {
  static double radius(const Sphere3& s) { return s.radius; }
  static Feature feature(const Sphere3& s, const Point3& p) {
    return {locate(s, p) == Location::inside ? FeatureKind::interior : FeatureKind::face, 0};
  }
  template <class T>
  static Foot<T> foot(const Sphere3& s, const Point3& p, const Feature& f) {
    if (f.kind == FeatureKind::interior) return foot_of_itself(vec<T>(p));
    return foot_on_point(vec<T>(s.center), vec<T>(p));
  }
};

template <>
struct Nearest<Circle2> {
  static double radius(const Circle2& s) { return s.radius; }
  static Feature feature(const Circle2& s, const Point2& p) {
    return {locate(s, p) == Location::inside ? FeatureKind::face : FeatureKind::edge, 0};
  }
  template <class T>
  static Foot<T> foot(const Circle2& s, const Point2& p, const Feature& f) {
    if (f.kind == FeatureKind::face) return foot_of_itself(vec<T>(p));
    return foot_on_point(vec<T>(s.center), vec<T>(p));
  }
};

template <class Capsule, class Segment, class Point, FeatureKind surface, FeatureKind inside>
struct NearestOfCapsule {
  static double radius(const Capsule& s) { return s.radius; }
  static Feature feature(const Capsule& s, const Point& p) {
    if (locate(s, p) == Location::inside) return {inside, 0};
    const Feature core = voronoi_region(Segment{s.a, s.b}, p);
    return {surface, core.kind == FeatureKind::vertex ? 1 + core.index : 0};
  }
  template <class T>
  static Foot<T> foot(const Capsule& s, const Point& p, const Feature& f) {
    if (f.kind == inside) return foot_of_itself(vec<T>(p));
    const Vec<T> a = vec<T>(s.a), b = vec<T>(s.b), q = vec<T>(p);
    return f.index == 0 ? foot_on_line(a, b - a, q) : foot_on_point(f.index == 1 ? a : b, q);
  }
};
template <>
struct Nearest<Capsule3> : NearestOfCapsule<Capsule3, Segment3, Point3, FeatureKind::face, FeatureKind::interior> {};
template <>
struct Nearest<Capsule2> : NearestOfCapsule<Capsule2, Segment2, Point2, FeatureKind::edge, FeatureKind::face> {};

}  // namespace query

PLUMB_CLOSEST_ROUND(Closest2, Point2, Circle2)
PLUMB_CLOSEST_ROUND(Closest2, Point2, Capsule2)
PLUMB_CLOSEST_ROUND(Closest, Point3, Sphere3)
PLUMB_CLOSEST_ROUND(Closest, Point3, Capsule3)

}  // namespace plumb
