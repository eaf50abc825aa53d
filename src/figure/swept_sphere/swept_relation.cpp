#include <algorithm>

#include "arith/rational_lp.hpp"
#include "certify/carried_errors.hpp"
#include "figure/basic/in_space.hpp"
#include "figure/support/quick_gap.hpp"
#include "figure/swept_sphere/core_distance.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

namespace plumb {
namespace {

// The distance of the cores against the sum of the radii, over numbers of type T.
template <class T, class Shape>
Sign sign_of_gap(const Shape& a, const Shape& b, CertainSigns& ask) {
  const T reach = T(a.radius) + T(b.radius), square = reach * reach;
  Sign least = Sign::positive;
  figure::swept::visit_distances(figure::swept::core_of<T>(a), figure::swept::core_of<T>(b), ask,
                                 [&](const T& numerator, const T& denominator) {
                                   least = std::min(least, ask(numerator - square * denominator));
                                 });
  return least;
}

// Do the relative interiors of two cores meet?  They are the images of open intervals and squares.
template <class Shape>
bool interiors_meet(const Shape& a, const Shape& b) {
  const auto directions = [](const Shape& s) {
    if constexpr (std::is_same_v<Shape, Capsule3>) {
      const auto of = [](const Point3& p) { return arith::RationalVector{p.x, p.y, p.z}; };
      arith::RationalVector from = of(s.a), along = of(s.b);
      for (std::size_t i = 0; i < 3; ++i) along[i] -= from[i];
      return std::vector{from, along};
    } else {
      const auto of = [](const auto& p) { return arith::RationalVector{p.x, p.y, p.z}; };
      return std::vector{of(s.corner), of(s.edges[0]), of(s.edges[1])};
    }
  };
  const auto of_a = directions(a), of_b = directions(b);
  const std::size_t n = of_a.size() - 1, variables = 2 * n;
  arith::Constraints all;
  std::vector<bool> strictly;
  const auto add = [&](arith::RationalVector row, mpq_class limit, bool strict) {
    all.add(std::move(row), std::move(limit));
    strictly.push_back(strict);
  };
  for (std::size_t v = 0; v < variables; ++v) {
    arith::RationalVector row(variables);
    row[v] = 1;
    add(row, 1, true);
    row[v] = -1;
    add(row, 0, true);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    arith::RationalVector row(variables);
    for (std::size_t v = 0; v < n; ++v) row[v] = of_a[v + 1][axis], row[n + v] = -of_b[v + 1][axis];
    const mpq_class apart = of_b[0][axis] - of_a[0][axis];
    add(row, apart, false);
    for (mpq_class& x : row) x = -x;
    add(std::move(row), -apart, false);
  }
  return arith::feasible(all, strictly).slack > 0;
}

template <class Shape>
Relation relation(std::string_view function, const Shape& a, const Shape& b) {
  figure::require_sound(function, "a", a);
  figure::require_sound(function, "b", b);
  const Sign gap =
      certainly<SignWorlds<Interval, BigDyadic>>([&]<class T>(Carrying<T>& ask) { return sign_of_gap<T>(a, b, ask); });
  if (gap != Sign::zero) return static_cast<Relation>(-gap);
  return a.radius == 0 && b.radius == 0 && interiors_meet(a, b) ? Relation::overlapping : Relation::touching;
}

using figure::swept::quick_gap;

template <class Shape>
Relation quick_relation(std::string_view function, const Shape& a, const Shape& b) {
  if (const auto gap = quick_gap(a, b)) [[likely]]
    return static_cast<Relation>(-*gap);
  return relation(function, a, b);
}

}  // namespace

Relation relate(const Capsule2& a, const Capsule2& b) { return relate(in_space(a), in_space(b)); }
Relation relate(const Capsule3& a, const Capsule3& b) { return quick_relation("relate", a, b); }
Relation relate(const Lozenge3& a, const Lozenge3& b) { return quick_relation("relate", a, b); }
bool intersects(const Capsule2& a, const Capsule2& b) { return intersects(in_space(a), in_space(b)); }
bool intersects(const Capsule3& a, const Capsule3& b) {
  return quick_relation("intersects", a, b) != Relation::disjoint;
}
bool intersects(const Lozenge3& a, const Lozenge3& b) {
  return quick_relation("intersects", a, b) != Relation::disjoint;
}

}  // namespace plumb
