// Axis-aligned boxes: each coordinate is that of p or of a side.
#include <algorithm>

#include "query/closest/answers.hpp"
#include "query/closest/flat_box.hpp"

namespace plumb {
namespace query {
namespace {

void require_not_empty(std::string_view function, const Aabb3& box) {
  if (!is_empty(box)) return;
  throw InvalidShape(std::string(function).append(": the box is empty, and nothing is nearest; give min at most max"));
}

template <class T>
Foot<T> foot_in(const Aabb3& s, const Point3& p, bool itself) {
  if (itself) return foot_of_itself(vec<T>(p));
  // The nearest point is a point of doubles, and as a foot a point of its own.
  const Point3 q{std::clamp(p.x, s.min.x, s.max.x), std::clamp(p.y, s.min.y, s.max.y),
                 std::clamp(p.z, s.min.z, s.max.z)};
  return foot_on_point(vec<T>(q), vec<T>(p));
}

}  // namespace

template <>
struct Nearest<Aabb3> {
  static void require_some(std::string_view function, const Aabb3& s) { require_not_empty(function, s); }
  static Feature feature(const Aabb3& s, const Point3& p) { return voronoi_region(s, p); }
  template <class T>
  static Foot<T> foot(const Aabb3& s, const Point3& p, const Feature& f) {
    return foot_in<T>(s, p, f.kind == FeatureKind::interior);
  }
};

template <>
struct Nearest<Aabb2> {
  static void require_some(std::string_view function, const Aabb2& s) { require_not_empty(function, in_space(s)); }
  static Feature feature(const Aabb2& s, const Point2& p) {
    return of_flat_box(voronoi_region(in_space(s), in_space(p)));
  }
  template <class T>
  static Foot<T> foot(const Aabb2& s, const Point2& p, const Feature& f) {
    return foot_in<T>(in_space(s), in_space(p), f.kind == FeatureKind::face);
  }
};

}  // namespace query

PLUMB_CLOSEST_FLAT(Closest2, Point2, Aabb2)
PLUMB_CLOSEST_FLAT(Closest, Point3, Aabb3)

}  // namespace plumb
