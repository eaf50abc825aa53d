#include "plumb/figure/aabb/aabb.hpp"

#include <algorithm>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/certify/direction.hpp"

namespace plumb {
namespace {

using figure::require_finite_parts;
using figure::require_finite_points;

// A bound of what is moved, swept or turned: t + sum of m_i x_i, and a sum of four.
constexpr auto image = [](auto t, auto m0, auto x0, auto m1, auto x1, auto m2, auto x2) {
  return t + (m0 * x0 + m1 * x1 + m2 * x2);
};
constexpr auto sum = [](auto a, auto b, auto c, auto d) { return (a + b) + (c + d); };

constexpr std::array<std::string_view, 3> min_name{"min.x", "min.y", "min.z"}, max_name{"max.x", "max.y", "max.z"};

double least_sum(std::string_view function, std::size_t axis, double a, double b, double c = 0, double d = 0) {
  return figure::within_doubles(rounded_value(Rounding::down, sum, a, b, c, d), function, min_name[axis]);
}
double greatest_sum(std::string_view function, std::size_t axis, double a, double b, double c = 0, double d = 0) {
  return figure::within_doubles(rounded_value(Rounding::up, sum, a, b, c, d), function, max_name[axis]);
}

struct Range {
  double min, max;
};

// Of t + sum of m_i x_i for x_i between from_i and to_i: each term takes the end that the sign of m_i names.
Range range_of_image(std::string_view function, std::size_t axis, double t, const std::array<double, 3>& m,
                     const std::array<double, 3>& from, const std::array<double, 3>& to) {
  std::array<double, 3> least, greatest;
  for (std::size_t i = 0; i < 3; ++i) {
    least[i] = m[i] < 0 ? to[i] : from[i];
    greatest[i] = m[i] < 0 ? from[i] : to[i];
  }
  return {
      figure::within_doubles(rounded_value(Rounding::down, image, t, m[0], least[0], m[1], least[1], m[2], least[2]),
                             function, min_name[axis]),
      figure::within_doubles(
          rounded_value(Rounding::up, image, t, m[0], greatest[0], m[1], greatest[1], m[2], greatest[2]), function,
          max_name[axis])};
}

// Of center + sum of s_i axes_i with |s_i| <= half_i.
Range range_of_box(std::size_t axis, double center, const std::array<double, 3>& axes, std::array<double, 3> half) {
  for (double& h : half) h = magnitude_of(h);
  return range_of_image("fit_aabb", axis, center, axes, {-half[0], -half[1], -half[2]}, half);
}

template <class... Points>
Aabb2 box_of2(const Points&... points) {
  return fit_aabb(std::span<const Point2>(std::array{points...}));
}
template <class... Points>
Aabb3 box_of3(const Points&... points) {
  return fit_aabb(std::span<const Point3>(std::array{points...}));
}

void require_radius(double radius, std::string_view shape) {
  if (radius < 0)
    throw InvalidShape(std::string("fit_aabb: ").append(shape).append(".radius is negative; give zero or more"));
}

Range swept(std::size_t axis, double a, double b, double radius) {
  return {least_sum("fit_aabb", axis, std::min(a, b), -radius), greatest_sum("fit_aabb", axis, std::max(a, b), radius)};
}

Range swept(std::size_t axis, double corner, double e, double f, double radius) {
  return {least_sum("fit_aabb", axis, corner, std::min(e, 0.0), std::min(f, 0.0), -radius),
          greatest_sum("fit_aabb", axis, corner, std::max(e, 0.0), std::max(f, 0.0), radius)};
}

Aabb2 box_of(Range x, Range y) { return {{x.min, y.min}, {x.max, y.max}}; }
Aabb3 box_of(Range x, Range y, Range z) { return {{x.min, y.min, z.min}, {x.max, y.max, z.max}}; }

[[noreturn]] void throw_no_points() { throw InvalidShape("fit_aabb: no points; give at least one"); }

}  // namespace

Aabb2 fit_aabb(std::span<const Point2> points) {
  if (points.empty()) throw_no_points();
  require_finite_points("fit_aabb", "points", points);
  Aabb2 b{points[0], points[0]};
  for (const Point2& p : points) {
    b.min = {std::min(b.min.x, p.x), std::min(b.min.y, p.y)};
    b.max = {std::max(b.max.x, p.x), std::max(b.max.y, p.y)};
  }
  return b;
}

Aabb3 fit_aabb(std::span<const Point3> points) {
  if (points.empty()) throw_no_points();
  require_finite_points("fit_aabb", "points", points);
  Aabb3 b{points[0], points[0]};
  for (const Point3& p : points) {
    b.min = {std::min(b.min.x, p.x), std::min(b.min.y, p.y), std::min(b.min.z, p.z)};
    b.max = {std::max(b.max.x, p.x), std::max(b.max.y, p.y), std::max(b.max.z, p.z)};
  }
  return b;
}

Aabb3 fit_aabb(std::span<const Point3> points, const Pose& pose) {
  if (points.empty()) throw_no_points();
  require_finite_points("fit_aabb", "points", points);
  const auto& [c, t] = pose;
  require_finite_parts("fit_aabb", {"pose.columns[0]", "pose.columns[1]", "pose.columns[2]", "pose.translation"}, c[0],
                       c[1], c[2], t);
  const auto range = [&](std::size_t axis, double translation, const Vector3& row) {
    const Point3 *least = points.data(), *greatest = least;
    for (const Point3& p : points) {
      if (sign_of(predicates::OrderAlongDirection3d{}, p, *greatest, row) == Sign::positive) {
        greatest = &p;
      } else if (sign_of(predicates::OrderAlongDirection3d{}, p, *least, row) == Sign::negative) {
        least = &p;
      }
    }
    const auto bound = [&](Rounding rounding, const Point3& p, std::string_view name) {
      return figure::within_doubles(rounded_value(rounding, image, translation, row.x, p.x, row.y, p.y, row.z, p.z),
                                    "fit_aabb", name);
    };
    return Range{bound(Rounding::down, *least, min_name[axis]), bound(Rounding::up, *greatest, max_name[axis])};
  };
  return box_of(range(0, t.x, {c[0].x, c[1].x, c[2].x}), range(1, t.y, {c[0].y, c[1].y, c[2].y}),
                range(2, t.z, {c[0].z, c[1].z, c[2].z}));
}

Aabb2 fit_aabb(const Segment2& s) { return box_of2(s.a, s.b); }
Aabb3 fit_aabb(const Segment3& s) { return box_of3(s.a, s.b); }
Aabb2 fit_aabb(const Triangle2& t) { return box_of2(t.a, t.b, t.c); }
Aabb3 fit_aabb(const Triangle3& t) { return box_of3(t.a, t.b, t.c); }
Aabb3 fit_aabb(const Tetrahedron3& t) { return box_of3(t.a, t.b, t.c, t.d); }

Aabb2 fit_aabb(const Circle2& s) {
  require_finite_parts("fit_aabb", {"circle.center", "circle.radius"}, s.center, s.radius);
  require_radius(s.radius, "circle");
  return box_of(swept(0, s.center.x, s.center.x, s.radius), swept(1, s.center.y, s.center.y, s.radius));
}

Aabb3 fit_aabb(const Sphere3& s) {
  require_finite_parts("fit_aabb", {"sphere.center", "sphere.radius"}, s.center, s.radius);
  require_radius(s.radius, "sphere");
  return box_of(swept(0, s.center.x, s.center.x, s.radius), swept(1, s.center.y, s.center.y, s.radius),
                swept(2, s.center.z, s.center.z, s.radius));
}

Aabb2 fit_aabb(const Capsule2& s) {
  require_finite_parts("fit_aabb", {"capsule.a", "capsule.b", "capsule.radius"}, s.a, s.b, s.radius);
  require_radius(s.radius, "capsule");
  return box_of(swept(0, s.a.x, s.b.x, s.radius), swept(1, s.a.y, s.b.y, s.radius));
}

Aabb3 fit_aabb(const Capsule3& s) {
  require_finite_parts("fit_aabb", {"capsule.a", "capsule.b", "capsule.radius"}, s.a, s.b, s.radius);
  require_radius(s.radius, "capsule");
  return box_of(swept(0, s.a.x, s.b.x, s.radius), swept(1, s.a.y, s.b.y, s.radius), swept(2, s.a.z, s.b.z, s.radius));
}

Aabb3 fit_aabb(const Lozenge3& s) {
  const auto& [e, f] = s.edges;
  require_finite_parts("fit_aabb", {"lozenge.corner", "lozenge.edges[0]", "lozenge.edges[1]", "lozenge.radius"},
                       s.corner, e, f, s.radius);
  require_radius(s.radius, "lozenge");
  return box_of(swept(0, s.corner.x, e.x, f.x, s.radius), swept(1, s.corner.y, e.y, f.y, s.radius),
                swept(2, s.corner.z, e.z, f.z, s.radius));
}

Aabb2 fit_aabb(const Obb2& s) {
  const auto& [u, v] = s.axes;
  require_finite_parts("fit_aabb", {"obb.center", "obb.axes[0]", "obb.axes[1]", "obb.half"}, s.center, u, v, s.half);
  const std::array half{s.half.x, s.half.y, 0.0};
  return box_of(range_of_box(0, s.center.x, {u.x, v.x, 0}, half), range_of_box(1, s.center.y, {u.y, v.y, 0}, half));
}

Aabb3 fit_aabb(const Obb3& s) {
  const auto& [u, v, w] = s.axes;
  require_finite_parts("fit_aabb", {"obb.center", "obb.axes[0]", "obb.axes[1]", "obb.axes[2]", "obb.half"}, s.center, u,
                       v, w, s.half);
  const std::array half{s.half.x, s.half.y, s.half.z};
  return box_of(range_of_box(0, s.center.x, {u.x, v.x, w.x}, half), range_of_box(1, s.center.y, {u.y, v.y, w.y}, half),
                range_of_box(2, s.center.z, {u.z, v.z, w.z}, half));
}

Aabb3 fit_aabb(const Rectangle3& s) {
  const auto& [u, v] = s.axes;
  require_finite_parts("fit_aabb", {"rectangle.center", "rectangle.axes[0]", "rectangle.axes[1]", "rectangle.half"},
                       s.center, u, v, s.half);
  const std::array half{s.half.x, s.half.y, 0.0};
  return box_of(range_of_box(0, s.center.x, {u.x, v.x, 0}, half), range_of_box(1, s.center.y, {u.y, v.y, 0}, half),
                range_of_box(2, s.center.z, {u.z, v.z, 0}, half));
}

Aabb3 fit_aabb(const Ellipsoid3& s) {
  const auto& [u, v, w] = s.axes;
  require_finite_parts(
      "fit_aabb", {"ellipsoid.center", "ellipsoid.axes[0]", "ellipsoid.axes[1]", "ellipsoid.axes[2]", "ellipsoid.half"},
      s.center, u, v, w, s.half);
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
  require_finite_parts("fit_aabb", {"cylinder.a", "cylinder.b", "cylinder.radius"}, s.a, s.b, s.radius);
  require_radius(s.radius, "cylinder");
  if (s.a == s.b) return fit_aabb(Sphere3{s.a, s.radius});
  // Along x the disk reaches radius times the sine of the angle between x and the axis d: a root of (y^2 + z^2) / d^2.
  constexpr auto across = [](auto x, auto y, auto z, auto u, auto v, auto w) {
    return (x - x) * (u - u) + ((y - v) * (y - v) + (z - w) * (z - w));
  };
  constexpr auto along = [](auto x, auto y, auto z, auto u, auto v, auto w) {
    return (x - u) * (x - u) + (y - v) * (y - v) + (z - w) * (z - w);
  };
  constexpr auto product = [](auto x, auto y) { return x * y; };
  const auto range = [&](std::size_t axis, double a, double b, const Point3& from, const Point3& to) {
    const double sine = rounded_root_of_quotient(Rounding::up, across, along, from, to);
    const double reach = std::min(s.radius, rounded_value(Rounding::up, product, sine, s.radius));
    return swept(axis, a, b, reach);
  };
  const Point3 &a = s.a, &b = s.b;
  return box_of(range(0, a.x, b.x, a, b), range(1, a.y, b.y, {a.y, a.z, a.x}, {b.y, b.z, b.x}),
                range(2, a.z, b.z, {a.z, a.x, a.y}, {b.z, b.x, b.y}));
}

Aabb2 merge(const Aabb2& a, const Aabb2& b) {
  require_finite_parts("merge", {"a.min", "a.max", "b.min", "b.max"}, a.min, a.max, b.min, b.max);
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

Aabb3 merge(const Aabb3& a, const Aabb3& b) {
  require_finite_parts("merge", {"a.min", "a.max", "b.min", "b.max"}, a.min, a.max, b.min, b.max);
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

Aabb2 transform(const Aabb2& box, const Pose2& pose) {
  const auto& [c, t] = pose;
  require_finite_parts("transform", {"box.min", "box.max", "pose.columns[0]", "pose.columns[1]", "pose.translation"},
                       box.min, box.max, c[0], c[1], t);
  if (is_empty(box)) return box;
  const std::array from{box.min.x, box.min.y, 0.0}, to{box.max.x, box.max.y, 0.0};
  return box_of(range_of_image("transform", 0, t.x, {c[0].x, c[1].x, 0}, from, to),
                range_of_image("transform", 1, t.y, {c[0].y, c[1].y, 0}, from, to));
}

Aabb3 transform(const Aabb3& box, const Pose& pose) {
  const auto& [c, t] = pose;
  require_finite_parts(
      "transform", {"box.min", "box.max", "pose.columns[0]", "pose.columns[1]", "pose.columns[2]", "pose.translation"},
      box.min, box.max, c[0], c[1], c[2], t);
  if (is_empty(box)) return box;
  const std::array from{box.min.x, box.min.y, box.min.z}, to{box.max.x, box.max.y, box.max.z};
  return box_of(range_of_image("transform", 0, t.x, {c[0].x, c[1].x, c[2].x}, from, to),
                range_of_image("transform", 1, t.y, {c[0].y, c[1].y, c[2].y}, from, to),
                range_of_image("transform", 2, t.z, {c[0].z, c[1].z, c[2].z}, from, to));
}

Aabb2 expand(const Aabb2& box, double margin) {
  require_finite_parts("expand", {"box.min", "box.max", "margin"}, box.min, box.max, margin);
  if (is_empty(box)) return box;
  const auto range = [&](std::size_t axis, double from, double to) {
    return Range{least_sum("expand", axis, from, -margin), greatest_sum("expand", axis, to, margin)};
  };
  return box_of(range(0, box.min.x, box.max.x), range(1, box.min.y, box.max.y));
}

Aabb3 expand(const Aabb3& box, double margin) {
  require_finite_parts("expand", {"box.min", "box.max", "margin"}, box.min, box.max, margin);
  if (is_empty(box)) return box;
  const auto range = [&](std::size_t axis, double from, double to) {
    return Range{least_sum("expand", axis, from, -margin), greatest_sum("expand", axis, to, margin)};
  };
  return box_of(range(0, box.min.x, box.max.x), range(1, box.min.y, box.max.y), range(2, box.min.z, box.max.z));
}

}  // namespace plumb
