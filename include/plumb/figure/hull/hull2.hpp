// What is the convex hull of points in the plane?  Its vertices in order, exactly, for whatever points there are.
//
//   Hull2 hull = convex_hull(points);                                // counterclockwise indices into `points`
//   Hull2 rim = convex_hull(points, {.all_boundary_points = true});  // and what lies on the edges
//
// Laws: (1) vertices are given once each, counterclockwise from the lexicographically smallest (by x, then y); of equal
//       points (-0 equals 0) the one of smallest index stands for all.  (2) Without all_boundary_points they are the
//       strictly extreme points; with it, every point that lies on the boundary, in order.  (3) The result depends on
//       the points alone: not on method, prefilter, execution or machine.  (4) dimension is that of the points' affine
//       hull: -1 for no points, 0 for equal ones (one vertex), 1 for collinear ones (the two ends; or all, from end to
//       end), 2 otherwise.
// A coordinate that is NaN or infinite throws NonFinite: "convex_hull: points[17].y is nan, ...".
// Source: RTCD 3.9.1 (Andrew 1979), 3.9.2 (quickhull; Barber, Dobkin and Huhdanpaa 1996); Akl and Toussaint 1978 for
// the prefilter.
// Cost: n log n for the chain; n log n as a rule for quickhull, n^2 at worst; the prefilter leaves out most of points
// that fill an area in linear time before either.  Bounded by n log n signs for the chain, n^2 signs for quickhull, on
// integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/certify/batch.hpp"
#include "plumb/figure/hull/verify_hull.hpp"

namespace plumb {

struct Hull2 {
  int dimension = -1;
  std::vector<std::uint32_t> vertices;
  friend bool operator==(const Hull2&, const Hull2&) = default;
};

enum class Hull2Method : unsigned char { monotone_chain, quickhull };

struct Hull2Options {
  Hull2Method method = Hull2Method::monotone_chain;
  bool all_boundary_points = false;
  bool prefilter = true;  // leave out what certainly lies inside a polygon of up to eight of the points
  Execution execution = Execution::serial;
};

/// At most 2^32 - 1 points; more throw InvalidShape.
Hull2 convex_hull(std::span<const Point2> points, const Hull2Options& options = {});

/// Is this what the laws say, of these points?  By exact signs, without making a hull: the dimension is right, the
/// vertices turn one way around once, every point is inside or is on an edge, and equal ones are named as law 1 says.
/// The verdict names the first flaw.  Of the options all_boundary_points counts.  Cost: h + n log h.
HullVerdict verify_hull(const Hull2& hull, std::span<const Point2> points, const Hull2Options& options = {});

/// Indices of the points farthest along the direction, ascending: all of those that tie, equal points included.  All
/// points for a zero direction.  Linear.
std::vector<std::uint32_t> extreme_points(std::span<const Point2> points, const Vector2& direction);

}  // namespace plumb
