// Pairs of edges that may span a face of the difference: which bounds were derived, and does a machine confirm them?
#include "query/vclip/edge_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/predicates.hpp"
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

using Pairs = std::vector<std::array<std::size_t, 2>>;

/// Of small integers, whose products are exact: both faces of neither edge lie strictly on different sides.
Pairs spanning(const Solid& a, const std::vector<SolidEdge>& edges_a, const Solid& b,
               const std::vector<SolidEdge>& edges_b) {
  const auto way = [](const Solid& s, const SolidEdge& e) {
    return s.place<double>(e.twin) - s.place<double>(e.corner);
  };
  const auto are_parted = [&](const Solid& s, const SolidEdge& e, const arith::Plain& along) {
    const arith::Plain of = way(s, e);
    return dot(cross(s.place<double>(e.off) - s.place<double>(e.corner), of), along) *
               dot(cross(s.place<double>(e.off_twin) - s.place<double>(e.twin), of), along) <
           0;
  };
  Pairs all;
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      if (!are_parted(a, edges_a[i], way(b, edges_b[j])) && !are_parted(b, edges_b[j], way(a, edges_a[i])))
        all.push_back({i, j});
    }
  }
  return all;
}

TEST(SpanningPairs, AreAllButThoseThatArePartedStrictly) {
  const std::vector<ConvexPolyhedron3> solids{
      solid_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}), solid_of({{1, 1, 1}, {5, 2, 1}, {1, 6, 2}, {2, 1, 5}}),
      solid_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}}),
      solid_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 1, 3}})};
  std::size_t level = 0;  // pairs of parallel edges, whose faces are on no side at all, are among those that stay
  for (const ConvexPolyhedron3& t : solids) {
    for (const ConvexPolyhedron3& u : solids) {
      const auto of_t = CoreCorners::of(body_view(t)), of_u = CoreCorners::of(body_view(u));
      const Solid a(t, *of_t, false), b(u, *of_u, false);
      const std::vector<SolidEdge> edges_a = edges_of(a), edges_b = edges_of(b);
      const Pairs wanted = spanning(a, edges_a, b, edges_b);
      Pairs by_floats, by_errors;
      FloatWorld<SpanningPairs> w;
      SpanningPairs{}(w, a, edges_a, b, edges_b, [&](std::size_t i, std::size_t j) {
        by_floats.push_back({i, j});
        return false;
      });
      each_spanning_pair(a, edges_a, b, edges_b, [&](std::size_t i, std::size_t j) {
        by_errors.push_back({i, j});
        return false;
      });
      EXPECT_TRUE(w.certain());
      EXPECT_EQ(by_floats, wanted);
      EXPECT_EQ(by_errors, wanted);
      if (&t == &u) level += wanted.size();
    }
  }
  EXPECT_GE(level, 6U + 6U + 12U * 4U + 8U);
}

/// A tetrahedron and what is asked of it; it stays where it is.
struct Kept {
  ConvexPolyhedron3 figure;
  CoreCorners core;
  Solid solid;
  std::vector<SolidEdge> edges;

  explicit Kept(const std::vector<Point3>& corners)
      : figure(solid_of(corners)),
        core(*CoreCorners::of(body_view(figure))),
        solid(figure, core, false),
        edges(edges_of(solid)) {}
};
/// The first that has an inside.
std::unique_ptr<Kept> kept(const auto& draw) {
  for (;;) {
    const std::vector<Point3> p = draw();
    if (orient3d(p[0], p[1], p[2], p[3]) != Sign::zero) return std::make_unique<Kept>(p);
  }
}
using Edges = std::vector<SolidEdge>;
Pairs told(auto& world, const Kept& a, const Edges& of_a, const Kept& b, const Edges& of_b) {
  Pairs all;
  SpanningPairs{}(world, a.solid, of_a, b.solid, of_b, [&](std::size_t i, std::size_t j) {
    all.push_back({i, j});
    return false;
  });
  return all;
}

struct Rationals : RationalWorld {
  static bool positive(const Rational& x) { return x.sign() == Sign::positive; }
};
TEST(SpanningPairs, DoublesLeaveOutInPromisedShare) {
  PromisedShare share("spanning_edges");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(40); ++i) {
      Entropy entropy(81, i);
      const auto draw = [&] {  // not all of them, of which two are equal in some family
        const std::vector<Point3> p = points3(info.family, Degeneracy::cospherical, 6, entropy);
        return std::vector{p[0], p[2], p[4], p[5]};
      };
      const auto a = kept(draw), b = kept(draw);
      FloatWorld<SpanningPairs> floats;
      Rationals exact;
      const Pairs found = told(floats, *a, a->edges, *b, b->edges), truth = told(exact, *a, a->edges, *b, b->edges);
      if (!floats.certain()) {  // out of their range they tell nothing
        share.add(info.family, 0, static_cast<int>(36 - truth.size()));
        continue;
      }
      EXPECT_TRUE(std::ranges::includes(found, truth)) << info.name << ", Entropy(81, " << i << ")";
      share.add(info.family, static_cast<int>(36 - found.size()), static_cast<int>(36 - truth.size()));
    }
  }
}

TEST(SpanningPairs, MutantsAreNoticed) {
  std::vector<std::unique_ptr<Kept>> all;
  for (std::uint64_t k = 0; k < 24; ++k) {
    mutants::Draw d(k);
    all.push_back(kept([&] { return std::vector{d.point(), d.point(), d.point(), d.point()}; }));
  }
  struct Drawn {
    const Kept *a, *b;
    Edges of_a, of_b;  // one of each
  };
  std::uint64_t i = 0;
  const auto draw = [&](mutants::Draw&) {
    Entropy entropy(82, i++);
    const auto one = [&] { return all[entropy.below(all.size())].get(); };
    const Kept *a = one(), *b = one();
    return Drawn{a, b, {a->edges[entropy.below(6)]}, {b->edges[entropy.below(6)]}};
  };
  mutants::expect_noticed(
      "spanning_edges", mutants::unnoticed(
                            draw,
                            [](const Drawn& x) {
                              mutants::World world;
                              return std::optional(told(world, *x.a, x.of_a, *x.b, x.of_b));
                            },
                            [](const Drawn& x) { return spanning(x.a->solid, x.of_a, x.b->solid, x.of_b); }, 0, 2000));
}

}  // namespace
}  // namespace plumb::query::vclipping
