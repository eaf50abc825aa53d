// Welding against its definition: groups by brute force, whatever the order of the input, exact at the tolerance itself.
#include "plumb/surface/repair/weld.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "figure/basic/solids.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb {
namespace {

TriangleMesh points_alone(std::vector<Point3> points) { return {std::move(points), {}}; }

std::vector<std::uint32_t> groups(const TriangleMesh& mesh, double tolerance, WeldRule rule) {
  return find_weld(mesh, {.tolerance = tolerance, .rule = rule}).into;
}

TEST(Weld, EqualPointsAreOne) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {1, 0, 0}},
                          {{0, 1, 2}, {3, 2, 4}, {0, 3, 1}}};
  const Weld weld = find_weld(mesh);
  EXPECT_EQ(weld.into, (std::vector<std::uint32_t>{0, 1, 2, 0, 1}));
  EXPECT_EQ(weld.merged, (std::vector<MergedVertex>{{3, 0, 0}, {4, 1, 0}}));
  EXPECT_EQ(weld.collapsed, std::vector<std::uint32_t>{2});
  EXPECT_TRUE(weld.turned.empty() && weld.refused.empty());
  const TriangleMesh one = welded(mesh, weld);
  EXPECT_EQ(one.triangles, (std::vector<TriangleMesh::Triangle>{{0, 1, 2}, {0, 2, 1}}));
  EXPECT_EQ(one.vertices, mesh.vertices);
  EXPECT_TRUE(find_weld({}).into.empty());
}

TEST(Weld, TheToleranceItselfIsWithin) {
  const TriangleMesh mesh = points_alone({{0, 0, 0}, {1, 1, 0}});
  const double root = std::sqrt(2.0);  // above the root
  EXPECT_EQ(groups(mesh, root, WeldRule::clusters)[1], 0U);
  EXPECT_EQ(groups(mesh, std::nextafter(root, 0), WeldRule::clusters)[1], 1U);
  const TriangleMesh five = points_alone({{0, 0, 0}, {3, 4, 0}});
  EXPECT_EQ(groups(five, 5, WeldRule::chains)[1], 0U);
  EXPECT_EQ(groups(five, std::nextafter(5, 0), WeldRule::chains)[1], 1U);
  EXPECT_EQ(find_weld(five, {.tolerance = 5}).merged[0].distance, 5);
}

TEST(Weld, ChainsGoOnAndClustersEnd) {
  std::vector<Point3> line;
  for (int i = 0; i < 10; ++i) line.push_back({double(i), 0, 0});
  EXPECT_EQ(groups(points_alone(line), 1, WeldRule::chains), std::vector<std::uint32_t>(10, 0));
  EXPECT_EQ(groups(points_alone(line), 1, WeldRule::clusters),
            (std::vector<std::uint32_t>{0, 0, 2, 2, 4, 4, 6, 6, 8, 8}));
}

TEST(Weld, ATriangleThatWouldTurnOverIsAskedAbout) {
  // The tip of a thin triangle beyond the far side of its base's neighbor.
  const TriangleMesh mesh{{{0, 0, 0}, {4, 0, 0}, {2, 0.25, 0}, {2, -0.25, 0}}, {{0, 1, 2}}};
  const WeldOptions kept{.tolerance = 0.5, .turned_over = TurnedOver::kept};
  const Weld turned = find_weld(mesh, kept);
  EXPECT_EQ(turned.into[2], 3U) << "to the point that comes first";
  EXPECT_EQ(turned.turned, std::vector<std::uint32_t>{0});
  const Weld refused = find_weld(mesh, {.tolerance = 0.5});
  EXPECT_EQ(refused.into, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(refused.refused, std::vector<std::uint32_t>{3});
  EXPECT_TRUE(refused.merged.empty() && refused.turned.empty());
}

TEST(Weld, RefusesWhatIsNone) {
  EXPECT_THROW(find_weld({}, {.tolerance = -1}), InvalidShape);
  EXPECT_THROW(find_weld({}, {.tolerance = std::nan("")}), NonFinite);
  EXPECT_THROW(find_weld({}, {.tolerance = INFINITY}), NonFinite);
  EXPECT_THROW(find_weld({{{0, 0, 0}}, {{0, 0, 1}}}), InvalidShape);
  EXPECT_THROW(find_weld(points_alone({{0, NAN, 0}})), NonFinite);
}

/// Points and triangles on a small grid, so that distances are often equal.
TriangleMesh on_grid(std::mt19937& random) {
  TriangleMesh mesh;
  mesh.vertices.resize(2 + random() % 30);
  for (Point3& p : mesh.vertices) p = {double(random() % 6), double(random() % 6), double(random() % 3)};
  mesh.triangles.resize(random() % 20);
  for (auto& t : mesh.triangles)
    for (auto& v : t) v = static_cast<std::uint32_t>(random() % mesh.vertices.size());
  return mesh;
}

using Places = std::set<std::pair<std::array<double, 3>, std::array<double, 3>>>;
/// Where each point goes.
Places moves(const TriangleMesh& mesh, const Weld& weld) {
  Places places;
  for (std::size_t v = 0; v < weld.into.size(); ++v) {
    const Point3 &p = mesh.vertices[v], &q = mesh.vertices[weld.into[v]];
    places.insert({{p.x, p.y, p.z}, {q.x, q.y, q.z}});
  }
  return places;
}

TEST(Weld, HangsOnNoOrderAndKeepsItsLaws) {
  std::size_t merged = 0, refused = 0, apart = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const TriangleMesh mesh = on_grid(random);
    const double tolerance = std::array{0.0, 1.0, std::sqrt(2.0), 2.0}[seed % 4];
    const WeldRule rule = seed % 8 < 4 ? WeldRule::clusters : WeldRule::chains;
    const Weld weld = find_weld(mesh, {.tolerance = tolerance, .rule = rule});

    std::vector<std::uint32_t> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::shuffle(order, random);
    TriangleMesh other{std::vector<Point3>(order.size()), mesh.triangles};
    for (std::size_t v = 0; v < order.size(); ++v) other.vertices[order[v]] = mesh.vertices[v];
    for (auto& t : other.triangles)
      for (auto& v : t) v = order[v];
    std::ranges::shuffle(other.triangles, random);
    EXPECT_EQ(moves(other, find_weld(other, {.tolerance = tolerance, .rule = rule, .execution = Execution::serial})),
              moves(mesh, weld));

    for (std::uint32_t v = 0; v < weld.into.size(); ++v) {
      EXPECT_EQ(weld.into[weld.into[v]], weld.into[v]);
      if (rule == WeldRule::clusters) {
        for (std::uint32_t w = 0; w < v; ++w) {
          if (weld.into[v] == weld.into[w]) {
            EXPECT_NE(compare_distance(mesh.vertices[v], mesh.vertices[w], tolerance), Sign::positive);
          }
        }
      }
      merged += weld.into[v] != v;
    }
    refused += weld.refused.size();
    if (rule == WeldRule::chains && weld.refused.empty()) {  // by brute force
      for (std::uint32_t v = 0; v < weld.into.size(); ++v) {
        for (std::uint32_t w = 0; w < v; ++w) {
          const bool near = compare_distance(mesh.vertices[v], mesh.vertices[w], tolerance) != Sign::positive;
          if (near) {
            EXPECT_EQ(weld.into[v], weld.into[w]);
          }
          apart += weld.into[v] != weld.into[w];
        }
      }
    }
    EXPECT_EQ(welded(mesh, weld).triangles.size() + weld.collapsed.size(), mesh.triangles.size());
  }
  EXPECT_TRUE(merged > 500 && refused > 5 && apart > 500) << merged << " " << refused << " " << apart;
}

/// The clusters by their definition, over all pairs.
std::vector<std::uint32_t> plain_clusters(const std::vector<Point3>& points, double tolerance) {
  const auto before = [](const Point3& p, const Point3& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::vector<std::uint32_t> order(points.size()), into(points.size(), 0xffffffff);
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t l, std::uint32_t r) { return before(points[l], points[r]); });
  const auto reaches = [&](std::uint32_t l, std::uint32_t r) {
    return compare_distance(points[l], points[r], tolerance) != Sign::positive;
  };
  for (const std::uint32_t least : order) {
    if (into[least] != 0xffffffff) continue;
    std::vector<std::uint32_t> near, group{least};
    for (const std::uint32_t k : order)
      if (k != least && into[k] == 0xffffffff && reaches(least, k)) near.push_back(k);
    std::ranges::stable_sort(near, [&](std::uint32_t l, std::uint32_t r) {
      return compare_distance(points[least], points[l], points[r]) == Sign::negative;
    });
    for (const std::uint32_t k : near)
      if (std::ranges::all_of(group, [&](std::uint32_t other) { return reaches(k, other); })) group.push_back(k);
    for (const std::uint32_t k : group) into[k] = least;
  }
  return into;
}

TEST(Weld, DenseClustersAreThoseOfTheirDefinition) {
  std::size_t groups_found = 0, refused = 0;
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::set<std::array<double, 3>> places;  // many at exactly the tolerance, as a grid has them
    const unsigned wide = 6 + seed % 9;
    while (places.size() < 80 + 20 * (seed % 12) && places.size() < wide * wide * (seed % 2 == 0 ? 1 : wide))
      places.insert({double(random() % wide), double(random() % wide), seed % 2 == 0 ? 0 : double(random() % wide)});
    std::vector<Point3> points;
    for (const auto& [x, y, z] : places) points.push_back({x, y, z});
    std::ranges::shuffle(points, random);
    const double tolerance = std::array{5.0, 3.0, std::sqrt(18.0), 100.0}[seed / 2 % 4];
    const std::vector<std::uint32_t> into = groups(points_alone(points), tolerance, WeldRule::clusters);
    EXPECT_EQ(into, plain_clusters(points, tolerance));
    for (std::uint32_t v = 0; v < into.size(); ++v) groups_found += into[v] == v, refused += into[v] != into[0];
  }
  EXPECT_TRUE(groups_found > 60 && refused > 400) << groups_found << " " << refused;
}

TEST(Weld, AHundredThousandPointsWithinTheToleranceOfEachOtherAreOneSoon) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> along(-0.25, 0.25);
  std::vector<Point3> points(100'000);
  for (Point3& p : points) p = {along(random), along(random), along(random)};
  const auto least = std::ranges::min_element(
      points, [](const Point3& p, const Point3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); });
  const std::vector<std::uint32_t> one(points.size(), static_cast<std::uint32_t>(least - points.begin()));
  for (const WeldRule rule : {WeldRule::clusters, WeldRule::chains})  // all pairs would take minutes
    EXPECT_EQ(groups(points_alone(points), 1, rule), one);
}

TEST(Weld, ASoupBecomesTheSolidThatItWas) {
  const TriangleMesh torus = solids::turned(solids::torus(3, 1, 23, 17));
  TriangleMesh soup;
  for (const auto& t : torus.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) soup.vertices.push_back(torus.vertices[v]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  const TriangleMesh one = welded(soup, find_weld(soup));
  EXPECT_EQ(find_edges(one).edges.size(), find_edges(torus).edges.size());
  EXPECT_EQ(mesh_statistics(one).boundary_edges, 0U);
}

}  // namespace
}  // namespace plumb
