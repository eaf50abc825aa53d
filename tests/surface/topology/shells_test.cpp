// Shells: how many, which lies in which, which is inside out, which is a wall; against shapes known beforehand and, for
// heaps of tetrahedra on a small grid, against the definition.
#include "plumb/surface/topology/shells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <random>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb {
namespace {

using solids::append;
using solids::box;

const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

TriangleMesh moved(TriangleMesh mesh, const Point3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}
TriangleMesh both(TriangleMesh mesh, const TriangleMesh& other, bool inside_out = false) {
  append(mesh, other, inside_out);
  return mesh;
}
/// Equal vertices become one, as in an STL file.
TriangleMesh welded(TriangleMesh mesh) {
  const std::vector<std::uint32_t> first = first_equal(mesh.vertices);
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = first[v];
  return mesh;
}
/// Two triangles across x, from (x, 0, 0) to (x, w, w).
TriangleMesh wall(double x, double w) { return {{{x, 0, 0}, {x, w, 0}, {x, w, w}, {x, 0, w}}, {{0, 1, 2}, {0, 2, 3}}}; }

std::vector<Shell> shells_of(const TriangleMesh& mesh) { return find_shells(mesh).shells; }

TEST(Shells, OneSolidIsOne) {
  const Shells found = find_shells(box({0, 0, 0}, {4, 4, 4}));
  ASSERT_EQ(found.shells.size(), 1U);
  const Shell& s = found.shells[0];
  EXPECT_EQ(s.triangles, 12U);
  EXPECT_TRUE(s.closed && s.oriented && !s.meets && !s.crosses && !s.wall && !s.inside_out());
  EXPECT_EQ(s.volume, 64);
  EXPECT_EQ(s.depth, 0U);
  EXPECT_FALSE(s.parent);
  EXPECT_EQ(found.met, PairCount{});
}

TEST(Shells, NoTrianglesNoShells) {
  EXPECT_TRUE(shells_of({}).empty());
  EXPECT_TRUE(shells_of({{{0, 0, 0}, {1, 1, 1}}, {{0, 1, 1}}}).empty());
  EXPECT_EQ(find_shells({{{0, 0, 0}, {1, 1, 1}}, {{0, 1, 1}}}).shell_of, (std::vector<std::uint32_t>{no_shell}));
}

TEST(Shells, TheOneThatIsWoundInwardIsInsideOut) {
  for (const double size : {0.25, 1.0, 8.0}) {
    TriangleMesh other = tetrahedron;
    for (Point3& p : other.vertices) p = {size * p.x + 5, size * p.y, size * p.z};
    const std::vector<Shell> shells = shells_of(both(tetrahedron, other, true));
    ASSERT_EQ(shells.size(), 2U);
    EXPECT_FALSE(shells[0].inside_out());
    EXPECT_TRUE(shells[1].inside_out());
    EXPECT_EQ(shells[1].first_triangle, 4U);
    EXPECT_EQ(shells[1].volume, -size * size * size / 6);
  }
}

TEST(Shells, ACavityIsWoundInwardAndWhatIsInItOutward) {
  TriangleMesh mesh = box({0, 0, 0}, {8, 8, 8});
  append(mesh, box({1, 1, 1}, {7, 7, 7}), true);
  append(mesh, box({2, 2, 2}, {3, 3, 3}));
  append(mesh, box({4, 4, 4}, {6, 6, 6}));
  std::vector<Shell> shells = shells_of(mesh);
  ASSERT_EQ(shells.size(), 4U);
  for (const Shell& s : shells) EXPECT_FALSE(s.inside_out() || s.meets);
  EXPECT_FALSE(shells[0].parent);
  EXPECT_EQ(shells[1].parent, 0U);
  EXPECT_EQ(shells[2].parent, 1U);
  EXPECT_EQ(shells[3].parent, 1U);
  EXPECT_EQ(shells[3].depth, 2U);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  for (const Shell& s : shells_of(mesh)) EXPECT_TRUE(s.inside_out());
  shells = shells_of(both(box({0, 0, 0}, {8, 8, 8}), box({1, 1, 1}, {7, 7, 7})));
  EXPECT_FALSE(shells[0].inside_out());
  EXPECT_TRUE(shells[1].inside_out()) << "a cavity with positive volume";
}

TEST(Shells, MeetAtAVertexOrAnEdge) {
  const TriangleMesh mirrored{{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                              {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  for (const bool shared : {false, true}) {
    const TriangleMesh mesh = both(tetrahedron, mirrored);
    const std::vector<Shell> shells = shells_of(shared ? welded(mesh) : mesh);
    ASSERT_EQ(shells.size(), 2U);
    for (const Shell& s : shells) EXPECT_TRUE(s.closed && s.meets && !s.crosses && !s.inside_out() && s.depth == 0);
    const TriangleMesh cubes = both(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}));
    const std::vector<Shell> two = shells_of(shared ? welded(cubes) : cubes);
    ASSERT_EQ(two.size(), 2U);
    for (const Shell& s : two) EXPECT_TRUE(s.closed && s.meets && !s.crosses && s.volume == 1);
  }
}

TEST(Shells, ThatShareAFaceMeetAndDoNotCross) {
  for (const Point3& by : {Point3{2, 0, 0}, Point3{2, 1, 0}, Point3{2, 1, 1}}) {
    const std::vector<Shell> shells = shells_of(both(box({0, 0, 0}, {2, 2, 2}), moved(box({0, 0, 0}, {2, 2, 2}), by)));
    ASSERT_EQ(shells.size(), 2U);
    for (const Shell& s : shells) EXPECT_TRUE(s.meets && !s.crosses && s.depth == 0) << by.y;
  }
}

TEST(Shells, CrossAlsoWhereTheirFacesAreCoplanar) {
  for (const Point3& by : {Point3{1, 0, 0}, Point3{1, 1, 0}, Point3{1, 1, 1}}) {
    const Shells found = find_shells(both(box({0, 0, 0}, {2, 2, 2}), moved(box({0, 0, 0}, {2, 2, 2}), by)));
    ASSERT_EQ(found.shells.size(), 2U);
    for (const Shell& s : found.shells) EXPECT_TRUE(s.crosses && s.depth == 0) << by.y << by.z;
    EXPECT_EQ(found.crossing, (std::vector<ShellPair>{{0, 1}}));
  }
}

TEST(Shells, LieInAnotherThatTheyTouch) {
  // With corners on the outer one's faces and edges, and with all of them there.
  for (const TriangleMesh& inner : {box({1, 1, 0}, {2, 2, 1}), box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {4, 4, 1})}) {
    const std::vector<Shell> shells = shells_of(both(box({0, 0, 0}, {4, 4, 4}), inner, true));
    ASSERT_EQ(shells.size(), 2U);
    EXPECT_EQ(shells[1].parent, 0U);
    EXPECT_FALSE(shells[0].parent);
    EXPECT_TRUE(shells[1].meets && !shells[1].crosses && !shells[1].inside_out());
  }
  const TriangleMesh whole = box({0, 0, 0}, {2, 2, 2});
  TriangleMesh octahedron{{{0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}},
                          {{0, 2, 5}, {2, 1, 5}, {1, 3, 5}, {3, 0, 5}, {2, 0, 4}, {1, 2, 4}, {3, 1, 4}, {0, 3, 4}}};
  std::vector<Shell> shells = shells_of(both(whole, octahedron));
  EXPECT_EQ(shells[1].parent, 0U);
  EXPECT_TRUE(shells[1].inside_out());
}

TEST(Shells, AWallIsInsideOfASolid) {
  std::vector<Shell> shells = shells_of(both(box({0, 0, 0}, {2, 2, 2}), wall(1, 2)));
  ASSERT_EQ(shells.size(), 2U);
  EXPECT_FALSE(shells[0].wall);
  EXPECT_TRUE(shells[1].wall);
  EXPECT_EQ(shells[1].parent, 0U);
  shells = shells_of(both(box({0, 0, 0}, {2, 2, 2}), moved(wall(1, 1), {0, 0.5, 0.5})));
  EXPECT_TRUE(shells[1].wall) << "that touches nothing";
  shells = shells_of(both(box({0, 0, 0}, {2, 2, 2}), wall(2, 2)));
  EXPECT_FALSE(shells[1].wall) << "on the surface";
  shells = shells_of(both(box({0, 0, 0}, {2, 2, 2}), wall(3, 2)));
  EXPECT_FALSE(shells[1].wall) << "outside";
  shells = shells_of(both(box({0, 0, 0}, {2, 2, 2}), moved(wall(1, 2), {0, 1, 1})));
  EXPECT_FALSE(shells[1].wall) << "partly outside";
  EXPECT_TRUE(shells[1].crosses);
  constexpr double odd = 0x1p53 - 1;
  shells = shells_of(both(box({0, 0, 0}, {odd, odd, odd}), wall(odd - 2, odd)));
  EXPECT_TRUE(shells[1].wall) << "whose corners are on the surface, and the middle of no triangle is a double";
  TriangleMesh hollow = both(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {3, 3, 3}), true);
  append(hollow, moved(wall(2, 1), {0, 1.5, 1.5}));
  EXPECT_FALSE(shells_of(hollow)[2].wall) << "in the cavity";
}

/// Boxes in a row, each with the wall to the next once, sharing all vertices.
TriangleMesh divided(int cells, bool with_walls) {
  TriangleMesh mesh = solids::voxels([&] {
    std::set<solids::Cell> row;
    for (int i = 0; i < cells; ++i) row.insert({i, 0, 0});
    return row;
  }());
  for (int i = 1; with_walls && i < cells; ++i) append(mesh, wall(i, 1), i % 2 == 0);
  return welded(mesh);
}

TEST(Shells, WallsThatShareTheirEdgesDivideASolid) {
  for (const int cells : {2, 3, 5}) {
    EXPECT_EQ(shells_of(divided(cells, false)).size(), 1U);
    const Shells found = find_shells(divided(cells, true));
    const auto walls = std::ranges::count(found.shells, true, &Shell::wall);
    EXPECT_EQ(walls, cells - 1);
    EXPECT_EQ(found.shells.size(), 2 * static_cast<std::size_t>(cells) - 1);
    for (std::size_t t = 0; t < found.shell_of.size(); ++t) {
      EXPECT_EQ(found.shells[found.shell_of[t]].wall,
                t >= found.shell_of.size() - 2 * static_cast<std::size_t>(cells - 1));
    }
  }
  // A fin outside is none.
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  append(mesh, {{{0, 0, 0}, {0, 0, 1}, {-1, -1, 0}}, {{0, 1, 2}}});
  for (const Shell& s : shells_of(welded(mesh))) EXPECT_FALSE(s.wall);
  // One inside is.
  mesh.vertices.back() = {0.5, 0.5, 0.25};
  const std::vector<Shell> shells = shells_of(welded(mesh));
  EXPECT_EQ(std::ranges::count(shells, true, &Shell::wall), 1);
  EXPECT_TRUE(shells.back().wall);
}

TEST(Shells, TheSignOfAVolumeIsExactWhereTheVolumeRoundsToNothing) {
  for (const bool inward : {false, true}) {
    TriangleMesh mesh;
    append(mesh, tetrahedron, inward);
    for (Point3& p : mesh.vertices) p = {p.x * 0x1p-1070, p.y * 0x1p-1070, p.z * 0x1p-1070};
    const std::vector<Shell> shells = shells_of(mesh);
    ASSERT_EQ(shells.size(), 1U);
    EXPECT_EQ(shells[0].volume, 0);
    EXPECT_EQ(shells[0].volume_sign, inward ? Sign::negative : Sign::positive);
    EXPECT_EQ(shells[0].inside_out(), inward);
  }
  const std::vector<Shell> flat = shells_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_TRUE(flat[0].closed && !flat[0].inside_out());
}

TEST(Shells, OpenAndUnorientedOnesHaveNoVolume) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  Shell s = shells_of(mesh).front();
  EXPECT_TRUE(s.closed && !s.oriented && !s.volume && !s.inside_out());
  mesh.triangles.pop_back();
  s = shells_of(mesh).front();
  EXPECT_TRUE(!s.closed && !s.volume && !s.wall);
}

TEST(Shells, AreTheSameInEveryTreeAndOnOneThread) {
  std::mt19937_64 random(35);
  const TriangleMesh mesh = both(welded(solids::heap(random, 40, 3)), box({-9, -9, -9}, {9, 9, 9}));
  const Shells parallel = find_shells(mesh), serial = find_shells(mesh, {.execution = Execution::serial});
  const Shells split = find_shells(mesh, find_edges(mesh), build_bvh(mesh, {.split_share = 2}));
  for (const Shells& other : {serial, split}) {
    EXPECT_EQ(parallel.shells, other.shells);
    EXPECT_EQ(parallel.crossing, other.crossing);
    EXPECT_EQ(parallel.met, other.met);
  }
  EXPECT_EQ(parallel.met, count_intersecting_pairs(build_bvh(mesh)));
}

/// The definition, pair by pair, of shells that are meshes of their own; coordinates are multiples of four.
struct ByDefinition {
  std::vector<TriangleMesh> shells;

  static Triangle3 triangle(const TriangleMesh& m, std::size_t t) {
    return {m.vertices[m.triangles[t][0]], m.vertices[m.triangles[t][1]], m.vertices[m.triangles[t][2]]};
  }
  static bool coplanar(const Triangle3& s, const Triangle3& t) {
    for (const Point3& p : {t.a, t.b, t.c})
      if (orient3d(s.a, s.b, s.c, p) != Sign::zero) return false;
    for (const Point3& p : {s.a, s.b, s.c})
      if (orient3d(t.a, t.b, t.c, p) != Sign::zero) return false;
    return true;
  }
  [[nodiscard]] bool meets(std::size_t s, std::size_t triangle_of_s, std::size_t t) const {
    for (std::size_t k = 0; k < shells[t].triangles.size(); ++k)
      if (relate(triangle(shells[s], triangle_of_s), triangle(shells[t], k)) != Relation::disjoint) return true;
    return false;
  }
  struct Seen {
    int inside = 0, on = 0, outside = 0;
  };
  /// Of s in t.
  [[nodiscard]] Seen seen(std::size_t s, std::size_t t) const {
    std::vector<Point3> places(shells[s].vertices);
    for (std::size_t k = 0; k < shells[s].triangles.size(); ++k) {
      bool at_others = false;
      for (std::size_t u = 0; u < shells.size(); ++u) at_others = at_others || (u != s && meets(s, k, u));
      const auto [a, b, c] = triangle(shells[s], k);
      if (at_others)
        places.push_back({(2 * a.x + b.x + c.x) / 4, (2 * a.y + b.y + c.y) / 4, (2 * a.z + b.z + c.z) / 4});
    }
    Seen seen;
    for (const Point3& p : places) {
      const Location l = locate(shells[t], p);
      ++(l == Location::inside ? seen.inside : l == Location::boundary ? seen.on : seen.outside);
    }
    return seen;
  }
  [[nodiscard]] bool cross(std::size_t s, std::size_t t) const {
    for (std::size_t i = 0; i < shells[s].triangles.size(); ++i) {
      for (std::size_t k = 0; k < shells[t].triangles.size(); ++k) {
        const Triangle3 a = triangle(shells[s], i), b = triangle(shells[t], k);
        if (relate(a, b) == Relation::overlapping && !coplanar(a, b)) return true;
      }
    }
    const Seen st = seen(s, t), ts = seen(t, s);
    return (st.inside > 0 && st.outside > 0) || (ts.inside > 0 && ts.outside > 0) || (st.inside > 0 && ts.inside > 0);
  }
  [[nodiscard]] bool lies_in(std::size_t s, std::size_t t) const {
    const Seen st = seen(s, t);
    return st.inside > 0 && st.outside == 0 && !cross(s, t);
  }
};

TEST(Shells, OfHeapsAreThoseOfTheDefinition) {
  constexpr std::uint64_t first_seed = 2035;
  int crossing = 0, nested = 0, meeting = 0, apart = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + 150; ++seed) {
    std::mt19937_64 random(seed);
    ByDefinition truth;
    TriangleMesh mesh;
    std::uniform_int_distribution<int> coordinate(-3, 3), size(1, 8), small(0, 2);
    for (int i = 0; i < 5; ++i) {
      TriangleMesh one;
      const Point3 at{4.0 * coordinate(random), 4.0 * coordinate(random), 4.0 * coordinate(random)};
      if (i % 2 == 0) {
        one = box(at, {at.x + 4 * size(random), at.y + 4 * size(random), at.z + 4 * size(random)});
      } else {
        for (int k = 0; k < 4; ++k) {
          one.vertices.push_back({at.x + 4 * small(random), at.y + 4 * small(random), at.z + 4 * small(random)});
        }
        one.triangles = tetrahedron.triangles;
      }
      append(mesh, one);
      truth.shells.push_back(one);
    }
    const Shells found = find_shells(mesh);
    ASSERT_EQ(found.shells.size(), truth.shells.size());
    for (std::uint32_t s = 0; s < found.shells.size(); ++s) {
      std::uint32_t depth = 0;
      for (std::uint32_t t = 0; t < found.shells.size(); ++t) {
        if (s == t) continue;
        const bool cross = truth.cross(s, t), in = truth.lies_in(s, t);
        EXPECT_EQ(std::ranges::binary_search(found.crossing, ShellPair(std::min(s, t), std::max(s, t))), cross)
            << "seed " << seed << ", shells " << s << " and " << t;
        depth += in;
        ++(cross ? crossing : in ? nested : found.shells[s].meets ? meeting : apart);
      }
      EXPECT_EQ(found.shells[s].depth, depth) << "seed " << seed << ", shell " << s;
      EXPECT_TRUE(depth == 0 || truth.lies_in(s, *found.shells[s].parent)) << "seed " << seed << ", shell " << s;
      EXPECT_EQ(found.shells[s].volume, signed_volume(truth.shells[s]));
    }
  }
  // They are no heaps of one kind.
  EXPECT_GT(std::min({crossing, nested, meeting, apart}), 50)
      << crossing << " " << nested << " " << meeting << " " << apart;
}

TEST(Shells, OfFilesOnWhichChecksFallShort) {
  const std::filesystem::path cases = std::filesystem::path(PLUMB_SHARED_DIR) / "cases";
  if (!std::filesystem::exists(cases)) {
    std::cout << "skipped: there is no folder " << cases << "\n";
    return;
  }
  const auto shells = [&](const std::string& file) { return shells_of(read_mesh(cases / file)); };
  for (const char* file : {"one_of_two_shells_inverted.obj", "larger_shell_inverted.obj"}) {
    ASSERT_EQ(shells(file).size(), 2U);
    EXPECT_FALSE(shells(file)[0].inside_out());
    EXPECT_TRUE(shells(file)[1].inside_out());
  }
  EXPECT_EQ(shells("two_shells_one_vertex.obj").size(), 2U);
  EXPECT_EQ(shells("edge_of_four_faces.stl").size(), 2U);
  EXPECT_TRUE(shells("internal_wall.stl")[1].wall);
}

}  // namespace
}  // namespace plumb
