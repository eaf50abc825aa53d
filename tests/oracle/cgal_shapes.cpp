#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <limits>

#include "oracle/cgal_figures.hpp"
#include "oracle/shapes.hpp"

namespace plumb::oracle {
namespace {

using Where = std::optional<Location>;

Where boundary_if(bool on) { return on ? Location::boundary : Location::outside; }
Where side(CGAL::Bounded_side s) {
  return s == CGAL::ON_BOUNDED_SIDE ? Location::inside
         : s == CGAL::ON_BOUNDARY   ? Location::boundary
                                    : Location::outside;
}

template <class Shape, class Point>
Where on(const Shape& shape, const Point& p) {
  if (shape.is_degenerate()) return {};
  return boundary_if(shape.has_on(p));
}
template <class Shape, class Point>
Where in(const Shape& shape, const Point& p) {
  if (shape.is_degenerate()) return {};
  return side(shape.bounded_side(p));
}

template <class Capsule, class Segment, class Point>
Where within(const Segment& segment, const Point& p, const Capsule& c) {
  if (segment.is_degenerate() || c.radius == 0) return {};
  return Location{
      static_cast<signed char>(CGAL::compare(Number(c.radius) * Number(c.radius), CGAL::squared_distance(p, segment)))};
}

/// No double is nearer to x.
bool is_nearest(double told, const Number& x) {
  const Number off = CGAL::abs(Number(told) - x);
  for (const double way : {-HUGE_VAL, HUGE_VAL}) {
    const double other = std::nextafter(told, way);
    if (std::isfinite(other) && CGAL::abs(Number(other) - x) < off) return false;
  }
  return std::isfinite(told);
}

}  // namespace

Where locate(const Line2& l, const Point2& p) { return on(Kernel::Line_2(of(l.point), of(l.direction)), of(p)); }
Where locate(const Line3& l, const Point3& p) {
  return l.direction == Vector3{0, 0, 0} ? Where() : on(Kernel::Line_3(of(l.point), of(l.direction)), of(p));
}
Where locate(const Ray2& r, const Point2& p) { return on(Kernel::Ray_2(of(r.origin), of(r.direction)), of(p)); }
Where locate(const Ray3& r, const Point3& p) { return on(Kernel::Ray_3(of(r.origin), of(r.direction)), of(p)); }
Where locate(const Segment2& s, const Point2& p) { return on(Kernel::Segment_2(of(s.a), of(s.b)), of(p)); }
Where locate(const Segment3& s, const Point3& p) { return on(Kernel::Segment_3(of(s.a), of(s.b)), of(p)); }
Where locate(const Plane3& s, const Point3& p) {
  const Vector3& n = s.normal;
  return on(Kernel::Plane_3(Number(n.x), Number(n.y), Number(n.z), -Number(s.offset)), of(p));
}
Where locate(const ThreePointPlane3& s, const Point3& p) {
  return on(Kernel::Plane_3(of(s.a), of(s.b), of(s.c)), of(p));
}
Where locate(const Halfspace2& h, const Point2& p) {
  const Kernel::Line_2 line(Number(h.normal.x), Number(h.normal.y), -Number(h.offset));
  if (line.is_degenerate()) return {};
  return Location{static_cast<signed char>(-line.oriented_side(of(p)))};
}
Where locate(const Halfspace3& h, const Point3& p) {
  const Kernel::Plane_3 plane(Number(h.normal.x), Number(h.normal.y), Number(h.normal.z), -Number(h.offset));
  if (plane.is_degenerate()) return {};
  return Location{static_cast<signed char>(-plane.oriented_side(of(p)))};
}
Where locate(const Triangle2& t, const Point2& p) { return in(Kernel::Triangle_2(of(t.a), of(t.b), of(t.c)), of(p)); }
Where locate(const Triangle3& t, const Point3& p) { return on(Kernel::Triangle_3(of(t.a), of(t.b), of(t.c)), of(p)); }
Where locate(const Tetrahedron3& t, const Point3& p) {
  return in(Kernel::Tetrahedron_3(of(t.a), of(t.b), of(t.c), of(t.d)), of(p));
}
Where locate(const Circle2& c, const Point2& p) {
  return in(Kernel::Circle_2(of(c.center), Number(c.radius) * Number(c.radius)), of(p));
}
Where locate(const Sphere3& s, const Point3& p) {
  return in(Kernel::Sphere_3(of(s.center), Number(s.radius) * Number(s.radius)), of(p));
}
Where locate(const Capsule2& c, const Point2& p) { return within(Kernel::Segment_2(of(c.a), of(c.b)), of(p), c); }
Where locate(const Capsule3& c, const Point3& p) { return within(Kernel::Segment_3(of(c.a), of(c.b)), of(p), c); }

// The constructors of CGAL's boxes order the corners: empty ones are not theirs.
Where locate(const Aabb2& b, const Point2& p) {
  if (b.min.x > b.max.x || b.min.y > b.max.y) return {};
  return in(Kernel::Iso_rectangle_2(of(b.min), of(b.max)), of(p));
}
Where locate(const Aabb3& b, const Point3& p) {
  if (b.min.x > b.max.x || b.min.y > b.max.y || b.min.z > b.max.z) return {};
  return in(Kernel::Iso_cuboid_3(of(b.min), of(b.max)), of(p));
}

// The image of p under the affine map that takes the box to the cube [-1, 1]^3, by CGAL's inverse transformation.
Where locate(const Obb3& b, const Point3& p) {
  const Kernel::Vector_3 u = of(b.axes[0]) * Number(b.half.x), v = of(b.axes[1]) * Number(b.half.y),
                         w = of(b.axes[2]) * Number(b.half.z);
  if (CGAL::determinant(u, v, w) == 0) return {};
  const CGAL::Aff_transformation_3<Kernel> from_cube(u.x(), v.x(), w.x(), Number(b.center.x), u.y(), v.y(), w.y(),
                                                     Number(b.center.y), u.z(), v.z(), w.z(), Number(b.center.z));
  const Kernel::Point_3 image = from_cube.inverse().transform(of(p));
  return side(Kernel::Iso_cuboid_3(-1, -1, -1, 1, 1, 1).bounded_side(image));
}

std::optional<bool> is_as_near(const Triangle3& t, const Feature& feature, const Point3& point) {
  const std::array corners{of(t.a), of(t.b), of(t.c)};
  const Kernel::Triangle_3 triangle(corners[0], corners[1], corners[2]);
  if (triangle.is_degenerate()) return {};
  const Kernel::Point_3 p = of(point);
  const Number least = CGAL::squared_distance(p, triangle);
  if (feature.kind == FeatureKind::face) return CGAL::squared_distance(p, triangle.supporting_plane()) == least;
  const auto &a = corners[feature.index], &b = corners[(feature.index + 1) % 3];
  if (feature.kind == FeatureKind::vertex) return CGAL::squared_distance(p, a) == least;
  return CGAL::squared_distance(p, Kernel::Line_3(a, b)) == least;
}

bool is_barycenter(const Triangle2& t, const std::array<double, 3>& w, const Point2& told) {
  const auto c = CGAL::barycenter(of(t.a), Number(w[0]), of(t.b), Number(w[1]), of(t.c), Number(w[2]));
  return is_nearest(told.x, c.x()) && is_nearest(told.y, c.y());
}
bool is_barycenter(const Triangle3& t, const std::array<double, 3>& w, const Point3& told) {
  const auto c = CGAL::barycenter(of(t.a), Number(w[0]), of(t.b), Number(w[1]), of(t.c), Number(w[2]));
  return is_nearest(told.x, c.x()) && is_nearest(told.y, c.y()) && is_nearest(told.z, c.z());
}

}  // namespace plumb::oracle
