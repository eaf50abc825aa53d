// Is this the solid that an operation makes?  By volumes in rationals, and by exact location of points in the meshes as
// given and in the result.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/surface/solid/boolean.hpp"

namespace plumb::solid_laws {

inline Rational volume_of(const TriangleMesh& mesh) {
  ExactMesh exact;
  for (const Point3& p : mesh.vertices) exact.vertices.emplace_back(p);
  exact.triangles = mesh.triangles;
  return exact_volume(exact);
}

/// As often along each edge one way as the other, no triangle without area, vertices and triangles in order.
inline void expect_closed(const ExactMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> flow;
  for (const auto& [a, b, c] : mesh.triangles) {
    EXPECT_FALSE(collinear(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      flow[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
  }
  for (const auto& [edge, count] : flow) EXPECT_EQ(count, 0) << edge.first << " " << edge.second;
  for (std::size_t v = 1; v < mesh.vertices.size(); ++v)
    EXPECT_EQ(compare_xyz(mesh.vertices[v - 1], mesh.vertices[v]), Sign::negative);
  EXPECT_TRUE(std::is_sorted(mesh.triangles.begin(), mesh.triangles.end()));
  EXPECT_EQ(mesh.sources.size(), mesh.triangles.size());
}

inline void expect_equal(const ExactMesh& a, const ExactMesh& b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t v = 0; v < a.vertices.size(); ++v) ASSERT_TRUE(a.vertices[v] == b.vertices[v]);
  EXPECT_EQ(a.triangles, b.triangles);
}

/// How often does the mesh wind around the point?  A line along x, half open edges, in rationals: nothing on the surface.
inline std::optional<int> winding_by_definition(const ExactMesh& mesh, const RationalPoint3& p) {
  int winding = 0;
  std::vector<RationalPoint3> at;
  for (const ExactPoint3& v : mesh.vertices) at.push_back(rational_point(v));
  for (const auto& corners : mesh.triangles) {
    const std::array<RationalPoint3, 3> t{at[corners[0]], at[corners[1]], at[corners[2]]};
    const auto minus = [](const RationalPoint3& l, const RationalPoint3& r) {
      return RationalPoint3{l.x - r.x, l.y - r.y, l.z - r.z};
    };
    const auto u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]);
    const Rational nx = u.y * v.z - u.z * v.y, ny = u.z * v.x - u.x * v.z, nz = u.x * v.y - u.y * v.x;
    if (nx.sign() == Sign::zero && ny.sign() == Sign::zero && nz.sign() == Sign::zero) continue;  // no area
    const Rational height = nx * w.x + ny * w.y + nz * w.z;
    if (height.sign() == Sign::zero) {
      // In the plane: is it in the triangle?
      const auto side = [&](const RationalPoint3& from, const RationalPoint3& to) {
        const auto e = minus(to, from), f = minus(p, from);
        return ((e.y * f.z - e.z * f.y) * nx + (e.z * f.x - e.x * f.z) * ny + (e.x * f.y - e.y * f.x) * nz).sign();
      };
      if (side(t[0], t[1]) != Sign::negative && side(t[1], t[2]) != Sign::negative &&
          side(t[2], t[0]) != Sign::negative)
        return {};
    }
    if (nx.sign() == Sign::zero) continue;
    // The number of edges of the triangle's shadow in (y, z) that pass right of the point.
    int crossings = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalPoint3 &a = t[k], &b = t[(k + 1) % 3];
      if ((a.z <= p.z) == (b.z <= p.z)) continue;
      const Rational y = a.y + (b.y - a.y) * ((p.z - a.z) / (b.z - a.z));
      if (y > p.y) ++crossings;
    }
    if (crossings % 2 == 0) continue;
    if (height.sign() * nx.sign() == Sign::negative) winding += nx.sign() == Sign::positive ? 1 : -1;
  }
  return winding;
}

inline ExactMesh exact_mesh_of(const TriangleMesh& mesh) {
  ExactMesh exact;
  for (const Point3& p : mesh.vertices) exact.vertices.emplace_back(p);
  exact.triangles = mesh.triangles;
  return exact;
}

inline RationalPoint3 beside(const Arrangement& all, std::size_t facet, const Rational& by) {
  std::array<RationalPoint3, 3> t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = rational_point(all.vertices[all.facets[facet][k]]);
  const Rational ux = t[1].x - t[0].x, uy = t[1].y - t[0].y, uz = t[1].z - t[0].z;
  const Rational vx = t[2].x - t[0].x, vy = t[2].y - t[0].y, vz = t[2].z - t[0].z;
  const Rational third(1, 3);
  return {(t[0].x + t[1].x + t[2].x) * third + by * (uy * vz - uz * vy),
          (t[0].y + t[1].y + t[2].y) * third + by * (uz * vx - ux * vz),
          (t[0].z + t[1].z + t[2].z) * third + by * (ux * vy - uy * vx)};
}

/// How many points are on triangles that cancel is returned.
inline std::size_t expect_windings(const std::vector<ExactMesh>& exact, const Arrangement& all, std::size_t every) {
  std::size_t unlucky = 0;
  for (std::size_t f = 0; f < all.facets.size(); f += every) {
    for (const int side : {1, -1}) {
      const RationalPoint3 p = beside(all, f, Rational(side) / Rational(1LL << 40));
      const auto told = all.windings_of(side > 0 ? all.sides[f].above : all.sides[f].below);
      for (std::size_t m = 0; m < exact.size(); ++m) {
        const auto by_definition = winding_by_definition(exact[m], p);
        if (!by_definition) {  // on triangles that cancel one another
          ++unlucky;
          continue;
        }
        EXPECT_EQ(told[m], *by_definition) << "facet " << f << ", side " << side << ", mesh " << m;
      }
    }
  }
  return unlucky;
}
inline std::size_t expect_windings(const std::vector<TriangleMesh>& meshes, const Arrangement& all, std::size_t every) {
  std::vector<ExactMesh> exact;
  for (const TriangleMesh& m : meshes) exact.push_back(exact_mesh_of(m));
  return expect_windings(exact, all, every);
}

}  // namespace plumb::solid_laws
