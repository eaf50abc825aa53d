// Solids that a plane cuts: volumes, sides and closedness of the halves, against operations with boxes.
#include "plumb/surface/solid/split.hpp"

#include <gtest/gtest.h>

#include "plumb/predicates.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/round.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::exact_mesh_of, solid_laws::expect_closed, solid_laws::expect_equal;
using solids::box, solids::heap;

/// The number of triangles in the plane.
std::size_t expect_halves(const ExactMesh& mesh, const AnyPlane3& plane) {
  const SplitSolid halves = split(mesh, plane);
  std::size_t cut = 0;
  for (const bool is_above : {true, false}) {
    const ExactMesh& half = is_above ? halves.above : halves.below;
    expect_closed(half);
    std::vector<Sign> sides;
    for (const ExactPoint3& v : half.vertices) {
      const RationalPoint3 p = rational_point(v);
      if (const auto* const by_normal = std::get_if<Plane3>(&plane)) {
        const Vector3& n = by_normal->normal;
        sides.push_back(
            (Rational(n.x) * p.x + Rational(n.y) * p.y + Rational(n.z) * p.z - Rational(by_normal->offset)).sign());
      } else {
        const auto& [a, b, c] = std::get<ThreePointPlane3>(plane);
        // Of the unit corner the sign says which side of a counterclockwise triangle is positive.
        const Sign unit = orient3d(Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1});
        sides.push_back(orient3d(ExactPoint3(a), ExactPoint3(b), ExactPoint3(c), v) * unit);
      }
      EXPECT_TRUE(sides.back() == Sign::zero || (sides.back() == Sign::positive) == is_above);
    }
    for (std::size_t t = 0; t < half.triangles.size(); ++t) {
      if (half.sources[t] != cut_face) continue;
      ++cut;
      for (const std::uint32_t v : half.triangles[t]) EXPECT_EQ(sides[v], Sign::zero);
    }
    if (!half.triangles.empty()) {
      EXPECT_EQ(exact_volume(half).sign(), Sign::positive);
    }
  }
  EXPECT_EQ(exact_volume(halves.above) + exact_volume(halves.below), exact_volume(mesh));
  return cut;
}

TEST(Split, CubesAtEveryHeight) {
  const ExactMesh cube = resolve(box({0, 0, 0}, {2, 2, 2}));
  EXPECT_EQ(expect_halves(cube, Plane3{{0, 0, 1}, 1}), 2 * 6U);  // eight corners a cap: diagonals are cut as well
  EXPECT_EQ(split(cube, Plane3{{0, 0, 1}, 0}).below.triangles.size(), 0U);
  EXPECT_EQ(split(cube, Plane3{{0, 0, 1}, 0}).above.triangles.size(), 12U);
  EXPECT_EQ(split(cube, Plane3{{0, 0, 1}, 2}).above.triangles.size(), 0U);
  expect_equal(split(cube, Plane3{{0, 0, 1}, -1}).above, cube);
  // Through two edges, and through corners alone.
  EXPECT_EQ(expect_halves(cube, Plane3{{1, -1, 0}, 0}), 4U);
  EXPECT_GT(expect_halves(cube, Plane3{{1, 1, 1}, 2}), 1U);
  EXPECT_GT(expect_halves(cube, Plane3{{1, 1, 1}, 3}), 7U);
  EXPECT_EQ(exact_volume(split(cube, Plane3{{1, 1, 1}, 2}).below), Rational(4, 3));
  EXPECT_EQ(exact_volume(split(cube, ThreePointPlane3{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}).below), Rational(4, 3));
  EXPECT_EQ(exact_volume(split(cube, ThreePointPlane3{{0, 2, 0}, {2, 0, 0}, {0, 0, 2}}).above), Rational(4, 3));
}

TEST(Split, VoidsAndTouchingSolids) {
  TriangleMesh hollow = box({0, 0, 0}, {4, 4, 4});
  solids::append(hollow, box({1, 1, 1}, {3, 3, 3}), true);
  const ExactMesh ring = resolve(hollow);
  expect_halves(ring, Plane3{{0, 0, 1}, 2});
  expect_halves(ring, Plane3{{0, 0, 1}, 1});  // the void's bottom lies in the plane
  expect_halves(ring, Plane3{{0, 0, 1}, 3});
  expect_halves(ring, Plane3{{1, 2, 3}, 11});
  const ExactMesh touching = unite(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}));
  expect_halves(touching, Plane3{{1, 0, 0}, 1});
  expect_halves(touching, Plane3{{1, 1, 0}, 2});
  expect_halves(touching, Plane3{{1, -1, 0}, 0});
  expect_halves(touching, Plane3{{0, 0, 1}, 0.5});
}

TEST(Split, HeapsByPlanesThroughTheirVertices) {
  std::size_t cut = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const ExactMesh solid = unite(heap(random, 2, 2), heap(random, 2, 2));
    if (solid.vertices.empty()) continue;  // heaps may be inside out
    std::uniform_int_distribution<int> number(-4, 4);
    const Vector3 normal{double(number(random)), double(number(random)), double(number(random) * 2 + 1)};
    cut += expect_halves(solid, Plane3{normal, double(number(random))});
    const auto corner = [&] { return approximate(solid.vertices[random() % solid.vertices.size()]); };
    const ThreePointPlane3 plane{corner(), corner(), corner()};
    if (!collinear(ExactPoint3(plane.a), ExactPoint3(plane.b), ExactPoint3(plane.c)))
      cut += expect_halves(solid, plane);
    const double at = number(random) / 2.0;
    const ExactMesh below = split(solid, Plane3{{0, 1, 0}, at}).below;
    // Two planes in either order.
    const SplitSolid again = split(below, Plane3{{0, 0, 1}, at}), other = split(solid, Plane3{{0, 0, 1}, at});
    EXPECT_EQ(exact_volume(again.below), exact_volume(split(other.below, Plane3{{0, 1, 0}, at}).below));
    EXPECT_TRUE(round(below).sound);
    if (HasFailure()) return;
  }
  EXPECT_GT(cut, 500U);
}

TEST(Split, AsABoxTakesIt) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh solid = heap(random, 3, 2);
    const double at = std::uniform_int_distribution<int>(-8, 8)(random) / 4.0;
    const SplitSolid halves = split(resolve(solid), Plane3{{1, 0, 0}, at});
    const TriangleMesh knife = box({-100, -100, -100}, {at, 100, 100});
    EXPECT_EQ(exact_volume(halves.below), exact_volume(intersect(solid, knife)));
    EXPECT_EQ(exact_volume(halves.above), exact_volume(subtract(solid, knife)));
  }
}

TEST(Split, RefusesWhatBoundsNothing) {
  TriangleMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  ExactMesh exact = exact_mesh_of(open);
  EXPECT_THROW(split(exact, Plane3{{0, 0, 1}, 0.5}), UnequalLengths);
  exact.sources.resize(exact.triangles.size());
  EXPECT_THROW(split(exact, Plane3{{1, 1, 1}, 1.5}), InvalidShape);
  const ExactMesh cube = resolve(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_THROW(split(cube, Plane3{{0, 0, 0}, 1}), InvalidShape);
  EXPECT_THROW(split(cube, ThreePointPlane3{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), InvalidShape);
  EXPECT_TRUE(split(ExactMesh{}, Plane3{{0, 0, 1}, 0}).above.triangles.empty());
}

}  // namespace
}  // namespace plumb
