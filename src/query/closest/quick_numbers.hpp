// Which doubles are nearest to the points and the distance of a closest pair, where two doubles a number tell?
//
// Laws: what is given is right; nothing is given where two doubles leave a doubt, and of numbers that are none.
// Source: arith/twofold.hpp.
// Cost: 60 to 120 ns.
#pragma once

#include <optional>

#include "plumb/figure/basic/simplex.hpp"
#include "query/closest/linear_pair.hpp"

namespace plumb::query {

template <class Point>
struct PairNumbers {
  Point on_a, on_b;
  double distance;
};

std::optional<PairNumbers<Point2>> quick_numbers(const Straight<Point2>& p, const Straight<Point2>& q,
                                                 SpotsOnLines places);
std::optional<PairNumbers<Point3>> quick_numbers(const Straight<Point3>& p, const Straight<Point3>& q,
                                                 SpotsOnLines places);
std::optional<double> quick_distance(const Straight<Point2>& p, const Straight<Point2>& q, SpotsOnLines places);
std::optional<double> quick_distance(const Straight<Point3>& p, const Straight<Point3>& q, SpotsOnLines places);

/// Of a vertex, which is on_a, and the face of a triangle that it projects into.
std::optional<PairNumbers<Point3>> quick_numbers(const Point3& vertex, const Triangle3& face);
std::optional<double> quick_distance(const Point3& vertex, const Triangle3& face);

/// Where the line of a segment or ray meets the plane of a triangle.
std::optional<Point3> quick_crossing(const Straight<Point3>& p, const Triangle3& face);

}  // namespace plumb::query
