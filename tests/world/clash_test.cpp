// Clashes: is the word for each pair of parts the one that cells of a lattice say, and that those say who built the
// parts: bolts in holes, panels face to face, gears in mesh, bars through plates, what is nested and what is there twice?
#include "plumb/world/clash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/surface/solid/exact_mesh.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solids::Cell;
using Cells = std::set<Cell>;

TriangleMesh moved(TriangleMesh mesh, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}
TriangleMesh inside_out(const TriangleMesh& mesh) {
  TriangleMesh made;
  solids::append(made, mesh, true);
  return made;
}
TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh made = a;
  solids::append(made, b);
  return made;
}

Clash clash_of(const TriangleMesh& a, const TriangleMesh& b, const ClashOptions& options = {}) {
  return find_clash(ClashPart(a), ClashPart(b), options);
}

/// Both ways round, and both parts inside out.
void expect_word(const TriangleMesh& a, const TriangleMesh& b, ClashKind kind, const char* what) {
  SCOPED_TRACE(what);
  const Clash one = clash_of(a, b), other = clash_of(b, a);
  EXPECT_EQ(name_of(one.kind), name_of(kind));
  EXPECT_EQ(name_of(other.kind), name_of(kind));
  EXPECT_EQ(one.volume, other.volume);
  EXPECT_EQ(one.depth.has_value(), other.depth.has_value());
  if (one.depth && other.depth) {
    EXPECT_EQ(one.depth->lower, other.depth->lower);
    EXPECT_EQ(one.depth->upper, other.depth->upper);
  }
  EXPECT_EQ(name_of(clash_of(inside_out(a), b).kind), name_of(kind));
  EXPECT_EQ(one.meeting.size(), other.meeting.size());
}

/// A prism over a regular polygon, whose corners are doubles.
std::vector<Point2> ring(int corners, double radius) {
  std::vector<Point2> made;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    made.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return made;
}
TriangleMesh prism(const std::vector<Point2>& ring, double bottom, double top) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(ring.size());
  for (const double z : {bottom, top})
    for (const Point2& p : ring) mesh.vertices.push_back({p.x, p.y, z});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n;
    mesh.triangles.insert(mesh.triangles.end(), {{i, k, n + k}, {i, n + k, n + i}});
    if (i >= 1 && i + 1 < n) mesh.triangles.insert(mesh.triangles.end(), {{0, k, i}, {n, n + i, n + k}});
  }
  return mesh;
}
/// A plate around the ring, whose border is far out: a ring of as many corners.
TriangleMesh plate_with_hole(const std::vector<Point2>& hole, double bottom, double top) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(hole.size());
  for (const double z : {bottom, top}) {
    for (const Point2& p : hole) mesh.vertices.push_back({p.x, p.y, z});
    for (const Point2& p : hole) mesh.vertices.push_back({4 * p.x, 4 * p.y, z});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n, out_i = n + i, out_k = n + k, up = 2 * n;
    mesh.triangles.insert(mesh.triangles.end(), {{i, up + k, k}, {i, up + i, up + k}});
    mesh.triangles.insert(mesh.triangles.end(), {{out_i, out_k, up + out_k}, {out_i, up + out_k, up + out_i}});
    mesh.triangles.insert(mesh.triangles.end(), {{i, k, out_k}, {i, out_k, out_i}});
    mesh.triangles.insert(mesh.triangles.end(), {{up + i, up + out_k, up + k}, {up + i, up + out_i, up + out_k}});
  }
  return mesh;
}

TriangleMesh tetrahedron(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return {{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TEST(Clash, SaysOfKnownPartsWhatTheyAre) {
  using enum ClashKind;
  const TriangleMesh cube = solids::box({0, 0, 0}, {4, 4, 4});
  expect_word(cube, solids::box({5, 0, 0}, {6, 4, 4}), apart, "beside one another");
  expect_word(cube, solids::box({4, 0, 0}, {6, 4, 4}), touching, "panels, face to face");
  expect_word(cube, solids::box({4, 1, -1}, {6, 3, 9}), touching, "panels, faces that overlap in part");
  expect_word(cube, solids::box({4, 4, 0}, {6, 6, 4}), touching, "edge on edge");
  expect_word(cube, solids::box({4, 4, 4}, {6, 6, 6}), touching, "corner on corner");
  expect_word(cube, tetrahedron({4, 2, 2}, {6, 1, 1}, {6, 3, 1}, {6, 2, 3}), touching, "corner on face");
  expect_word(cube, tetrahedron({5, 3, 1}, {3, 5, 1}, {9, 9, 0}, {9, 9, 2}), touching, "edge across edge");
  expect_word(cube, solids::box({1, 1, 1}, {2, 2, 2}), enclosed, "nested");
  expect_word(cube, solids::box({0, 1, 1}, {2, 2, 2}), enclosed, "nested, with a face in common");
  expect_word(cube, solids::box({0, 0, 0}, {4, 4, 5}), enclosed, "five faces in common");
  expect_word(cube, tetrahedron({0, 0, 0}, {4, 4, 0}, {4, 0, 4}, {0, 4, 4}), enclosed, "corners and edges alone");
  expect_word(cube, cube, duplicate, "the same");
  expect_word(cube, inside_out(cube), duplicate, "the same inside out");
  expect_word(cube, solids::box({3, 3, 3}, {6, 6, 6}), overlapping, "corner in corner");
  expect_word(cube, solids::box({3, 0, 0}, {6, 4, 4}), overlapping, "in line, sides in common");
  expect_word(cube, solids::box({1, 1, -1}, {2, 2, 5}), piercing, "a bar through");
  expect_word(cube, solids::box({1, 1, -1}, {2, 2, 4}), overlapping, "a bar as far as the other face");
  expect_word(cube, solids::box({1, -1, -1}, {2, 5, 5}), piercing, "a saw cut");
  TriangleMesh hollow = cube;
  solids::append(hollow, solids::box({1, 1, 1}, {3, 3, 3}), true);
  expect_word(hollow, solids::box({1.5, 1.5, 1.5}, {2, 2, 2}), apart, "in a hollow");
  expect_word(hollow, solids::box({1, 1.5, 1.5}, {2, 2, 2}), touching, "in a hollow, on its wall");
  expect_word(hollow, solids::box({1, 1, 1}, {3, 3, 3}), touching, "fills the hollow");
  expect_word(hollow, solids::box({0.5, 0.5, 0.5}, {3.5, 3.5, 3.5}), overlapping, "around the hollow");
  expect_word(hollow, cube, enclosed, "a hollow less");
  // Pieces that do not touch: one is inside, the other is not.
  const TriangleMesh two = together(solids::box({1, 1, 1}, {2, 2, 2}), solids::box({8, 0, 0}, {9, 1, 1}));
  expect_word(cube, two, overlapping, "one of two pieces inside");
  expect_word(cube, together(solids::box({4, 1, 1}, {5, 2, 2}), solids::box({1, 1, 1}, {2, 2, 2})), overlapping,
              "one piece inside, another on a face");
  // Walls without thickness bound nothing: a triangle twice, wound both ways.
  TriangleMesh fin = cube;
  solids::append(fin, {{{5, 1, 1}, {8, 1, 1}, {5, 3, 1}}, {{0, 1, 2}, {0, 2, 1}}});
  expect_word(fin, solids::box({6, 0, 0}, {9, 2, 2}), touching, "a wall without thickness in another part");
}

TEST(Clash, SaysOfBoltsInHoles) {
  using enum ClashKind;
  for (const int corners : {3, 8, 31}) {
    const auto hole = ring(corners, 1), loose = ring(corners, 0.75), tight = ring(corners, 1.25);
    const TriangleMesh plate = plate_with_hole(hole, 0, 1);
    expect_word(plate, prism(hole, 0, 1), touching, "exact fit, flush");
    expect_word(plate, prism(hole, -1, 2), touching, "exact fit");
    expect_word(plate, prism(hole, 0.25, 0.5), touching, "exact fit, within");
    expect_word(plate, prism(hole, 1, 2), touching, "on the rim");
    expect_word(plate, prism(loose, -1, 2), apart, "loose");
    expect_word(plate, prism(tight, -1, 2), overlapping, "tight: what is in the hole joins the ends");
    expect_word(plate, prism(tight, 0.5, 2), overlapping, "tight, half way");
    const Clash near = clash_of(plate, prism(loose, -1, 2), {.clearance = 0.25});
    EXPECT_EQ(name_of(near.kind), "within clearance");
    ASSERT_TRUE(near.distance.has_value());
    EXPECT_LE(*near.distance, 0.25);
  }
}

TEST(Clash, SaysOfGearsInMesh) {
  // A tooth in a gap of the other gear, of which the flanks are the same doubles: a rack and its cast.
  const std::vector<Point2> low{{0, 0}, {8, 0}, {8, 2}, {7, 4}, {6, 2}, {5, 4}, {4, 2}, {3, 4}, {2, 2}, {1, 4}, {0, 2}};
  const auto rack = [](const std::vector<Point2>& ring) {
    TriangleMesh mesh = prism(ring, 0, 1);
    // The ring is not convex: its caps are fans about a corner that sees all of it.
    std::erase_if(mesh.triangles, [&](const auto& t) {
      const auto n = static_cast<std::uint32_t>(ring.size());
      return std::ranges::all_of(t, [&](std::uint32_t v) { return v < n; }) ||
             std::ranges::all_of(t, [&](std::uint32_t v) { return v >= n; });
    });
    const auto n = static_cast<std::uint32_t>(ring.size());
    // Strips between the back, two corners, and the teeth: corner 0 and 1 are the back, 2 to n - 1 the teeth.
    const auto cap = [&](std::uint32_t first, bool up) {
      std::vector<TriangleMesh::Triangle> fan;
      for (std::uint32_t i = 2; i + 2 < n; i += 2) fan.push_back({first + i, first + i + 1, first + i + 2});  // teeth
      for (std::uint32_t i = 2; i + 2 < n; i += 2) fan.push_back({first, first + i, first + i + 2});
      fan.push_back({first, first + 1, first + 2});
      for (auto& t : fan) {
        if (!up) std::swap(t[1], t[2]);
        mesh.triangles.push_back(t);
      }
    };
    cap(0, false);
    cap(n, true);
    return mesh;
  };
  const TriangleMesh below = rack(low);
  ASSERT_TRUE(ClashPart(below).is_solid());
  TriangleMesh above = below;  // half a turn about z, and so far that teeth lie in gaps
  for (Point3& p : above.vertices) p = {9 - p.x, 6 - p.y, p.z};
  expect_word(below, above, ClashKind::touching, "teeth fill gaps");
  expect_word(below, moved(above, {0, 0.125, 0}), ClashKind::apart, "with play");
  expect_word(below, moved(above, {0.125, 0, 0}), ClashKind::overlapping, "a flank too far");
  expect_word(below, moved(above, {0.125, 0.25, 0}), ClashKind::touching, "on one flank");
}

TEST(Clash, ComparesTheClearanceExactly) {
  const TriangleMesh a = solids::box({0, 0, 0}, {1, 1, 1}), b = solids::box({1.25, 0, 0}, {2, 1, 1});
  EXPECT_EQ(clash_of(a, b, {.clearance = 0.25}).kind, ClashKind::within_clearance);
  EXPECT_EQ(clash_of(a, b, {.clearance = 0.25}).distance, 0.25);
  EXPECT_EQ(clash_of(a, b, {.clearance = std::nextafter(0.25, 0.0)}).kind, ClashKind::apart);
  EXPECT_EQ(clash_of(a, b).kind, ClashKind::apart);
  EXPECT_EQ(clash_of(a, a, {.clearance = 1}).kind, ClashKind::duplicate);
  // The diagonal between corners is the root of 2, which no double is.
  const TriangleMesh c = solids::box({2, 2, 0}, {3, 3, 1});
  const double above = std::sqrt(2.0), below = std::nextafter(above, 0.0);
  EXPECT_EQ(clash_of(a, c, {.clearance = above}).kind, ClashKind::within_clearance);
  EXPECT_EQ(clash_of(a, c, {.clearance = below}).kind, ClashKind::apart);
}

TEST(Clash, TellsDepthAndVolume) {
  const TriangleMesh cube = solids::box({0, 0, 0}, {4, 4, 4});
  const Clash c = clash_of(cube, solids::box({3, 2, 1}, {6, 6, 6}));
  EXPECT_EQ(c.volume, 1 * 2 * 3);
  ASSERT_TRUE(c.depth.has_value());
  EXPECT_EQ(c.depth->lower, 1);
  EXPECT_EQ(c.depth->upper, 1);
  EXPECT_EQ(c.depth->direction, (Vector3{-1, 0, 0}));
  const Clash bar = clash_of(cube, solids::box({1, 1, -1}, {2, 2, 5}));
  EXPECT_EQ(bar.volume, 4);
  EXPECT_EQ(bar.depth->upper, 2);  // to x = 0
  // A voxel shape that is not convex: no translation shorter than `lower` frees it, and `upper` does.
  const TriangleMesh hook = solids::voxels({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}});
  const TriangleMesh spike = tetrahedron({1.5, 0.5, 0.5}, {1.5, 5, 0.75}, {1.25, 5, 0.25}, {1.75, 5, 0.25});
  const Clash into = clash_of(hook, spike);
  ASSERT_TRUE(into.depth.has_value());
  EXPECT_LT(into.depth->lower, into.depth->upper);
  EXPECT_EQ(into.depth->lower, std::nextafter(0.5, 0.0));  // the spike's end
}

TEST(Clash, SaysOfSheets) {
  using enum ClashKind;
  const TriangleMesh cube = solids::box({0, 0, 0}, {4, 4, 4});
  const auto sheet = [](const Point3& a, const Point3& b, const Point3& c) {
    return TriangleMesh{{a, b, c}, {{0, 1, 2}}};
  };
  expect_word(cube, sheet({1, 1, 1}, {2, 1, 1}, {1, 2, 1}), enclosed, "in a solid");
  expect_word(cube, sheet({5, 1, 1}, {6, 1, 1}, {5, 2, 1}), apart, "beside it");
  expect_word(cube, sheet({4, 1, 1}, {4, 2, 1}, {4, 1, 2}), touching, "on a face");
  expect_word(cube, sheet({4, 1, 1}, {6, 2, 1}, {6, 1, 2}), touching, "a corner on a face");
  expect_word(cube, sheet({1, 1, 4}, {3, 1, 1}, {1, 3, 1}), enclosed, "in a solid, a corner on a face");
  expect_word(cube, sheet({0, 0, 0}, {4, 4, 0}, {0, 4, 4}), enclosed, "corners and an edge on faces");
  expect_word(cube, sheet({2, 2, 2}, {9, 2, 2}, {9, 3, 2}), overlapping, "through a face");
  expect_word(cube, sheet({-9, -9, 2}, {19, -9, 2}, {2, 19, 2}), overlapping, "all through");
  const TriangleMesh flat = sheet({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  expect_word(flat, flat, duplicate, "the same sheet");
  expect_word(flat, sheet({1, 1, 0}, {1, 1, 2}, {2, 1, 2}), touching, "a corner on a sheet");
  expect_word(flat, sheet({1, 1, -1}, {1, 1, 2}, {2, 1, 2}), overlapping, "through a sheet");
  expect_word(flat, sheet({1, 1, 0}, {3, 1, 0}, {1, 9, 0}), touching, "in one plane");
  TriangleMesh twice = sheet({1, 1, 1}, {2, 1, 1}, {1, 2, 1});
  twice.triangles.push_back({0, 2, 1});  // both sides of a sheet
  EXPECT_FALSE(ClashPart(twice).is_solid());
  expect_word(cube, twice, enclosed, "a sheet with two sides, in a solid");
}

TEST(Clash, OfNothingIsApart) {
  const TriangleMesh cube = solids::box({0, 0, 0}, {4, 4, 4});
  expect_word(cube, {}, ClashKind::apart, "an empty mesh");
  EXPECT_EQ(clash_of({}, {}, {.clearance = 1}).kind, ClashKind::apart);
  EXPECT_THROW(ClashPart({{{0, 0, 0}}, {{0, 1, 2}}}), InvalidShape);
  EXPECT_THROW(ClashPart({{{0, 0, std::nan("")}}, {{0, 0, 0}}}), NonFinite);
}

// What cells say

Cells refined(const Cells& cells, const Cell& shift) {
  Cells made;
  for (const Cell& c : cells)
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y)
        for (int z = 0; z < 2; ++z)
          made.insert({2 * c[0] + x + shift[0], 2 * c[1] + y + shift[1], 2 * c[2] + z + shift[2]});
  return made;
}

Cells less(const Cells& a, const Cells& b) {
  Cells made;
  std::ranges::set_difference(a, b, std::inserter(made, made.end()));
  return made;
}

int pieces(Cells cells) {
  int count = 0;
  while (!cells.empty()) {
    ++count;
    std::vector<Cell> pending{*cells.begin()};
    cells.erase(cells.begin());
    while (!pending.empty()) {
      const Cell at = pending.back();
      pending.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        for (const int step : {-1, 1}) {
          Cell beside = at;
          beside[k] += step;
          if (cells.erase(beside) != 0) pending.push_back(beside);
        }
      }
    }
  }
  return count;
}

bool share_a_point(const Cells& a, const Cells& b) {
  return std::ranges::any_of(a, [&](const Cell& c) {
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (b.contains({c[0] + x, c[1] + y, c[2] + z})) return true;
    return false;
  });
}

ClashKind word_of_cells(const Cells& a, const Cells& b) {
  const Cells a_alone = less(a, b), b_alone = less(b, a);
  if (a_alone.size() == a.size()) return share_a_point(a, b) ? ClashKind::touching : ClashKind::apart;
  if (a_alone.empty() && b_alone.empty()) return ClashKind::duplicate;
  if (a_alone.empty() || b_alone.empty()) return ClashKind::enclosed;
  return pieces(a_alone) > pieces(a) || pieces(b_alone) > pieces(b) ? ClashKind::piercing : ClashKind::overlapping;
}

/// Whole numbers stay whole, volumes are kept, and no face stays square to an axis.
TriangleMesh sheared(TriangleMesh mesh, const Cell& shift) {
  for (Point3& p : mesh.vertices) {
    const double x = 2 * p.x + shift[0], y = 2 * p.y + shift[1], z = 2 * p.z + shift[2];
    p = {x + y, y - 2 * (x + y), z + 3 * x - y};
  }
  return mesh;
}

/// Grown from a cell, so that most are of one piece; now and then two.
Cells drawn_cells(std::mt19937_64& random, int count) {
  std::uniform_int_distribution<int> at(0, 2), axis(0, 2);
  Cells cells{{at(random), at(random), at(random)}};
  while (static_cast<int>(cells.size()) < count) {
    auto from = cells.begin();
    std::advance(from, std::uniform_int_distribution<std::ptrdiff_t>(0, std::ssize(cells) - 1)(random));
    Cell next = *from;
    int& k = next[static_cast<std::size_t>(axis(random))];
    k = std::clamp(k + (at(random) == 0 ? -1 : 1), 0, 4);
    cells.insert(at(random) == 0 && at(random) == 0 ? Cell{at(random), at(random), at(random)} : next);
  }
  return cells;
}

TEST(Clash, SaysOfLatticePartsWhatTheirCellsSay) {
  constexpr std::uint64_t cases = 400;
  std::map<ClashKind, int> said;
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> size(1, 12), place(-3, 3), odd(0, 1);
    const Cells coarse_a = drawn_cells(random, size(random));
    // Sometimes what the first leaves free of a block, so that faces meet all over, or a part of the first.
    Cells coarse_b = drawn_cells(random, size(random));
    Cell shift{place(random), place(random), place(random)};
    if (seed % 4 == 0) coarse_b = less(coarse_b, coarse_a), shift = {0, 0, 0};
    if (seed % 16 == 1) coarse_b = coarse_a, shift = {0, 0, 0};
    if (seed % 16 == 3) coarse_b.insert(coarse_a.begin(), coarse_a.end()), shift = {0, 0, 0};
    if (odd(random) == 0)
      for (int& k : shift) k *= 2;
    if (coarse_b.empty()) continue;
    const Cells a = refined(coarse_a, {0, 0, 0}), b = refined(coarse_b, shift);
    const TriangleMesh mesh_a = sheared(solids::voxels(coarse_a), {0, 0, 0});
    const TriangleMesh mesh_b = sheared(solids::voxels(coarse_b), shift);
    const ClashPart part_a(mesh_a), part_b(mesh_b);
    ASSERT_TRUE(part_a.is_solid() && part_b.is_solid());
    const Clash clash = find_clash(part_a, part_b), other = find_clash(part_b, part_a);
    const ClashKind expected = word_of_cells(a, b);
    EXPECT_EQ(name_of(clash.kind), name_of(expected));
    EXPECT_EQ(name_of(other.kind), name_of(expected));
    EXPECT_EQ(name_of(find_clash(part_a, part_b, {.measure = false}).kind), name_of(expected));
    ++said[expected];
    if (expected == ClashKind::apart || expected == ClashKind::touching) {
      EXPECT_FALSE(clash.volume.has_value());
      continue;
    }
    EXPECT_EQ(clash.volume, double(a.size() - less(a, b).size()));
    if (expected == ClashKind::enclosed) {
      EXPECT_EQ(clash.inner, less(a, b).empty() ? 0U : 1U);
    }
    ASSERT_TRUE(clash.depth.has_value());
    EXPECT_LE(clash.depth->lower, clash.depth->upper);
    EXPECT_GT(clash.depth->upper, 0);
  }
  for (const ClashKind k : {ClashKind::apart, ClashKind::touching, ClashKind::overlapping, ClashKind::piercing,
                            ClashKind::enclosed, ClashKind::duplicate})
    EXPECT_GE(said[k], 10) << name_of(k);
}

// Tetrahedra that cross one another, inside out, flat and twice: no point of a grid is in both of parts that touch, and
// whatever is in both makes them more than touching.
TEST(Clash, OfHeapsKnowsPointsInBoth) {
  int touching = 0, meeting = 0, in_both = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = solids::heap(random, 1 + int(seed % 3), 2), b = solids::heap(random, 1, 1);
    const ClashPart part_a(a), part_b(b);
    const ClashKind kind = find_clash(part_a, part_b).kind;
    EXPECT_EQ(find_clash(part_b, part_a).kind, kind);
    if (!part_a.is_solid() || !part_b.is_solid()) continue;
    const ExactMesh exact_a = solid_laws::exact_mesh_of(a), exact_b = solid_laws::exact_mesh_of(b);
    bool any = false;
    for (int x = -5; x <= 5 && !any; ++x) {
      for (int y = -5; y <= 5 && !any; ++y) {
        for (int z = -5; z <= 5 && !any; ++z) {
          const RationalPoint3 p{Rational(4 * x + 1, 21), Rational(4 * y + 2, 23), Rational(4 * z + 3, 25)};
          any = solid_laws::winding_by_definition(exact_b, p).value_or(0) != 0 &&
                solid_laws::winding_by_definition(exact_a, p).value_or(0) != 0;
        }
      }
    }
    const bool are_in_both = kind != ClashKind::apart && kind != ClashKind::touching;
    EXPECT_TRUE(are_in_both || !any);
    touching += kind == ClashKind::touching;
    meeting += are_in_both;
    in_both += any;
  }
  EXPECT_GE(touching, 5);
  EXPECT_GE(meeting, 30);
  EXPECT_GE(in_both, 20);
}

}  // namespace
}  // namespace plumb
