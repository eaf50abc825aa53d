// The classic predicates as CGAL states them.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include "oracle/oracle.hpp"

namespace plumb::oracle {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

Sign of(int cgal) { return static_cast<Sign>((cgal > 0) - (cgal < 0)); }

Kernel::Point_2 point2(std::span<const double> p, std::size_t i) {
  return {CGAL::Gmpq(p[2 * i]), CGAL::Gmpq(p[2 * i + 1])};
}

Kernel::Point_3 point3(std::span<const double> p, std::size_t i) {
  return {CGAL::Gmpq(p[3 * i]), CGAL::Gmpq(p[3 * i + 1]), CGAL::Gmpq(p[3 * i + 2])};
}

}  // namespace

std::optional<Sign> cgal_sign(std::string_view predicate, std::span<const double> p) {
  if (predicate == "orient2d") return of(CGAL::orientation(point2(p, 0), point2(p, 1), point2(p, 2)));
  if (predicate == "incircle") {
    return of(CGAL::side_of_oriented_circle(point2(p, 0), point2(p, 1), point2(p, 2), point2(p, 3)));
  }
  // CGAL calls a tetrahedron positive that the literature of robust predicates calls negative.
  if (predicate == "orient3d") {
    return -of(CGAL::orientation(point3(p, 0), point3(p, 1), point3(p, 2), point3(p, 3)));
  }
  if (predicate == "insphere") {
    return -of(CGAL::side_of_oriented_sphere(point3(p, 0), point3(p, 1), point3(p, 2), point3(p, 3), point3(p, 4)));
  }
  return std::nullopt;
}

}  // namespace plumb::oracle
