// Boolean operations on solids, against volumes in rationals and an independent count of windings.
#include "plumb/surface/solid/boolean.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plumb/surface/solid/round.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::exact_mesh_of, solid_laws::expect_closed, solid_laws::expect_equal, solid_laws::volume_of;
using solid_laws::winding_by_definition;
using solids::box, solids::heap;

struct All {
  ExactMesh both, common, first_only, second_only, either;
};

All checked(const TriangleMesh& a, const TriangleMesh& b) {
  const std::vector<TriangleMesh> meshes{a, b};
  const Arrangement arrangement = arrange(meshes);
  const auto where = [&](bool (*rule)(bool, bool)) {
    return solid_where(arrangement, [rule](std::span<const std::int32_t> w) { return rule(w[0] > 0, w[1] > 0); });
  };
  const All all{where([](bool l, bool r) { return l || r; }), where([](bool l, bool r) { return l && r; }),
                where([](bool l, bool r) { return l && !r; }), where([](bool l, bool r) { return r && !l; }),
                where([](bool l, bool r) { return l != r; })};
  for (const ExactMesh* m : {&all.both, &all.common, &all.first_only, &all.second_only, &all.either}) expect_closed(*m);
  const Rational of_a = volume_of(a), of_b = volume_of(b);
  EXPECT_EQ(of_a + of_b, exact_volume(all.both) + exact_volume(all.common));
  EXPECT_EQ(of_a, exact_volume(all.common) + exact_volume(all.first_only));
  EXPECT_EQ(of_b, exact_volume(all.common) + exact_volume(all.second_only));
  EXPECT_EQ(exact_volume(all.either), exact_volume(all.first_only) + exact_volume(all.second_only));
  expect_equal(unite(b, a), all.both);
  return all;
}

TEST(Boolean, BoxesThatOverlap) {
  const All all = checked(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
  EXPECT_EQ(exact_volume(all.both), Rational(15));
  EXPECT_EQ(exact_volume(all.common), Rational(1));
  EXPECT_EQ(exact_volume(all.first_only), Rational(7));
}

TEST(Boolean, BoxesFaceToFace) {
  const All all = checked(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}));
  EXPECT_EQ(exact_volume(all.both), Rational(2));
  EXPECT_TRUE(all.common.triangles.empty());
  EXPECT_TRUE(all.common.vertices.empty());
}

TEST(Boolean, BoxesFaceToFaceMoved) {
  const All all = checked(box({0, 0, 0}, {1, 1, 1}), box({1, 0.25, 0.5}, {2, 1.25, 1.5}));
  EXPECT_EQ(exact_volume(all.both), Rational(2));
  EXPECT_TRUE(all.common.triangles.empty());
}

TEST(Boolean, AMeshWithItself) {
  const TriangleMesh a = box({0, 0, 0}, {1, 2, 3});
  const All all = checked(a, a);
  EXPECT_EQ(all.both.triangles.size(), 12U);
  EXPECT_TRUE(all.either.triangles.empty());
}

TEST(Boolean, Nested) {
  const All all = checked(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(exact_volume(all.first_only), Rational(63));
  EXPECT_EQ(all.first_only.triangles.size(), 24U);
}

TEST(Boolean, TouchingAtAnEdgeAVertexAndAPointOfAFace) {
  const TriangleMesh a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(checked(a, box({1, 1, 0}, {2, 2, 1})).both.triangles.size(), 24U);
  EXPECT_EQ(checked(a, box({1, 1, 1}, {2, 2, 2})).both.triangles.size(), 24U);
  const TriangleMesh tip{{{0.5, 0.25, 1}, {0, 0, 2}, {1, 0, 2}, {0.5, 1, 2}},
                         {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  checked(a, tip);
}

/// Random points of a grid, some of them on planes and edges of the meshes: those on no surface are judged.
void expect_membership(const std::vector<TriangleMesh>& meshes, const ExactMesh& result, std::mt19937_64& random,
                       std::size_t& judged, std::size_t& inside,
                       const std::function<bool(const std::vector<int>&)>& rule) {
  std::vector<ExactMesh> exact;
  for (const TriangleMesh& m : meshes) exact.push_back(exact_mesh_of(m));
  std::uniform_int_distribution<int> coordinate(-9, 9);
  for (int i = 0; i < 12; ++i) {
    const Rational fourth(1, 4);
    const RationalPoint3 p{Rational(coordinate(random)) * fourth, Rational(coordinate(random)) * fourth,
                           Rational(coordinate(random)) * fourth};
    std::vector<int> windings;
    for (const ExactMesh& m : exact)
      if (const auto w = winding_by_definition(m, p)) windings.push_back(*w);
    if (windings.size() != meshes.size()) continue;
    const auto told = winding_by_definition(result, p);
    ASSERT_TRUE(told.has_value());
    EXPECT_EQ(*told, rule(windings) ? 1 : 0);
    ++judged;
    inside += rule(windings) ? 1 : 0;
  }
}

TEST(Boolean, HeapsAgainstWindingsByDefinition) {
  std::size_t judged = 0, inside = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = heap(random, 3, 2), b = heap(random, 2, 2);
    const std::vector<TriangleMesh> meshes{a, b};
    const ExactMesh both = unite(a, b), common = intersect(a, b), first = subtract(a, b),
                    either = symmetric_difference(a, b), of_a = resolve(a), of_b = resolve(b);
    for (const ExactMesh* m : {&both, &common, &first, &either, &of_a, &of_b}) expect_closed(*m);
    EXPECT_EQ(exact_volume(of_a) + exact_volume(of_b), exact_volume(both) + exact_volume(common));
    EXPECT_EQ(exact_volume(of_a), exact_volume(common) + exact_volume(first));
    EXPECT_EQ(exact_volume(either) + exact_volume(common), exact_volume(both));
    using W = const std::vector<int>&;
    expect_membership(meshes, both, random, judged, inside, [](W w) { return w[0] > 0 || w[1] > 0; });
    expect_membership(meshes, common, random, judged, inside, [](W w) { return w[0] > 0 && w[1] > 0; });
    expect_membership(meshes, first, random, judged, inside, [](W w) { return w[0] > 0 && w[1] <= 0; });
    expect_membership(meshes, either, random, judged, inside, [](W w) { return (w[0] > 0) != (w[1] > 0); });
    expect_membership({a}, resolve(a, WindingRule::nonzero), random, judged, inside, [](W w) { return w[0] != 0; });
    expect_membership({a}, resolve(a, WindingRule::odd), random, judged, inside, [](W w) { return w[0] % 2 != 0; });
    if (HasFailure()) return;
  }
  EXPECT_GT(judged, 500U);
  EXPECT_GT(inside, 25U);
  EXPECT_LT(inside, judged / 2);
}

TEST(Boolean, LatticeBoxesAgainstVoxels) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> at(0, 4), size(1, 3);
    std::vector<TriangleMesh> meshes;
    std::set<solids::Cell> all, some;
    for (int i = 0; i < 8; ++i) {
      const int x = at(random), y = at(random), z = at(random), u = size(random), v = size(random), w = size(random);
      meshes.push_back(box({double(x), double(y), double(z)}, {double(x + u), double(y + v), double(z + w)}));
      for (int j = x; j < x + u; ++j)
        for (int k = y; k < y + v; ++k)
          for (int l = z; l < z + w; ++l) {
            all.insert({j, k, l});
            if (!some.insert({j, k, l}).second) some.erase({j, k, l});
          }
    }
    const ExactMesh both = unite(meshes), odd = symmetric_difference(meshes);
    expect_closed(both);
    expect_closed(odd);
    EXPECT_EQ(exact_volume(both), Rational(all.size()));
    EXPECT_EQ(exact_volume(odd), Rational(some.size()));
    // In turn and all at once, and against the cells themselves: the same set of points.
    const std::vector<TriangleMesh> halves{solids::voxels(all), solids::voxels(some)};
    std::vector<TriangleMesh> three = meshes;
    three.push_back(halves[0]);
    const ExactMesh apart = solid_where(three, [](std::span<const std::int32_t> w) {
      bool in_any = false;
      for (const std::int32_t n : w.first(w.size() - 1)) in_any = in_any || n > 0;
      return in_any != (w.back() > 0);
    });
    EXPECT_TRUE(apart.triangles.empty());
  }
}

TEST(Boolean, PowersOfTwoChangeNothing) {
  std::mt19937_64 random(7);
  const TriangleMesh a = heap(random, 4, 3), b = heap(random, 4, 3);
  const ExactMesh plain = subtract(a, b);
  ASSERT_FALSE(plain.triangles.empty());
  for (const int exponent : {-300, 300}) {
    std::vector<TriangleMesh> scaled{a, b};
    for (TriangleMesh& mesh : scaled)
      for (Point3& p : mesh.vertices)
        p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    const ExactMesh other = subtract(scaled);
    EXPECT_EQ(other.triangles, plain.triangles);
    EXPECT_EQ(other.sources, plain.sources);
    const Rational factor(std::ldexp(1.0, exponent));
    EXPECT_EQ(exact_volume(other), exact_volume(plain) * factor * factor * factor);
  }
}

TEST(Boolean, SixtyLatticeBoxesAtOnceAreSoundWhenRounded) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> at(0, 9), size(1, 3);
    std::vector<TriangleMesh> meshes;
    std::set<solids::Cell> in_turn;  // united and subtracted in turn
    for (int i = 0; i < 60; ++i) {
      const int x = at(random), y = at(random), z = at(random), u = size(random), v = size(random), w = size(random);
      meshes.push_back(box({double(x), double(y), double(z)}, {double(x + u), double(y + v), double(z + w)}));
      for (int j = x; j < x + u; ++j)
        for (int k = y; k < y + v; ++k)
          for (int l = z; l < z + w; ++l) {
            if (i % 3 == 2)
              in_turn.erase({j, k, l});
            else
              in_turn.insert({j, k, l});
          }
    }
    const ExactMesh chain = solid_where(meshes, [](std::span<const std::int32_t> w) {
      bool inside = false;
      for (std::size_t i = 0; i < w.size(); ++i)
        if (w[i] > 0) inside = i % 3 != 2;
      return inside;
    });
    expect_closed(chain);
    EXPECT_EQ(exact_volume(chain), Rational(in_turn.size()));
    const RoundedMesh rounded = round(chain);
    EXPECT_TRUE(rounded.sound);
    EXPECT_EQ(rounded.rounds, 1U);
    EXPECT_LT(rounded.moved, 1e-14);  // diagonals of faces cross where no doubles are
  }
}

}  // namespace
}  // namespace plumb
