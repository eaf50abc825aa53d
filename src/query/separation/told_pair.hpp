// What is said of the nearest points of two cores?  The answer of closest_points: points on surfaces, features, distance.
//
// Laws: (1), (4) and (6) of query/separation/separation.hpp.
// Cost: GMP; a radical a coordinate of what is round.
#pragma once

#include "plumb/query/closest/result.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/nearest_pair.hpp"

namespace plumb::query {

/// A figure as it is seen: with this radius, and under the map, if there is one.
struct SeenFigure {
  FigureView figure;
  mpq_class radius;
  const ExactMap* map = nullptr;
};

Closest told_pair(const NearestPair& pair, const SeenFigure& a, const SeenFigure& b);
/// Without features: both are the interior.
Closest told_places(const NearestPair& pair, const mpq_class& radius_a, const mpq_class& radius_b);

/// root(square) - radii, or zero.
double rounded_distance(const mpq_class& square, const mpq_class& radii);

}  // namespace plumb::query
