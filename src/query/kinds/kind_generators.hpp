// Which cases is a kind asked?  The families of hard points, arranged as the kind's arguments.
//
// Law: an arrangement asks `fill` for the coordinates of some points of one dimension, and makes a valid case of them.
// Source: docs/degeneracies.md.
// Cost: as the families take.
#pragma once

#include "plumb/degenerate/family.hpp"
#include "plumb/degenerate/kind.hpp"
#include "plumb/degenerate/shape_pair.hpp"

namespace plumb::degenerate {

using Fill = std::function<void(std::span<double> coordinates, Entropy& entropy)>;
using Arrange = void (*)(Numbers& numbers, Entropy& entropy, const Fill& fill);

/// Every family, aimed at the degeneracy, and "touching": integers from -2 to 2.
std::vector<Generator> family_generators(Degeneracy aim, int dimension, Arrange arrange);

/// The count of points, and their coordinates.
void append_counted(Numbers& numbers, std::span<const double> coordinates, std::size_t dimension);
/// Makes a direction of the second point, rounded, where that is finite.
void aim_at_second(std::span<double> ray);

template <std::size_t count>
void arrange_points(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  numbers.resize(count);
  fill(numbers, entropy);
}
/// Two boxes, each of two corners.
void arrange_boxes(Numbers& numbers, Entropy& entropy, const Fill& fill);
/// A ray toward a sixth point, and a triangle.
void arrange_ray(Numbers& numbers, Entropy& entropy, const Fill& fill);
/// Two oriented boxes: axes of the coordinates, turned at random, the same of both, or off by ulps.
void arrange_oriented_boxes(Numbers& numbers, Entropy& entropy, const Fill& fill);
/// A point and 3 to 10 vertices.
void arrange_polygon(Numbers& numbers, Entropy& entropy, const Fill& fill);
/// Two sets of 1 to 8 points.
void arrange_point_sets(Numbers& numbers, Entropy& entropy, const Fill& fill);
/// 4 to 16 points.
void arrange_cloud(Numbers& numbers, Entropy& entropy, const Fill& fill);

/// Every position that the two can have, exactly or nearly so, each a generator.
using Join = void (*)(Numbers& numbers, const ShapePair& pair);
std::vector<Generator> position_generators(ShapeKind a, ShapeKind b, int dimension, Join join);
void join_plainly(Numbers& numbers, const ShapePair& pair);
void join_point_and_polygon(Numbers& numbers, const ShapePair& pair);
void join_point_sets(Numbers& numbers, const ShapePair& pair);
/// With axes of length one, for which they are rounded where they must be.
void join_oriented_boxes(Numbers& numbers, const ShapePair& pair);

/// A point on a vertex, on an edge, or beside a vertex at its height: exactly so.
Generator boundary_points();
/// Two boxes of the same axes, the second moved along one of them until it touches, but for rounding.
Generator stacked_boxes();
/// The clouds of degenerate/cloud.hpp, 4 to 24 points, and the forms of degenerate/shape.hpp.
std::vector<Generator> cloud_generators();

}  // namespace plumb::degenerate
