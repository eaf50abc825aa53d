// CGAL's smallest balls: Min_sphere_d in rationals, Min_sphere_of_spheres_d in doubles.
#include "oracle/cgal_spheres_of_points.hpp"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Min_sphere_annulus_d_traits_d.h>
#include <CGAL/Min_sphere_d.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Min_sphere_of_spheres_d_traits_3.h>
#include <gmpxx.h>

namespace plumb::oracle {

std::vector<std::string> exact_smallest_ball(std::span<const double> coordinates, int dimension) {
  using Kernel = CGAL::Cartesian_d<CGAL::Gmpq>;
  using Traits = CGAL::Min_sphere_annulus_d_traits_d<Kernel>;
  std::vector<Kernel::Point_d> points;
  const auto axes = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i + axes <= coordinates.size(); i += axes) {
    std::vector<CGAL::Gmpq> p;
    for (std::size_t a = 0; a < axes; ++a) p.emplace_back(coordinates[i + a]);
    points.emplace_back(dimension, p.begin(), p.end());
  }
  const CGAL::Min_sphere_d<Traits> ball(points.begin(), points.end());
  const auto text = [](const CGAL::Gmpq& x) { return mpq_class(x.mpq()).get_str(); };
  std::vector<std::string> all;
  const Kernel::Point_d center = ball.center();
  for (int a = 0; a < dimension; ++a) all.push_back(text(center.cartesian(a)));
  all.push_back(text(ball.squared_radius()));
  return all;
}

std::vector<double> smallest_ball_of_balls(std::span<const double> numbers) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Traits = CGAL::Min_sphere_of_spheres_d_traits_3<Kernel, double, CGAL::Tag_true>;
  std::vector<Traits::Sphere> balls;
  for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4) {
    balls.emplace_back(Kernel::Point_3(numbers[i], numbers[i + 1], numbers[i + 2]), numbers[i + 3]);
  }
  CGAL::Min_sphere_of_spheres_d<Traits> ball(balls.begin(), balls.end());
  std::vector<double> all(ball.center_cartesian_begin(), ball.center_cartesian_end());
  all.push_back(ball.radius());
  return all;
}

}  // namespace plumb::oracle
