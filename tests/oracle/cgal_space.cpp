// Lines, triangles and planes as CGAL states them.
#include <CGAL/intersections.h>

#include "oracle/cgal_figures.hpp"
#include "oracle/space.hpp"

namespace plumb::oracle {
namespace {

// The parameter at which o + t d lies in the plane.
std::optional<Number> parameter(const Point3& o, const Vector3& d, const std::array<Point3, 3>& plane) {
  const Kernel::Point_3 a = of(plane[0]), b = of(plane[1]), c = of(plane[2]);
  const Kernel::Vector_3 direction = of(d);
  if (direction == CGAL::NULL_VECTOR || CGAL::collinear(a, b, c)) return std::nullopt;
  const auto found = CGAL::intersection(Kernel::Line_3(of(o), direction), Kernel::Plane_3(a, b, c));
  if (!found) return std::nullopt;
  const auto* at = boost::get<Kernel::Point_3>(&*found);
  if (at == nullptr) return std::nullopt;
  return ((*at - of(o)) * direction) / (direction * direction);
}

}  // namespace

Sign coplanar_orientation(const Point3& a, const Point3& b, const Point3& c) {
  return of(CGAL::coplanar_orientation(of(a), of(b), of(c)));
}

std::optional<Sign> coplanar_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (CGAL::collinear(of(a), of(b), of(c))) return std::nullopt;
  if (!CGAL::coplanar(of(a), of(b), of(c), of(d))) return std::nullopt;
  return of(CGAL::coplanar_orientation(of(a), of(b), of(c), of(d)));
}

std::optional<bool> line_meets_triangle(const Point3& o, const Vector3& d, const std::array<Point3, 3>& triangle) {
  if (!parameter(o, d, triangle)) {
    const Kernel::Vector_3 direction = of(d);
    const Kernel::Triangle_3 t(of(triangle[0]), of(triangle[1]), of(triangle[2]));
    if (direction == CGAL::NULL_VECTOR || t.is_degenerate() || t.supporting_plane().has_on(of(o))) {
      return std::nullopt;
    }
    return false;  // parallel to the plane
  }
  return CGAL::do_intersect(Kernel::Line_3(of(o), of(d)),
                            Kernel::Triangle_3(of(triangle[0]), of(triangle[1]), of(triangle[2])));
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
