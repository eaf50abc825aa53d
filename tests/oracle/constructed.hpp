// What is the true sign at points that are constructed or posed?  Two judges that construct the points, by division.
//
// Laws: both are exact for all finite doubles.  The rational judge solves for each point in GMP's rationals and runs
// the classic formula there; CGAL constructs with its own intersections and transformations over its exact rational
// kernel. Neither knows weights.
// Source: CGAL's manual, "2D and 3D Linear Geometry Kernel".
// Cost: 10 to 500 us a sign.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plumb/arith/sign.hpp"

namespace plumb::oracle {

enum class Construction {
  explicit2,
  line_line2,
  segment2,
  posed2,
  explicit3,
  line_plane3,
  three_plane3,
  segment3,
  posed3
};

/// A point: how it is made, and of which numbers, in the order of coordinates(point).
struct Constructed {
  Construction by;
  std::vector<double> numbers;
};

enum class Question { orient, in_sphere };  // in the plane: incircle

/// The sign of orient2d, orient3d, incircle or insphere; nothing where a construction has no point.
std::optional<Sign> rational_sign(Question question, std::span<const Constructed> points);
std::optional<Sign> cgal_sign(Question question, std::span<const Constructed> points);

/// Lexicographic order, and the first axis in which the points differ (their dimension when equal); nothing where a
/// construction has no point.
struct Order {
  Sign sign;
  int axis;
};
std::optional<Order> rational_order(const Constructed& p, const Constructed& q);

/// The exact coordinate as the nearest double, ties to even, and whether it is beyond all of them; nothing where the
/// construction has no point.
struct Nearest {
  double value;
  bool overflows;
};
std::optional<Nearest> nearest_coordinate(const Constructed& point, int axis);

}  // namespace plumb::oracle
