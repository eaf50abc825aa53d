// Bounds rated on placements whose hulls' meeting is told by the hull of all differences; proxies that keep what they
// promise.
#include "plumb/figure/bound/choose_bound.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "figure/basic/rationals.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/bound/proxy.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;

/// Exact, for all products and sums are integers below 2^53.
Point3 image(const Pose& pose, const Point3& p) {
  const auto& [x, y, z] = pose.columns;
  return {x.x * p.x + y.x * p.y + z.x * p.z + pose.translation.x,
          x.y * p.x + y.y * p.y + z.y * p.z + pose.translation.y,
          x.z * p.x + y.z * p.y + z.z * p.z + pose.translation.z};
}

/// Do the hulls have a common point: is the origin one of the differences' hull?
bool meet(const BoundRatings& ratings, const RatedPlacement& placement) {
  std::vector<Point3> differences;
  for (const Point3& p : ratings.lattice) {
    for (const Point3& q : ratings.lattice) {
      const Point3 a = image(placement.a, p), b = image(placement.b, q);
      differences.push_back({a.x - b.x, a.y - b.y, a.z - b.z});
    }
  }
  const Hull3 hull = convex_hull(differences);
  EXPECT_EQ(hull.dimension, 3);
  return contains(convex_polyhedron(hull, differences), Point3{0, 0, 0});
}

std::vector<Point3> box_points(double x, double y, double z) {
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i) points.push_back({(i & 1) != 0 ? x : 0, (i & 2) != 0 ? y : 0, (i & 4) != 0 ? z : 0});
  return points;
}

TEST(ChooseBoundTest, HullsMeetAsTheirDifferencesSay) {
  int met = 0, apart = 0;
  for (std::uint64_t index = 0; index < 12; ++index) {
    SCOPED_TRACE(testing::Message() << "start 41 index " << index);
    Entropy entropy(41, index);
    const auto points =
        index == 0 ? box_points(3, 2, 1) : points3(any_family(entropy), Degeneracy::cospherical, 12, entropy);
    const BoundRatings ratings = rate_bounds(points, {.placements = 30});
    if (convex_hull(ratings.lattice).dimension < 2) continue;
    for (const RatedPlacement& p : ratings.placements) {
      EXPECT_EQ(p.hulls_meet, meet(ratings, p));
      ++(p.hulls_meet ? met : apart);
    }
    EXPECT_EQ(ratings.hulls_apart(),
              static_cast<std::uint32_t>(std::ranges::count(ratings.placements, false, &RatedPlacement::hulls_meet)));
  }
  EXPECT_GT(met, 20);
  EXPECT_GT(apart, 100);
}

// A rotation scaled by 1009, in integers: columns of one length, at right angles.
TEST(ChooseBoundTest, PlacementsAreExactSimilarities) {
  const BoundRatings ratings = rate_bounds(box_points(1, 2, 3), {.placements = 100});
  for (const RatedPlacement& p : ratings.placements) {
    for (const Pose& pose : {p.a, p.b}) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const auto& u = pose.columns[i];
          const auto& v = pose.columns[j];
          EXPECT_EQ(u.x * v.x + u.y * v.y + u.z * v.z, i == j ? 1009.0 * 1009.0 : 0);
        }
      }
    }
  }
  for (const Point3& p : ratings.lattice) EXPECT_EQ(p.x, std::round(p.x));
}

TEST(ChooseBoundTest, RatesAreThoseOfTheShapes) {
  const BoundRatings rod = rate_bounds(box_points(10, 1, 1), {.placements = 300});
  const auto of = [&](BoundKind kind) { return rod.kinds[static_cast<std::size_t>(kind)]; };
  EXPECT_EQ(of(BoundKind::sphere).overlapping, 300);  // as they are placed
  EXPECT_EQ(of(BoundKind::obb).false_overlaps, 0);    // the rod is that box: up to its rounding outward
  EXPECT_NEAR(of(BoundKind::obb).tightness, 1, 1e-6);
  EXPECT_EQ(of(BoundKind::aabb).tightness, 1);
  EXPECT_EQ(rod.hull_share, 1);
  EXPECT_GT(of(BoundKind::aabb).false_overlaps, of(BoundKind::k_dop_26).false_overlaps);
  EXPECT_GT(of(BoundKind::k_dop_26).false_overlaps, 0);
  EXPECT_LT(of(BoundKind::capsule).tightness, 3);
  EXPECT_GT(of(BoundKind::sphere).tightness, 30);
  for (const BoundRating& r : rod.kinds) {
    EXPECT_EQ(r.overlapping - r.false_overlaps, 300 - rod.hulls_apart());  // no bound misses what meets
    EXPECT_EQ(r.test_ns, 0);
  }
  const BoundRatings again = rate_bounds(box_points(10, 1, 1), {.placements = 300});
  for (std::size_t k = 0; k < bound_kinds.size(); ++k) EXPECT_EQ(again.kinds[k].overlapping, rod.kinds[k].overlapping);
}

TEST(ChooseBoundTest, CostDecides) {
  const auto rod = box_points(10, 1, 1);
  BoundCosts costs;
  costs.refined_ns = 0;
  EXPECT_EQ(choose_bound(rod, costs).kind, BoundKind::sphere);  // the cheapest test
  costs.refined_ns = 1e6;
  const BoundChoice choice = choose_bound(rod, costs);
  EXPECT_EQ(choice.kind, BoundKind::obb);
  ASSERT_TRUE(std::holds_alternative<Obb3>(choice.bound));
  for (const Point3& p : rod) EXPECT_TRUE(contains(std::get<Obb3>(choice.bound), p));
  for (std::size_t k = 0; k < bound_kinds.size(); ++k) {
    const double share = choice.ratings.kinds[k].overlapping / 200.0;
    EXPECT_EQ(choice.expected_ns[k], costs.test_ns[k] + share * costs.refined_ns);
    EXPECT_GE(choice.expected_ns[k], choice.expected_ns[static_cast<std::size_t>(choice.kind)]);
  }
  costs.test_ns.fill(1);
  costs.test_ns[static_cast<std::size_t>(BoundKind::k_dop_18)] = 0;
  costs.refined_ns = 0;
  EXPECT_EQ(choose_bound(rod, costs).kind, BoundKind::k_dop_18);
}

TEST(ChooseBoundTest, EveryKindContainsHardPoints) {
  for (std::uint64_t index = 0; index < 40; ++index) {
    SCOPED_TRACE(testing::Message() << "start 42 index " << index);
    Entropy entropy(42, index);
    const auto points = points3(any_family(entropy), degeneracies[index % 4], 10, entropy);
    const BoundRatings ratings = rate_bounds(points, {.placements = 5});
    for (const BoundRating& r : ratings.kinds)
      EXPECT_EQ(r.overlapping - r.false_overlaps, 5 - ratings.hulls_apart()) << name_of(r.kind);
    for (const BoundKind kind : bound_kinds) {
      // Boxes of least volume are tried hard by tests of their own.
      const std::span<const Point3> around = kind == BoundKind::obb ? ratings.lattice : points;
      try {
        const AnyBound bound = fit_bound(kind, around);
        for (const Point3& p : around)
          EXPECT_TRUE(std::visit([&](const auto& b) { return contains(b, p); }, bound)) << name_of(kind);
      } catch (const BeyondDoubles&) {
        EXPECT_NE(kind, BoundKind::aabb);
      }
    }
  }
}

TEST(ChooseBoundTest, OfOnePointAndOfAPlane) {
  const std::vector<Point3> one{{1, 2, 3}, {1, 2, 3}};
  const BoundChoice choice = choose_bound(one);
  EXPECT_TRUE(std::visit([&](const auto& b) { return contains(b, one[0]); }, choice.bound));
  EXPECT_EQ(choice.ratings.hull_share, 0);
  const BoundRatings flat = rate_bounds(box_points(2, 1, 0), {.placements = 50});
  EXPECT_EQ(flat.kinds[static_cast<std::size_t>(BoundKind::sphere)].tightness, std::numeric_limits<double>::infinity());
  EXPECT_EQ(flat.kinds[static_cast<std::size_t>(BoundKind::aabb)].tightness, 1);
}

TEST(ChooseBoundTest, BadInputIsNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point3> bad{{0, 0, 0}, {0, nan, 0}};
  EXPECT_THAT(text_of<NonFinite>([&] { choose_bound(bad); }), HasSubstr("choose_bound: points[1].y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([] { choose_bound({}); }), HasSubstr("no points"));
  BoundCosts costs;
  costs.test_ns[2] = -1;
  EXPECT_THAT(text_of<InvalidShape>([&] { choose_bound(box_points(1, 1, 1), costs); }),
              HasSubstr("costs.test_ns[2] is negative"));
  costs.refined_ns = nan;
  EXPECT_THAT(text_of<NonFinite>([&] { choose_bound(box_points(1, 1, 1), costs); }),
              HasSubstr("costs.refined_ns is nan"));
}

TriangleMesh mesh_of(std::vector<Point3> points) {
  TriangleMesh mesh{std::move(points), {}};
  for (std::uint32_t i = 0; i + 2 < mesh.vertices.size(); ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

TEST(ProxyTest, HullAndKDopHoldTheMesh) {
  for (std::uint64_t index = 0; index < 60; ++index) {
    SCOPED_TRACE(testing::Message() << "start 43 index " << index);
    Entropy entropy(43, index);
    const TriangleMesh mesh = mesh_of(points3(any_family(entropy), degeneracies[index % 4], 20, entropy));
    const HullProxy proxy = hull_proxy(mesh);
    EXPECT_EQ(proxy.hull, convex_hull(proxy.vertices));  // all of its vertices, in the same order
    if (proxy.hull.dimension == 3) {
      const ConvexPolyhedron3 polyhedron = convex_polyhedron(proxy.hull, proxy.vertices);
      for (const Point3& p : mesh.vertices) EXPECT_TRUE(contains(polyhedron, p));
    }
    try {
      const KDop3 k_dop = k_dop_proxy(mesh, 14);
      for (const Point3& p : mesh.vertices) EXPECT_TRUE(contains(k_dop, p));
    } catch (const BeyondDoubles&) {
    }
  }
}

TEST(ProxyTest, QuantizedCopiesMoveNoFartherThanTheySay) {
  int moved = 0, kept = 0, beyond = 0;
  for (std::uint64_t index = 0; index < 300; ++index) {
    Entropy entropy(44, index);
    const int bits = 1 + static_cast<int>(entropy.below(52));
    const Family family = any_family(entropy);
    const TriangleMesh mesh = mesh_of(points3(family, Degeneracy::coplanar, 9, entropy));
    SCOPED_TRACE(testing::Message() << "start 44 index " << index << " bits " << bits);
    QuantizedProxy proxy;
    try {
      proxy = quantized_proxy(mesh, bits);
    } catch (const BeyondDoubles&) {
      ++beyond;
      continue;
    }
    const auto shifted = [&](double x) {
      mpq_class q(x);
      if (proxy.exponent >= 0) {
        mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(proxy.exponent));
      } else {
        mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-proxy.exponent));
      }
      return q;
    };
    mpq_class largest = 0, widest = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const auto from = coordinates(mesh.vertices[i]), to = coordinates(proxy.mesh.vertices[i]);
      mpq_class squared = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const mpq_class at = shifted(to[axis]), off = abs(mpq_class(at - shifted(from[axis])));
        EXPECT_EQ(at.get_den(), 1);
        EXPECT_LE(off, mpq_class(1, 2));
        EXPECT_TRUE(off < mpq_class(1, 2) || abs(at) > abs(shifted(from[axis])));
        widest = std::max(widest, mpq_class(abs(at)));
        const mpq_class d = mpq_class(to[axis]) - mpq_class(from[axis]);
        squared += d * d;
      }
      largest = std::max(largest, squared);
    }
    mpq_class limit = 1;
    mpq_mul_2exp(limit.get_mpq_t(), limit.get_mpq_t(), static_cast<mp_bitcnt_t>(bits));
    EXPECT_LT(widest, limit);
    const mpq_class told(proxy.largest_displacement);
    EXPECT_GE(told * told, largest);
    if (largest == 0) {
      EXPECT_EQ(told, 0);
      ++kept;
    } else {
      const mpq_class below(std::nextafter(proxy.largest_displacement, 0.0));
      EXPECT_LT(below * below, largest);
      ++moved;
    }
    const QuantizedProxy again = quantized_proxy(proxy.mesh, bits);
    EXPECT_EQ(again.mesh.vertices, proxy.mesh.vertices);
    EXPECT_EQ(again.largest_displacement, 0);
  }
  EXPECT_GT(moved, 100);
  EXPECT_GT(kept, 20);
}

TEST(ProxyTest, CollapsedTrianglesAreCounted) {
  const QuantizedProxy proxy = quantized_proxy(mesh_of({{0, 0, 0}, {1, 0, 0}, {1.001, 0, 0}, {0, 7, 0}}), 3);
  EXPECT_EQ(proxy.exponent, 0);
  EXPECT_EQ(proxy.collapsed, 2);
  EXPECT_EQ(proxy.mesh.vertices[2], (Point3{1, 0, 0}));
}

TEST(ProxyTest, BadInputIsNamed) {
  EXPECT_THAT(text_of<InvalidShape>([] { hull_proxy({}); }), HasSubstr("hull_proxy: the mesh has no vertices"));
  EXPECT_THAT(text_of<InvalidShape>([] { quantized_proxy(mesh_of(box_points(1, 1, 1)), 0); }),
              HasSubstr("from 1 to 52"));
  TriangleMesh mesh = mesh_of(box_points(1, 1, 1));
  mesh.triangles[1][2] = 8;
  EXPECT_THAT(text_of<InvalidShape>([&] { quantized_proxy(mesh); }), HasSubstr("triangle 1 names vertex 8 of 8"));
  mesh.vertices[3].z = std::numeric_limits<double>::infinity();
  EXPECT_THAT(text_of<NonFinite>([&] { k_dop_proxy(mesh); }), HasSubstr("k_dop_proxy: vertices[3].z is inf"));
}

}  // namespace
}  // namespace plumb
