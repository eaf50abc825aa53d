// The classic predicates as CGAL states them, and who to ask for the others.
#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

std::optional<Sign> classics_by_cgal(std::string_view predicate, Arguments p) {
  if (predicate == "orient2d") {
    const auto a = p.point2(), b = p.point2(), c = p.point2();
    return of(CGAL::orientation(a, b, c));
  }
  if (predicate == "incircle") {
    const auto a = p.point2(), b = p.point2(), c = p.point2(), d = p.point2();
    return of(CGAL::side_of_oriented_circle(a, b, c, d));
  }
  // CGAL calls a tetrahedron positive that the literature of robust predicates calls negative.
  if (predicate == "orient3d") {
    const auto a = p.point3(), b = p.point3(), c = p.point3(), d = p.point3();
    return -of(CGAL::orientation(a, b, c, d));
  }
  if (predicate == "insphere") {
    const auto a = p.point3(), b = p.point3(), c = p.point3(), d = p.point3(), e = p.point3();
    return -of(CGAL::side_of_oriented_sphere(a, b, c, d, e));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Sign> cgal_sign(std::string_view predicate, std::span<const double> coordinates) {
  for (const Judge judge : {classics_by_cgal, directions_by_cgal, distances_by_cgal, planes_by_cgal, spheres_by_cgal,
                            rays_by_cgal, cross_products_by_cgal, radicals_by_cgal}) {
    if (const auto sign = judge(predicate, Arguments(coordinates))) return sign;
  }
  return std::nullopt;
}

}  // namespace plumb::oracle
