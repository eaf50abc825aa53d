#include <algorithm>

#include "arith/exact_number.hpp"
#include "arith/rational_lp.hpp"
#include "certify/carried_errors.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/closest/posed_triangle.hpp"
#include "query/overlap/posed_triangles.hpp"

namespace plumb::query {
namespace {

using RationalCorners = std::array<std::array<mpq_class, 3>, 3>;

RationalCorners rational_corners(const PosedTriangle3& t) {
  RationalCorners corners;
  const WeightedCorners<BigDyadic> exact(t);
  const mpq_class weight = gmp_number(exact.by.weight);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [x, y, z] = exact.at[i];
    corners[i] = {gmp_number(x) / weight, gmp_number(y) / weight, gmp_number(z) / weight};
  }
  return corners;
}

/// Unknowns: the weights of the corners.
arith::Constraints weights_of_corners() {
  arith::Constraints all;
  for (std::size_t i = 0; i < 3; ++i) {
    arith::RationalVector row(3);
    row[i] = -1;
    all.add(row, 0);
  }
  all.add({1, 1, 1}, 1);
  all.add({-1, -1, -1}, -1);
  return all;
}

/// Asks the search, and what is exact where that leaves it open.
bool meets(const PosedTriangle3& triangle, const FigureView& box) {
  return relate_posed("intersects", posed_view(triangle), {box}) != Relation::disjoint;
}

/// normal . corner - offset, times the weight.
template <class T>
T excess_over(const Halfspace3& h, const WeightedCorners<T>& corners, std::size_t i) {
  return dot(vector_of<T>(h.normal), corners.at[i]) - corners.beside(T(h.offset));
}

}  // namespace

bool intersects(const PosedTriangle3& triangle, const Aabb3& box) { return meets(triangle, view_of(box)); }
bool intersects(const PosedTriangle3& triangle, const Obb3& box) { return meets(triangle, view_of(box)); }

bool intersects(const PosedTriangle3& triangle, const Sphere3& ball) {
  return compare_distance(triangle, ball.center, ball.radius) != Sign::positive;
}
bool intersects(const PosedTriangle3& triangle, const Capsule3& capsule) {
  const PosedTriangle3 axis = standing(Segment3{capsule.a, capsule.b});
  return compare_distance(triangle, axis, capsule.radius) != Sign::positive;
}
bool intersects(const PosedTriangle3& triangle, const Segment3& segment) {
  return relate(triangle, standing(segment)) != Relation::disjoint;
}

bool intersects(const PosedTriangle3& triangle, const Halfspace3& halfspace) {
  return certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) {
    const WeightedCorners<T> corners(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      const T excess = excess_over(halfspace, corners, i);
      CertainSigns alone;
      if (alone(excess) != Sign::positive && alone.certain()) return true;
      if (!alone.certain()) (void)ask(excess);
    }
    return false;
  });
}

bool intersects(const PosedTriangle3& triangle, const HalfspaceIntersection3& region) {
  const WeightedCorners<Approximate> corners(triangle);
  std::array<bool, 3> inside{true, true, true};
  for (const Halfspace3& h : region.halfspaces) {
    int out = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int s = excess_over(h, corners, i).certain_sign();
      inside[i] = inside[i] && s < 0;
      out += s > 0 ? 1 : 0;
    }
    if (out == 3) return false;
  }
  if (std::ranges::any_of(inside, [](bool is) { return is; })) return true;
  const RationalCorners exact = rational_corners(triangle);
  arith::Constraints all = weights_of_corners();
  for (const Halfspace3& h : region.halfspaces) {
    arith::RationalVector row(3);
    for (std::size_t i = 0; i < 3; ++i) {
      row[i] = mpq_class(h.normal.x) * exact[i][0] + mpq_class(h.normal.y) * exact[i][1] +
               mpq_class(h.normal.z) * exact[i][2];
    }
    all.add(row, mpq_class(h.offset));
  }
  return arith::feasible(all, std::vector<bool>(all.rows.size())).slack >= 0;
}

}  // namespace plumb::query
