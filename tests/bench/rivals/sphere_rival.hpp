// CGAL's smallest enclosing sphere in doubles (Min_sphere_of_spheres_d).
#pragma once

#include <functional>
#include <span>

namespace plumb::bench {

/// Finds the sphere once for each call and returns its radius; the points (x y z ...) are made beforehand.
std::function<double()> cgal_minimum_sphere(std::span<const double> coordinates);

/// Of balls (x y z r ...).
std::function<double()> cgal_minimum_sphere_of_balls(std::span<const double> numbers);

}  // namespace plumb::bench
