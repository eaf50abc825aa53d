// Lines, triangles and planes as CGAL states them.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include "oracle/space.hpp"

namespace plumb::oracle {
namespace {

using Number = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Number>;

Sign of(int cgal) { return static_cast<Sign>((cgal > 0) - (cgal < 0)); }

Kernel::Point_3 point(const Point3& p) { return {Number(p.x), Number(p.y), Number(p.z)}; }
Kernel::Vector_3 vector(const Vector3& v) { return {Number(v.x), Number(v.y), Number(v.z)}; }

// The parameter at which o + t d lies in the plane.
std::optional<Number> parameter(const Point3& o, const Vector3& d, const std::array<Point3, 3>& plane) {
  const Kernel::Point_3 a = point(plane[0]), b = point(plane[1]), c = point(plane[2]);
  const Kernel::Vector_3 direction = vector(d);
  if (direction == CGAL::NULL_VECTOR || CGAL::collinear(a, b, c)) return std::nullopt;
  const auto found = CGAL::intersection(Kernel::Line_3(point(o), direction), Kernel::Plane_3(a, b, c));
  if (!found) return std::nullopt;
  const auto* at = boost::get<Kernel::Point_3>(&*found);
  if (at == nullptr) return std::nullopt;
  return ((*at - point(o)) * direction) / (direction * direction);
}

}  // namespace

Sign coplanar_orientation(const Point3& a, const Point3& b, const Point3& c) {
  return of(CGAL::coplanar_orientation(point(a), point(b), point(c)));
}

std::optional<Sign> coplanar_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (CGAL::collinear(point(a), point(b), point(c))) return std::nullopt;
  if (!CGAL::coplanar(point(a), point(b), point(c), point(d))) return std::nullopt;
  return of(CGAL::coplanar_orientation(point(a), point(b), point(c), point(d)));
}

std::optional<bool> line_meets_triangle(const Point3& o, const Vector3& d, const std::array<Point3, 3>& triangle) {
  if (!parameter(o, d, triangle)) {
    const Kernel::Vector_3 direction = vector(d);
    const Kernel::Triangle_3 t(point(triangle[0]), point(triangle[1]), point(triangle[2]));
    if (direction == CGAL::NULL_VECTOR || t.is_degenerate() || t.supporting_plane().has_on(point(o))) {
      return std::nullopt;
    }
    return false;  // parallel to the plane
  }
  return CGAL::do_intersect(Kernel::Line_3(point(o), vector(d)),
                            Kernel::Triangle_3(point(triangle[0]), point(triangle[1]), point(triangle[2])));
}

std::optional<Sign> compare_ray_parameters(const Point3& o, const Vector3& d, const std::array<Point3, 3>& first,
                                           const std::array<Point3, 3>& second) {
  const auto one = parameter(o, d, first), other = parameter(o, d, second);
  if (!one || !other) return std::nullopt;
  return of(CGAL::compare(*one, *other));
}

std::optional<Sign> compare_ray_parameter(const Point3& o, const Vector3& d, const std::array<Point3, 3>& plane,
                                          double t) {
  const auto at = parameter(o, d, plane);
  if (!at) return std::nullopt;
  return of(CGAL::compare(*at, Number(t)));
}

}  // namespace plumb::oracle
