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

TEST(Clash, SaysTheSameOfSimpleSolidsAsWhereAllIsArranged) {
  std::map<ClashKind, int> said;
  int at_once = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh mesh_a = drawn_solid(random), mesh_b = drawn_solid(random);
    // A part with a piece that is far off is not simple.
    const TriangleMesh far = moved(solids::box({0, 0, 0}, {1, 1, 1}), {99, 99, 99});
    const ClashPart a(together({}, mesh_a, seed % 3 == 0)), b(together({}, mesh_b, seed % 5 == 0));
    const ClashPart two(together(mesh_a, far));
    ASSERT_TRUE(a.is_simple() && b.is_simple() && !two.is_simple());
    const Clash clash = find_clash(a, b), other = find_clash(b, a), word = find_clash(a, b, {.measure = false});
    const Clash arranged = find_clash(two, b);
    // The piece that is far off is outside of the other, so that what was enclosed or a duplicate is not.
    const bool whole = clash.kind == ClashKind::enclosed || clash.kind == ClashKind::duplicate;
    if (!whole) {
      EXPECT_EQ(name_of(clash.kind), name_of(arranged.kind));
    }
    EXPECT_EQ(name_of(other.kind), name_of(clash.kind));
    EXPECT_EQ(name_of(word.kind), name_of(clash.kind));
    EXPECT_EQ(clash.volume, arranged.volume);
    EXPECT_EQ(clash.volume, other.volume);
    EXPECT_EQ(clash.place, arranged.place);
    EXPECT_EQ(word.place, arranged.place);
    EXPECT_EQ(word.meeting, arranged.meeting);
    EXPECT_FALSE(word.volume || word.depth);
    ASSERT_EQ(clash.depth.has_value(), other.depth.has_value());
    if (clash.depth) {
      EXPECT_EQ(clash.depth->lower, other.depth->lower);
      EXPECT_EQ(clash.depth->upper, other.depth->upper);
      EXPECT_LE(clash.depth->lower, clash.depth->upper);
    }
    // Of parts that are not convex the deepest corner is that which the arrangement has.
    if (clash.depth && clash.depth->lower != clash.depth->upper && arranged.depth->lower != arranged.depth->upper) {
      EXPECT_EQ(clash.depth->lower, std::min(clash.depth->upper, arranged.depth->lower));
    }
    ++said[clash.kind];
    const auto common =
        clash.meeting.empty() ? std::nullopt : world::common_of_one_piece_each(a, b, clash.meeting, true);
    EXPECT_TRUE(!common || clash.kind == ClashKind::overlapping);
    at_once += common ? 1 : 0;
  }
  for (const ClashKind k : {ClashKind::apart, ClashKind::touching, ClashKind::overlapping, ClashKind::piercing})
    EXPECT_GE(said[k], 4) << name_of(k);
  EXPECT_GE(at_once, said[ClashKind::overlapping] / 3);
  EXPECT_GE(at_once, 30);
}

TEST(Clash, MeasuresWhatNoDoubleTellsFromZero) {
  TriangleMesh tiny = solids::turned(solids::box({0, 0, 0}, {4, 4, 4}));
  for (Point3& p : tiny.vertices) p = {p.x * 0x1p-900, p.y * 0x1p-900, p.z * 0x1p-900};
  const ClashPart part(tiny), other(moved(tiny, {0x1p-900, 0x1p-901, 0x1p-902}));
  EXPECT_TRUE(part.is_simple());
  EXPECT_EQ(part.hull().volume_of_part, 0);
  const Clash clash = find_clash(part, other);
  EXPECT_EQ(clash.kind, ClashKind::overlapping);
  EXPECT_EQ(clash.volume, 0);
  EXPECT_TRUE(clash.depth.has_value());
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
