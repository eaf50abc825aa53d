// Edges, neighbors and defects of a mesh, against counts known beforehand and against brute force.
#include "plumb/surface/topology/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/equal_points.hpp"

namespace plumb {
namespace {

TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TEST(Topology, ClosedSurface) {
  const MeshStatistics said = mesh_statistics(tetrahedron());
  EXPECT_EQ(said.vertices, 4U);
  EXPECT_EQ(said.faces, 4U);
  EXPECT_EQ(said.edges, 6U);
  EXPECT_EQ(said.interior_edges, 6U);
  EXPECT_EQ(said.boundary_edges + said.non_manifold_edges + said.inconsistent_edges + said.repeated_vertices +
                said.unused_vertices + said.repeated_corners + said.zero_area_faces,
            0U);
}

TEST(Topology, EachDefectIsCounted) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.push_back({-0.0, 1, 0});  // equals vertex 2
  mesh.vertices.push_back({2, 0, 0});
  mesh.triangles.push_back({0, 1, 5});  // a third face on edge 0-1; all on one line
  mesh.triangles.push_back({5, 5, 0});  // a vertex twice, no edges
  MeshStatistics said = mesh_statistics(mesh);
  EXPECT_EQ(said.repeated_vertices, 1U);
  EXPECT_EQ(said.unused_vertices, 1U);
  EXPECT_EQ(said.non_manifold_edges, 1U);
  EXPECT_EQ(said.boundary_edges, 2U);
  EXPECT_EQ(said.interior_edges, 5U);
  EXPECT_EQ(said.repeated_corners, 1U);
  EXPECT_EQ(said.zero_area_faces, 2U);
  mesh = tetrahedron();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  said = mesh_statistics(mesh);
  EXPECT_EQ(said.inconsistent_edges, 3U);
  EXPECT_EQ(said.interior_edges, 6U);
}

TEST(Topology, InteriorEdgesAreSeenByTheirFirstFace) {
  TriangleMesh mesh = tetrahedron();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);  // against the others
  const auto edges = interior_edges(find_edges(mesh));
  ASSERT_EQ(edges.size(), 6U);
  const auto has = [&](std::uint32_t face, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const TriangleMesh::Triangle& t = mesh.triangles[face];
    return t == TriangleMesh::Triangle{a, b, c} || t == TriangleMesh::Triangle{b, c, a} ||
           t == TriangleMesh::Triangle{c, a, b};
  };
  for (const auto& e : edges) {
    EXPECT_LT(e.face_c, e.face_d);
    EXPECT_TRUE(has(e.face_c, e.a, e.b, e.c));
    EXPECT_TRUE(e.consistent ? has(e.face_d, e.b, e.a, e.d) : has(e.face_d, e.a, e.b, e.d));
    EXPECT_EQ(e.consistent, e.face_d != 3);
  }
}

TEST(Topology, ListsAreInOrderAndComplete) {
  std::mt19937 random(17);
  for (int round = 0; round < 300; ++round) {
    TriangleMesh mesh;
    mesh.vertices.resize(3 + random() % 8);
    for (auto& p : mesh.vertices) p = {double(random() % 2), double(random() % 3), random() % 2 ? 0.0 : -0.0};
    mesh.triangles.resize(random() % 30);
    for (auto& t : mesh.triangles)
      for (auto& v : t) v = static_cast<std::uint32_t>(random() % mesh.vertices.size());
    const MeshEdges edges = find_edges(mesh);
    EXPECT_TRUE(std::is_sorted(edges.edges.begin(), edges.edges.end()));
    EXPECT_EQ(std::adjacent_find(edges.edges.begin(), edges.edges.end()), edges.edges.end());
    ASSERT_EQ(edges.first.size(), edges.edges.size() + 1);
    EXPECT_EQ(edges.first.back(), edges.uses.size());
    std::size_t listed = 0;
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
      const auto [a, b] = edges.edges[e];
      EXPECT_LT(a, b);
      std::vector<EdgeUse> expected;
      for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto& t = mesh.triangles[f];
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (std::size_t k = 0; k < 3; ++k)
          if (std::min(t[k], t[(k + 1) % 3]) == a && std::max(t[k], t[(k + 1) % 3]) == b)
            expected.push_back({f, t[(k + 2) % 3], t[k] == a});
      }
      EXPECT_TRUE(std::ranges::equal(edges.uses_of(e), expected));
      listed += expected.size();
    }
    const MeshStatistics said = mesh_statistics(mesh, edges);
    EXPECT_EQ(listed, 3 * (mesh.triangles.size() - said.repeated_corners));
    const auto first = first_equal(mesh.vertices);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
      EXPECT_EQ(first[v],
                std::find(mesh.vertices.begin(), mesh.vertices.end(), mesh.vertices[v]) - mesh.vertices.begin());
  }
}

TEST(Topology, ZeroAreaIsExact) {
  const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE(collinear({0, 0, 0}, {1, 2, 3}, {3, 6, 9}));
  EXPECT_TRUE(collinear({-huge, -huge, -huge}, {0, 0, 0}, {huge, huge, huge}));
  EXPECT_TRUE(collinear({tiny, tiny, 0}, {2 * tiny, 2 * tiny, 0}, {3 * tiny, 3 * tiny, 0}));
  EXPECT_TRUE(collinear({5, 5, 5}, {5, 5, 5}, {1, 2, 7}));
  EXPECT_FALSE(collinear({0, 0, 0}, {1, 1, 1}, {2, 2, std::nextafter(2, 3)}));
  EXPECT_FALSE(collinear({0, 0, 0}, {huge, 0, 0}, {0, tiny, 0})) << "its area rounds to nothing";
  EXPECT_FALSE(collinear({0.1, 0.1, 0}, {0.2, 0.2, 0}, {0.3, std::nextafter(0.3, 1), 0}));
}

}  // namespace
}  // namespace plumb
