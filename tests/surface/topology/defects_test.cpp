// Bow ties, T-junctions, double faces and close vertices, against shapes known beforehand and against brute force.
#include "plumb/surface/topology/defects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <random>
#include <set>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb {
namespace {

std::vector<std::uint32_t> bow_ties(const TriangleMesh& mesh) { return non_manifold_vertices(mesh, find_edges(mesh)); }
std::vector<VertexOnEdge> on_edges(const TriangleMesh& mesh) {
  return vertices_on_edges(find_edges(mesh), build_bvh(mesh));
}

TEST(Defects, ASoundSolidHasNone) {
  const TriangleMesh cube = solids::box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(bow_ties(cube).empty());
  EXPECT_TRUE(on_edges(cube).empty());
  EXPECT_TRUE(coincident_triangles(cube).empty());
  EXPECT_TRUE(close_vertices(cube, 1).empty()) << "nearer than, not as near as";
  EXPECT_EQ(close_vertices(cube, std::nextafter(1, 2)).size(), 8U);
  EXPECT_TRUE(bow_ties({}).empty() && on_edges({}).empty() && coincident_triangles({}).empty());
}

TEST(Defects, TwoFansAtAVertex) {
  TriangleMesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 5, 4}, {0, 4, 6}, {0, 6, 5}, {4, 5, 6}}};
  EXPECT_EQ(bow_ties(two), std::vector<std::uint32_t>{0});
  two.triangles = {{0, 1, 2}, {0, 4, 5}};  // open ones
  EXPECT_EQ(bow_ties(two), std::vector<std::uint32_t>{0});
  two.triangles = {{0, 1, 2}, {0, 4, 4}};  // what names a vertex twice is no fan
  EXPECT_TRUE(bow_ties(two).empty());
  two.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}};  // an edge of four triangles is another fault
  EXPECT_TRUE(bow_ties(two).empty());
}

TEST(Defects, AVertexOnAnEdge) {
  TriangleMesh mesh{{{0, 0, 0}, {0.3, 0.3, 0.9}, {0.1, 0.1, 0.3}, {1, 0, 0}, {0, 1, 0}},
                    {{0, 1, 3}, {0, 2, 4}, {2, 1, 4}}};
  mesh.vertices[2] = {0.15, 0.15, 0.45};  // exactly half
  ASSERT_EQ(on_edges(mesh).size(), 1U);
  EXPECT_EQ(on_edges(mesh)[0].vertex, 2U);
  EXPECT_EQ(find_edges(mesh).edges[on_edges(mesh)[0].edge], (std::array<std::uint32_t, 2>{0, 1}));
  mesh.vertices[2].z = std::nextafter(mesh.vertices[2].z, 1);
  EXPECT_TRUE(on_edges(mesh).empty());
  // Closed by a triangle without area, the vertex is on the edge all the same.
  const TriangleMesh sliver{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {1, 0, 2}}};
  ASSERT_EQ(on_edges(sliver).size(), 1U);
  EXPECT_EQ(on_edges(sliver)[0].vertex, 2U);
}

TEST(Defects, DuplicateAndOppositeTriangles) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-0.0, 1, 0}},
                    {{0, 1, 2}, {1, 2, 3}, {2, 0, 1}, {1, 0, 2}, {1, 4, 0}, {0, 1, 4}, {2, 4, 1}, {2, 1, 4}}};
  EXPECT_EQ(coincident_triangles(mesh),
            (std::vector<CoincidentTriangle>{{2, 0, false}, {3, 0, true}, {4, 0, false}, {5, 0, false}}));
}

TEST(Defects, CloseVerticesAreDecidedExactly) {
  // The distance is a root between two doubles.
  const TriangleMesh mesh{{{0, 0, 0}, {1, 1, 0}, {9, 0, 0}, {0, 0, 0}, {5, 5, 5}}, {{0, 1, 2}, {3, 2, 1}}};
  const double root = std::sqrt(2.0);  // above it
  EXPECT_TRUE(close_vertices(mesh, std::nextafter(root, 0)).empty());
  EXPECT_EQ(close_vertices(mesh, root), (std::vector<CloseVertex>{{0, 1}, {1, 0}}));
  EXPECT_TRUE(close_vertices(mesh, 0).empty());
  EXPECT_EQ(close_vertices(mesh, 1e308).size(), 3U) << "that no triangle names, and what repeats another, are none";
  EXPECT_THROW(close_vertices(mesh, std::nan("")), NonFinite);
  EXPECT_THROW(close_vertices(mesh, -1), InvalidShape);
  EXPECT_THROW(close_vertices({}, -1), InvalidShape);
  EXPECT_THROW(vertices_near_edges(find_edges(mesh), build_bvh(mesh), std::nan("")), NonFinite);
  EXPECT_THROW(vertices_near_edges(find_edges(mesh), build_bvh(mesh), -1), InvalidShape);
}

TEST(Defects, AreThoseOfBruteForce) {
  std::size_t ties = 0, junctions = 0, near_edges = 0, doubles = 0, close = 0;
  for (std::uint32_t seed = 35; seed < 335; ++seed) {
    std::mt19937 random(seed);
    TriangleMesh mesh;
    mesh.vertices.resize(4 + random() % 9);
    for (auto& p : mesh.vertices) p = {double(random() % 4), double(random() % 4), double(random() % 2)};
    mesh.triangles.resize(1 + random() % 24);
    for (auto& t : mesh.triangles)
      for (auto& v : t) v = static_cast<std::uint32_t>(random() % mesh.vertices.size());
    const MeshEdges edges = find_edges(mesh);
    const auto& at = mesh.vertices;
    const auto names = [&](std::size_t t, std::uint32_t v) { return std::ranges::count(mesh.triangles[t], v) != 0; };
    const auto has_edges = [&](std::size_t t) {
      return std::set(mesh.triangles[t].begin(), mesh.triangles[t].end()).size() == 3;
    };
    const auto is_named = [&](std::uint32_t v) {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (names(t, v)) return true;
      return false;
    };

    std::vector<std::uint32_t> tied;
    std::vector<VertexOnEdge> on, by;
    const double length = std::array{0.0, 0.5, 1.0, 1.5}[seed % 4];
    for (std::uint32_t v = 0; v < at.size(); ++v) {
      std::vector<std::size_t> left;  // triangles at v that are not yet in a fan
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (names(t, v) && has_edges(t)) left.push_back(t);
      std::size_t fans = 0;
      for (; !left.empty(); ++fans) {
        std::vector<std::size_t> fan{left.back()};
        left.pop_back();
        for (std::size_t i = 0; i < fan.size(); ++i) {
          std::erase_if(left, [&](std::size_t t) {
            bool shares = false;
            for (const std::uint32_t w : mesh.triangles[t]) shares = shares || (w != v && names(fan[i], w));
            if (shares) fan.push_back(t);
            return shares;
          });
        }
      }
      if (fans > 1) tied.push_back(v);
      for (std::uint32_t e = 0; e < edges.edges.size() && is_named(v); ++e) {
        const Point3 &a = at[edges.edges[e][0]], &b = at[edges.edges[e][1]];
        if (at[v] != a && at[v] != b && collinear(a, at[v], b) && are_ordered_along_line(a, at[v], b))
          on.push_back({v, e});
        // Whole numbers, so that doubles are exact.
        const auto minus = [](const Point3& p, const Point3& q) { return std::array{p.x - q.x, p.y - q.y, p.z - q.z}; };
        const auto dot = [](const auto& p, const auto& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
        const auto along = minus(b, a), to = minus(at[v], a);
        const double foot = dot(to, along), whole = dot(along, along);
        if (at[v] == a || at[v] == b || foot <= 0 || foot >= whole) continue;
        if (dot(to, to) * whole - foot * foot > length * length * whole) continue;
        const auto uses = edges.uses_of(e);
        if (std::ranges::any_of(uses, [&](const EdgeUse& u) { return u.opposite == v; })) continue;
        by.push_back({v, e});
      }
    }
    EXPECT_EQ(bow_ties(mesh), tied) << "seed " << seed;
    EXPECT_EQ(on_edges(mesh), on) << "seed " << seed;
    EXPECT_EQ(vertices_near_edges(edges, build_bvh(mesh), length), by) << "seed " << seed;
    near_edges += length == 0 ? 0 : by.size();

    std::vector<CoincidentTriangle> same;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto points = [&](std::uint32_t of) {
        const auto& [a, b, c] = mesh.triangles[of];
        return std::array{at[a], at[b], at[c]};
      };
      auto p = points(t);
      if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
      for (std::uint32_t first = 0; first < t; ++first) {
        auto q = points(first);
        bool found = false;
        for (int turn = 0; turn < 6 && !found; ++turn) {
          if (turn == 3) std::swap(q[0], q[1]);
          std::rotate(q.begin(), q.begin() + 1, q.end());
          if (p == q) same.push_back({t, first, turn >= 3}), found = true;
        }
        if (found) break;
      }
    }
    EXPECT_EQ(coincident_triangles(mesh), same) << "seed " << seed;

    std::vector<std::uint32_t> near, found_near;
    for (std::uint32_t v = 0; v < at.size(); ++v) {
      if (std::ranges::find(at, at[v]) - at.begin() != static_cast<std::ptrdiff_t>(v)) continue;
      const auto any_of_point = [&](const Point3& p) {
        for (std::uint32_t w = 0; w < at.size(); ++w)
          if (at[w] == p && is_named(w)) return true;
        return false;
      };
      if (!any_of_point(at[v])) continue;
      for (std::uint32_t w = 0; w < at.size(); ++w) {
        if (at[w] == at[v] || !any_of_point(at[w])) continue;
        if (compare_distance(at[v], at[w], {0, 0, 0}, {1.5, 0, 0}) != Sign::negative) continue;
        near.push_back(v);
        break;
      }
    }
    for (const CloseVertex& c : close_vertices(mesh, 1.5)) {
      found_near.push_back(c.vertex);
      EXPECT_EQ(compare_distance(at[c.vertex], at[c.nearest], {0, 0, 0}, {1.5, 0, 0}), Sign::negative);
    }
    EXPECT_EQ(found_near, near) << "seed " << seed;
    ties += tied.size(), junctions += on.size(), doubles += same.size(), close += near.size();
  }
  EXPECT_GT(std::min({ties, junctions, near_edges, doubles, close}), 100U)
      << ties << " " << junctions << " " << near_edges << " " << doubles;
}

TEST(Defects, OfFilesOnWhichChecksFallShort) {
  const std::filesystem::path cases = std::filesystem::path(PLUMB_SHARED_DIR) / "cases";
  if (!std::filesystem::exists(cases)) {
    std::cout << "skipped: there is no folder " << cases << "\n";
    return;
  }
  EXPECT_EQ(bow_ties(read_mesh(cases / "two_shells_one_vertex.obj")), std::vector<std::uint32_t>{0});
  EXPECT_TRUE(bow_ties(read_mesh(cases / "edge_of_four_faces.stl")).empty());
  const TriangleMesh junctions = read_mesh(cases / "t_junctions.stl");
  ASSERT_EQ(on_edges(junctions).size(), 1U);
  EXPECT_EQ(junctions.vertices[on_edges(junctions)[0].vertex], (Point3{0, 1, 2}));
}

}  // namespace
}  // namespace plumb
