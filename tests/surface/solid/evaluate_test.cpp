// Trees of solids as meshes: against the tree's own answers for points, operations on meshes, voxels and volumes.
#include "plumb/surface/solid/evaluate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/surface/solid/round.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::expect_closed, solid_laws::expect_equal, solid_laws::winding_by_definition;
using solids::box, solids::heap;
using testing::HasSubstr;

Rational evaluated_volume(const Csg3& tree) {
  const ExactMesh made = evaluate(tree);
  expect_closed(made);
  return exact_volume(made);
}

TEST(Evaluate, FlatSidedFiguresHaveTheirVolumes) {
  EXPECT_EQ(evaluated_volume(csg(Aabb3{{0, 0, 0}, {1, 2, 3}})), Rational(6));
  EXPECT_EQ(evaluated_volume(csg(Aabb3{{0, 0, 0}, {0, 2, 3}})), Rational(0));
  EXPECT_EQ(evaluated_volume(csg(AabbWidths3{{1, 1, 1}, {1, 2, 3}})), Rational(6));
  EXPECT_EQ(evaluated_volume(csg(AabbCenter3{{1, 1, 1}, {1, 2, 3}})), Rational(48));
  for (const double turn : {1.0, -1.0})
    EXPECT_EQ(evaluated_volume(csg(Obb3{{1, 0, 0}, {{{3, 4, 0}, {-4, 3, 0}, {0, 0, turn}}}, {1, 0.5, 2}})),
              Rational(200));
  EXPECT_EQ(evaluated_volume(csg(Tetrahedron3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 6}})), Rational(1));
  EXPECT_EQ(evaluated_volume(csg(Tetrahedron3{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 6}})), Rational(1));
  const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 1, 3}};
  EXPECT_EQ(evaluated_volume(csg(convex_polyhedron(convex_hull(points), points))), Rational(4));
  EXPECT_EQ(evaluated_volume(csg(TriangleMesh{})), Rational(0));
}

TEST(Evaluate, TreesAgainstOperationsOnMeshes) {
  std::size_t kept = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = heap(random, 2, 2), b = heap(random, 2, 2), c = heap(random, 1, 2);
    const Csg3 of_a = csg(a), of_b = csg(b), of_c = csg(c);
    const std::vector<TriangleMesh> all{a, b, c};
    expect_equal(evaluate(of_a | of_b | of_c), unite(all));
    expect_equal(evaluate(of_a & of_b & of_c), intersect(all));
    expect_equal(evaluate(of_a - of_b - of_c), subtract(all));
    // De Morgan and absorption; edges that another leaf cuts stay, so that sets are compared, not meshes.
    expect_equal(evaluate(of_a - (of_b | of_c)), evaluate((of_a - of_b) & (of_a - of_c)));
    EXPECT_EQ(evaluated_volume(of_a & (of_a | of_b)), exact_volume(resolve(a)));
    EXPECT_TRUE(evaluate((of_a | of_b) - of_a - of_b).triangles.empty());
    EXPECT_TRUE(evaluate((of_a & of_c) - of_c).triangles.empty());
    kept += evaluate(of_a - of_b).triangles.size();
  }
  EXPECT_GT(kept, 100U);
}

TEST(Evaluate, PointsAreWhereTheTreeHasThem) {
  std::size_t inside = 0, judged = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> at(-4, 4), size(1, 5);
    const auto any_box = [&] {
      const Point3 p{double(at(random)), double(at(random)), double(at(random))};
      return Aabb3{p, {p.x + size(random), p.y + size(random), p.z + size(random)}};
    };
    const Csg3 tree =
        ((csg(any_box()) | csg(box({-3, -3, -3}, {2, 2, 2}))) - csg(any_box())) & (~csg(any_box()) | csg(any_box()));
    const ExactMesh made = evaluate(tree);
    expect_closed(made);
    for (int i = 0; i < 60; ++i) {
      const Point3 p{at(random) + 0.5, at(random) + 0.25, at(random) + 0.125};
      const auto where = tree.locate_regularized(p);
      ASSERT_TRUE(where.has_value());
      const auto winding = winding_by_definition(made, {Rational(p.x), Rational(p.y), Rational(p.z)});
      ASSERT_TRUE(winding.has_value());
      EXPECT_EQ(*winding, *where == Location::inside ? 1 : 0);
      ++judged;
      inside += *winding == 1 ? 1 : 0;
    }
  }
  EXPECT_EQ(judged, 1200U);
  EXPECT_GT(inside, 100U);
  EXPECT_LT(inside, 900U);
}

/// A cell of the lattice, or none of what was there, as each operation of the chain says.
TEST(Evaluate, ThreeHundredChainsOfLatticeBoxesAgainstVoxels) {
  std::size_t empty = 0, operations[3]{};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> at(0, 3), size(1, 3), which(0, 2);
    std::set<solids::Cell> cells;
    std::optional<Csg3> chain;
    const int count = 2 + static_cast<int>(seed % 3);
    for (int i = 0; i < count; ++i) {
      const int x = at(random), y = at(random), z = at(random), u = size(random), v = size(random), w = size(random);
      const Csg3 leaf = csg(Aabb3{{double(x), double(y), double(z)}, {double(x + u), double(y + v), double(z + w)}});
      std::set<solids::Cell> mine, common;
      for (int j = x; j < x + u; ++j)
        for (int k = y; k < y + v; ++k)
          for (int l = z; l < z + w; ++l) mine.insert({j, k, l});
      const int operation = i == 0 ? 0 : which(random);
      ++operations[operation];
      if (operation == 0) cells.insert(mine.begin(), mine.end());
      if (operation == 1) std::erase_if(cells, [&](const solids::Cell& c) { return !mine.contains(c); });
      if (operation == 2) std::erase_if(cells, [&](const solids::Cell& c) { return mine.contains(c); });
      if (!chain)
        chain = leaf;
      else
        chain = operation == 0 ? *chain | leaf : operation == 1 ? *chain & leaf : *chain - leaf;
    }
    const ExactMesh made = evaluate(*chain), merged = evaluate(*chain, Pieces::of_polygons);
    expect_closed(made);
    expect_closed(merged);
    EXPECT_EQ(exact_volume(made), Rational(cells.size()));
    EXPECT_EQ(exact_volume(merged), Rational(cells.size()));
    EXPECT_TRUE(evaluate(*chain - csg(solids::voxels(cells))).triangles.empty());
    EXPECT_TRUE(evaluate(csg(solids::voxels(cells)) - *chain).triangles.empty());
    const RoundedMesh rounded = round(made);
    EXPECT_TRUE(rounded.sound);
    EXPECT_LT(rounded.moved, 1e-14);
    empty += cells.empty() ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_LT(empty, 150U);
  for (const std::size_t n : operations) EXPECT_GT(n, 100U);
}

void expect_refused(const Csg3& tree, const std::string& text) {
  try {
    evaluate(tree);
    ADD_FAILURE() << "is not refused: " << text;
  } catch (const InvalidShape& e) {
    EXPECT_THAT(e.what(), HasSubstr(text));
  }
}

TEST(Evaluate, RefusesByName) {
  const Csg3 cube = csg(Aabb3{{0, 0, 0}, {1, 1, 1}});
  expect_refused(cube | csg(Sphere3{{0, 0, 0}, 1}), "leaf 1 is a Sphere3, which is round");
  expect_refused(cube & csg(Halfspace3{{1, 0, 0}, 0}), "leaf 1 is a Halfspace3, which is unbounded");
  expect_refused(~cube, "the solid of the tree is unbounded");
  expect_refused(cube | ~cube, "the solid of the tree is unbounded");
  expect_refused(csg(AabbWidths3{{0.1, 0, 0}, {0.2, 1, 1}}),
                 "leaf 0 is an AabbWidths3 with a corner that no double holds");
  TriangleMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_THROW(csg(open), UnbalancedEdge);
}

TEST(Evaluate, AMeshIsALeafThatLocatesPoints) {
  const Csg3 tree = csg(box({0, 0, 0}, {2, 2, 2})) - csg(Aabb3{{1, 1, 1}, {3, 3, 3}});
  EXPECT_EQ(locate(tree, {0.5, 0.5, 0.5}), Location::inside);
  EXPECT_EQ(locate(tree, {1.5, 1.5, 1.5}), Location::outside);
  EXPECT_EQ(locate(tree, {0, 1, 1}), Location::boundary);
}

}  // namespace
}  // namespace plumb
