// Which point do others construct?  Implicit points: what they were made from, and nothing rounded.
//
// Laws: an implicit point stands for the exact point; two that are given differently may be equal.  Nothing is checked
// here; whoever asks about a construction that has no point gets DegeneratePoint.
// With Posed<Point2, Pose2> and Posed<Point3> (pose.hpp) these are the kinds that the signs take beside explicit
// points.
// Source: RTCD 5.1.9.1, 5.3.1, 5.4.5.
// Cost: none.
#pragma once

#include <array>

#include "plumb/arith/point.hpp"

namespace plumb {

/// Where the lines ab and cd meet, within the segments or beyond; none when they are parallel or one has no length.
struct LineLinePoint2 {
  Point2 a, b, c, d;
  friend bool operator==(const LineLinePoint2&, const LineLinePoint2&) = default;
};

/// Where the line pq meets the plane abc; none when parallel, when p equals q, or when a, b, c are collinear.
struct LinePlanePoint3 {
  Point3 p, q;
  Point3 a, b, c;
  friend bool operator==(const LinePlanePoint3&, const LinePlanePoint3&) = default;
};

/// Where three planes, each through three points, meet; none when all are parallel to one line.
struct ThreePlanePoint3 {
  std::array<Point3, 3> first, second, third;
  friend bool operator==(const ThreePlanePoint3&, const ThreePlanePoint3&) = default;
};

/// The point a + t (b - a), for any finite t.
struct SegmentPoint2 {
  Point2 a, b;
  double t;
  friend bool operator==(const SegmentPoint2&, const SegmentPoint2&) = default;
};

struct SegmentPoint3 {
  Point3 a, b;
  double t;
  friend bool operator==(const SegmentPoint3&, const SegmentPoint3&) = default;
};

}  // namespace plumb
