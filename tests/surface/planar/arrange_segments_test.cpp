// Arrangements: vertices and edges by definition, faces by Euler's formula, windings in rational numbers.
#include "plumb/surface/planar/arrange_segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/section/intersection2.hpp"

namespace plumb {
namespace {

using Edges = std::map<std::array<std::uint32_t, 2>, int>;

// Every point that two segments have in common, and the pieces between, pair by pair.
void expect_by_definition(const std::vector<Segment2>& segments, const PlanarArrangement& made) {
  std::vector<ExactPoint2> vertices;
  for (const Segment2& s : segments) {
    vertices.insert(vertices.end(), {s.a, s.b});
    for (const Segment2& t : segments)
      for (const ExactPoint2& p : intersection(s, t).vertices) vertices.push_back(p);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  ASSERT_EQ(made.vertices, vertices);
  Edges edges;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ExactPoint2 a = segments[i].a, b = segments[i].b;
    std::vector<std::uint32_t> on;
    for (std::uint32_t v = 0; v < vertices.size(); ++v)
      if (orient2d(a, b, vertices[v]) == Sign::zero && std::min(a, b) <= vertices[v] && vertices[v] <= std::max(a, b))
        on.push_back(v);
    for (std::size_t k = 1; k < on.size(); ++k) edges[{on[k - 1], on[k]}] += a < b ? 1 : -1;
    EXPECT_EQ(vertices[made.ends[i][0]], a);
    EXPECT_EQ(vertices[made.ends[i][1]], b);
  }
  ASSERT_EQ(made.edges.size(), edges.size());
  std::size_t k = 0;
  for (const auto& [edge, weight] : edges) {
    EXPECT_EQ(made.edges[k], edge);
    EXPECT_EQ(made.weights[k++], weight);
  }
}

std::size_t faces_by_euler(const PlanarArrangement& made) {
  std::vector<std::size_t> root(made.vertices.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t v) {
    while (root[v] != v) v = root[v];
    return v;
  };
  std::size_t parts = root.size();
  for (const auto& [a, b] : made.edges) {
    if (find(a) == find(b)) continue;
    root[find(a)] = find(b);
    --parts;
  }
  return made.edges.size() + parts + 1 - made.vertices.size();
}

void expect_faces(const PlanarArrangement& made, bool closed) {
  EXPECT_EQ(made.faces, made.vertices.empty() ? 1 : faces_by_euler(made));
  ASSERT_EQ(made.windings.size(), closed ? made.faces : 0);
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> left;
  for (std::size_t t = 0; t < made.triangles.size(); ++t) {
    const auto& [a, b, c] = made.triangles[t];
    EXPECT_EQ(orient2d(made.vertices[a], made.vertices[b], made.vertices[c]), Sign::positive);
    for (const auto& [from, to] : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
      left[{from, to}] = made.face_of[t];
  }
  for (std::size_t k = 0; k < made.edges.size(); ++k) {
    const auto [a, b] = made.edges[k];
    const auto face = [&](std::uint32_t from, std::uint32_t to) {
      const auto found = left.find({from, to});
      return found == left.end() ? 0 : found->second;
    };
    EXPECT_EQ(made.sides[k][0], face(a, b));
    EXPECT_EQ(made.sides[k][1], face(b, a));
    if (closed) {
      EXPECT_EQ(made.windings[made.sides[k][0]] - made.windings[made.sides[k][1]], made.weights[k]);
    }
  }
  if (closed) {
    EXPECT_EQ(made.windings[0], 0);
  }
}

TEST(ArrangeSegments, OfSmallLatticesByDefinition) {
  std::size_t faces = 0, closed_paths = 0;
  for (std::uint64_t round = 0; round < battery::fitting(400U); ++round) {
    SCOPED_TRACE("Entropy(60, " + std::to_string(round) + ")");
    Entropy entropy(60, round);
    const auto coordinate = [&] { return static_cast<double>(entropy.below(5)); };
    std::vector<Point2> path(1 + entropy.below(9));
    for (Point2& p : path) {
      p.x = coordinate();
      p.y = coordinate();
    }
    const bool closed = round % 2 == 0;
    std::vector<Segment2> segments;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) segments.push_back({path[k], path[k + 1]});
    if (closed) segments.push_back({path.back(), path.front()});
    const PlanarArrangement made = arrange_segments(segments);
    expect_by_definition(segments, made);
    expect_faces(made, closed || path.front() == path.back() || segments.empty());
    faces += made.faces;
    closed_paths += closed;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(faces, battery::fitting(1000U));
  EXPECT_GT(closed_paths, battery::fitting(100U));
}

TEST(ArrangeSegments, OfHardPointsByDefinition) {
  for (const FamilyInfo& info : families) {
    for (std::uint64_t round = 0; round < battery::fitting(10U); ++round) {
      SCOPED_TRACE(std::string(info.name) + ", Entropy(61, " + std::to_string(round) + ")");
      Entropy entropy(61, round);
      const auto points = points2(info.family, Degeneracy::collinear, 8, entropy);
      std::vector<Segment2> segments;
      for (std::size_t k = 0; k + 1 < points.size(); k += 2) segments.push_back({points[k], points[k + 1]});
      const PlanarArrangement made = arrange_segments(segments);
      expect_by_definition(segments, made);
      expect_faces(made, !made.windings.empty());
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(ArrangeSegments, KnownOnes) {
  const PlanarArrangement none = arrange_segments({});
  EXPECT_EQ(none.faces, 1U);
  EXPECT_TRUE(none.vertices.empty());
  const std::vector<Segment2> bow{{{0, 0}, {3, 3}}, {{3, 3}, {3, 0}}, {{3, 0}, {0, 3}}, {{0, 3}, {0, 0}}};
  const PlanarArrangement made = arrange_segments(bow);
  EXPECT_EQ(made.vertices.size(), 5U);
  EXPECT_EQ(made.faces, 3U);
  EXPECT_EQ(std::set<std::int32_t>(made.windings.begin(), made.windings.end()), (std::set<std::int32_t>{-1, 0, 1}));
  const std::vector<Segment2> line{{{0, 0}, {2, 2}}, {{3, 3}, {1, 1}}, {{5, 5}, {5, 5}}};
  const PlanarArrangement flat = arrange_segments(line);
  EXPECT_EQ(flat.vertices.size(), 5U);
  EXPECT_EQ(flat.weights, (std::vector<std::int32_t>{1, 0, -1}));
  EXPECT_EQ(flat.faces, 1U);
  EXPECT_THROW((void)arrange_segments(std::vector<Segment2>{{{0, 0}, {0, std::numeric_limits<double>::infinity()}}}),
               NonFinite);
}

}  // namespace
}  // namespace plumb
