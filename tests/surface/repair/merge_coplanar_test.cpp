// Coplanar faces: against every pair of neighbors in rationals, with areas that add up, and whatever the order.
#include "plumb/surface/repair/merge_coplanar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "certify/sanitized.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/surface/repair/repair.hpp"
#include "plumb/surface/topology/adjacency.hpp"
#include "plumb/surface/topology/faults.hpp"
#include "surface/repair/meshes_alike.hpp"

namespace plumb {
namespace {

using namespace meshes_alike;

using Exact = std::array<Rational, 3>;

Exact exact(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
Exact operator-(const Exact& a, const Exact& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact operator+(const Exact& a, const Exact& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Twice the vector area of a ring.
Exact vector_area(const TriangleMesh& mesh, std::span<const std::uint32_t> ring) {
  Exact sum{Rational(0), Rational(0), Rational(0)};
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum = sum + cross(exact(mesh.vertices[ring[i]]), exact(mesh.vertices[ring[(i + 1) % ring.size()]]));
  return sum;
}

/// Of each triangle the first of those that are joined to it, by looking at all pairs of neighbors again and again.
std::vector<std::uint32_t> joined_by_definition(const TriangleMesh& mesh) {
  const HalfEdges half = half_edges(mesh, find_edges(mesh));
  std::vector<std::uint32_t> least(mesh.triangles.size());
  for (std::uint32_t t = 0; t < least.size(); ++t) least[t] = t;
  const auto normal = [&](std::uint32_t t) { return vector_area(mesh, mesh.triangles[t]); };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t h = 0; h < half.twin.size(); ++h) {
      if (half.twin[h] == no_half_edge) continue;
      const std::uint32_t s = h / 3, t = half.twin[h] / 3;
      const Exact m = normal(s), n = normal(t);
      const Rational zero(0);
      if (!(dot(cross(m, n), cross(m, n)) == zero) || !(zero < dot(m, n)) || least[s] == least[t]) continue;
      least[s] = least[t] = std::min(least[s], least[t]);
      changed = true;
    }
  }
  return least;
}

void expect_laws(const TriangleMesh& mesh, const CoplanarFaces& faces) {
  std::vector<int> times(mesh.triangles.size());
  std::size_t sum = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    Exact outline{Rational(0), Rational(0), Rational(0)}, covered = outline;
    for (const auto& ring : faces.rings_of(f)) outline = outline + vector_area(mesh, ring);
    for (const std::uint32_t t : faces.triangles_of(f)) {
      ++times[t];
      covered = covered + vector_area(mesh, mesh.triangles[t]);
    }
    EXPECT_TRUE(dot(outline - covered, outline - covered) == Rational(0)) << "area of face " << f;
    sum += std::min<std::size_t>(faces.fewest_triangles(f), faces.triangles_of(f).size());
    EXPECT_LT(f == 0 ? 0 : faces.triangles_of(f - 1)[0] + 1, faces.triangles_of(f)[0] + 1);
  }
  EXPECT_EQ(std::ranges::count(times, 1), std::ssize(times)) << "each triangle in one face";
  EXPECT_EQ(triangulated(mesh, faces).triangles.size(), sum);
}

TriangleMesh some_voxels(std::mt19937& random, int n) {
  std::set<solids::Cell> cells;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        if (random() % 3 != 0) cells.insert({x, y, z});
  return solids::voxels(cells);
}

TEST(MergeCoplanar, AsAllPairsOfNeighborsSay) {
  std::size_t holed = 0, touching_themselves = 0;
  for (std::uint32_t seed = 0; seed < (battery::sanitized ? 8u : 30u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const TriangleMesh mesh = some_voxels(random, 2 + static_cast<int>(seed % 4));
    const CoplanarFaces faces = merge_coplanar(mesh);
    EXPECT_TRUE(faces.apart.empty());
    expect_laws(mesh, faces);
    const auto least = joined_by_definition(mesh);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      for (const std::uint32_t t : faces.triangles_of(f)) EXPECT_EQ(least[t], faces.triangles_of(f)[0]);
      holed += faces.rings_of(f).size() > 1;
      for (const auto& ring : faces.rings_of(f))
        touching_themselves += std::set(ring.begin(), ring.end()).size() < ring.size();
    }
    for (std::uint32_t t = 0; t < least.size(); ++t) EXPECT_LE(least[t], t);
  }
  EXPECT_GT(holed, battery::sanitized ? 0U : 5U);
  EXPECT_GT(touching_themselves, battery::sanitized ? 0U : 5U);
}

TEST(MergeCoplanar, ClosedStaysClosedWhateverTheOrder) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const TriangleMesh mesh = some_voxels(random, 3);
    for (const CollinearVertices collinear : {CollinearVertices::kept, CollinearVertices::dropped}) {
      const RepairStep step{.kind = RepairKind::merge_coplanar, .collinear = collinear};
      const Repaired before = repair(mesh, std::vector<RepairStep>{}), done = repair(mesh, {step});
      EXPECT_LT(done.mesh.triangles.size(), mesh.triangles.size());
      EXPECT_EQ(done.mesh.vertices, mesh.vertices);
      EXPECT_EQ(done.faults.closed, before.faults.closed);
      EXPECT_EQ(done.faults.oriented, before.faults.oriented);
      EXPECT_EQ(done.faults.vertices_on_edges, before.faults.vertices_on_edges);
      EXPECT_EQ(done.faults.met.overlapping, before.faults.met.overlapping);
      EXPECT_EQ(triangles_of(repair(shuffled(mesh, random), {step}).mesh), triangles_of(done.mesh));
      const Repaired again = repair(done.mesh, {step});
      EXPECT_EQ(again.mesh.triangles, done.mesh.triangles) << "there is no more to merge";
      EXPECT_TRUE(again.changes.empty());
    }
  }
}

TEST(MergeCoplanar, ABoxIsTwelveTriangles) {
  const TriangleMesh mesh = grid_box(5);
  const Repaired done = repair(mesh, {{RepairKind::merge_coplanar}, {RepairKind::unused}});
  EXPECT_EQ(done.mesh.triangles.size(), 12U);
  EXPECT_EQ(done.mesh.vertices.size(), 8U);
  EXPECT_FALSE(done.faults.any());
  const CoplanarFaces kept = merge_coplanar(mesh);
  ASSERT_EQ(kept.size(), 6U);
  for (std::uint32_t f = 0; f < 6; ++f) EXPECT_EQ(kept.rings_of(f)[0].size(), 20U);
}

TEST(MergeCoplanar, AVertexThatAnotherFaceEndsAtIsKept) {
  // Two squares below one of twice their width: the vertex between them is straight in the upper one only.
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, -1}, {1, 0, -1}, {2, 1, -1}},
                    {{0, 1, 4}, {1, 2, 3}, {1, 3, 4}, {1, 0, 5}, {1, 5, 6}, {2, 1, 7}}};
  const CoplanarFaces faces = merge_coplanar(mesh, {.collinear = CollinearVertices::dropped});
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_EQ(faces.rings_of(0)[0].size(), 5U);
  mesh.triangles.resize(3);
  EXPECT_EQ(merge_coplanar(mesh, {.collinear = CollinearVertices::dropped}).rings_of(0)[0].size(), 4U);
  EXPECT_EQ(merge_coplanar(mesh).rings_of(0)[0].size(), 5U);
}

/// A square of n by n cells, its inner vertices lifted in turn by the heights.
TriangleMesh sheet(std::uint32_t n, const std::vector<double>& heights) {
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const bool inner = x > 0 && y > 0 && x < n && y < n;
      mesh.vertices.push_back({double(x), double(y), inner ? heights[(x + y * n) % heights.size()] : 0.0});
    }
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = x + y * (n + 1);
      mesh.triangles.push_back({v, v + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return mesh;
}

TEST(MergeCoplanar, WithinATolerance) {
  const TriangleMesh mesh = sheet(2, {0.125});
  EXPECT_EQ(merge_coplanar(mesh, {.tolerance = 1}).size(), 1U);
  EXPECT_GT(merge_coplanar(mesh, {.tolerance = 0x1p-30}).size(), 2U);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<double> heights(7);
    for (double& h : heights) h = std::ldexp(double(random() % 100), -8);
    const TriangleMesh bumpy = sheet(9, heights);
    const double tolerance = std::ldexp(double(1 + random() % 100), -8);
    const RepairStep step{
        .kind = RepairKind::merge_coplanar, .tolerance = tolerance, .collinear = CollinearVertices::kept};
    const CoplanarFaces faces = merge_coplanar(bumpy, {.tolerance = tolerance});
    expect_laws(bumpy, faces);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {  // by definition: the squared distance of each corner
      const auto& plane = bumpy.triangles[faces.plane[f]];
      const Exact normal = vector_area(bumpy, plane);
      for (const std::uint32_t t : faces.triangles_of(f))
        for (const std::uint32_t v : bumpy.triangles[t]) {
          const Rational off = dot(normal, exact(bumpy.vertices[v]) - exact(bumpy.vertices[plane[0]]));
          EXPECT_FALSE(Rational(tolerance) * Rational(tolerance) * dot(normal, normal) < off * off);
        }
    }
    const Repaired done = repair(bumpy, {step});
    EXPECT_EQ(done.faults.open_edges, 36U);
    EXPECT_EQ(triangles_of(repair(shuffled(bumpy, random), {step}).mesh), triangles_of(done.mesh));
  }
}

TEST(MergeCoplanar, WhatCoversItselfIsLeftApart) {
  // A strip around the origin, one and a half times, all in one plane.
  TriangleMesh spiral;
  const std::vector<Point2> around{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (std::uint32_t i = 0; i <= 12; ++i) {
    const Point2& p = around[i % 8];
    spiral.vertices.push_back({p.x + i * 0.001, p.y, 0});
    spiral.vertices.push_back({3 * p.x - i * 0.001, 3 * p.y, 0});
    if (i > 0) {
      spiral.triangles.push_back({2 * i - 2, 2 * i - 1, 2 * i + 1});
      spiral.triangles.push_back({2 * i - 2, 2 * i + 1, 2 * i});
    }
  }
  const CoplanarFaces faces = merge_coplanar(spiral);
  EXPECT_EQ(faces.apart, std::vector<std::uint32_t>{0});
  EXPECT_EQ(faces.size(), spiral.triangles.size());
  const Repaired done = repair(spiral, {{RepairKind::merge_coplanar}});
  EXPECT_EQ(done.mesh.triangles, spiral.triangles);
  ASSERT_EQ(done.changes.size(), 1U);
  EXPECT_EQ(done.changes[0].kind, ChangeKind::kept_coplanar);
  spiral.triangles.resize(12);  // not yet once around
  EXPECT_EQ(merge_coplanar(spiral).size(), 1U);
}

TEST(MergeCoplanar, AVertexOnAnEdgeOfItsFaceOpensNothing) {
  // A clasp whose tip, vertex 6, lies on the edge from 3 to 2: that would be divided above and below, not in the wall.
  const std::vector<Point2> outline{{0, 0}, {6, 0}, {6, 1}, {1, 1}, {1, 5}, {2, 5},
                                    {3, 1}, {4, 5}, {6, 5}, {6, 6}, {0, 6}, {0, 3}};
  const std::vector<TriangleMesh::Triangle> within{{0, 1, 2}, {0, 2, 3}, {11, 0, 3}, {11, 3, 4}, {5, 6, 7},
                                                   {7, 8, 9}, {5, 7, 9}, {4, 5, 9},  {4, 9, 10}, {4, 10, 11}};
  TriangleMesh clasp;
  const std::uint32_t n = 12;
  for (const double z : {0.0, 1.0})
    for (const Point2& p : outline) clasp.vertices.push_back({p.x, p.y, z});
  for (const auto& [a, b, c] : within) {
    clasp.triangles.push_back({a, c, b});
    clasp.triangles.push_back({n + a, n + b, n + c});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    clasp.triangles.push_back({i, j, n + j});
    clasp.triangles.push_back({i, n + j, n + i});
  }
  const CoplanarFaces faces = merge_coplanar(clasp);
  EXPECT_EQ(faces.apart, (std::vector<std::uint32_t>{0, 1}));
  const RepairStep step{.kind = RepairKind::merge_coplanar, .collinear = CollinearVertices::dropped};
  const Repaired before = repair(clasp, std::vector<RepairStep>{}), done = repair(clasp, {step});
  ASSERT_TRUE(before.faults.closed);
  EXPECT_TRUE(done.faults.closed);
  EXPECT_EQ(done.faults.open_edges, 0U);
}

TEST(MergeCoplanar, FoldsFinsAndFlatTriangles) {
  const TriangleMesh folded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_EQ(merge_coplanar(folded).size(), 2U) << "on the same side of their edge";
  TriangleMesh fin = sheet(3, {0.0});
  fin.vertices.push_back({1, 1, 1});
  fin.triangles.push_back({5, 6, 16});  // stands on the edge from (1, 1) to (2, 1)
  const CoplanarFaces faces = merge_coplanar(fin, {.collinear = CollinearVertices::dropped});
  ASSERT_EQ(faces.size(), 2U);
  ASSERT_EQ(faces.rings_of(0).size(), 2U);
  EXPECT_EQ(faces.rings_of(0)[0].size(), 4U);
  EXPECT_EQ(faces.rings_of(0)[1].size(), 2U) << "both sides of the fin's edge";
  expect_laws(fin, faces);
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {3, 3, 0}}};
  const CoplanarFaces kept = merge_coplanar(flat, {.collinear = CollinearVertices::dropped});
  EXPECT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept.rings_of(1)[0].size(), 4U) << "the flat triangle has that vertex for a corner";
  EXPECT_EQ(merge_coplanar(TriangleMesh{}).size(), 0U);
}

TEST(MergeCoplanar, RefusesWhatIsNone) {
  const TriangleMesh mesh = grid_box(1);
  EXPECT_THROW(merge_coplanar(mesh, {.tolerance = -1}), InvalidShape);
  EXPECT_THROW(merge_coplanar(mesh, {.tolerance = NAN}), NonFinite);
  EXPECT_THROW(merge_coplanar({{{0, 0, 0}}, {{0, 1, 0}}}), InvalidShape);
  EXPECT_THROW(merge_coplanar({{{0, 0, NAN}}, {{0, 0, 0}}}), NonFinite);
}

TEST(MergeCoplanar, AVertexInTheMidstOfAFaceThatOthersHaveStays) {
  // A square of four triangles about its center, on which another solid's tip stands, and one on which nothing does.
  for (const bool has_tip : {true, false}) {
    TriangleMesh mesh{
        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {0.5, 0.5, 1}, {1.5, 0.5, 1}, {1, 1.5, 1}},
        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    if (has_tip) mesh.triangles.insert(mesh.triangles.end(), {{4, 6, 5}, {4, 7, 6}, {4, 5, 7}, {5, 6, 7}});
    const CoplanarFaces faces = merge_coplanar(mesh, {.collinear = CollinearVertices::dropped});
    EXPECT_EQ(faces.apart, has_tip ? std::vector<std::uint32_t>{0} : std::vector<std::uint32_t>{});
    const TriangleMesh fewer = triangulated(mesh, faces);
    EXPECT_EQ(fewer.triangles.size(), has_tip ? 8U : 2U);
    EXPECT_FALSE(find_faults(fewer).meets_itself());
  }
}

}  // namespace
}  // namespace plumb
