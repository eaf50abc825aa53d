// Operations on what operations made, and on meshes under poses that are not rounded: against voxels, trees of the same
// operations, windings by definition and volumes in rationals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plumb/surface/solid/evaluate.hpp"
#include "plumb/surface/solid/round.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::expect_closed, solid_laws::expect_equal, solid_laws::expect_windings;
using solids::box, solids::heap;

std::size_t points_held(const ExactMesh& mesh) {
  std::size_t held = 0;
  for (const ExactPoint3& p : mesh.vertices) held += std::holds_alternative<Point3>(p.as()) ? 0 : 1;
  return held;
}

TEST(ExactInput, AMeshOfDoublesIsTakenAsItIs) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = heap(random, 3, 2), b = heap(random, 2, 2);
    const ExactMesh exact_a = exact_mesh(a), exact_b = exact_mesh(b);
    expect_equal(unite(exact_a, exact_b), unite(a, b));
    expect_equal(intersect(exact_a, exact_b), intersect(a, b));
    expect_equal(subtract(exact_a, exact_b), subtract(a, b));
    expect_equal(symmetric_difference(exact_a, exact_b), symmetric_difference(a, b));
    expect_equal(resolve(exact_a), resolve(a));
    expect_equal(subtract(exact_a, exact_b, WindingRule::positive, Pieces::of_polygons),
                 subtract(a, b, WindingRule::positive, Pieces::of_polygons));
  }
}

/// Chains of heaps, some of them turned so that they meet where no doubles are.
TEST(ExactInput, ChainsAreWhatTheirTreesAre) {
  std::size_t held = 0, kept = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    TriangleMesh a = heap(random, 2, 2), b = heap(random, 2, 2), c = heap(random, 1, 2), d = heap(random, 1, 2);
    if (seed % 2 != 0) b = solids::turned(b), d = solids::turned(d);
    const ExactMesh both = unite(a, b), rest = subtract(both, exact_mesh(c));
    const ExactMesh chain = intersect(rest, subtract(exact_mesh(d), exact_mesh(a)));
    const ExactMesh merged = subtract(both, exact_mesh(c), WindingRule::positive, Pieces::of_polygons);
    for (const ExactMesh* m : {&rest, &chain, &merged}) expect_closed(*m);
    const Csg3 of_rest = (csg(a) | csg(b)) - csg(c);
    const ExactMesh by_tree = evaluate(of_rest), whole = evaluate(of_rest & (csg(d) - csg(a)));
    EXPECT_EQ(exact_volume(rest), exact_volume(by_tree));
    EXPECT_EQ(exact_volume(merged), exact_volume(by_tree));
    EXPECT_EQ(exact_volume(chain), exact_volume(whole));
    EXPECT_TRUE(symmetric_difference(rest, by_tree).triangles.empty());
    EXPECT_TRUE(symmetric_difference(merged, by_tree).triangles.empty());
    EXPECT_TRUE(symmetric_difference(chain, whole).triangles.empty());
    expect_equal(unite(rest, both), unite(both, rest));
    EXPECT_TRUE(symmetric_difference(unite(rest, both), both).triangles.empty());  // absorption
    held += points_held(both) + points_held(rest);
    kept += chain.triangles.size();
    if (HasFailure()) return;
  }
  EXPECT_GT(held, 300U);
  EXPECT_GT(kept, 100U);
}

/// Each mesh is two results side by side, which cross one another, and which no doubles hold.
TEST(ExactInput, WindingsAreThoseByDefinition) {
  std::size_t held = 0, judged = 0;
  const RigidPose one{{2, 0, 0, 1}, {0.25, 0, 0}}, other{{3, 1, 0, 1}, {0, 0.5, 0}};
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const ExactMesh a = exact_mesh(heap(random, 2, 2), one), b = exact_mesh(heap(random, 1, 2));
    const ExactMesh c = exact_mesh(heap(random, 2, 2), other), rest = subtract(c, a);
    ExactMesh first = unite(a, b);
    const auto n = static_cast<std::uint32_t>(first.vertices.size());
    first.vertices.insert(first.vertices.end(), rest.vertices.begin(), rest.vertices.end());
    for (const auto& [i, k, l] : rest.triangles) first.triangles.push_back({i + n, k + n, l + n});
    const std::vector<ExactMesh> meshes{first, intersect(a, c)};
    const Arrangement all = arrange(meshes);
    held += points_held(first);
    judged += all.facets.size() / 2;
    EXPECT_EQ(expect_windings(meshes, all, 2), 0U);
    if (HasFailure()) return;
  }
  EXPECT_GT(held, 60U);
  EXPECT_GT(judged, 40U);
}

TEST(ExactInput, SixtyLatticeBoxesInTurnStayExact) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> at(0, 9), size(1, 3);
    ExactMesh chain;
    std::set<solids::Cell> cells;
    for (int i = 0; i < 60; ++i) {
      const int x = at(random), y = at(random), z = at(random), u = size(random), v = size(random), w = size(random);
      const ExactMesh next =
          exact_mesh(box({double(x), double(y), double(z)}, {double(x + u), double(y + v), double(z + w)}));
      for (int j = x; j < x + u; ++j)
        for (int k = y; k < y + v; ++k)
          for (int l = z; l < z + w; ++l) {
            if (i % 3 == 2)
              cells.erase({j, k, l});
            else
              cells.insert({j, k, l});
          }
      chain = i % 3 == 2 ? subtract(chain, next, WindingRule::positive, Pieces::of_polygons)
                         : unite(chain, next, WindingRule::positive, Pieces::of_polygons);
    }
    expect_closed(chain);
    EXPECT_EQ(exact_volume(chain), Rational(cells.size()));
    EXPECT_TRUE(symmetric_difference(chain, exact_mesh(solids::voxels(cells))).triangles.empty());
    const RoundedMesh rounded = round(chain);
    EXPECT_TRUE(rounded.sound);
    EXPECT_EQ(rounded.moved, 0);  // polygons of a lattice have its points for corners
  }
}

TEST(ExactInput, ACommonPoseChangesNothing) {
  const RigidPose rigid{{3, 1, 2, 0.5}, {0.1, -7, 1e3}};
  const RigidChain chain{{rigid, {{1, 0, 0.3, 0}, {0, 0.7, 0}}}};
  const Pose sheared{{{{1, 0.1, 0}, {0.3, 2, 0}, {0, 0.7, 1}}}, {0.1, 0.2, 0.3}};
  const Pose mirror{{{{-1, 0.1, 0}, {0.3, 2, 0}, {0, 0.7, 1}}}, {0, 0, 0}};
  std::mt19937_64 random(7);
  const TriangleMesh a = heap(random, 3, 3), b = heap(random, 3, 3);
  const ExactMesh common = intersect(a, b), first = subtract(a, b);
  ASSERT_FALSE(common.triangles.empty());
  for (const PoseView pose : {PoseView(rigid), PoseView(chain), PoseView(sheared), PoseView(mirror)}) {
    const ExactMesh of_a = resolve(exact_mesh(a, pose)), of_b = resolve(exact_mesh(b, pose));
    EXPECT_GT(points_held(of_a), 8U);
    const ExactMesh posed_common = intersect(of_a, of_b), posed_first = subtract(of_a, of_b);
    expect_closed(posed_common);
    expect_closed(posed_first);
    EXPECT_TRUE(symmetric_difference(posed_common, exact_mesh(common, pose)).triangles.empty());
    EXPECT_TRUE(symmetric_difference(posed_first, exact_mesh(first, pose)).triangles.empty());
    EXPECT_EQ(exact_volume(of_a), exact_volume(posed_common) + exact_volume(posed_first));
    EXPECT_EQ(exact_volume(posed_common) * exact_volume(first), exact_volume(posed_first) * exact_volume(common));
  }
  EXPECT_EQ(exact_volume(intersect(exact_mesh(a, rigid), exact_mesh(b, rigid))), exact_volume(common));
  EXPECT_GT(exact_volume(exact_mesh(box({0, 0, 0}, {1, 1, 1}), mirror)), Rational(0));
}

TEST(ExactInput, FacesToFacesUnderOnePose) {
  // Boxes side by side, turned by a third: their common wall is gone, and all that lies in one plane is merged.
  const RigidPose pose{{1, 1, 1, 0.25}, {0.1, 0.2, 0.3}};
  const ExactMesh a = exact_mesh(Posed{box({0, 0, 0}, {1, 1, 1}), pose});
  const ExactMesh b = exact_mesh(Posed{box({1, 0, 0}, {2, 1, 1}), pose});
  EXPECT_TRUE(intersect(a, b).triangles.empty());
  EXPECT_EQ(unite(a, b).vertices.size(), 12U);
  const ExactMesh both = unite(a, b, WindingRule::positive, Pieces::of_polygons);
  EXPECT_EQ(both.triangles.size(), 12U);
  EXPECT_EQ(exact_volume(both), Rational(2));
  EXPECT_TRUE(round(both).sound);
}

TEST(ExactInput, IsInOrderWhateverWasGiven) {
  TriangleMesh twice = box({0, 0, 0}, {1, 2, 3});
  solids::append(twice, box({1, 2, 3}, {2, 3, 4}));  // has a corner in common
  const ExactMesh made = exact_mesh(twice);
  EXPECT_EQ(made.vertices.size(), 15U);
  expect_closed(made);
  EXPECT_EQ(made.sources.size(), 24U);
  ExactMesh held = made;  // the same, in other words
  for (ExactPoint3& p : held.vertices) p = ExactPoint3(rational_point(p));
  expect_equal(resolve(held), resolve(made));
  EXPECT_EQ(points_held(exact_mesh(held, identity_pose)), 0U);
}

TEST(ExactInput, RefusesByName) {
  ExactMesh open = exact_mesh(box({0, 0, 0}, {1, 1, 1}), RigidPose{{3, 1, 0, 0}, {0, 0, 0}});
  open.triangles.pop_back();
  open.sources.pop_back();
  EXPECT_THROW(resolve(open), UnbalancedEdge);
  open.triangles[0][0] = 99;
  EXPECT_THROW(resolve(open), InvalidShape);
  EXPECT_THROW(exact_mesh(open, identity_pose), InvalidShape);
  TriangleMesh bad = box({0, 0, 0}, {1, 1, 1});
  bad.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(exact_mesh(bad), NonFinite);
  EXPECT_THROW(exact_mesh(box({0, 0, 0}, {1, 1, 1}), RigidPose{{0, 0, 0, 0}, {0, 0, 0}}), InvalidShape);
  const Pose vast{{{{1e300, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};
  EXPECT_THROW(exact_mesh(box({0, 0, 0}, {1e100, 1, 1}), vast), BeyondDoubles);
  ExactMesh unnamed = open;
  unnamed.sources.clear();
  EXPECT_THROW(exact_mesh(unnamed, identity_pose), UnequalLengths);
}

}  // namespace
}  // namespace plumb
