// The boxes of single shapes.
#include <algorithm>

#include "figure/aabb/ranges.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

using namespace figure::box;

template <class... Points>
Aabb2 box_of2(const Points&... points) {
  return fit_aabb(std::span<const Point2>(std::array{points...}));
}
template <class... Points>
Aabb3 box_of3(const Points&... points) {
  return fit_aabb(std::span<const Point3>(std::array{points...}));
}

template <class Polygon>
auto box_of_chain(const Polygon& polygon) {
  figure::require_sound("fit_aabb", polygon);
  return fit_aabb(std::span(polygon.vertices));
}

// Holes are looked through, and change nothing.
template <class Polygon>
auto box_of_holed(const Polygon& polygon) {
  figure::require_sound("fit_aabb", polygon);
  return fit_aabb(std::span(polygon.outer.vertices));
}

// Of center + sum of s_i axes_i with |s_i| <= half_i.
Range range_of_box(std::size_t axis, double center, const std::array<double, 3>& axes, std::array<double, 3> half) {
  for (double& h : half) h = magnitude_of(h);
  return range_of_image("fit_aabb", axis, center, axes, {-half[0], -half[1], -half[2]}, half);
}

Range swept(std::size_t axis, double a, double b, double radius) {
  return {least_sum("fit_aabb", axis, std::min(a, b), -radius), greatest_sum("fit_aabb", axis, std::max(a, b), radius)};
}

Range swept(std::size_t axis, double corner, double e, double f, double radius) {
  return {least_sum("fit_aabb", axis, corner, std::min(e, 0.0), std::min(f, 0.0), -radius),
          greatest_sum("fit_aabb", axis, corner, std::max(e, 0.0), std::max(f, 0.0), radius)};
}

// How far a disk perpendicular to an axis from a to b reaches along each coordinate.
Vector3 reach_of_disk(const Point3& a, const Point3& b, double radius) {
  // Along x the disk reaches radius times the sine of the angle between x and the axis d: a root of (y^2 + z^2) / d^2.
  constexpr auto across = [](auto x, auto y, auto z, auto u, auto v, auto w) {
    return (x - x) * (u - u) + ((y - v) * (y - v) + (z - w) * (z - w));
  };
  constexpr auto along = [](auto x, auto y, auto z, auto u, auto v, auto w) {
    return (x - u) * (x - u) + (y - v) * (y - v) + (z - w) * (z - w);
  };
  constexpr auto product = [](auto x, auto y) { return x * y; };
  const auto reach = [&](const Point3& from, const Point3& to) {
    const double sine = rounded_root_of_quotient(Rounding::up, across, along, from, to);
    return std::min(radius, rounded_value(Rounding::up, product, sine, radius));
  };
  return {reach(a, b), reach({a.y, a.z, a.x}, {b.y, b.z, b.x}), reach({a.z, a.x, a.y}, {b.z, b.x, b.y})};
}

}  // namespace

double figure::box::require_bound(double bound) { return figure::within_doubles(bound, "fit_aabb", "a bound"); }

Aabb2 fit_aabb(const Segment2& s) { return box_of2(s.a, s.b); }
Aabb3 fit_aabb(const Segment3& s) { return box_of3(s.a, s.b); }
Aabb2 fit_aabb(const Triangle2& t) { return box_of2(t.a, t.b, t.c); }
Aabb3 fit_aabb(const Triangle3& t) { return box_of3(t.a, t.b, t.c); }
Aabb3 fit_aabb(const Tetrahedron3& t) { return box_of3(t.a, t.b, t.c, t.d); }
Aabb2 fit_aabb(const Quadrilateral2& q) { return box_of2(q.a, q.b, q.c, q.d); }
Aabb3 fit_aabb(const Quadrilateral3& q) { return box_of3(q.a, q.b, q.c, q.d); }
Aabb2 fit_aabb(const Polygon2& polygon) { return box_of_chain(polygon); }
Aabb3 fit_aabb(const Polygon3& polygon) { return box_of_chain(polygon); }
Aabb2 fit_aabb(const HoledPolygon2& polygon) { return box_of_holed(polygon); }
Aabb3 fit_aabb(const HoledPolygon3& polygon) { return box_of_holed(polygon); }
Aabb3 fit_aabb(const ConvexPolyhedron3& polyhedron) {
  return fit_aabb(std::span<const Point3>(polyhedron.mesh.vertices));
}

Aabb2 fit_aabb(const Circle2& s) {
  figure::require_sound("fit_aabb", s);
  return box_of(swept(0, s.center.x, s.center.x, s.radius), swept(1, s.center.y, s.center.y, s.radius));
}

Aabb3 fit_aabb(const Sphere3& s) {
  figure::require_sound("fit_aabb", s);
  return box_of(swept(0, s.center.x, s.center.x, s.radius), swept(1, s.center.y, s.center.y, s.radius),
                swept(2, s.center.z, s.center.z, s.radius));
}

Aabb2 fit_aabb(const Capsule2& s) {
  figure::require_sound("fit_aabb", s);
  return box_of(swept(0, s.a.x, s.b.x, s.radius), swept(1, s.a.y, s.b.y, s.radius));
}

Aabb3 fit_aabb(const Capsule3& s) {
  figure::require_sound("fit_aabb", s);
  return box_of(swept(0, s.a.x, s.b.x, s.radius), swept(1, s.a.y, s.b.y, s.radius), swept(2, s.a.z, s.b.z, s.radius));
}

Aabb3 fit_aabb(const Lozenge3& s) {
  const auto& [e, f] = s.edges;
  figure::require_sound("fit_aabb", s);
  return box_of(swept(0, s.corner.x, e.x, f.x, s.radius), swept(1, s.corner.y, e.y, f.y, s.radius),
                swept(2, s.corner.z, e.z, f.z, s.radius));
}

Aabb2 fit_aabb(const Obb2& s) {
  const auto& [u, v] = s.axes;
  figure::require_sound("fit_aabb", s);
  const std::array half{s.half.x, s.half.y, 0.0};
  return box_of(range_of_box(0, s.center.x, {u.x, v.x, 0}, half), range_of_box(1, s.center.y, {u.y, v.y, 0}, half));
}

Aabb3 fit_aabb(const Obb3& s) {
  const auto& [u, v, w] = s.axes;
  figure::require_sound("fit_aabb", s);
  const std::array half{s.half.x, s.half.y, s.half.z};
  return box_of(range_of_box(0, s.center.x, {u.x, v.x, w.x}, half), range_of_box(1, s.center.y, {u.y, v.y, w.y}, half),
                range_of_box(2, s.center.z, {u.z, v.z, w.z}, half));
}

Aabb3 fit_aabb(const Rectangle3& s) {
  const auto& [u, v] = s.axes;
  figure::require_sound("fit_aabb", s);
  const std::array half{s.half.x, s.half.y, 0.0};
  return box_of(range_of_box(0, s.center.x, {u.x, v.x, 0}, half), range_of_box(1, s.center.y, {u.y, v.y, 0}, half),
                range_of_box(2, s.center.z, {u.z, v.z, 0}, half));
}

Aabb3 fit_aabb(const Ellipsoid3& s) {
  const auto& [u, v, w] = s.axes;
  figure::require_sound("fit_aabb", s);
  constexpr auto squares = [](auto x, auto a, auto y, auto b, auto z, auto c) {
    return (x * a) * (x * a) + (y * b) * (y * b) + (z * c) * (z * c);
  };
  const auto range = [&](std::size_t axis, double center, double x, double y, double z) {
    const double reach =
        figure::within_doubles(rounded_root(Rounding::up, squares, x, s.half.x, y, s.half.y, z, s.half.z), "fit_aabb",
                               "the ellipsoid's reach");
    return swept(axis, center, center, reach);
  };
  return box_of(range(0, s.center.x, u.x, v.x, w.x), range(1, s.center.y, u.y, v.y, w.y),
                range(2, s.center.z, u.z, v.z, w.z));
}

Aabb3 fit_aabb(const Cylinder3& s) {
  figure::require_sound("fit_aabb", s);
  if (s.a == s.b) return fit_aabb(Sphere3{s.a, s.radius});
  const Vector3 reach = reach_of_disk(s.a, s.b, s.radius);
  return box_of(swept(0, s.a.x, s.b.x, reach.x), swept(1, s.a.y, s.b.y, reach.y), swept(2, s.a.z, s.b.z, reach.z));
}

Aabb3 fit_aabb(const Cone3& s) {
  figure::require_sound("fit_aabb", s);
  if (s.apex == s.base) return fit_aabb(Sphere3{s.apex, s.radius});
  const Vector3 reach = reach_of_disk(s.apex, s.base, s.radius);
  const Point3& c = s.base;
  const Aabb3 disk = box_of(swept(0, c.x, c.x, reach.x), swept(1, c.y, c.y, reach.y), swept(2, c.z, c.z, reach.z));
  return merge(disk, Aabb3{s.apex, s.apex});
}

}  // namespace plumb
