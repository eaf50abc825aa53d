// Are these the convex parts of the solid?  In rationals, by definition: convex, apart inside, in the solid, and together
// as large.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "arith/exact_number.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/parts/convex_parts.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::part_laws {

using query::Exact3, query::operator-, query::operator+, query::operator*;

inline Exact3 exact(const Point3& p) { return {p.x, p.y, p.z}; }
inline Exact3 exact(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  return {gmp_number(r.x), gmp_number(r.y), gmp_number(r.z)};
}

inline Rational volume_of(const TriangleMesh& mesh) {
  mpq_class six = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    six += query::dot(exact(mesh.vertices[a]), query::cross(exact(mesh.vertices[b]), exact(mesh.vertices[c])));
  return exact_number(mpq_class(six / 6));
}

/// In pairs of sums: denominators grow with what is added, and one after another they would be long from the start.
inline Rational volume_of(const ConvexParts& found) {
  std::vector<Rational> sums{Rational(0)};
  for (const ConvexPart& p : found.parts) sums.push_back(exact_volume(p.solid));
  for (; sums.size() > 1; sums.resize((sums.size() + 1) / 2))
    for (std::size_t i = 0; 2 * i < sums.size(); ++i)
      sums[i] = 2 * i + 1 < sums.size() ? sums[2 * i] + sums[2 * i + 1] : sums[2 * i];
  return sums[0];
}

inline std::vector<Exact3> corners_of(const ConvexPart& part) {
  std::vector<Exact3> at;
  for (const ExactPoint3& p : part.solid.vertices) at.push_back(exact(p));
  return at;
}

/// Positive where p is above the face.
inline int side_of_face(const ConvexPart& part, const std::vector<Exact3>& at, std::size_t face, const Exact3& p) {
  const auto ids = part.solid.corners_of(face);
  const Exact3 normal = query::cross(at[ids[1]] - at[ids[0]], at[ids[2]] - at[ids[0]]);
  return sgn(query::dot(normal, p - at[ids[0]]));
}

inline void expect_convex(const ConvexPart& part) {
  const std::vector<Exact3> at = corners_of(part);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> used;
  for (std::size_t f = 0; f < part.solid.faces(); ++f) {
    const auto ids = part.solid.corners_of(f);
    ASSERT_GE(ids.size(), 3U);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      ++edges[{ids[i], ids[(i + 1) % ids.size()]}];
      used.insert(ids[i]);
    }
    for (std::uint32_t v = 0; v < at.size(); ++v) {
      const int side = side_of_face(part, at, f, at[v]);
      const bool on = std::ranges::find(ids, v) != ids.end();
      ASSERT_TRUE(on ? side == 0 : side < 0) << "face " << f << ", vertex " << v;
    }
  }
  for (const auto& [edge, times] : edges) {
    ASSERT_EQ(times, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
  }
  ASSERT_EQ(used.size(), at.size());
  ASSERT_EQ(at.size() + part.solid.faces(), edges.size() / 2 + 2) << "Euler";
  ASSERT_EQ(part.plane.size(), part.solid.faces());
  if (part.is_exact) {
    ASSERT_TRUE(is_convex(rounded(part)));
    for (std::size_t v = 0; v < at.size(); ++v) ASSERT_EQ(exact(rounded(part).vertices[v]), at[v]);
  }
}

inline bool holds(const ConvexPart& part, const std::vector<Exact3>& at, const Exact3& p) {
  for (std::size_t f = 0; f < part.solid.faces(); ++f)
    if (side_of_face(part, at, f, p) > 0) return false;
  return true;
}

/// Faces are where they are said to be, and of the triangles of which they are said to have a piece.
inline void expect_planes(const TriangleMesh& mesh, const ConvexPart& part) {
  const std::vector<Exact3> at = corners_of(part);
  for (std::size_t f = 0; f < part.solid.faces(); ++f) {
    const auto sources = part.sources_of(f);
    ASSERT_TRUE(std::ranges::is_sorted(sources));
    std::vector<std::uint32_t> triangles(sources.begin(), sources.end());
    triangles.push_back(part.plane[f]);
    for (const std::uint32_t t : triangles)
      for (const std::uint32_t v : mesh.triangles[t])
        ASSERT_EQ(side_of_face(part, at, f, exact(mesh.vertices[v])), 0) << "face " << f << ", triangle " << t;
  }
}

inline void expect_apart(const ConvexParts& found) {
  std::vector<query::FlatSet> sets;
  for (const ConvexPart& p : found.parts) sets.push_back({corners_of(p), {}, {}});
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t k = i + 1; k < sets.size(); ++k) {
      bool boxes_meet = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto by = [axis](const Exact3& a, const Exact3& b) { return a[axis] < b[axis]; };
        const auto [low_i, high_i] = std::ranges::minmax_element(sets[i].points, by);
        const auto [low_k, high_k] = std::ranges::minmax_element(sets[k].points, by);
        boxes_meet = boxes_meet && (*low_i)[axis] < (*high_k)[axis] && (*low_k)[axis] < (*high_i)[axis];
      }
      if (!boxes_meet) continue;
      ASSERT_NE(query::relate(sets[i], sets[k]), Relation::overlapping) << i << " and " << k;
    }
  }
}

/// Is the point, which is on no triangle, inside of the mesh?  By a ray that meets no edge.
inline bool is_inside(const TriangleMesh& mesh, const Exact3& p) {
  for (int k = 1;; ++k) {
    const Exact3 along{1, mpq_class(k, 97), mpq_class(k * k, 89)};
    bool inside = false, meets_edge = false;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Exact3 u = exact(mesh.vertices[a]) - p, v = exact(mesh.vertices[b]) - p, w = exact(mesh.vertices[c]) - p;
      const auto side = [&](const Exact3& s, const Exact3& t) { return sgn(query::dot(along, query::cross(s, t))); };
      const std::array<int, 3> sides{side(u, v), side(v, w), side(w, u)};
      if (std::ranges::count(sides, 1) != 0 && std::ranges::count(sides, -1) != 0) continue;
      if (std::ranges::count(sides, 0) != 0) {
        meets_edge = true;
        break;
      }
      if (sgn(query::dot(u, query::cross(v, w))) == sides[0]) inside = !inside;
    }
    if (!meets_edge) return inside;
  }
}

/// The middle of each part.
inline void expect_inside(const TriangleMesh& mesh, const ConvexParts& found) {
  for (const ConvexPart& part : found.parts) {
    const std::vector<Exact3> at = corners_of(part);
    Exact3 sum{0, 0, 0};
    for (const Exact3& p : at) sum = sum + p;
    ASSERT_TRUE(is_inside(mesh, mpq_class(1, static_cast<unsigned long>(at.size())) * sum));
  }
}

/// Is a point in the solid where it is in a part, and nowhere else?
inline void expect_same_points(const TriangleMesh& mesh, const ConvexParts& found, std::span<const Point3> points) {
  std::vector<std::vector<Exact3>> corners;
  for (const ConvexPart& part : found.parts) corners.push_back(corners_of(part));
  for (const Point3& p : points) {
    bool in_part = false;
    for (std::size_t i = 0; i < found.parts.size() && !in_part; ++i)
      in_part = holds(found.parts[i], corners[i], exact(p));
    EXPECT_EQ(in_part, contains(mesh, p)) << p.x << " " << p.y << " " << p.z;
  }
}

inline void expect_parts(const TriangleMesh& mesh, const ConvexParts& found) {
  for (const ConvexPart& part : found.parts) {
    ASSERT_NO_FATAL_FAILURE(expect_convex(part));
    ASSERT_NO_FATAL_FAILURE(expect_planes(mesh, part));
  }
  ASSERT_EQ(volume_of(found), volume_of(mesh));
  ASSERT_NO_FATAL_FAILURE(expect_apart(found));
  ASSERT_NO_FATAL_FAILURE(expect_inside(mesh, found));
}

}  // namespace plumb::part_laws
