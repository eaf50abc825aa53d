// What is the smallest ball of points, and of balls, by CGAL?  Exactly, in rationals; as text, so that nobody else
// needs CGAL or GMP.
//
// Source: CGAL 5.5's manual, Bounding Volumes.
// Cost: microseconds a point and more.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace plumb::oracle {

/// The center's coordinates and the squared radius, as fractions in lowest terms.  Takes x y x y ... or x y z ...
std::vector<std::string> exact_smallest_ball(std::span<const double> coordinates, int dimension);

/// In doubles, of balls given as x y z r ...: center and radius.
std::vector<double> smallest_ball_of_balls(std::span<const double> numbers);

}  // namespace plumb::oracle
