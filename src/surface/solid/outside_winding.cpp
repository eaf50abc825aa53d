#include "surface/solid/outside_winding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/predicates.hpp"
#include "plumb/space/bvh/build.hpp"
#include "plumb/space/range/range_search.hpp"

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

/// The turn of a, b and the moved point, whose y is in the place of x and z in that of y.
Sign turn_with_moved(const Point2& a, const Point2& b, const ExactPoint2& p) {
  const Sign turn = orient2d(ExactPoint2(a), ExactPoint2(b), p);
  if (turn != Sign::zero) return turn;
  const Sign along = order_of(b.x, a.x);
  return along != Sign::zero ? along : order_of(a.y, b.y);
}

/// The triangle's turn seen from +x where the line along x through the moved point passes it, else zero.
Sign passage(const std::array<Point3, 3>& t, const ExactPoint2& p) {
  const std::array<Point2, 3> at{shadow(t[0], 0), shadow(t[1], 0), shadow(t[2], 0)};
  const Sign turn = orient2d(at[0], at[1], at[2]);
  if (turn == Sign::zero) return turn;
  for (std::size_t k = 0; k < 3; ++k)
    if (turn_with_moved(at[k], at[(k + 1) % 3], p) != turn) return Sign::zero;
  return turn;
}

}  // namespace

OutsideWinding::OutsideWinding(const FacePool& pool, const FacetList& list, const PointTable& table)
    : pool_(pool), list_(list), table_(table), bvh_(build_bvh(pool.mesh)) {}

WindingBeside OutsideWinding::beside(std::uint32_t facet) const {
  const auto& [a, b, c] = list_.facets[facet];
  const RationalPoint3 middle =
      middle_of({rational_point(table_.point(a)), rational_point(table_.point(b)), rational_point(table_.point(c))});
  const ExactPoint3 from(middle);
  const ExactPoint2 seen(RationalPoint2{middle.y, middle.z});
  const PlaneView& view = list_.planes[list_.plane_of[facet]];
  const auto [normal_x, normal_y, normal_z] = view.normal_signs();
  const Sign moved = normal_z != Sign::zero ? normal_z : normal_y != Sign::zero ? normal_y : Sign::positive;
  WindingBeside found{moved == Sign::positive, std::vector<std::int32_t>(pool_.meshes)};
  for (const std::uint32_t face : meeting(bvh_, box_around_line(approximate(from)))) {
    const std::array<Point3, 3> t = pool_.points_of(face);
    const Sign turn = passage(t, seen);
    if (turn == Sign::zero) continue;
    // Positive where the line still comes to the triangle.
    Sign ahead = orient3d(ExactPoint3(t[0]), ExactPoint3(t[1]), ExactPoint3(t[2]), from) * turn;
    if (ahead == Sign::zero) ahead = -(normal_x * moved);
    if (ahead != Sign::positive) continue;
    for (const FacetSource& use : pool_.uses_of(face))
      found.windings[use.face.mesh] += (turn == Sign::positive) != use.opposite ? 1 : -1;
  }
  return found;
}

}  // namespace plumb::surface
