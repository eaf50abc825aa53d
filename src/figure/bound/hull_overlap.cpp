#include "figure/bound/hull_overlap.hpp"

#include <algorithm>
#include <array>

#include "arith/rational_lp.hpp"
#include "figure/support/gjk_simplex.hpp"
#include "plumb/figure/support/support.hpp"
#include "plumb/predicates.hpp"

namespace plumb::figure {
namespace {

namespace f = predicates;
using figure::gjk::Plain;

/// A point of each hull.
struct HullPair {
  Point3 a, b;
  friend bool operator==(const HullPair&, const HullPair&) = default;
};
using Simplex = figure::gjk::Simplex<HullPair>;

Simplex::Corner corner(const Point3& a, const Point3& b) {
  return {{a, b}, arith::vec<double>(a) - arith::vec<double>(b)};
}

Point3 farthest(std::span<const Point3> points, const Plain& along, double sign) {
  const Point3* best = points.data();
  double most = -std::numeric_limits<double>::infinity();
  for (const Point3& p : points) {
    const double reach = sign * arith::dot(arith::vec<double>(p), along);
    if (reach > most) {
      most = reach;
      best = &p;
    }
  }
  return *best;
}

/// Do all points of a lie strictly farther along the direction than all of b?
bool proves_apart(std::span<const Point3> a, std::span<const Point3> b, const Plain& along) {
  if (!(arith::dot(along, along) < std::numeric_limits<double>::infinity())) return false;
  const Vector3 direction{along.x, along.y, along.z}, back{-along.x, -along.y, -along.z};
  return compare_along_direction(support_point(a, back).point, support_point(b, direction).point, direction) ==
         Sign::positive;
}

/// Of three differences given by their ends.
struct TripleOfDifferences {
  static constexpr std::string_view name = "hulls_meet";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    return f::triple(f::difference(p, 0, 1), f::difference(p, 2, 3), f::difference(p, 4, 5));
  }
};

/// Is the origin strictly inside of the tetrahedron of the exact differences?
bool proves_meeting(const std::array<HullPair, 4>& s) {
  return figure::gjk::is_around_origin([&](std::size_t i, std::size_t j, std::size_t k) {
    return sign_of(TripleOfDifferences{}, s[i].a, s[i].b, s[j].a, s[j].b, s[k].a, s[k].b);
  });
}

bool meet_by_rationals(std::span<const Point3> a, std::span<const Point3> b) {
  arith::Constraints apart;  // direction . x - offset >= 1 on one side, <= -1 on the other
  const auto add = [&](std::span<const Point3> points, int side) {
    for (const Point3& p : points)
      apart.add({mpq_class(side * mpq_class(p.x)), mpq_class(side * mpq_class(p.y)), mpq_class(side * mpq_class(p.z)),
                 mpq_class(-side)},
                mpq_class(-1));
  };
  add(a, -1);
  add(b, 1);
  return arith::feasible(apart, std::vector<bool>(apart.rows.size(), false)).slack < 0;
}

}  // namespace

bool hulls_meet(std::span<const Point3> a, std::span<const Point3> b) {
  Simplex simplex(corner(a[0], b[0]));
  constexpr int most_steps = 64;  // a guess: the rest is left to what is asked then
  for (int step = 0; step < most_steps; ++step) {
    const Plain at = simplex.nearest();
    const Simplex::Corner next = corner(farthest(a, at, -1), farthest(b, at, 1));
    if (arith::dot(next.at, at) > 0 && proves_apart(a, b, at)) return false;
    const auto& c = simplex.corners();
    if (std::ranges::find(c, next.ends, &Simplex::Corner::ends) != c.end()) break;
    if (c.size() == 3 && proves_meeting({c[0].ends, c[1].ends, c[2].ends, next.ends})) return true;
    simplex.add(next);
    if (simplex.is_full()) break;
  }
  return meet_by_rationals(a, b);
}

}  // namespace plumb::figure
