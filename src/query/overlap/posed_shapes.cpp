#include <algorithm>

#include "arith/exact_number.hpp"
#include "arith/rational_lp.hpp"
#include "certify/carried_errors.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/closest/posed_triangle.hpp"
#include "query/overlap/posed_triangles.hpp"

namespace plumb::query {
namespace {

/// Zero also where it is not certain.
int sure_sign(const Approximate& x) { return static_cast<int>(CertainSigns()(x)); }

/// center + sum of numbers from -1 to 1 times these.
struct PosedBox {
  Vec3<Approximate> center;
  std::array<Vec3<Approximate>, 3> half;
};

PosedBox box_of(const Aabb3& b) {
  const Approximate zero(0.0), half(0.5);
  const Vec3<Approximate> low = vector_of<Approximate>(b.min), high = vector_of<Approximate>(b.max),
                          width = (high - low) * half;
  return {(low + high) * half, {{{width.x, zero, zero}, {zero, width.y, zero}, {zero, zero, width.z}}}};
}
PosedBox box_of(const Obb3& b) {
  return {vector_of<Approximate>(b.center),
          {vector_of<Approximate>(b.axes[0]) * Approximate(b.half.x),
           vector_of<Approximate>(b.axes[1]) * Approximate(b.half.y),
           vector_of<Approximate>(b.axes[2]) * Approximate(b.half.z)}};
}

/// What can separate a box with an inside from a triangle: normals of both, and what is across an edge of each.
class SeparatingWays {
 public:
  SeparatingWays(const std::array<Vec3<Approximate>, 3>& corner, const PosedBox& box)
      : to_{corner[0] - box.center, corner[1] - box.center, corner[2] - box.center}, box_(box) {
    const std::array edges{corner[1] - corner[0], corner[2] - corner[1], corner[0] - corner[2]};
    const auto& u = box.half;
    see(cross(edges[0], edges[1]));
    for (std::size_t k = 0; k < 3; ++k) {
      see(cross(u[k], u[(k + 1) % 3]));
      for (const Vec3<Approximate>& e : edges) see(cross(u[k], e));
    }
  }
  [[nodiscard]] bool certainly_apart() const { return apart_; }
  [[nodiscard]] bool certainly_together() const { return together_; }

 private:
  void see(const Vec3<Approximate>& way) {
    const auto& u = box_.half;
    const Approximate reach = magnitude(dot(way, u[0])) + magnitude(dot(way, u[1])) + magnitude(dot(way, u[2]));
    int beyond = 0, before = 0, below_end = 0, above_start = 0;
    for (const Vec3<Approximate>& to : to_) {
      const Approximate at = dot(way, to);
      const int end = sure_sign(at - reach), start = sure_sign(at + reach);
      beyond += end > 0 ? 1 : 0, below_end += end < 0 ? 1 : 0;
      before += start < 0 ? 1 : 0, above_start += start > 0 ? 1 : 0;
    }
    apart_ = apart_ || beyond == 3 || before == 3;
    together_ = together_ && below_end != 0 && above_start != 0;
  }

  std::array<Vec3<Approximate>, 3> to_;
  const PosedBox& box_;
  bool apart_ = false, together_ = true;
};

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

template <class Box>
bool meets_box(const PosedTriangle3& t, const Box& b) {
  const WeightedCorners<Approximate> corners(t);
  PosedBox box = box_of(b);
  box.center = corners.beside(box.center);
  for (Vec3<Approximate>& half : box.half) half = corners.beside(half);
  const SeparatingWays ways(corners.at, box);
  if (ways.certainly_apart()) return false;
  return ways.certainly_together() || relate_posed("intersects", posed_view(t), posed_view(b)) != Relation::disjoint;
}

/// normal . corner - offset, times the weight.
template <class T>
T excess_over(const Halfspace3& h, const WeightedCorners<T>& corners, std::size_t i) {
  return dot(vector_of<T>(h.normal), corners.at[i]) - corners.beside(T(h.offset));
}

}  // namespace

bool intersects(const PosedTriangle3& triangle, const Aabb3& box) { return !is_empty(box) && meets_box(triangle, box); }
bool intersects(const PosedTriangle3& triangle, const Obb3& box) { return meets_box(triangle, box); }

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
      const int s = sure_sign(excess_over(h, corners, i));
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
