// Faces of one plane in pieces: each piece is covered by just the faces around its middle, areas are equal in rationals,
// and what nothing cuts is told whole.
#include "surface/solid/plane_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/predicates.hpp"
#include "plumb/space/bvh/build.hpp"

namespace plumb {
namespace {

using surface::FacePool, surface::PlaneClass, surface::PlaneClasses, surface::PlanePiece, surface::PlaneView;
using surface::PointTable;

/// Points of a lattice on a slope, in order; triangles of them that may overlap as they like.
FacePool random_faces(std::mt19937_64& random, int count) {
  FacePool pool;
  pool.meshes = 1;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y) pool.mesh.vertices.push_back({double(x), double(y), double(x + 2 * y)});
  std::uniform_int_distribution<std::uint32_t> vertex(0, 24);
  std::vector<surface::PooledTriangle> triangles;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    TriangleMesh::Triangle corners{vertex(random), vertex(random), vertex(random)};
    std::ranges::sort(corners);
    if (corners[0] != corners[1] && corners[1] != corners[2]) triangles.push_back({corners, {{0, i}, false}});
  }
  surface::add_faces(pool, std::move(triangles));
  return pool;
}

Rational twice_the_area(const std::array<RationalPoint3, 3>& t) {  // seen along z
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
}
Rational size_of(const std::array<RationalPoint3, 3>& t) {
  const Rational area = twice_the_area(t);
  return area.sign() == Sign::negative ? -area : area;
}
/// The middle of a piece is on no edge of what divides it.
bool surrounds(const std::array<RationalPoint3, 3>& t, const RationalPoint3& p) {
  const Sign turn = twice_the_area(t).sign();
  for (std::size_t k = 0; k < 3; ++k)
    if (twice_the_area({t[k], t[(k + 1) % 3], p}).sign() != turn) return false;
  return true;
}

TEST(PlanePieces, AreCoveredByTheFacesAroundTheirMiddles) {
  std::size_t pieces = 0, covered_twice = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const FacePool pool = random_faces(random, 2 + static_cast<int>(seed % 6));
    PointTable table(pool.mesh.vertices);
    const PlaneClasses classes = surface::find_plane_classes(pool, build_bvh(pool.mesh), table);
    std::vector<Rational> left;  // of the faces' areas
    for (std::uint32_t f = 0; f < pool.mesh.triangles.size(); ++f) {
      std::array<RationalPoint3, 3> t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = rational_point(ExactPoint3(pool.points_of(f)[k]));
      left.push_back(size_of(t));
    }
    for (const std::uint32_t face : classes.whole) left[face] = 0;
    for (const PlaneClass& of : classes.cut) {
      const PlaneView view(pool.points(), pool.mesh.triangles[of.faces.front()]);
      const surface::PlanePieces divided = surface::divide_plane(pool, table, of, view);
      for (const PlanePiece& piece : divided.pieces) {
        std::array<RationalPoint3, 3> t;
        for (std::size_t k = 0; k < 3; ++k) t[k] = rational_point(table.points().at(piece.corners[k]));
        const Rational third(1, 3);
        const RationalPoint3 middle{(t[0].x + t[1].x + t[2].x) * third, (t[0].y + t[1].y + t[2].y) * third, 0};
        std::vector<std::uint32_t> told, by_definition;
        for (const surface::CoveringFace& by : piece.covers) {
          told.push_back(by.face);
          left[by.face] = left[by.face] - size_of(t);
        }
        for (const std::uint32_t f : of.faces) {
          std::array<RationalPoint3, 3> face;
          for (std::size_t k = 0; k < 3; ++k) face[k] = rational_point(ExactPoint3(pool.points_of(f)[k]));
          if (!surrounds(face, middle)) continue;
          by_definition.push_back(f);
          const auto at = std::ranges::find(piece.covers, f, &surface::CoveringFace::face);
          ASSERT_NE(at, piece.covers.end());
          EXPECT_EQ(at->opposite, twice_the_area(face).sign() != twice_the_area(t).sign());
        }
        EXPECT_EQ(told, by_definition);
        ++pieces;
        covered_twice += told.size() > 1 ? 1 : 0;
      }
    }
    for (const Rational& rest : left) EXPECT_EQ(rest, Rational(0));
    if (HasFailure()) return;
  }
  EXPECT_GT(pieces, 500U);
  EXPECT_GT(covered_twice, 100U);
}

TEST(PlanePieces, WhatNothingCutsIsWholeAndConstructsNothing) {
  const TriangleMesh torus = solids::torus(3, 1, 24, 12);
  const FacePool pool = surface::pool_faces(std::vector{torus, torus});
  PointTable table(pool.mesh.vertices);
  const PlaneClasses classes = surface::find_plane_classes(pool, build_bvh(pool.mesh), table);
  EXPECT_EQ(classes.whole.size(), torus.triangles.size());
  EXPECT_TRUE(classes.cut.empty());
  EXPECT_EQ(table.size(), torus.vertices.size());
}

}  // namespace
}  // namespace plumb
