#include "bench/rivals/sphere_rival.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Min_sphere_of_spheres_d_traits_3.h>

#include <vector>

namespace plumb::bench {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

}  // namespace

std::function<double()> cgal_minimum_sphere(std::span<const double> c) {
  using Traits = CGAL::Min_sphere_of_points_d_traits_3<K, double>;
  std::vector<K::Point_3> p;
  for (std::size_t i = 0; i + 2 < c.size(); i += 3) p.emplace_back(c[i], c[i + 1], c[i + 2]);
  return [p] { return CGAL::Min_sphere_of_spheres_d<Traits>(p.begin(), p.end()).radius(); };
}

std::function<double()> cgal_minimum_sphere_of_balls(std::span<const double> c) {
  using Traits = CGAL::Min_sphere_of_spheres_d_traits_3<K, double>;
  std::vector<Traits::Sphere> balls;
  for (std::size_t i = 0; i + 3 < c.size(); i += 4) balls.emplace_back(K::Point_3(c[i], c[i + 1], c[i + 2]), c[i + 3]);
  return [balls] { return CGAL::Min_sphere_of_spheres_d<Traits>(balls.begin(), balls.end()).radius(); };
}

}  // namespace plumb::bench
