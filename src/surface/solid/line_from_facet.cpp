#include "surface/solid/line_from_facet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/predicates.hpp"

namespace plumb::surface {
namespace {

RationalPoint3 middle_of(const std::array<RationalPoint3, 3>& p) {
  const Rational third(1, 3);
  return {third * (p[0].x + p[1].x + p[2].x), third * (p[0].y + p[1].y + p[2].y), third * (p[0].z + p[1].z + p[2].z)};
}

double just_below(double x) {
  return std::max(std::nextafter(x, -std::numeric_limits<double>::infinity()), std::numeric_limits<double>::lowest());
}
double just_above(double x) {
  return std::min(std::nextafter(x, std::numeric_limits<double>::infinity()), std::numeric_limits<double>::max());
}

/// A box that holds the line from the point on: a number is between the neighbors of its nearest double.
Aabb3 box_around_line(const Point3& nearest) {
  return {{just_below(nearest.x), just_below(nearest.y), just_below(nearest.z)},
          {std::numeric_limits<double>::max(), just_above(nearest.y), just_above(nearest.z)}};
}

Sign order_of(double a, double b) { return a < b ? Sign::negative : a == b ? Sign::zero : Sign::positive; }

/// The turn of a, b and a point on their line that is moved: its y is in the place of x and z in that of y.
Sign turn_when_moved(const Point2& a, const Point2& b) {
  const Sign along = order_of(b.x, a.x);
  return along != Sign::zero ? along : order_of(a.y, b.y);
}
Sign turn_when_moved(const ExactPoint2& a, const ExactPoint2& b) {
  const RationalPoint2 from = rational_point(a), to = rational_point(b);
  const Sign along = (to.x - from.x).sign();
  return along != Sign::zero ? along : (from.y - to.y).sign();
}

template <class Point>
Sign turn_with_moved(const Point& a, const Point& b, const ExactPoint2& p) {
  const Sign turn = orient2d(a, b, p);
  return turn != Sign::zero ? turn : turn_when_moved(a, b);
}

/// The triangle's turn seen from +x where the line along x through the moved point passes it, else zero.
template <class Point>
Sign passage(const std::array<Point, 3>& at, const ExactPoint2& p) {
  const Sign turn = orient2d(at[0], at[1], at[2]);
  if (turn == Sign::zero) return turn;
  for (std::size_t k = 0; k < 3; ++k)
    if (turn_with_moved(at[k], at[(k + 1) % 3], p) != turn) return Sign::zero;
  return turn;
}

}  // namespace

LineFromFacet::LineFromFacet(const NumberedPoints& points, const TriangleMesh::Triangle& corners,
                             const TurnedPlane& plane) {
  const auto& [a, b, c] = corners;
  const RationalPoint3 middle =
      middle_of({rational_point(points.at(a)), rational_point(points.at(b)), rational_point(points.at(c))});
  from_ = ExactPoint3(middle);
  seen_ = ExactPoint2(RationalPoint2{middle.y, middle.z});
  const auto [normal_x, normal_y, normal_z] = plane.normal_signs(points);
  normal_x_ = normal_x;
  moved_ = normal_z != Sign::zero ? normal_z : normal_y != Sign::zero ? normal_y : Sign::positive;
}

Aabb3 LineFromFacet::box() const { return box_around_line(approximate(from_)); }

int LineFromFacet::winding_of(const std::array<Point3, 3>& t) const {
  return winding_where_passed(passage(std::array{shadow(t[0], 0), shadow(t[1], 0), shadow(t[2], 0)}, seen_), t);
}

int LineFromFacet::winding_of(const NumberedPoints& points, const TriangleMesh::Triangle& corners) const {
  const auto& [a, b, c] = corners;
  if (points.is_given(a) && points.is_given(b) && points.is_given(c))
    return winding_of({points.given[a], points.given[b], points.given[c]});
  const std::array<HeldPoint, 3> t{points.at(a), points.at(b), points.at(c)};
  return winding_where_passed(passage(std::array{shadow(t[0], 0), shadow(t[1], 0), shadow(t[2], 0)}, seen_), t);
}

template <class Point>
int LineFromFacet::winding_where_passed(Sign turn, const std::array<Point, 3>& t) const {
  if (turn == Sign::zero) return 0;
  // Positive where the line still comes to the triangle.
  Sign ahead = orient3d(t[0], t[1], t[2], from_) * turn;
  if (ahead == Sign::zero) ahead = -(normal_x_ * moved_);
  if (ahead != Sign::positive) return 0;
  return turn == Sign::positive ? 1 : -1;
}

}  // namespace plumb::surface
