// Dobkin-Kirkpatrick hierarchy: what it is made of, by definition; extreme vertices and distances as without it.
#include "plumb/query/polytope_hierarchy/polytope_hierarchy.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/polytope_hierarchy/polyhedra.hpp"

namespace plumb {
namespace {

using hierarchy_cases::NamedPolyhedron, hierarchy_cases::polyhedra_of;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::size_t largest = battery::sanitized ? 60 : 300;

std::vector<NamedPolyhedron> all_polyhedra() {
  std::vector<NamedPolyhedron> all;
  for (const std::size_t n : {std::size_t{5}, std::size_t{30}, largest}) {
    for (NamedPolyhedron& p : polyhedra_of(n, 19)) all.push_back(std::move(p));
  }
  return all;
}

/// Who is beside whom, by the hull's faces.
std::vector<std::set<std::uint32_t>> neighbors_in(const Hull3& hull) {
  std::vector<std::set<std::uint32_t>> of(hull.vertices.size());
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t a = face[k], b = face[k + 1 < face.size() ? k + 1 : 0];
      of[a].insert(b), of[b].insert(a);
    }
  }
  return of;
}

TEST(PolytopeHierarchies, PolytopesAreNestedHulls) {
  std::size_t levels = 0, vertices = 0, kept = 0;
  bool has_fans = false;
  for (const auto& [name, polyhedron] : all_polyhedra()) {
    const PolytopeHierarchy h = build_polytope_hierarchy(polyhedron);
    ASSERT_FALSE(h.levels.empty()) << name;
    EXPECT_EQ(h.levels[0].size, convex_hull(polyhedron.mesh.vertices).vertices.size()) << name;
    for (std::size_t v = 0; v < h.points.size(); ++v) {
      EXPECT_EQ(h.points[v], polyhedron.mesh.vertices[h.vertices[v]]) << name;
      EXPECT_EQ(polyhedron.mesh.corners[h.corners[v]], h.vertices[v]) << name;
    }
    for (std::size_t i = 0; i < h.levels.size(); ++i) {
      const HierarchyLevel& level = h.levels[i];
      const Hull3 hull = convex_hull(std::span(h.points).first(level.size));
      ASSERT_EQ(hull.dimension, 3) << name;
      ASSERT_EQ(hull.vertices.size(), level.size) << name << ", polytope " << i;
      if (i + 1 == h.levels.size()) break;
      ++levels;
      const std::uint32_t coarser = h.levels[i + 1].size;
      EXPECT_LE(std::size_t{coarser} * 18, std::size_t{level.size} * 17) << name;
      vertices += level.size, kept += coarser;
      const auto neighbors = neighbors_in(hull);
      for (std::uint32_t v = 0; v < level.size; ++v) {
        if (v < coarser) {
          const auto removed = level.removed_at(v);
          std::set<std::uint32_t> wanted;
          std::ranges::copy_if(neighbors[v], std::inserter(wanted, wanted.end()),
                               [&](std::uint32_t w) { return w >= coarser; });
          EXPECT_EQ(std::set(removed.begin(), removed.end()), wanted) << name;
          continue;
        }
        const auto around = level.neighbors_of_removed(v - coarser);
        EXPECT_EQ(std::set(around.begin(), around.end()), neighbors[v]) << name;
        EXPECT_LE(around.size(), PolytopeHierarchy::most_neighbors) << name;
        EXPECT_TRUE(std::ranges::all_of(around, [&](std::uint32_t w) { return w < coarser; })) << name;
      }
      has_fans = has_fans || !level.fans.empty();
    }
    EXPECT_GT(bytes(h), h.points.size() * sizeof(Point3)) << name;
  }
  std::printf("%zu steps, of %zu vertices %zu kept\n", levels, vertices, kept);
  EXPECT_GT(levels, 100U);
  EXPECT_LT(kept * 4, vertices * 3);
  EXPECT_TRUE(has_fans);
}

/// Along an axis, an edge, the normal of three vertices, a difference, or any way.
Vector3 direction_for(const ConvexPolyhedron3& p, Entropy& entropy) {
  const auto& v = p.mesh.vertices;
  const auto vertex = [&] { return v[entropy.below(v.size())]; };
  const auto way = [](const Point3& a, const Point3& b) { return Vector3{a.x - b.x, a.y - b.y, a.z - b.z}; };
  const auto small = [&] { return static_cast<double>(entropy.within(2)); };
  switch (entropy.below(4)) {
    case 0:
      return {small(), small(), small()};
    case 1:
      return way(vertex(), vertex());
    case 2: {
      const std::size_t f = entropy.below(p.mesh.first.size() - 1);
      const auto corner = [&](std::size_t k) { return v[p.mesh.corners[p.mesh.first[f] + k]]; };
      const Vector3 a = way(corner(1), corner(0)), b = way(corner(2), corner(0));
      return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    default:
      return way(cloud3(Cloud::ball, 1, entropy)[0], Point3{0, 0, 0});
  }
}

TEST(PolytopeHierarchies, SupportIsThatOfAllVertices) {
  int ties = 0, alone = 0;
  for (const auto& [name, polyhedron] : all_polyhedra()) {
    const PolytopeHierarchy h = build_polytope_hierarchy(polyhedron);
    Entropy entropy(20, h.points.size());
    for (int k = 0; k < (battery::sanitized ? 10 : 60); ++k) {
      const Vector3 d = direction_for(polyhedron, entropy);
      const Support3 wanted = support_point(std::span<const Point3>(polyhedron.mesh.vertices), d),
                     is = support_point(h, d);
      ASSERT_EQ(is, wanted) << name << ": " << d.x << " " << d.y << " " << d.z;
      (is.unique ? alone : ties) += 1;
    }
  }
  std::printf("%d alone, %d tie\n", alone, ties);
  EXPECT_GT(ties * 10, alone);
  EXPECT_GT(alone * 2, ties);
}

/// A vertex, the middle of two, a point about a face, or one near to all.
Point3 point_for(const ConvexPolyhedron3& p, Entropy& entropy) {
  const auto& v = p.mesh.vertices;
  const Point3 a = v[entropy.below(v.size())], b = v[entropy.below(v.size())], c = v[entropy.below(v.size())];
  const auto mean = [](const Point3& from, const Point3& to, double t) {
    return Point3{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), from.z + t * (to.z - from.z)};
  };
  const double beyond = static_cast<double>(entropy.within(4));
  switch (entropy.below(4)) {
    case 0:
      return a;
    case 1:
      return mean(a, b, beyond / 2);
    case 2:
      return mean(mean(a, b, 0.5), c, beyond / 4);
    default:
      return mean(cloud3(Cloud::ball, 1, entropy)[0], a, beyond);
  }
}

void expect_distances(const ConvexPolyhedron3& polyhedron, const PolytopeHierarchy& h, const Point3& p,
                      const std::string& name) {
  EXPECT_EQ(closest_points(p, h), closest_points(p, polyhedron)) << name;
  EXPECT_EQ(distance(p, h), distance(p, polyhedron)) << name;
  EXPECT_EQ(squared_distance_exact(p, h), squared_distance_exact(p, polyhedron)) << name;
  EXPECT_EQ(contains(h, p), contains(polyhedron, p)) << name;
}

TEST(PolytopeHierarchies, DistancesAreThoseOfThePolyhedron) {
  int within = 0, apart = 0;
  for (const auto& [name, polyhedron] : all_polyhedra()) {
    const PolytopeHierarchy h = build_polytope_hierarchy(polyhedron);
    Entropy entropy(21, h.points.size());
    for (int k = 0; k < (battery::sanitized ? 3 : 12); ++k) {
      const Point3 p = point_for(polyhedron, entropy);
      expect_distances(polyhedron, h, p,
                       name + ": " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z));
      (contains(h, p) ? within : apart) += 1;
    }
  }
  std::printf("%d within, %d apart\n", within, apart);
  EXPECT_GT(within * 5, apart);
  EXPECT_GT(apart * 5, within);
}

/// Mutants of a hierarchy, each of which lacks the removed neighbors of one polytope, are wrong of some direction.
TEST(PolytopeHierarchies, NoPolytopeCanBeLeftOut) {
  const ConvexPolyhedron3 ball = polyhedra_of(largest, 19)[4].polyhedron;
  const PolytopeHierarchy h = build_polytope_hierarchy(ball);
  ASSERT_GT(h.levels.size(), 4U);
  for (std::size_t i = 0; i + 1 < h.levels.size(); ++i) {
    PolytopeHierarchy mutant = h;
    std::ranges::fill(mutant.levels[i].first_removed, 0U);
    const auto is_noticed = [&](const Point3& p) {
      const Vector3 d{p.x, p.y, p.z};
      return !(support_point(mutant, d) == support_point(h, d));
    };
    EXPECT_TRUE(std::ranges::any_of(h.points, is_noticed)) << i;
  }
}

void expect_hits(const ConvexPolyhedron3& polyhedron, const PolytopeHierarchy& h, const AnyRay& ray,
                 const std::string& name, int& hits) {
  const auto wanted = first_hit_parameter(ray, polyhedron), is = first_hit_parameter(ray, h);
  ASSERT_EQ(is.has_value(), wanted.has_value()) << name;
  if (!is) return;
  ++hits;
  ASSERT_TRUE((*is <=> *wanted) == 0) << name;
}

TEST(PolytopeHierarchies, RaysHitWhenTheyHitThePolyhedron) {
  int hits = 0, asked = 0;
  for (const auto& [name, polyhedron] : all_polyhedra()) {
    const PolytopeHierarchy h = build_polytope_hierarchy(polyhedron);
    Entropy entropy(23, h.points.size());
    for (int k = 0; k < (battery::sanitized ? 3 : 12); ++k) {
      const Point3 a = point_for(polyhedron, entropy), b = point_for(polyhedron, entropy);
      const Vector3 d{b.x - a.x, b.y - a.y, b.z - a.z};
      const std::string about = name + ", ray " + std::to_string(k);
      ASSERT_NO_FATAL_FAILURE(expect_hits(polyhedron, h, Ray3{a, d}, about, hits));
      ASSERT_NO_FATAL_FAILURE(expect_hits(polyhedron, h, Segment3{a, b}, about, hits));
      ASSERT_NO_FATAL_FAILURE(expect_hits(polyhedron, h, Line3{a, d}, about, hits));
      ASSERT_NO_FATAL_FAILURE(expect_hits(polyhedron, h, Ray3{b, direction_for(polyhedron, entropy)}, about, hits));
      asked += 4;
    }
  }
  std::printf("%d rays, %d hit\n", asked, hits);
  EXPECT_GT(hits * 4, asked);
  EXPECT_LT(hits * 10, asked * 9);
}

TEST(PolytopeHierarchies, SmallOnesOfAnyExponent) {
  shape_cases::on_shapes(22, battery::sanitized ? 30 : 400, [&](shape_cases::Material& m) {
    const auto polyhedron = pair_cases::figure<ConvexPolyhedron3>(m);
    const PolytopeHierarchy h = build_polytope_hierarchy(polyhedron);
    const Vector3 d = m.direction3();
    EXPECT_EQ(support_point(h, d), support_point(std::span<const Point3>(polyhedron.mesh.vertices), d)) << m.about();
    expect_distances(polyhedron, h, m.probe3(), m.about());
    int hits = 0;
    expect_hits(polyhedron, h, Ray3{m.probe3(), m.direction3()}, m.about(), hits);
    expect_hits(polyhedron, h, Segment3{m.probe3(), m.probe3()}, m.about(), hits);
    expect_hits(polyhedron, h, Line3{m.probe3(), m.direction3()}, m.about(), hits);
  });
}

TEST(PolytopeHierarchies, WhatIsNoneIsNamed) {
  EXPECT_THAT([] { (void)build_polytope_hierarchy({}); },
              ThrowsMessage<InvalidShape>(HasSubstr("build_polytope_hierarchy: the polyhedron has no faces")));
  const PolytopeHierarchy h = build_polytope_hierarchy(polyhedra_of(9, 1)[0].polyhedron);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { (void)support_point(h, {0, nan, 0}); }, ThrowsMessage<NonFinite>(HasSubstr("direction.y")));
  EXPECT_THAT([&] { (void)closest_points(Point3{0, 0, nan}, h); }, ThrowsMessage<NonFinite>(HasSubstr("p.z")));
  EXPECT_THAT(
      [&] {
        (void)first_hit_parameter(Ray3{{0, nan, 0}, {1, 0, 0}}, h);
      },
      ThrowsMessage<NonFinite>(HasSubstr("origin.y")));
  EXPECT_THAT([&] { (void)contains(h, {0, INFINITY, 0}); }, ThrowsMessage<NonFinite>(HasSubstr("contains: p.y")));
}

}  // namespace
}  // namespace plumb
