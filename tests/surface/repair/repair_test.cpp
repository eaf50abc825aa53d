// Repair: what each step does, had alone or in the default plan; what is sound stays.  planted_faults_test.cpp has the
// faults that a mesh can have, one by one.
#include "plumb/surface/repair/repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "figure/basic/solids.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/surface/topology/components.hpp"
#include "surface/repair/meshes_alike.hpp"

namespace plumb {
namespace {

using namespace meshes_alike;

std::size_t count(const Repaired& done, ChangeKind kind) {
  return static_cast<std::size_t>(std::ranges::count(done.changes, kind, &RepairChange::kind));
}

void expect_sound(const Repaired& done) {
  for (const std::string_view defect : surface_defects) EXPECT_FALSE(done.faults.has(defect)) << defect;
  EXPECT_EQ(done.faults.repeated_vertices, 0U);
  for (const RepairChange& c : done.changes) EXPECT_FALSE(is_left(c.kind)) << text_of(c.kind);
}

TEST(Repair, WhatIsSoundStaysBitForBit) {
  for (const TriangleMesh& mesh : {grid_box(3), solids::torus(3, 1, 12, 9), solids::hollow_torus(3, 1, 12, 9)}) {
    const Repaired done = repair(mesh);
    EXPECT_EQ(done.mesh.vertices, mesh.vertices);
    EXPECT_EQ(done.mesh.triangles, mesh.triangles);
    EXPECT_TRUE(done.changes.empty());
    expect_sound(done);
  }
  EXPECT_TRUE(repair(TriangleMesh{}).mesh.triangles.empty());
}

TEST(Repair, StepsCanBeHadAlone) {
  TriangleMesh mesh = grid_box(2);
  mesh.triangles.pop_back();
  mesh.vertices.push_back({9, 9, 9});
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  const Repaired filled = repair(mesh, {{RepairKind::orientation}, {RepairKind::holes}});
  EXPECT_TRUE(filled.faults.closed && filled.faults.oriented);
  EXPECT_EQ(filled.mesh.vertices, mesh.vertices) << "the unused one as well";
  const Repaired less = repair(mesh, {{RepairKind::unused}}, {.judge = false});
  EXPECT_EQ(less.mesh.triangles, mesh.triangles);
  EXPECT_EQ(less.mesh.vertices.size() + 1, mesh.vertices.size());
  EXPECT_EQ(less.faults.triangles, 0U) << "not judged";
  EXPECT_EQ(repair(mesh, std::vector<RepairStep>{}).mesh.triangles, mesh.triangles);
}

TEST(Repair, AMoebiusStripIsNamed) {
  TriangleMesh strip;
  for (std::uint32_t i = 0; i < 7; ++i) {
    strip.vertices.push_back({std::cos(i * 0.9), std::sin(i * 0.9), i % 2 == 0 ? 0.5 : -0.5});
    strip.triangles.push_back({i, (i + 1 + i % 2) % 7, (i + 2 - i % 2) % 7});
  }
  const Repaired done = repair(strip);
  EXPECT_EQ(count(done, ChangeKind::one_sided), 1U);
  EXPECT_EQ(count(done, ChangeKind::one_sided_hole), 1U);
  EXPECT_EQ(done.mesh.triangles, strip.triangles);
}

TEST(Repair, AHoleIsNotFilledThroughTheSurface) {
  // A box without its lid, out of which a pillar stands: the lid would pass through the pillar.
  TriangleMesh mesh = solids::box({0, 0, 0}, {4, 4, 1});
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return mesh.vertices[v].z == 1; });
  });
  ASSERT_EQ(mesh.triangles.size(), 10U);
  const TriangleMesh open = mesh;
  EXPECT_EQ(count(repair(open), ChangeKind::filled_hole), 1U);
  solids::append(mesh, solids::box({1, 1, 0.5}, {2, 2, 3}));
  const Repaired done = repair(mesh);
  EXPECT_EQ(count(done, ChangeKind::kept_hole), 1U);
  EXPECT_EQ(count(done, ChangeKind::filled_hole), 0U);
  EXPECT_EQ(done.faults.open_edges, 4U);
}

TEST(Repair, AHoleThatIsGoneInTheEndIsNotToldAsLeft) {
  // The box without its lid, out of which a pillar stands.
  TriangleMesh mesh = solids::box({0, 0, 0}, {4, 4, 1});
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return mesh.vertices[v].z == 1; });
  });
  solids::append(mesh, solids::box({1, 1, 0.5}, {2, 2, 3}));
  const RepairStep holes{RepairKind::holes};
  EXPECT_EQ(count(repair(mesh, {holes}), ChangeKind::kept_hole), 1U);
  EXPECT_EQ(count(repair(mesh, {holes, holes}), ChangeKind::kept_hole), 1U) << "told once";
  EXPECT_EQ(count(repair(mesh, {holes, {RepairKind::unused}}), ChangeKind::kept_hole), 1U);
  const Repaired without_box = repair(mesh, {holes, {RepairKind::small_components, 0, 12}});
  EXPECT_EQ(count(without_box, ChangeKind::removed_component), 1U);
  EXPECT_EQ(count(without_box, ChangeKind::kept_hole), 0U) << "its component was left out";
  EXPECT_EQ(without_box.faults.open_edges, 0U);
  // Of two such boxes, one of them alone left out, one hole is left.
  TriangleMesh larger = grid_box(3);
  std::erase_if(larger.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return larger.vertices[v].z == 3; });
  });
  for (Point3& p : larger.vertices) p.x += 10;
  solids::append(larger, solids::box({11, 1, 1.5}, {12, 2, 5}));
  solids::append(mesh, larger);
  EXPECT_EQ(count(repair(mesh, {holes}), ChangeKind::kept_hole), 2U);
  const Repaired one = repair(mesh, {holes, {RepairKind::small_components, 0, 12}});
  ASSERT_EQ(count(one, ChangeKind::kept_hole), 1U);
  EXPECT_EQ(one.faults.open_edges, 12U);
  for (const RepairChange& c : one.changes) {
    EXPECT_TRUE(c.kind != ChangeKind::kept_hole || c.place.x >= 10);
  }
}

TEST(Repair, OfAClosedMeshNoHoleIsToldAsLeft) {
  std::mt19937 random(11);
  std::size_t closed_later = 0, told = 0;
  for (int i = 0; i < 200; ++i) {
    TriangleMesh mesh;
    const auto at = [&] { return static_cast<double>(random() % 3); };
    for (int v = 0; v < 9; ++v) {
      const double x = at(), y = at();
      mesh.vertices.push_back({x, y, at()});
    }
    for (int t = 0; t < 14; ++t) {
      const auto vertex = [&] { return static_cast<std::uint32_t>(random() % 9); };
      const std::uint32_t a = vertex(), b = vertex();
      mesh.triangles.push_back({a, b, vertex()});
    }
    const Repaired holes = repair(mesh, {{RepairKind::holes}}),
                   done = repair(mesh, {{RepairKind::holes}, {RepairKind::zip, 2}});
    const auto left = [&](const Repaired& r) {
      return count(r, ChangeKind::kept_hole) + count(r, ChangeKind::tied_hole);
    };
    if (done.faults.open_edges == 0) {
      closed_later += left(holes) > left(done);
      EXPECT_EQ(left(done), 0U);
    }
    told += left(done);
  }
  EXPECT_GT(closed_later, 3U);
  EXPECT_GT(told, 10U);
}

TEST(Repair, HolesInNoPlane) {
  TriangleMesh mesh = solids::torus(4, 1, 24, 17);
  const auto whole = mesh.triangles.size();
  std::erase_if(mesh.triangles, [&](const auto& t) {  // all about three neighboring vertices
    return std::ranges::any_of(t, [](std::uint32_t v) { return v == 40 || v == 41 || v == 42; });
  });
  const Repaired done = repair(mesh);
  expect_sound(done);
  EXPECT_EQ(count(done, ChangeKind::filled_hole), 1U);
  EXPECT_EQ(done.mesh.triangles.size(), whole - 6) << "three vertices less";
  EXPECT_EQ(surface_kinds(done.mesh, find_edges(done.mesh))[0].genus(), 1);
}

TEST(Repair, HolesWithIslands) {
  // A block with a square tunnel through it, of which the end that has the hole is missing.
  std::set<solids::Cell> cells;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 2; ++z)
        if (x != 1 || y != 1) cells.insert({x, y, z});
  const TriangleMesh whole = solids::voxels(cells);
  TriangleMesh mesh = whole;
  const auto is_at_end = [&](const TriangleMesh& m, const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return m.vertices[v].z == 2; });
  };
  std::erase_if(mesh.triangles, [&](const auto& t) { return is_at_end(mesh, t); });
  const Repaired done = repair(mesh);
  expect_sound(done);
  EXPECT_EQ(count(done, ChangeKind::filled_hole), 1U);
  EXPECT_EQ(surface_kinds(done.mesh, find_edges(done.mesh))[0].genus(), 1);
  EXPECT_EQ(std::ranges::count_if(done.mesh.triangles, [&](const auto& t) { return is_at_end(done.mesh, t); }), 16);
  EXPECT_EQ(signed_volume(done.mesh), 16);
  std::mt19937 random(3);
  EXPECT_EQ(triangles_of(repair(shuffled(mesh, random)).mesh), triangles_of(done.mesh));
  // Both ends.
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return mesh.vertices[v].z == 0; });
  });
  const Repaired both = repair(mesh);
  expect_sound(both);
  EXPECT_EQ(count(both, ChangeKind::filled_hole), 2U);
  EXPECT_EQ(signed_volume(both.mesh), 16);
}

TEST(Repair, AHoleThatTwoFillingsFitEquallyWellIsNamed) {
  // Four walls around a square of which two opposite corners are lifted: both diagonals have the same area.
  const auto with_lift = [](double lift) {
    TriangleMesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 3}, {2, 0, 4}, {2, 2, 3}, {0, 2, lift}}, {}};
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t j = (i + 1) % 4;
      mesh.triangles.push_back({i, j, j + 4});
      mesh.triangles.push_back({i, j + 4, i + 4});
    }
    mesh.triangles.push_back({0, 2, 1});
    mesh.triangles.push_back({0, 3, 2});
    return mesh;
  };
  const Repaired done = repair(with_lift(4));
  EXPECT_EQ(count(done, ChangeKind::tied_hole), 1U);
  EXPECT_EQ(count(done, ChangeKind::filled_hole), 0U);
  EXPECT_EQ(done.faults.open_edges, 4U);
  for (const double lift : {std::nextafter(4, 5), std::nextafter(4, 3)}) {
    const Repaired decided = repair(with_lift(lift));
    EXPECT_EQ(count(decided, ChangeKind::filled_hole), 1U) << "an ulp tells";
    expect_sound(decided);
  }
}

TEST(Repair, BowTiesAndEdgesOfFourTrianglesAreSplit) {
  TriangleMesh mesh = solids::voxels({{0, 0, 0}, {1, 1, 0}, {2, 2, 1}});  // an edge, and a vertex
  ASSERT_TRUE(find_faults(mesh).has("non-manifold-edge") && find_faults(mesh).has("non-manifold-vertex"));
  const Repaired done = repair(mesh);
  EXPECT_FALSE(done.faults.has("non-manifold-edge") || done.faults.has("non-manifold-vertex"));
  EXPECT_TRUE(done.faults.closed && done.faults.oriented);
  EXPECT_EQ(done.faults.shells.size(), 3U);
  EXPECT_EQ(count(done, ChangeKind::split_vertex), 3U);
  EXPECT_EQ(triangles_of(done.mesh), triangles_of(mesh)) << "where they were";
}

TEST(Repair, WallsAndSmallComponentsAreLeftOut) {
  TriangleMesh mesh = grid_box(2);
  solids::append(mesh, {{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {0.5, 1.5, 0.5}}, {{0, 1, 2}}});
  const Repaired done = repair(mesh);
  EXPECT_EQ(count(done, ChangeKind::removed_wall), 1U);
  expect_sound(done);
  solids::append(mesh, solids::box({9, 9, 9}, {10, 10, 10}));
  const Repaired less = repair(mesh, {{RepairKind::small_components, 0, 13}, {RepairKind::unused}});
  EXPECT_EQ(triangles_of(less.mesh), triangles_of(grid_box(2)));
}

TEST(Repair, NeedlesOfATriangleAreTakenOutWithoutAGap) {
  // A square over a base: its edge 0-1 is closed by triangles on one line, with vertices 4 and 5 on it.
  TriangleMesh mesh = solids::box({0, 0, 0}, {3, 3, 3});
  const auto at = std::ranges::find_if(mesh.triangles, [&](const auto& t) {
    return std::ranges::count_if(t, [&](std::uint32_t v) { return mesh.vertices[v].z == 0; }) == 3;
  });
  const auto [a, b, c] = *at;
  const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
  const auto third = [&](double s) { return Point3{p.x + (q.x - p.x) / 3 * s, p.y + (q.y - p.y) / 3 * s, 0}; };
  const auto m = static_cast<std::uint32_t>(mesh.vertices.size());
  const Point3 one = third(1), two = third(2);
  mesh.vertices.insert(mesh.vertices.end(), {one, two});
  *at = {a, m, c};
  mesh.triangles.insert(mesh.triangles.end(), {{m, m + 1, c}, {m + 1, b, c}, {a, b, m + 1}, {a, m + 1, m}});
  ASSERT_EQ(mesh_statistics(mesh).boundary_edges, 0U);
  const Repaired done = repair(mesh, {{RepairKind::degenerate}});
  expect_sound(done);
  EXPECT_EQ(count(done, ChangeKind::flat_triangle), 2U);
  EXPECT_EQ(done.mesh.triangles.size(), 16U);
}

TEST(Repair, SliversWithinATolerance) {
  TriangleMesh mesh = solids::box({0, 0, 0}, {2, 2, 2});
  const auto at = std::ranges::find_if(mesh.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return mesh.vertices[v].z == 0; });
  });
  const auto [a, b, c] = *at;
  const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
  const auto m = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, -0.0625});  // a cap of that height below the edge
  *at = {a, m, c};
  mesh.triangles.insert(mesh.triangles.end(), {{m, b, c}, {a, b, m}});
  ASSERT_EQ(mesh_statistics(mesh).boundary_edges, 0U);
  const double low = std::nextafter(0.0625, 0);
  EXPECT_EQ(count(repair(mesh, {{RepairKind::slivers, low}}), ChangeKind::flat_triangle), 0U);
  const Repaired done = repair(mesh, {{RepairKind::slivers, 0.0625}});
  EXPECT_EQ(count(done, ChangeKind::flat_triangle), 1U);
  expect_sound(done);
}

TEST(Repair, CracksAreZippedWithinATolerance) {
  // Two halves of a box, of unlike vertices along the crack, which is 2^-10 wide.
  const double gap = std::ldexp(1, -10);
  TriangleMesh mesh = grid_box(2);
  TriangleMesh right = solids::box({2, 0, 0}, {4, 2, 2});
  for (auto* half : {&mesh, &right}) {
    std::erase_if(half->triangles, [&](const auto& t) {
      return std::ranges::all_of(t, [&](std::uint32_t v) { return half->vertices[v].x == 2; });
    });
  }
  for (Point3& p : right.vertices) p.x += gap;
  solids::append(mesh, right);
  EXPECT_EQ(find_faults(mesh).open_edges, 12U);
  const Repaired done = repair(mesh, {{RepairKind::zip, gap}, {RepairKind::unused}});
  expect_sound(done);
  EXPECT_EQ(done.faults.shells.size(), 1U);
  const Repaired less = repair(mesh, {{RepairKind::zip, std::nextafter(gap, 0)}});
  EXPECT_EQ(less.mesh.triangles, mesh.triangles);
}

TEST(Repair, AVertexByAClosedEdgeDividesBothItsTrianglesWithinATolerance) {
  // The tip of a sheet that stands on the middle of a box's edge, but for 2^-10.
  const double gap = std::ldexp(1, -10);
  TriangleMesh mesh = solids::box({0, 0, 0}, {2, 2, 2});
  solids::append(mesh, {{{1, -gap, 0}, {0.5, -1, -1}, {1.5, -1, -1}}, {{0, 1, 2}}});
  ASSERT_EQ(mesh_statistics(mesh).boundary_edges, 3U);
  const Repaired done = repair(mesh, {{RepairKind::t_junctions, gap}});
  EXPECT_EQ(count(done, ChangeKind::divided_edge), 1U);
  EXPECT_EQ(done.changes[0].count, 2U) << "both sides of the edge";
  EXPECT_EQ(done.changes[0].place, (Point3{1, -gap, 0}));
  EXPECT_EQ(done.mesh.vertices, mesh.vertices);
  EXPECT_EQ(done.mesh.triangles.size(), mesh.triangles.size() + 2);
  EXPECT_EQ(mesh_statistics(done.mesh).boundary_edges, 3U) << "no gap is opened";
  EXPECT_EQ(repair(done.mesh, {{RepairKind::t_junctions, gap}}).mesh.triangles, done.mesh.triangles);
  for (const RepairStep& less : {RepairStep{RepairKind::t_junctions, std::nextafter(gap, 0)},
                                 RepairStep{RepairKind::t_junctions}, RepairStep{RepairKind::zip, gap}})
    EXPECT_EQ(repair(mesh, {less}).mesh.triangles, mesh.triangles);
}

TEST(Repair, ASliverIsNoJunction) {
  // The third corner of a triangle at the edge: to divide its neighbor alone would open a gap.
  TriangleMesh mesh = solids::box({0, 0, 0}, {2, 2, 2});
  const auto [a, b, c] = mesh.triangles[0];
  const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
  const auto m = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({(p.x + q.x) / 2 + 0x1p-9, (p.y + q.y) / 2 + 0x1p-9, (p.z + q.z) / 2 + 0x1p-9});
  mesh.triangles[0] = {a, m, c};
  mesh.triangles.insert(mesh.triangles.end(), {{m, b, c}, {a, b, m}});
  const Repaired done = repair(mesh, {{RepairKind::t_junctions, 0.0625}});
  EXPECT_EQ(done.mesh.triangles, mesh.triangles);
  EXPECT_TRUE(done.changes.empty());
}

TEST(Repair, TJunctionsWithinAToleranceEndInASoup) {
  std::size_t divided = 0, left = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    TriangleMesh mesh;
    mesh.vertices.resize(5 + random() % 12);
    for (Point3& p : mesh.vertices) p = {double(random() % 8), double(random() % 8), double(random() % 3)};
    mesh.triangles.resize(1 + random() % 14);
    for (auto& t : mesh.triangles)
      for (auto& v : t) v = static_cast<std::uint32_t>(random() % mesh.vertices.size());
    mesh = repair(mesh, {{RepairKind::weld}, {RepairKind::degenerate}, {RepairKind::unused}}).mesh;
    const std::vector<RepairStep> steps{{RepairKind::t_junctions, 0.75}};
    const Repaired done = repair(mesh, steps);
    EXPECT_EQ(triangles_of(repair(shuffled(mesh, random), steps, {.execution = Execution::serial}).mesh),
              triangles_of(done.mesh));
    divided += count(done, ChangeKind::divided_edge), left += count(done, ChangeKind::kept_junction);
  }
  EXPECT_TRUE(divided > 40 && left > 0) << divided << " " << left;
}

TEST(Repair, RefusesWhatIsNone) {
  const TriangleMesh mesh = grid_box(1);
  EXPECT_THROW(repair(mesh, {{RepairKind::weld, -1}}), InvalidShape);
  EXPECT_THROW(repair(mesh, {{RepairKind::zip, NAN}}), NonFinite);
  EXPECT_THROW(repair(mesh, {{static_cast<RepairKind>(99)}}), InvalidShape);
  EXPECT_THROW(repair({{{0, 0, 0}}, {{0, 1, 0}}}, {{RepairKind::unused}}), InvalidShape);
  EXPECT_THROW(repair(mesh, RepairOptions{.progress = [](double) { return false; }}), Cancelled);
  EXPECT_THROW((void)find_faults(mesh).has("opened"), InvalidShape);
  for (std::size_t k = 0; k < repair_kinds; ++k) EXPECT_FALSE(name_of(static_cast<RepairKind>(k)).empty());
  for (std::size_t k = 0; k < change_kinds; ++k) EXPECT_FALSE(text_of(static_cast<ChangeKind>(k)).empty());
}

}  // namespace
}  // namespace plumb
