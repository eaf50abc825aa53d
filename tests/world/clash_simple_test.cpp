// Simple solids: is each word the same where nothing is measured, though what does not meet is not arranged then, and which
// parts are simple?
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/world/clash.hpp"
#include "world/clash_contact.hpp"

namespace plumb {
namespace {

TriangleMesh moved(TriangleMesh mesh, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}
TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b, bool inside_out = false) {
  TriangleMesh made = a;
  solids::append(made, b, inside_out);
  return made;
}

/// One surface that is drawn: smooth or of cells, turned by a matrix that is not exact, and moved; or on a lattice.
TriangleMesh drawn_solid(std::mt19937_64& random) {
  std::uniform_int_distribution<int> kind(0, 3), place(-6, 6), odd(0, 1);
  TriangleMesh mesh;
  switch (kind(random)) {
    case 0:
      mesh = solids::torus(2, 0.75, 9, 6);
      break;
    case 1:
      mesh = solids::box({-3, -0.5, -0.5}, {3, 0.5, 0.5});
      break;
    case 2:
      mesh = moved(solids::voxels({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}), {-1, -1, 0});
      break;
    default:
      mesh = solids::box({-1, -1, -1}, {1, 1, 1});
  }
  if (odd(random) == 0) mesh = solids::turned(mesh);
  if (odd(random) == 0)
    for (Point3& p : mesh.vertices) p = {p.y, p.z, p.x};
  return moved(mesh, {place(random) / 4.0, place(random) / 4.0, place(random) / 4.0});
}

TEST(Clash, SaysTheSameWhereNothingIsMeasured) {
  std::map<ClashKind, int> said;
  int at_once = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const ClashPart a(drawn_solid(random)), b(drawn_solid(random));
    ASSERT_TRUE(a.is_simple() && b.is_simple());
    for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      const Clash measured = find_clash(*first, *second), word = find_clash(*first, *second, {.measure = false});
      EXPECT_EQ(name_of(word.kind), name_of(measured.kind));
      EXPECT_EQ(word.inner, measured.inner);
      EXPECT_EQ(word.place, measured.place);
      EXPECT_EQ(word.meeting, measured.meeting);
      EXPECT_FALSE(word.volume || word.depth);
    }
    const Clash clash = find_clash(a, b);
    ++said[clash.kind];
    const bool plain = !clash.meeting.empty() && world::stay_one_piece_each(a, b, clash.meeting);
    EXPECT_TRUE(!plain || clash.kind == ClashKind::overlapping);
    at_once += plain;
  }
  for (const ClashKind k : {ClashKind::apart, ClashKind::touching, ClashKind::overlapping, ClashKind::piercing})
    EXPECT_GE(said[k], 4) << name_of(k);
  EXPECT_GE(at_once, said[ClashKind::overlapping] / 3);
  EXPECT_GE(at_once, 30);
}

TEST(ClashPart, KnowsOneSurfaceFromOthers) {
  const TriangleMesh cube = solids::box({0, 0, 0}, {4, 4, 4});
  EXPECT_TRUE(ClashPart(cube).is_simple());
  EXPECT_TRUE(ClashPart(together({}, cube, true)).is_simple());
  EXPECT_TRUE(ClashPart(solids::torus(2, 1, 8, 5)).is_simple());
  EXPECT_FALSE(ClashPart(together(cube, moved(cube, {9, 0, 0}))).is_simple()) << "two";
  EXPECT_FALSE(ClashPart(together(cube, solids::box({1, 1, 1}, {2, 2, 2}), true)).is_simple()) << "hollow";
  EXPECT_FALSE(ClashPart(solids::torus(1, 2, 8, 5)).is_simple()) << "crosses itself";
  EXPECT_FALSE(ClashPart(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).is_simple()) << "a sheet";
  TriangleMesh flat = cube;  // a vertex that is moved into the edge beside it
  flat.vertices[0] = flat.vertices[1];
  EXPECT_FALSE(ClashPart(flat).is_simple());
  EXPECT_FALSE(ClashPart(TriangleMesh{}).is_simple());
  const ClashPart part(cube);
  ASSERT_TRUE(part.is_simple());
  for (std::uint32_t t = 0; t < cube.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& other = cube.triangles[part.neighbors()[t][k]];
      EXPECT_TRUE(std::ranges::count(other, cube.triangles[t][k]) == 1 &&
                  std::ranges::count(other, cube.triangles[t][(k + 1) % 3]) == 1);
    }
  }
}

}  // namespace
}  // namespace plumb
