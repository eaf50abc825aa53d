// Are hulls in space right, for whatever points?  Against brute force over rationals, CGAL, and their own proof.
#include "plumb/figure/hull/hull3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <set>

#include "certify/sanitized.hpp"
#include "degenerate/rational_signs.hpp"
#include "figure/basic/thrown.hpp"
#include "oracle/cgal_hulls.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/moves.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/hull/verify_hull.hpp"

namespace plumb {
namespace {

using Indices = std::vector<std::uint32_t>;
using Points = std::vector<Point3>;

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t rounds = 100;
#else
constexpr std::uint64_t rounds = 1;
#endif

/// Every way of asking gives the same, and is proved.
Hull3 hull_of(const Points& points, bool all = false) {
  Hull3 first;
  for (const bool triangulate : {false, true}) {
    HullOptions options{.triangulate = triangulate, .all_boundary_points = all};
    const Hull3 hull = convex_hull(points, options);
    const HullVerdict verdict = verify_hull(hull, points, options);
    EXPECT_TRUE(verdict) << verdict.flaw << (triangulate ? ", triangulated" : "") << (all ? ", all points" : "");
    options.method = HullMethod::incremental;
    EXPECT_EQ(convex_hull(points, options), hull) << "incremental" << (all ? ", all points" : "");
    if (!triangulate) first = hull;
  }
  return first;
}

/// The same hull in coordinates: faces as sets of corners.
std::multiset<std::set<std::array<double, 3>>> shape_of(const Hull3& hull, const Points& points) {
  std::multiset<std::set<std::array<double, 3>>> faces;
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    std::set<std::array<double, 3>> face;
    for (const auto c : hull.face(f)) face.insert({points[c].x + 0.0, points[c].y + 0.0, points[c].z + 0.0});
    faces.insert(face);
  }
  return faces;
}

/// By definition, from the rational signs of all quadruples: planes that have no point on one side.
struct ByDefinition {
  std::set<std::set<std::uint32_t>> facets;  // all points of each, by their smallest index
  std::set<std::uint32_t> extreme, boundary;

  explicit ByDefinition(const Points& points) {
    Indices distinct;
    std::vector<double> c;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      c.insert(c.end(), {points[i].x, points[i].y, points[i].z});
      if (std::ranges::none_of(distinct, [&](auto j) { return points[j] == points[i]; })) distinct.push_back(i);
    }
    const std::size_t n = distinct.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        for (std::size_t k = j + 1; k < n; ++k) {
          std::set<std::uint32_t> on;
          std::set<int> sides;
          for (const std::uint32_t q : distinct) {
            const std::size_t which[] = {distinct[i], distinct[j], distinct[k], q};
            const bool corner = q == distinct[i] || q == distinct[j] || q == distinct[k];
            const int s = corner ? 0 : plumb_test::sign_of_flat(c, 3, which);
            s == 0 ? static_cast<void>(on.insert(q)) : static_cast<void>(sides.insert(s));
          }
          if (sides.size() == 1) facets.insert(on);
        }
      }
    }
    for (const auto& facet : facets) boundary.insert(facet.begin(), facet.end());
    for (const std::uint32_t v : boundary) {
      std::set<std::uint32_t> shared = boundary;
      for (const auto& facet : facets) {
        if (!facet.contains(v)) continue;
        std::erase_if(shared, [&](auto q) { return !facet.contains(q); });
      }
      if (shared.size() == 1) extreme.insert(v);
    }
  }

  /// The points of a facet that a polygon has for corners: where another facet is met; all: also within edges.
  std::set<std::set<std::uint32_t>> polygons(bool all) const {
    std::set<std::set<std::uint32_t>> made;
    for (const auto& facet : facets) {
      std::set<std::uint32_t> polygon;
      for (const std::uint32_t v : facet) {
        const auto meet = std::ranges::count_if(facets, [&](const auto& f) { return f.contains(v); });
        if (all ? meet >= 2 : extreme.contains(v)) polygon.insert(v);
      }
      made.insert(polygon);
    }
    return made;
  }
};

std::set<std::set<std::uint32_t>> polygons_of(const Hull3& hull) {
  std::set<std::set<std::uint32_t>> made;
  for (std::size_t f = 0; f < hull.face_count(); ++f) made.insert({hull.face(f).begin(), hull.face(f).end()});
  return made;
}

TEST(Hull3, IsThatOfTheDefinition) {
  std::map<int, int> dimensions;
  int with_polygons = 0, with_points_on_facets = 0;
  for (const FamilyInfo& family : families) {
    for (const Degeneracy degeneracy : degeneracies) {
      for (std::uint64_t i = 0; i < 6 * rounds; ++i) {
        Entropy entropy(41, i);
        const Points points = points3(family.family, degeneracy, 4 + entropy.below(8), entropy);
        SCOPED_TRACE(testing::Message() << family.name << ' ' << name_of(degeneracy) << ", start 41, index " << i);
        const Hull3 hull = hull_of(points), rim = hull_of(points, true);
        ++dimensions[hull.dimension];
        EXPECT_EQ(hull.dimension, rim.dimension);
        const ByDefinition truth(points);
        ASSERT_EQ(hull.dimension == 3, !truth.facets.empty());
        if (hull.dimension < 3) continue;
        EXPECT_EQ(hull.vertices, Indices(truth.extreme.begin(), truth.extreme.end()));
        EXPECT_EQ(rim.vertices, Indices(truth.boundary.begin(), truth.boundary.end()));
        EXPECT_EQ(polygons_of(hull), truth.polygons(false));
        EXPECT_EQ(polygons_of(rim), truth.polygons(true));
        with_polygons += hull.corners.size() > 3 * hull.face_count() ? 1 : 0;
        with_points_on_facets += rim.vertices != hull.vertices ? 1 : 0;
      }
    }
  }
  for (const int d : {1, 2}) EXPECT_GE(dimensions[d], 1) << d;
  EXPECT_GE(dimensions[3], 100);
  EXPECT_GE(with_polygons, 10);
  EXPECT_GE(with_points_on_facets, 5);
}

// A small lattice is the most degenerate of all: every plane and line holds several points.
TEST(Hull3, IsThatOfTheDefinitionOnSmallLattices) {
  for (std::uint64_t i = 0; i < 60 * rounds; ++i) {
    Entropy entropy(42, i);
    Points points(4 + entropy.below(11));
    const auto side = static_cast<std::int64_t>(1 + entropy.below(2));
    for (Point3& p : points) {
      const auto coordinate = [&] { return static_cast<double>(entropy.within(side)); };
      p = {coordinate(), coordinate(), coordinate()};
    }
    SCOPED_TRACE(testing::Message() << "start 42, index " << i);
    const Hull3 hull = hull_of(points), rim = hull_of(points, true);
    const ByDefinition truth(points);
    if (hull.dimension < 3) continue;
    EXPECT_EQ(hull.vertices, Indices(truth.extreme.begin(), truth.extreme.end()));
    EXPECT_EQ(rim.vertices, Indices(truth.boundary.begin(), truth.boundary.end()));
    EXPECT_EQ(polygons_of(hull), truth.polygons(false));
    EXPECT_EQ(polygons_of(rim), truth.polygons(true));
  }
}

TEST(Hull3, HasTheVerticesThatCgalFinds) {
  for (const CloudInfo& cloud : clouds) {
    for (std::uint64_t i = 0; i < 3 * rounds; ++i) {
      Entropy entropy(43, i);
      const Points points = cloud3(cloud.cloud, 30 + entropy.below(600), entropy);
      SCOPED_TRACE(testing::Message() << cloud.name << ", start 43, index " << i);
      const Hull3 hull = hull_of(points);
      hull_of(points, true);
      if (hull.dimension < 3) continue;
      EXPECT_EQ(hull.vertices, oracle::hull_vertices(points));
    }
  }
}

TEST(Hull3, DoesNotDependOnOrderOrScale) {
  for (const CloudInfo& cloud : clouds) {
    Entropy entropy(44, static_cast<std::uint64_t>(cloud.cloud));
    const Points points = cloud3(cloud.cloud, 200, entropy);
    SCOPED_TRACE(cloud.name);
    for (const bool all : {false, true}) {
      const Hull3 hull = hull_of(points, all);
      Points shuffled = points;
      permute_points({&shuffled[0].x, 3 * shuffled.size()}, 3, entropy);
      EXPECT_EQ(shape_of(hull_of(shuffled, all), shuffled), shape_of(hull, points));
      Points scaled = points;
      for (Point3& p : scaled) p = {p.x * 0x1p20, p.y * 0x1p-30, p.z * 0x1p300};
      const Hull3 same = hull_of(scaled, all);
      EXPECT_EQ(same.vertices, hull.vertices);
      EXPECT_EQ(same.corners, hull.corners);
      EXPECT_EQ(same.first, hull.first);
      Points turned = points;
      for (Point3& p : turned) p = {p.y, p.z, p.x};
      EXPECT_EQ(hull_of(turned, all).vertices, hull.vertices);
      Points mirrored = points;
      for (Point3& p : mirrored) p = {-p.x, p.y, p.z};
      EXPECT_EQ(hull_of(mirrored, all).vertices, hull.vertices);
    }
  }
}

TEST(Hull3, OfHardlyAnything) {
  EXPECT_EQ(hull_of({}), (Hull3{}));
  EXPECT_EQ(hull_of({{1, 2, 3}}), (Hull3{0, {0}, {}, {0}}));
  EXPECT_EQ(hull_of({{0.0, 0, 0}, {-0.0, 0, -0.0}, {0, 0, 0}}), (Hull3{0, {0}, {}, {0}}));
  EXPECT_EQ(hull_of({{1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {1, 1, 1}, {3, 3, 3}}), (Hull3{1, {0, 1}, {}, {0}}));
  EXPECT_EQ(hull_of({{1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {1, 1, 1}}, true), (Hull3{1, {0, 1, 2}, {}, {0}}));
  EXPECT_EQ(hull_of({{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}, {1, 0, 5}, {1, 1, 5}}),
            (Hull3{2, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 4}}));
  EXPECT_EQ(hull_of({{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}, {1, 0, 5}, {1, 1, 5}}, true),
            (Hull3{2, {0, 1, 2, 3, 4, 5}, {0, 4, 1, 2, 3}, {0, 5}}));
  // Seen as coplanar_orientation does: of constant y, from the front.
  EXPECT_EQ(hull_of({{0, 7, 0}, {1, 7, 0}, {0, 7, 1}}).corners, (Indices{0, 1, 2}));
  const Points corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(hull_of(corner), (Hull3{3, {0, 1, 2, 3}, {0, 1, 3, 0, 2, 1, 0, 3, 2, 1, 2, 3}, {0, 3, 6, 9, 12}}));
}

TEST(Hull3, NamesTheSmallestOfEqualPoints) {
  for (std::uint64_t i = 0; i < 40 * rounds; ++i) {
    Entropy entropy(45, i);
    Points points = cloud3(Cloud::lattice, 64, entropy);
    const Points once = points;
    points.insert(points.end(), once.begin(), once.end());
    permute_points({&points[0].x, 3 * points.size()}, 3, entropy);
    SCOPED_TRACE(testing::Message() << "start 45, index " << i);
    for (const bool all : {false, true}) {
      for (const std::uint32_t v : hull_of(points, all).vertices) {
        EXPECT_EQ(std::ranges::find(points, points[v]) - points.begin(), v);
      }
    }
  }
}

// A plane that 2^-1074 is above, and coordinates whose differences are no doubles.
TEST(Hull3, ReachesTheEndsOfTheDoubles) {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, least}, {0.25, 0.25, 0}}).vertices,
            (Indices{0, 1, 2, 3}));
  EXPECT_EQ(hull_of({{-most, 0, 0},
                     {most, 0, 0},
                     {0, -most, 0},
                     {0, most, 0},
                     {0, 0, -most},
                     {0, 0, most},
                     {least, least, least},
                     {most / 2, most / 2, 0},
                     {most / 2, most / 2, 1}})
                .vertices,
            (Indices{0, 1, 2, 3, 4, 5, 8}));
}

TEST(Hull3, OfLargeSets) {
#ifdef PLUMB_LONG_TESTS
  constexpr std::size_t count = 1'000'000;
#else
  constexpr std::size_t count = 34'000;  // enough to leave out what is inside first
#endif
  for (const CloudInfo& cloud : clouds) {
    if (cloud.cloud == Cloud::moments) continue;  // integers up to t^3
    Entropy entropy(46, static_cast<std::uint64_t>(cloud.cloud));
    const bool mostly_vertices =
        cloud.cloud == Cloud::sphere || cloud.cloud == Cloud::exact_sphere || cloud.cloud == Cloud::prism;
    const std::size_t most = cloud.cloud == Cloud::ball ? count : battery::fitting(count);
    const Points points = cloud3(cloud.cloud, mostly_vertices ? most / 8 : most, entropy);
    SCOPED_TRACE(cloud.name);
    const Hull3 hull = convex_hull(points);
    const HullVerdict verdict = verify_hull(hull, points);
    EXPECT_TRUE(verdict) << verdict.flaw;
    if (cloud.cloud == Cloud::facets) {
      const HullOptions all{.triangulate = true, .all_boundary_points = true};
      const HullVerdict of_all = verify_hull(convex_hull(points, all), points, all);
      EXPECT_TRUE(of_all) << of_all.flaw;
    }
  }
}

TEST(Hull3, OfALatticeHasEightVertices) {
  const std::size_t side = battery::sanitized ? 20 : 40;
  Points points;
  for (std::size_t i = 0; i < side * side * side; ++i) {
    points.push_back(
        {static_cast<double>(i % side), static_cast<double>(i / side % side), static_cast<double>(i / (side * side))});
  }
  const Hull3 hull = convex_hull(points), rim = convex_hull(points, {.all_boundary_points = true});
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(hull.face_count(), 6u);
  EXPECT_EQ(rim.vertices.size(), side * side * side - (side - 2) * (side - 2) * (side - 2));
  EXPECT_EQ(rim.corners.size(), 6 * 4 * (side - 1));
  EXPECT_TRUE(verify_hull(hull, points));
  EXPECT_TRUE(verify_hull(rim, points, {.all_boundary_points = true}));
}

TEST(Hull3, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto text = [](const Points& points) { return text_of<NonFinite>([&] { convex_hull(points); }); };
  EXPECT_TRUE(text({{0, 0, 0}, {1, nan, 0}}).starts_with("convex_hull: points[1].y is nan"));
  EXPECT_TRUE(text({{0, 0, -inf}}).starts_with("convex_hull: points[0].z is -inf"));
  EXPECT_THROW(verify_hull({}, Points{{nan, 0, 0}}), NonFinite);
  EXPECT_THROW(extreme_points(Points{{0, 0, 0}}, {0, 0, inf}), NonFinite);
}

TEST(Hull3, AsAPolyhedron) {
  Entropy entropy(47, 0);
  const Points points = cloud3(Cloud::facets, 100, entropy);
  const Hull3 hull = convex_hull(points);
  const ConvexPolyhedron3 cube = convex_polyhedron(hull, points);
  EXPECT_EQ(cube.mesh.vertices.size(), hull.vertices.size());
  EXPECT_EQ(cube.mesh.first, hull.first);
  for (const Point3& p : points) EXPECT_EQ(locate(cube, p), Location::boundary);
  const Hull3 flat = convex_hull(cloud3(Cloud::plane, 10, entropy));
  EXPECT_THROW(convex_polyhedron(flat, points), InvalidShape);
}

TEST(Hull3Builder, HasTheHullOfThePointsSoFar) {
  int outside = 0, inside = 0;
  const auto insert_all = [&](const Points& points) {
    Hull3Builder builder;
    EXPECT_EQ(builder.hull(), Hull3{});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool grew = builder.insert(points[i]);
      const Points so_far(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i + 1));
      ASSERT_EQ(builder.points().size(), i + 1);
      for (const bool all : {false, true}) {
        const HullOptions options{.triangulate = i % 2 == 0, .all_boundary_points = all};
        ASSERT_EQ(builder.hull(options), convex_hull(so_far, options)) << i;
      }
      const Hull3 hull = builder.hull();
      ASSERT_EQ(builder.dimension(), hull.dimension);
      ASSERT_EQ(grew, std::ranges::binary_search(hull.vertices, i));
      ++(grew ? outside : inside);
    }
  };
  for (const CloudInfo& cloud : clouds) {
    Entropy entropy(49, static_cast<std::uint64_t>(cloud.cloud));
    SCOPED_TRACE(cloud.name);
    insert_all(cloud3(cloud.cloud, 80, entropy));
  }
  for (std::uint64_t i = 0; i < 100 * rounds; ++i) {
    Entropy entropy(50, i);
    SCOPED_TRACE(testing::Message() << "start 50, index " << i);
    const Family family = any_family(entropy);
    insert_all(points3(family, degeneracies[entropy.below(4)], 5 + entropy.below(10), entropy));
  }
  EXPECT_GE(outside, 500);
  EXPECT_GE(inside, 500);
  Hull3Builder builder;
  EXPECT_THROW(builder.insert({0, 0, std::numeric_limits<double>::quiet_NaN()}), NonFinite);
  EXPECT_EQ(builder.dimension(), -1);
}

TEST(ExtremePoints, AreAllThatTie) {
  const Points cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(extreme_points(cube, {1, 1, 1}), (Indices{7, 8}));
  EXPECT_EQ(extreme_points(cube, {0, 0, -3}), (Indices{0, 1, 2, 3}));
  EXPECT_EQ(extreme_points(cube, {1, 1, 0}), (Indices{3, 7, 8}));
  EXPECT_EQ(extreme_points(cube, {0, 0, 0}).size(), 9u);
  EXPECT_TRUE(extreme_points({}, {1, 0, 0}).empty());
  // An extreme point of any direction is on the boundary, and all of a vertex's index are vertices where one is alone.
  for (std::uint64_t i = 0; i < 50 * rounds; ++i) {
    Entropy entropy(48, i);
    const Points points = points3(any_family(entropy), Degeneracy::coplanar, 10, entropy);
    const Point3 d = points3(Family::mixture, Degeneracy::coplanar, 1, entropy)[0];
    const Indices farthest = extreme_points(points, {d.x, d.y, d.z});
    const Hull3 rim = convex_hull(points, {.all_boundary_points = true});
    const std::set<std::array<double, 3>> boundary = [&] {
      std::set<std::array<double, 3>> all;
      for (const auto v : rim.vertices) all.insert({points[v].x + 0.0, points[v].y + 0.0, points[v].z + 0.0});
      return all;
    }();
    if (d == Point3{}) continue;
    for (const auto v : farthest) {
      EXPECT_TRUE(boundary.contains({points[v].x + 0.0, points[v].y + 0.0, points[v].z + 0.0}))
          << "start 48, index " << i;
    }
  }
}

}  // namespace
}  // namespace plumb
