// Half-edges, winged edges, components, boundary loops and Euler's formula, against shapes known beforehand and against
// the definitions on random heaps of triangles.
#include "plumb/surface/topology/adjacency.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "figure/basic/solids.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/surface/topology/components.hpp"
#include "plumb/surface/topology/defects.hpp"

namespace plumb {
namespace {

using Triangles = std::vector<TriangleMesh::Triangle>;

TriangleMesh abstract(std::uint32_t vertices, Triangles triangles) {
  return {std::vector<Point3>(vertices), std::move(triangles)};
}

/// A strip of n triangles whose ends are joined, with or without a half turn.
TriangleMesh strip(std::uint32_t n) {
  TriangleMesh mesh = abstract(n, {});
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({i, (i + 1 + i % 2) % n, (i + 2 - i % 2) % n});
  return mesh;
}

SurfaceKind only_kind(const TriangleMesh& mesh) {
  const auto kinds = surface_kinds(mesh, find_edges(mesh));
  EXPECT_EQ(kinds.size(), 1U);
  return kinds.at(0);
}

TEST(Adjacency, HalfEdgesOfASolidAreTwins) {
  const TriangleMesh cube = solids::box({0, 0, 0}, {1, 1, 1});
  const MeshEdges edges = find_edges(cube);
  const HalfEdges half = half_edges(cube, edges);
  EXPECT_TRUE(half.boundary.empty() && half.crowded.empty() && half.opposed.empty());
  const auto from = [&](std::uint32_t h) { return cube.triangles[h / 3][h % 3]; };
  for (std::uint32_t h = 0; h < 36; ++h) {
    EXPECT_EQ(half.twin[half.twin[h]], h);
    EXPECT_EQ(from(half.twin[h]), from(next_half_edge(h)));
    EXPECT_EQ(previous_half_edge(next_half_edge(h)), h);
  }
  const auto winged = winged_edges(cube, edges, half);
  ASSERT_EQ(winged.size(), 18U);
  for (std::size_t e = 0; e < winged.size(); ++e) {
    const WingedEdge& w = winged[e];
    EXPECT_EQ((std::array{w.a, w.b}), edges.edges[e]);
    EXPECT_TRUE(from(w.left) == w.a && from(w.right) == w.b && from(w.left_after) == w.b && from(w.right_after) == w.a);
    EXPECT_TRUE(next_half_edge(w.left_before) == w.left && next_half_edge(w.right_before) == w.right);
  }
}

TEST(Adjacency, WhatIsNotManifoldIsListed) {
  // An open edge 1-2, one of three triangles 0-1, one of two that run alike 0-2.
  const TriangleMesh mesh = abstract(6, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 5, 0}, {5, 0, 2}, {3, 3, 4}});
  const MeshEdges edges = find_edges(mesh);
  const HalfEdges half = half_edges(mesh, edges);
  const auto named = [&](const std::vector<std::uint32_t>& list) {
    std::set<std::array<std::uint32_t, 2>> names;
    for (const std::uint32_t e : list) names.insert(edges.edges[e]);
    return names;
  };
  using Names = std::set<std::array<std::uint32_t, 2>>;
  EXPECT_EQ(named(half.crowded), (Names{{0, 1}, {0, 2}}));
  EXPECT_EQ(named(half.opposed), (Names{{0, 5}, {2, 5}}));
  EXPECT_TRUE(named(half.boundary).contains({1, 2}) && half.boundary.size() == 5);
  EXPECT_EQ(edges_of_faces(mesh, edges)[5], (std::array{no_edge, no_edge, no_edge}));
  EXPECT_EQ(winged_edges(mesh, edges, half).size(), 5U);
  const FacesAtVertices at = faces_at_vertices(mesh);
  EXPECT_TRUE(std::ranges::equal(at[3], std::vector<std::uint32_t>{1, 5}));
  EXPECT_TRUE(std::ranges::equal(at[0], std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_THROW(find_edges(abstract(2, {{0, 1, 2}})), InvalidShape);
  EXPECT_TRUE(faces_at_vertices({}).faces.empty() && half_edges({}, {}).twin.empty());
}

TEST(Components, AreJoinedThreeWays) {
  // Two over an edge, a third over its other triangle, a fourth over a vertex, a fifth alone.
  const TriangleMesh mesh =
      abstract(12, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 5, 6}, {7, 8, 9}, {6, 10, 5}, {10, 10, 11}});
  const MeshEdges edges = find_edges(mesh);
  EXPECT_EQ(connected_components(mesh, edges, JoinedOver::manifold_edges).of,
            (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 3, 5}));
  EXPECT_EQ(connected_components(mesh, edges, JoinedOver::edges).of, (std::vector<std::uint32_t>{0, 0, 0, 1, 2, 1, 3}));
  EXPECT_EQ(connected_components(mesh, edges, JoinedOver::vertices).of,
            (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(connected_components(mesh).count, 2U);
  EXPECT_EQ(connected_components({}).count, 0U);
}

TEST(Components, EulerNamesEachSurface) {
  EXPECT_EQ(only_kind(solids::box({0, 0, 0}, {1, 1, 1})), (SurfaceKind{8, 18, 12, 0, true}));
  EXPECT_EQ(only_kind(solids::box({0, 0, 0}, {1, 1, 1})).genus(), 0);
  EXPECT_EQ(only_kind(solids::torus(3, 1, 7, 5)).genus(), 1);
  const SurfaceKind moebius = only_kind(strip(5)), band = only_kind(strip(6));
  EXPECT_TRUE(!moebius.orientable && moebius.loops == 1 && moebius.genus() == 1) << "one crosscap";
  EXPECT_TRUE(band.orientable && band.loops == 2 && band.genus() == 0) << "an annulus";
  // Six vertices of an icosahedron whose opposite points are one: the projective plane.
  const SurfaceKind projective = only_kind(abstract(
      6,
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}}));
  EXPECT_TRUE(!projective.orientable && projective.loops == 0 && projective.euler() == 1 && projective.genus() == 1);
  TriangleMesh pair = solids::torus(3, 1, 7, 5);  // a bow tie is one vertex of each fan
  solids::append(pair, solids::box({0, 0, 0}, {1, 1, 1}));
  pair.triangles[70] = {0, pair.triangles[70][1], pair.triangles[70][2]};
  EXPECT_GT(surface_kinds(pair, find_edges(pair)).size(), 1U);
}

TEST(Components, LoopsKeepToOneSideOfTheSurface) {
  // Two triangles that meet in a vertex: each has a loop of its own.
  const TriangleMesh tie = abstract(5, {{0, 1, 2}, {0, 3, 4}});
  const auto loops = boundary_loops(tie, find_edges(tie));
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].vertices, (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_TRUE(loops[0].closed && loops[1].closed);
  // Three at an edge: three chains from one of its ends to the other.
  const TriangleMesh fins = abstract(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  for (const BoundaryLoop& chain : boundary_loops(fins, find_edges(fins)))
    EXPECT_TRUE(!chain.closed && chain.vertices.size() == 3);
  EXPECT_EQ(boundary_loops(strip(5), find_edges(strip(5)))[0].vertices.size(), 5U);
  EXPECT_TRUE(boundary_loops({}, {}).empty());
}

TEST(Components, EachOpenEdgeIsInOneLoop) {
  std::size_t open = 0, chains = 0, loops = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    TriangleMesh mesh = abstract(4 + static_cast<std::uint32_t>(random() % 9), {});
    mesh.triangles.resize(1 + random() % 20);
    for (auto& t : mesh.triangles)
      for (auto& v : t) v = static_cast<std::uint32_t>(random() % mesh.vertices.size());
    const MeshEdges edges = find_edges(mesh);
    std::size_t wanted = 0, found = 0;
    for (std::size_t e = 0; e < edges.edges.size(); ++e) wanted += edges.uses_of(e).size() == 1;
    for (const BoundaryLoop& loop : boundary_loops(mesh, edges)) {
      found += loop.vertices.size() - (loop.closed ? 0 : 1);
      ++(loop.closed ? loops : chains);
    }
    EXPECT_EQ(found, wanted) << "seed " << seed;
    open += wanted;
    std::uint64_t corners = 0, kinds = 0;  // Euler's V of all components is the number of fans
    const auto all = surface_kinds(mesh, edges);
    for (const SurfaceKind& k : all) kinds += k.faces;
    EXPECT_EQ(kinds, mesh.triangles.size());
    for (const SurfaceKind& k : all) {
      if (k.edges == 0) continue;
      EXPECT_GE(k.genus(), 0) << "seed " << seed;
      corners += k.vertices;
    }
    EXPECT_LE(corners, 3 * mesh.triangles.size());
  }
  EXPECT_TRUE(open > 1000 && chains > 100 && loops > 100) << open << " " << chains << " " << loops;
}

}  // namespace
}  // namespace plumb
