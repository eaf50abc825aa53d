// Lines against triangles and planes as CGAL states them.
#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

// Numerator and denominator of the parameter at which o + t d meets the plane of the next three points.
std::pair<Number, Number> parameter(const Kernel::Point_3& o, const Kernel::Vector_3& d, Arguments& p) {
  const auto a = p.point3(), b = p.point3(), c = p.point3();
  const Kernel::Plane_3 plane(a, b, c);
  const Number above = plane.a() * o.x() + plane.b() * o.y() + plane.c() * o.z() + plane.d();
  return {-above, plane.orthogonal_vector() * d};
}

std::optional<Sign> order(const Kernel::Point_3& o, const Kernel::Vector_3& d, Arguments& p) {
  const auto one = parameter(o, d, p), other = parameter(o, d, p);
  return of(CGAL::compare(one.first * other.second, other.first * one.second));
}

std::optional<Sign> below_at(const Kernel::Point_3& o, const Kernel::Vector_3& d, Arguments& p) {
  const auto a = p.point3(), b = p.point3(), c = p.point3();
  const Kernel::Plane_3 plane(a, b, c);
  return -of(plane.oriented_side(o + p.number() * d));
}

}  // namespace

std::optional<Sign> rays_by_cgal(std::string_view predicate, Arguments p) {
  if (predicate == "orient_seen_from") {
    const auto direction = p.vector3();
    const auto a = p.point3(), b = p.point3(), c = p.point3();
    return of(CGAL::orientation(b - a, c - a, direction));
  }
  if (predicate == "line_edge" || predicate == "ray_order" || predicate == "ray_against") {
    const auto o = p.point3();
    const auto d = p.vector3();
    if (predicate == "ray_order") return order(o, d, p);
    if (predicate == "ray_against") return below_at(o, d, p);
    const auto a = p.point3(), b = p.point3();
    return -of(CGAL::orientation(o, o + d, a, b));
  }
  if (predicate == "orient_seen_along" || predicate == "segment_order" || predicate == "segment_against") {
    const auto from = p.point3(), to = p.point3();
    if (predicate == "segment_order") return order(from, to - from, p);
    if (predicate == "segment_against") return below_at(from, to - from, p);
    const auto a = p.point3(), b = p.point3(), c = p.point3();
    return of(CGAL::orientation(b - a, c - a, to - from));
  }
  return std::nullopt;
}

}  // namespace plumb::oracle
