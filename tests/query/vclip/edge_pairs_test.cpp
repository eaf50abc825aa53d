// Pairs of edges that may span a face of the difference: which bounds were derived, and does a machine confirm them?
#include "query/vclip/edge_pairs.hpp"

#include <gtest/gtest.h>

#include "certify/golden_statements.hpp"
#include "certify/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query::vclipping {
namespace {

ConvexPolyhedron3 solid_of(const std::vector<Point3>& corners) {
  return convex_polyhedron(convex_hull(corners), corners);
}

TEST(SpanningPairs, DerivedBoundsAreAsRecordedAndProved) {
  const ConvexPolyhedron3 t = solid_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  const ConvexPolyhedron3 u = solid_of({{1, 1, 1}, {5, 2, 1}, {1, 6, 2}, {2, 1, 5}});
  const auto of_t = CoreCorners::of(body_view(t)), of_u = CoreCorners::of(body_view(u));
  const Solid a(t, *of_t, false), b(u, *of_u, false);
  const std::vector<SolidEdge> edges_a = edges_of(a), edges_b = edges_of(b);
  ASSERT_EQ(edges_a.size(), 6u);
  int spanning = 0;
  const auto take = [&](std::size_t, std::size_t) { return ++spanning < 0; };
  const auto bounds = judged_bounds(SpanningPairs{}, a, edges_a, b, edges_b, take);
  EXPECT_GE(spanning, 1);
  EXPECT_LT(spanning, 36);
  expect_golden("spanning_edges", bounds);
  expect_proved(bounds, judged_proofs("spanning_edges", SpanningPairs{}, a, edges_a, b, edges_b, take));
}

}  // namespace
}  // namespace plumb::query::vclipping
