// Pieces merged: the same solids by exact volume and by an independent count of windings, of the fewest triangles where
// these are known.
#include "plumb/surface/solid/merge_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "plumb/surface/solid/round.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::expect_closed, solid_laws::expect_equal, solid_laws::winding_by_definition;
using solids::box, solids::heap;

/// What is merged is closed, as large, not larger in triangles, and merged once for all.
ExactMesh merged_and_checked(const ExactMesh& mesh) {
  ExactMesh merged = merge_pieces(mesh);
  expect_closed(merged);
  EXPECT_EQ(exact_volume(merged), exact_volume(mesh));
  EXPECT_LE(merged.triangles.size(), mesh.triangles.size());
  expect_equal(merge_pieces(merged), merged);
  return merged;
}

/// The unit cells of a slab of n times n, whose walls between cancel.
TriangleMesh slab(int n, double shift) {
  std::set<solids::Cell> cells;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y) cells.insert({x, y, 0});
  TriangleMesh made = solids::voxels(cells);
  for (Point3& p : made.vertices) p = {p.x + shift, p.y, p.z};
  return made;
}

/// A block of n by n by n cells whose surface is cut along them, each coordinate a sum of lattice coordinates.
TriangleMesh gridded_block(std::uint32_t n, const Point3& from, bool skewed) {
  TriangleMesh mesh;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number;
  const auto vertex = [&](std::array<std::uint32_t, 3> at) {
    const auto [found, is_new] = number.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
    const double x = from.x + at[0], y = from.y + at[1], z = from.z + at[2];
    if (is_new) mesh.vertices.push_back(skewed ? Point3{x + 2 * y - z, 3 * y + z, x + 5 * z - y} : Point3{x, y, z});
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::uint32_t height : {0U, n}) {
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
          const auto at = [&](std::uint32_t u, std::uint32_t v) {
            std::array<std::uint32_t, 3> p{};
            p[axis] = height, p[(axis + 1) % 3] = u, p[(axis + 2) % 3] = v;
            return vertex(p);
          };
          TriangleMesh::Triangle one{at(i, j), at(i + 1, j), at(i, j + 1)};
          TriangleMesh::Triangle two{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if (height == 0) std::swap(one[1], one[2]), std::swap(two[1], two[2]);
          mesh.triangles.push_back(one), mesh.triangles.push_back(two);
        }
      }
    }
  }
  return mesh;
}

/// In how many planes are the triangles?
std::size_t planes_of(const ExactMesh& mesh) {
  std::set<std::array<Rational, 4>> planes;
  for (const auto& [a, b, c] : mesh.triangles) {
    const RationalPoint3 p = rational_point(mesh.vertices[a]), q = rational_point(mesh.vertices[b]),
                         r = rational_point(mesh.vertices[c]);
    const Rational ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z, vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
    std::array<Rational, 4> n{uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, 0};
    n[3] = n[0] * p.x + n[1] * p.y + n[2] * p.z;
    Rational first = n[0].sign() != Sign::zero ? n[0] : n[1].sign() != Sign::zero ? n[1] : n[2];
    if (first.sign() == Sign::negative) first = -first;
    for (Rational& x : n) x = x / first;
    planes.insert(n);
  }
  return planes.size();
}

TEST(MergePieces, SlabsHalfACellApartAreTwelveTriangles) {
  const ExactMesh both = unite(slab(12, 0), slab(12, 0.5));
  EXPECT_GT(both.triangles.size(), 500U);
  const ExactMesh merged = merged_and_checked(both);
  EXPECT_EQ(merged.triangles.size(), 12U);
  EXPECT_EQ(merged.vertices.size(), 8U);
  EXPECT_TRUE(round(merged).sound);
}

TEST(MergePieces, BlocksHalfACellApartAreABox) {
  for (const bool skewed : {false, true}) {
    for (const double apart : {0.5, 1.0, 0.25}) {
      const ExactMesh both = unite(gridded_block(3, {0, 0, 0}, skewed), gridded_block(3, {apart, 0, 0}, skewed));
      const ExactMesh merged = merged_and_checked(both);
      EXPECT_GT(both.triangles.size(), 108U);
      EXPECT_EQ(merged.triangles.size(), 12U) << skewed << apart;
      EXPECT_EQ(merged.vertices.size(), 8U);
      EXPECT_TRUE(round(merged).sound);
    }
  }
}

TEST(MergePieces, SolidsThatTouchAtAnEdgeKeepIt) {
  for (const Point3& at : {Point3{2, 2, 0.5}, Point3{2, 2, 2}, Point3{2, 0.5, 0.5}}) {
    const ExactMesh both = unite(gridded_block(2, {0, 0, 0}, false), gridded_block(2, at, false));
    const ExactMesh merged = merged_and_checked(both);
    EXPECT_LT(merged.triangles.size(), both.triangles.size());
    EXPECT_TRUE(round(merged).sound);
  }
}

TEST(MergePieces, AHoleThroughABlock) {
  const ExactMesh drilled = merged_and_checked(subtract(box({0, 0, 0}, {3, 3, 3}), box({1, 1, -1}, {2, 2, 4})));
  EXPECT_EQ(drilled.triangles.size(), 32U);  // twice 8 + 2 - 2 around the hole, and eight rectangles
}

TEST(MergePieces, ATriangleWithoutASourceIsRefused) {
  ExactMesh mesh = resolve(box({0, 0, 0}, {1, 1, 1}));
  mesh.sources.pop_back();
  EXPECT_THROW(merge_pieces(mesh), UnequalLengths);
}

TEST(MergePieces, NothingIsMergedWhereNothingLiesInOnePlane) {
  const TriangleMesh a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const ExactMesh one = resolve(a);
  expect_equal(merge_pieces(one), one);
  EXPECT_TRUE(merge_pieces(ExactMesh{}).triangles.empty());
}

TEST(MergePieces, ATipInTheMidstOfAFaceStays) {
  const TriangleMesh tip{{{1, 2, 2}, {1, 1, 4}, {3, 1, 4}, {2, 3, 4}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  const ExactMesh both = unite(box({0, 0, 0}, {4, 4, 2}), tip);
  const ExactMesh merged = merged_and_checked(both);
  EXPECT_EQ(merged.triangles.size(), 10U + 4U + 4U);  // four around the point, and those of the tip
  EXPECT_TRUE(round(merged).sound);
}

TEST(MergePieces, ARidgeOnAFaceStays) {
  // The edge of the roof that is upside down lies in the midst of the box's face: more than two triangles have it.
  const TriangleMesh roof{{{1, 2, 2}, {3, 2, 2}, {1, 1, 4}, {3, 1, 4}, {1, 3, 4}, {3, 3, 4}},
                          {{0, 1, 3}, {0, 3, 2}, {1, 0, 4}, {1, 4, 5}, {2, 3, 5}, {2, 5, 4}, {0, 2, 4}, {1, 5, 3}}};
  const ExactMesh both = unite(box({0, 0, 0}, {4, 4, 2}), roof, WindingRule::nonzero);
  const ExactMesh merged = merged_and_checked(both);
  EXPECT_EQ(merged.triangles.size(), 10U + 6U + 8U);  // a slit: 4 + 2 + 2 - 2
  EXPECT_TRUE(round(merged).sound);
}

TEST(MergePieces, LatticeBoxesAreSoundInAnyOrder) {
  std::size_t fewer = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> at(0, 4), size(1, 3);
    std::vector<TriangleMesh> meshes;
    std::set<solids::Cell> some;
    for (int i = 0; i < 8; ++i) {
      const int x = at(random), y = at(random), z = at(random), u = size(random), v = size(random), w = size(random);
      meshes.push_back(box({double(x), double(y), double(z)}, {double(x + u), double(y + v), double(z + w)}));
      for (int j = x; j < x + u; ++j)
        for (int k = y; k < y + v; ++k)
          for (int l = z; l < z + w; ++l)
            if (!some.insert({j, k, l}).second) some.erase({j, k, l});
    }
    const ExactMesh odd = symmetric_difference(meshes), merged = merged_and_checked(odd);
    fewer += odd.triangles.size() - merged.triangles.size();
    EXPECT_EQ(exact_volume(merged), Rational(some.size()));
    // Every corner is one of the lattice: the diagonals' crossings are gone.
    EXPECT_EQ(round(merged).moved, 0);
    EXPECT_TRUE(round(merged).sound);
    // Of single cells the same corners come; diagonals of faces that had the fewest triangles before are as given.
    const ExactMesh of_cells = merge_pieces(resolve(solids::voxels(some)));
    EXPECT_EQ(of_cells.triangles.size(), merged.triangles.size());
    EXPECT_TRUE(std::ranges::equal(of_cells.vertices, merged.vertices));
    // The same of triangles and meshes in another order.
    std::ranges::reverse(meshes);
    for (TriangleMesh& mesh : meshes) std::ranges::shuffle(mesh.triangles, random);
    expect_equal(merge_pieces(symmetric_difference(meshes)), merged);
    if (HasFailure()) return;
  }
  EXPECT_GT(fewer, 1000U);
}

TEST(MergePieces, BoxesCutByASkewBlock) {
  std::size_t fewer = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 source(seed);
    std::uniform_int_distribution<int> at(0, 5), size(1, 3);
    std::vector<TriangleMesh> boxes;
    for (int k = 0; k < 4; ++k) {
      const Point3 low{static_cast<double>(at(source)), static_cast<double>(at(source)),
                       static_cast<double>(at(source))};
      boxes.push_back(box(low, {low.x + size(source), low.y + size(source), low.z + size(source)}));
    }
    // A skew block cuts them at points that no doubles hold.
    const TriangleMesh skew = gridded_block(1, {0.25, 0.5, 0.5}, true);
    boxes.push_back(skew);
    for (const ExactMesh& made : {unite(boxes), symmetric_difference(boxes), subtract(boxes)}) {
      const ExactMesh merged = merged_and_checked(made);
      EXPECT_EQ(planes_of(merged), planes_of(made));
      fewer += merged.triangles.size() < made.triangles.size() ? 1 : 0;
    }
    std::vector<TriangleMesh> reversed(boxes.rbegin(), boxes.rend());
    expect_equal(merge_pieces(unite(reversed)), merge_pieces(unite(boxes)));
  }
  EXPECT_GT(fewer, 80U);
}

TEST(MergePieces, HeapsWindAsBefore) {
  std::size_t judged = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = heap(random, 3, 2), b = heap(random, 2, 2);
    const ExactMesh both = unite(a, b), merged = merged_and_checked(both);
    std::uniform_int_distribution<int> coordinate(-9, 9);
    for (int i = 0; i < 12; ++i) {
      const auto next = [&] { return Rational(coordinate(random), 4); };
      const RationalPoint3 p{next(), next(), next()};
      const auto before = winding_by_definition(both, p);
      EXPECT_EQ(winding_by_definition(merged, p), before);
      judged += before.has_value() ? 1 : 0;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(judged, 100U);
}

}  // namespace
}  // namespace plumb
