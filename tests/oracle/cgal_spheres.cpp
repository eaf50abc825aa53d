// Smallest spheres and powers as CGAL states them.
#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

std::optional<Sign> powers(std::string_view predicate, Arguments p) {
  Arguments q = p;
  if (predicate == "power_circle") {
    const auto a = p.weighted2(), b = p.weighted2(), c = p.weighted2(), d = p.weighted2();
    return of(Kernel().power_side_of_oriented_power_circle_2_object()(a, b, c, d));
  }
  if (predicate == "compare_power2d") {
    const auto a = p.point2();
    const auto b = p.weighted2(), c = p.weighted2();
    return of(Kernel().compare_power_distance_2_object()(a, b, c));
  }
  if (predicate == "power_product2d") {
    const auto a = p.weighted2(), b = p.weighted2();
    return of(Kernel().compute_power_product_2_object()(a, b));
  }
  if (predicate == "power_sphere") {  // CGAL's orientation is the opposite
    const auto a = q.weighted3(), b = q.weighted3(), c = q.weighted3(), d = q.weighted3(), e = q.weighted3();
    return -of(Kernel().power_side_of_oriented_power_sphere_3_object()(a, b, c, d, e));
  }
  if (predicate == "compare_power3d") {
    const auto a = q.point3();
    const auto b = q.weighted3(), c = q.weighted3();
    return of(Kernel().compare_power_distance_3_object()(a, b, c));
  }
  if (predicate == "power_product3d") {
    const auto a = q.weighted3(), b = q.weighted3();
    return of(Kernel().compute_power_product_3_object()(a, b));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Sign> spheres_by_cgal(std::string_view predicate, Arguments p) {
  if (predicate == "in_smallest_circle") {
    const auto a = p.point2(), b = p.point2(), c = p.point2();
    return of(CGAL::side_of_bounded_circle(a, b, c));
  }
  if (predicate == "in_smallest_sphere2") {
    const auto a = p.point3(), b = p.point3(), c = p.point3();
    return of(CGAL::side_of_bounded_sphere(a, b, c));
  }
  if (predicate == "in_smallest_sphere3") {
    const auto a = p.point3(), b = p.point3(), c = p.point3(), d = p.point3();
    return CGAL::collinear(a, b, c) ? Sign::zero : of(CGAL::side_of_bounded_sphere(a, b, c, d));
  }
  return powers(predicate, p);
}

}  // namespace plumb::oracle
