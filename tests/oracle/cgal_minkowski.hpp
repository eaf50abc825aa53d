// What does CGAL make of hulls and Minkowski sums in the plane?  Exact answers, as numbers that can be compared.
//
// Source: CGAL 5.5's manual, "2D Convex Hulls", "2D Minkowski Sums".
// Cost: microseconds a point; milliseconds a sum.
#pragma once

#include <span>
#include <vector>

namespace plumb::oracle {

/// The coordinates x y x y ... of the strictly extreme points, counterclockwise from the lexicographically smallest.
std::vector<double> hull_2(std::span<const double> coordinates);

/// Is the sum of these two polygons (x y x y ..., at least three vertices, convex, counterclockwise, of positive area)
/// the polygon whose vertices are pairs of points (x y x y each, to be added), counterclockwise, strictly convex?
bool is_sum_2(std::span<const double> a, std::span<const double> b, std::span<const double> pairs);

}  // namespace plumb::oracle
