// Are triangles that share a vertex or an edge judged beyond it: as the sets that they have in common say?
#include "plumb/space/pairs/neighbors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "figure/basic/shape_cases.hpp"
#include "oracle/intersections.hpp"
#include "plumb/query.hpp"

namespace plumb {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Vertices = std::vector<Point3>;

Triangle3 at(const Vertices& v, const Corners& t) { return {v[t[0]], v[t[1]], v[t[2]]}; }

/// By definition: what is in common against what the shared vertices span.
Relation by_definition(const Vertices& v, const Corners& a, const Corners& b) {
  const std::set<std::uint32_t> of_a(a.begin(), a.end()), of_b(b.begin(), b.end());
  std::vector<Point3> shared;
  for (const std::uint32_t i : of_a) {
    if (of_b.contains(i)) shared.push_back(v[i]);
  }
  const Relation relation = relate(at(v, a), at(v, b));
  if (shared.empty() || of_a == of_b) return relation;
  const Intersection3 common = intersection(at(v, a), at(v, b));
  const Intersection3 feature =
      intersection(Segment3{shared.front(), shared.back()}, Segment3{shared.front(), shared.back()});
  return common == feature ? Relation::disjoint : relation;
}

Corners any_corners(shape_cases::Material& m, std::size_t n) {
  const auto any = [&] { return static_cast<std::uint32_t>(m.below(n)); };
  Corners t{any(), any(), any()};
  if (m.below(6) != 0) {  // mostly three
    for (std::uint32_t k = 1; k < 3; ++k) {
      while (t[k] == t[0] || (k == 2 && t[k] == t[1])) t[k] = static_cast<std::uint32_t>((t[k] + 1) % n);
    }
  }
  return t;
}

TEST(RelateInMesh, IsWhatTheyHaveInCommonBeyondWhatTheyShare) {
  std::array<std::array<std::size_t, 3>, 4> seen{};  // by how many they share, and the answer
  shape_cases::on_shapes(931, 6000, [&](shape_cases::Material& m) {
    Vertices v;
    for (int i = 0; i < 5; ++i) v.push_back(m.point3());
    const Corners a = any_corners(m, 5), b = any_corners(m, 5);
    const Relation relation = relate_in_mesh(v, a, b);
    EXPECT_EQ(relation, by_definition(v, a, b)) << m.about(at(v, a), at(v, b));
    EXPECT_EQ(relate_in_mesh(v, b, a), relation);
    EXPECT_EQ(relate_in_mesh(v, {a[1], a[2], a[0]}, {b[2], b[1], b[0]}), relation);
    const std::set<std::uint32_t> of_a(a.begin(), a.end()), of_b(b.begin(), b.end());
    const auto shared = std::ranges::count_if(of_a, [&](std::uint32_t i) { return of_b.contains(i); });
    ++seen[static_cast<std::size_t>(shared)][static_cast<std::size_t>(static_cast<int>(relation) + 1)];
  });
  for (const std::size_t shared : {1u, 2u}) {
    for (const std::size_t answer : {0u, 2u}) EXPECT_GT(seen[shared][answer], 100u) << shared << " " << answer;
  }
  EXPECT_GT(seen[1][1], 20u);
  EXPECT_EQ(seen[3][0] + seen[3][1], 0u);
}

// Of triangles with an area, by CGAL: as many vertices as the shared feature has, or others.
TEST(RelateInMesh, AgreesWithCgal) {
  std::size_t asked = 0, more = 0;
  shape_cases::on_shapes(932, 4000, [&](shape_cases::Material& m) {
    Vertices v;
    for (int i = 0; i < 5; ++i) v.push_back(m.point3());
    const bool by_edge = m.below(2) == 0;
    const Corners a{0, 1, 2}, b{0, by_edge ? 1u : 3u, 4};
    const auto common = oracle::common_vertices(at(v, a), at(v, b));
    if (!common) return;
    ++asked;
    const bool has_more = common->size() != (by_edge ? 2u : 1u);
    more += has_more ? 1 : 0;
    EXPECT_EQ(relate_in_mesh(v, a, b) != Relation::disjoint, has_more) << m.about(at(v, a), at(v, b));
  });
  EXPECT_GT(more, 200u);
  EXPECT_GT(asked - more, 200u);
}

TEST(RelateInMesh, TellsFoldedFromFlat) {
  const Vertices v{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, -2, 0}, {0, 0, 3}, {2, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(relate_in_mesh(v, {0, 1, 2}, {1, 0, 4}), Relation::disjoint);     // flat
  EXPECT_EQ(relate_in_mesh(v, {0, 1, 2}, {1, 0, 5}), Relation::disjoint);     // at an angle
  EXPECT_EQ(relate_in_mesh(v, {0, 1, 2}, {0, 1, 3}), Relation::overlapping);  // folded over
  EXPECT_EQ(relate_in_mesh(v, {0, 1, 2}, {2, 0, 1}), Relation::overlapping);  // coincident
  EXPECT_EQ(relate_in_mesh(v, {0, 1, 2}, {0, 4, 5}), Relation::disjoint);
  EXPECT_EQ(relate_in_mesh(v, {0, 1, 2}, {0, 6, 5}), Relation::touching);  // another vertex at the same place
  EXPECT_EQ(relate_in_mesh(v, {0, 1, 5}, {0, 7, 4}), Relation::touching);  // along an edge, from a vertex
  EXPECT_EQ(relate_in_mesh(v, {0, 0, 1}, {0, 1, 2}), Relation::disjoint);  // the edge that they share
  EXPECT_EQ(relate_in_mesh(v, {0, 0, 1}, {0, 1, 1}), Relation::overlapping);
}

}  // namespace
}  // namespace plumb
