// Planes and halfspaces: along the normal, as given or of three points.
#include "figure/basic/plane_of_points.hpp"
#include "plumb/certify/side_of_plane.hpp"
#include "query/closest/answers.hpp"

namespace plumb {
namespace query {
namespace {

constexpr Feature inside_space{FeatureKind::interior, 0}, inside_plane{FeatureKind::face, 0};

[[noreturn]] void throw_empty(std::string_view function, std::string_view shape) {
  throw InvalidShape(std::string(function).append(": the ").append(shape).append(
      "'s normal is zero and no point fulfills it; nothing is nearest, give another normal"));
}

template <class T, class Shape, class Point>
T above(const Shape& s, const Point& p) {
  return dot(vec<T>(s.normal), vec<T>(p)) - T(s.offset);
}

/// Of what has a normal: p itself, or the foot on the boundary.
template <class T, class Shape, class Point>
Foot<T> foot_of(const Shape& s, const Point& p, bool itself) {
  return itself ? foot_of_itself(vec<T>(p)) : foot_on_plane(vec<T>(s.normal), above<T>(s, p), vec<T>(p));
}

}  // namespace

template <>
struct Nearest<Plane3> {
  static void require_some(std::string_view function, const Plane3& s) {
    if (s.normal == Vector3{} && s.offset != 0) throw_empty(function, "plane");
  }
  static Feature feature(const Plane3& s, const Point3&) {
    return s.normal == Vector3{} ? inside_space : Feature{FeatureKind::face, 0};
  }
  template <class T>
  static Foot<T> foot(const Plane3& s, const Point3& p, const Feature& f) {
    return foot_of<T>(s, p, f == inside_space);
  }
};

template <>
struct Nearest<Halfspace3> {
  static void require_some(std::string_view function, const Halfspace3& s) {
    if (s.normal == Vector3{} && s.offset < 0) throw_empty(function, "halfspace");
  }
  static Feature feature(const Halfspace3& s, const Point3& p) {
    const bool in =
        s.normal == Vector3{} || sign_of(predicates::SideOfPlane{}, s.normal, s.offset, p) == Sign::negative;
    return in ? inside_space : Feature{FeatureKind::face, 0};
  }
  template <class T>
  static Foot<T> foot(const Halfspace3& s, const Point3& p, const Feature& f) {
    return foot_of<T>(s, p, f == inside_space);
  }
};

template <>
struct Nearest<Halfspace2> {
  static void require_some(std::string_view function, const Halfspace2& s) {
    if (s.normal == Vector2{} && s.offset < 0) throw_empty(function, "halfspace");
  }
  static Feature feature(const Halfspace2& s, const Point2& p) {
    const bool in = s.normal == Vector2{} || sign_of(predicates::SideOfLine{}, s.normal, s.offset, p) == Sign::negative;
    return in ? inside_plane : Feature{FeatureKind::edge, 0};
  }
  template <class T>
  static Foot<T> foot(const Halfspace2& s, const Point2& p, const Feature& f) {
    return foot_of<T>(s, p, f == inside_plane);
  }
};

template <>
struct Nearest<ThreePointPlane3> {
  static Feature feature(const ThreePointPlane3& s, const Point3&) {
    if (!collinear(s.a, s.b, s.c)) return {FeatureKind::face, 0};
    return {s.a == s.b && s.a == s.c ? FeatureKind::vertex : FeatureKind::edge, 0};
  }
  template <class T>
  static Foot<T> foot(const ThreePointPlane3& s, const Point3& p, const Feature& f) {
    const Vec<T> a = vec<T>(s.a), q = vec<T>(p);
    if (f.kind == FeatureKind::vertex) return foot_on_point(a, q);
    if (f.kind == FeatureKind::edge) return foot_on_line(a, vec<T>(s.a == s.b ? s.c : s.b) - a, q);
    const Vec<T> n = cross(vec<T>(s.b) - a, vec<T>(s.c) - a);
    return foot_on_plane(n, dot(n, q - a), q);
  }
};

}  // namespace query

PLUMB_CLOSEST_FLAT(Closest2, Point2, Halfspace2)
PLUMB_CLOSEST_FLAT(Closest, Point3, Halfspace3)
PLUMB_CLOSEST_FLAT(Closest, Point3, Plane3)
PLUMB_CLOSEST_FLAT(Closest, Point3, ThreePointPlane3)

}  // namespace plumb
