// Oriented boxes and rectangles: parallelepipeds of three axes, of which those of a flat one are zero.
#include <cmath>

#include "query/closest/answers.hpp"
#include "query/closest/flat_box.hpp"

namespace plumb {
namespace query {
namespace {

Obb3 solid(const Rectangle3& s) { return {s.center, {s.axes[0], s.axes[1], Vector3{}}, in_space(s.half)}; }
Obb3 solid(const Obb2& s) {
  return {in_space(s.center), {in_space(s.axes[0]), in_space(s.axes[1]), Vector3{}}, in_space(s.half)};
}

template <class T>
Foot<T> foot_in(const Obb3& s, const Point3& p, const Feature& f) {
  const Vec<T> q = vec<T>(p);
  if (f.kind == FeatureKind::interior) return foot_of_itself(q);
  const std::array<Vec<T>, 3> axis{vec<T>(s.axes[0]), vec<T>(s.axes[1]), vec<T>(s.axes[2])};
  const std::array half{std::fabs(s.half.x), std::fabs(s.half.y), std::fabs(s.half.z)};
  const std::uint32_t n = f.index;
  const auto end = [&](std::size_t i, std::uint32_t upper) { return axis[i] * T(upper != 0 ? half[i] : -half[i]); };
  const Vec<T> center = vec<T>(s.center);
  if (f.kind == FeatureKind::vertex) return foot_on_point(center + end(0, n & 1) + end(1, n & 2) + end(2, n & 4), q);
  if (f.kind == FeatureKind::edge) {
    const std::size_t u = n / 4, v = u == 0 ? 1 : 0, w = 3 - u - v;
    return foot_on_line(center + end(v, n & 1) + end(w, n & 2), axis[u], q);
  }
  const std::size_t w = n / 2, u = w == 0 ? 1 : 0, v = 3 - u - w;
  const Vec<T> normal = cross(axis[u], axis[v]);
  return foot_on_plane(normal, dot(normal, q - (center + end(w, n & 1))), q);
}

}  // namespace

template <>
struct Nearest<Obb3> {
  static Feature feature(const Obb3& s, const Point3& p) { return voronoi_region(s, p); }
  template <class T>
  static Foot<T> foot(const Obb3& s, const Point3& p, const Feature& f) {
    return foot_in<T>(s, p, f);
  }
};

template <>
struct Nearest<Rectangle3> {
  static Feature feature(const Rectangle3& s, const Point3& p) { return of_flat_box(voronoi_region(solid(s), p)); }
  template <class T>
  static Foot<T> foot(const Rectangle3& s, const Point3& p, const Feature& f) {
    return foot_in<T>(solid(s), p, of_solid_box(f));
  }
};

template <>
struct Nearest<Obb2> {
  static Feature feature(const Obb2& s, const Point2& p) { return of_flat_box(voronoi_region(solid(s), in_space(p))); }
  template <class T>
  static Foot<T> foot(const Obb2& s, const Point2& p, const Feature& f) {
    if (f.kind == FeatureKind::face) return foot_of_itself(vec<T>(p));
    return foot_in<T>(solid(s), in_space(p), of_solid_box(f));
  }
};

}  // namespace query

PLUMB_CLOSEST_FLAT(Closest2, Point2, Obb2)
PLUMB_CLOSEST_FLAT(Closest, Point3, Obb3)
PLUMB_CLOSEST_FLAT(Closest, Point3, Rectangle3)

}  // namespace plumb
