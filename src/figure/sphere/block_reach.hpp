// Extreme points: how far do many points reach, along the axes and from a center?  Passes of plain doubles, in lanes.
//
// Laws: the extent is exact.  What is said of a center is the largest that square_of_distance() computes of the points,
// by the same operations in the same order: the same bits on every machine.
// Source: RTCD 4.2, 13.7.
// Cost: some 0.7 ns a point, or what memory allows.
#pragma once

#include <span>
#include <type_traits>

#include "plumb/arith/point.hpp"
#include "plumb/arith/square_sum.hpp"

namespace plumb::figure::sphere {

template <class Point>
struct Extent {
  Point min, max;
};

/// Of at least one point; false where a number is none or infinite, and the extent then means nothing.
bool find_extent(std::span<const Point2> points, Extent<Point2>& extent);
bool find_extent(std::span<const Point3> points, Extent<Point3>& extent);

/// |cp|^2 times the square of a power of two.
template <class Point>
auto square_of_distance(const Point& c, const Point& p, double power) {
  const auto square = [power](double to, double from) {
    return squared(arith::squares::scaled(arith::squares::difference(to, from), power));
  };
  if constexpr (std::is_same_v<Point, Point3>) {
    return square(p.x, c.x) + square(p.y, c.y) + square(p.z, c.z);
  } else {
    return square(p.x, c.x) + square(p.y, c.y);
  }
}

/// The largest of the points; 0 at least.
double farthest_square(const Point2& c, std::span<const Point2> points, double power);
double farthest_square(const Point3& c, std::span<const Point3> points, double power);

}  // namespace plumb::figure::sphere
