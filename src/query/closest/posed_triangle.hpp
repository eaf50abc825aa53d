// Closest points of triangles under poses, whose corners are not rounded: to a point, and to one another.
//
// Laws: those of query/closest/closest.hpp and pairs.hpp, of the exact images.
// Source: RTCD 5.1.5, 5.1.10.
// Cost: some 500 ns for a point, tens of microseconds for two triangles.
#pragma once

#include <array>
#include <optional>

#include "plumb/arith/rational.hpp"
#include "plumb/query/closest/result.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

struct ClosestOnPosed {
  Point3 point;
  double distance;
  Feature feature;
};

/// Which holds the nearest point; of finite numbers, as all that follow.
Feature nearest_feature(const PosedTriangle3& triangle, const Point3& p);
ClosestOnPosed closest_on(const PosedTriangle3& triangle, const Point3& p);
double distance(const PosedTriangle3& triangle, const Point3& p);
Rational squared_distance_exact(const PosedTriangle3& triangle, const Point3& p);
/// The sign of the distance minus a number that is not negative.
Sign compare_distance(const PosedTriangle3& triangle, const Point3& p, double than);

/// at / weight, with a positive weight.
template <class T>
struct WeightedPoint {
  Vec3<T> at;
  T weight;
};
/// Closest points, one of each; quickly where pairs of doubles tell.
template <class T>
using WeightedPair = std::array<WeightedPoint<T>, 2>;
WeightedPair<BigDyadic> exact_closest_points(const PosedTriangle3& a, const PosedTriangle3& b);
std::optional<WeightedPair<Ball>> quick_closest_points(const PosedTriangle3& a, const PosedTriangle3& b);

Closest closest_points(const PosedTriangle3& a, const PosedTriangle3& b);
double distance(const PosedTriangle3& a, const PosedTriangle3& b);
Rational squared_distance_exact(const PosedTriangle3& a, const PosedTriangle3& b);
/// Features as far apart as the triangles, within which closest points lie; where pairs of doubles tell.
std::optional<std::array<Feature, 2>> quick_features(const PosedTriangle3& a, const PosedTriangle3& b);
Sign compare_distance(const PosedTriangle3& a, const PosedTriangle3& b, double than);

}  // namespace plumb::query
