// The embedded part: the clean flange is a closed solid on a short lattice, and the turned one has exactly the defects
// that its header lists.
#include "tool/mesh/sample_part.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "tool/mesh/flange.hpp"

namespace plumb::tool {
namespace {

using HalfEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

HalfEdges half_edges(const TriangleMesh& mesh) {
  HalfEdges count;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++count[{t[i], t[(i + 1) % 3]}];
  }
  return count;
}

std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces_of_edges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (const auto& [edge, n] : half_edges(mesh)) count[std::minmax(edge.first, edge.second)] += n;
  return count;
}

long euler_characteristic(const TriangleMesh& mesh) {
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(faces_of_edges(mesh).size()) +
         static_cast<long>(mesh.triangles.size());
}

using Exact = std::array<mpq_class, 3>;
Exact exact(const Point3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

Exact normal(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const Exact a = exact(mesh.vertices[t[0]]), b = exact(mesh.vertices[t[1]]), c = exact(mesh.vertices[t[2]]);
  Exact n;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
  }
  return n;
}

bool has_zero_area(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const Exact n = normal(mesh, t);
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

TEST(Flange, IsAClosedOrientedSurfaceOfGenusNine) {
  const TriangleMesh mesh = build_flange().mesh;
  for (const auto& [edge, n] : half_edges(mesh)) {
    ASSERT_NE(edge.first, edge.second);
    ASSERT_EQ(n, 1) << edge.first << ' ' << edge.second;
  }
  for (const auto& [edge, n] : faces_of_edges(mesh)) ASSERT_EQ(n, 2) << edge.first << ' ' << edge.second;
  EXPECT_EQ(euler_characteristic(mesh), 2 - 2 * 9);
}

TEST(Flange, EnclosesAsMuchAsItsDrawingSays) {
  const TriangleMesh mesh = build_flange().mesh;
  double volume = 0;
  for (const auto& t : mesh.triangles) {
    const Point3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    volume += (a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x)) / 6;
  }
  // Plate and hub less bore, bolt holes and counterbores; rounding of edges and of circles to polygons is below 2 %.
  const double pi = 3.14159265;
  const double drawn =
      pi * (60 * 60 * 16 + 28 * 28 * 22 - 18 * 18 * 38 - 8 * (4.5 * 4.5 * 9 + 7.5 * 7.5 * 7) - 4 * 2 * 2 * 9);
  EXPECT_NEAR(volume / drawn, 1, 0.02);
}

TEST(Flange, LiesOnAShortLatticeAndItsFlatsAreFlat) {
  const Flange flange = build_flange();
  for (std::size_t v = 0; v < flange.mesh.vertices.size(); ++v) {
    const Point3 p = flange.mesh.vertices[v];
    for (const double x : {p.x, p.y, p.z}) {
      ASSERT_LE(std::abs(x), 64);
      ASSERT_TRUE(v == flange.cap_center || x * 1024 == std::floor(x * 1024)) << v;
    }
  }
  // A face whose corners have one height looks straight up or down, never flipped: up on the outside tops, down at 0.
  std::map<double, std::pair<int, int>> up_and_down;
  for (const auto& t : flange.mesh.triangles) {
    ASSERT_FALSE(has_zero_area(flange.mesh, t));
    const double z = flange.mesh.vertices[t[0]].z;
    if (flange.mesh.vertices[t[1]].z != z || flange.mesh.vertices[t[2]].z != z) continue;
    (normal(flange.mesh, t)[2] > 0 ? up_and_down[z].first : up_and_down[z].second) += 1;
  }
  ASSERT_EQ(up_and_down.size(), 4U);  // underside, counterbore floors, plate, hub
  for (const auto& [z, count] : up_and_down) {
    EXPECT_EQ(z == 0 ? count.first : count.second, 0) << z;
    EXPECT_GT(count.first + count.second, 300) << z;
  }
}

TEST(Flange, HasOneNearlyFlatCap) {
  const Flange flange = build_flange();
  ASSERT_EQ(flange.cap_faces.size(), 24U);
  std::set<double> heights;
  for (const std::uint32_t f : flange.cap_faces) {
    EXPECT_EQ(flange.mesh.triangles[f][2], flange.cap_center);
    heights.insert(flange.mesh.vertices[flange.mesh.triangles[f][0]].z);
  }
  ASSERT_EQ(heights.size(), 1U);
  EXPECT_EQ(flange.mesh.vertices[flange.cap_center].z - *heights.begin(), 0x1p-36);
}

TEST(SamplePart, HasAFewThousandTriangles) {
  const TriangleMesh mesh = sample_part();
  EXPECT_GE(mesh.triangles.size(), 3000U);
  EXPECT_LE(mesh.triangles.size(), 6000U);
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      ASSERT_LT(v, mesh.vertices.size());
      used[v] = true;
    }
  }
  EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
}

TEST(SamplePart, RepeatsAsManyVerticesAsItSays) {
  const TriangleMesh mesh = sample_part();
  std::set<std::tuple<double, double, double>> places;
  for (const Point3& p : mesh.vertices) places.emplace(p.x, p.y, p.z);
  EXPECT_EQ(mesh.vertices.size() - places.size(), std::size_t{SampleDefects::kRepeatedVertices});
}

TEST(SamplePart, HasAsManyFacesOfZeroAreaAsItSays) {
  const TriangleMesh mesh = sample_part();
  int zero = 0, repeated_place = 0, sliver = 0;
  for (const auto& t : mesh.triangles) {
    const Point3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    if (has_zero_area(mesh, t)) {
      ++zero;
      repeated_place += a == b || b == c || a == c;
      continue;
    }
    const Exact n = normal(mesh, t);
    sliver += n[0] * n[0] + n[1] * n[1] + n[2] * n[2] < mpq_class(0x1p-80);
  }
  EXPECT_EQ(zero, SampleDefects::kZeroAreaFaces);
  EXPECT_EQ(repeated_place, 2 * SampleDefects::kCollapsedEdges);
  EXPECT_EQ(sliver, SampleDefects::kRoundedJunctions);
}

TEST(SamplePart, HasOneFinOneHoleAndOneSeam) {
  const TriangleMesh mesh = sample_part();
  std::map<int, int> edges_with;
  for (const auto& [edge, n] : faces_of_edges(mesh)) ++edges_with[n];
  EXPECT_EQ(edges_with.size(), 3U);
  EXPECT_EQ(edges_with[3], 1);
  // Both sides of the seam, the fin's two free sides, the sides of the missing face.
  EXPECT_EQ(edges_with[1], 2 * SampleDefects::kSeamVertices + 2 + 3);
  // Splits keep the characteristic, the seam (a loop) too; a fin adds a vertex, two edges and a face.
  EXPECT_EQ(euler_characteristic(mesh), 2 - 2 * 9 - 1);
}

TEST(SamplePart, IsTurnedOffEveryShortLattice) {
  const TriangleMesh mesh = sample_part();
  int full = 0;  // coordinates that need at least 50 of their 53 bits
  for (const Point3& p : mesh.vertices) {
    for (const double x : {p.x, p.y, p.z}) {
      int exponent = 0;
      const double scaled = std::ldexp(std::frexp(x, &exponent), 49);
      full += scaled != std::floor(scaled);
    }
  }
  EXPECT_GT(full, static_cast<int>(mesh.vertices.size()) * 3 * 8 / 10);
}

TEST(SamplePart, IsTheSameBitsEverywhere) {
  const TriangleMesh mesh = sample_part();
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a over words
  const auto mix = [&hash](std::uint64_t word) { hash = (hash ^ word) * 1099511628211U; };
  for (const Point3& p : mesh.vertices) {
    for (const double x : {p.x, p.y, p.z}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof bits);
      mix(bits);
    }
  }
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) mix(v);
  }
  EXPECT_EQ(hash, 11341797615059612562U);
}

}  // namespace
}  // namespace plumb::tool
