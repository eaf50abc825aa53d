// Rounded solids: what is called sound is found sound by the checks of meshes, and volumes stay near; what is not is
// named.
#include "plumb/surface/solid/round.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/topology/faults.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solids::box, solids::heap, solids::torus, solids::turned;

/// By code that knows nothing of solids.
void expect_sound(const RoundedMesh& r) {
  ASSERT_EQ(r.sources.size(), r.mesh.triangles.size());
  if (!r.sound) return;
  EXPECT_TRUE(r.meeting.empty());
  const SurfaceFaults f = find_faults(r.mesh);
  EXPECT_TRUE(f.closed);
  EXPECT_TRUE(f.oriented);
  EXPECT_FALSE(f.meets_itself());
  EXPECT_EQ(f.degenerate, 0U);
  EXPECT_EQ(f.repeated_vertices, 0U);
  EXPECT_EQ(f.duplicate_triangles + f.opposite_triangles, 0U);
  EXPECT_EQ(f.open_edges, 0U);
}

TEST(Round, NothingIsRoundedWhereDoublesHoldIt) {
  const ExactMesh exact = unite(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
  const RoundedMesh r = round(exact);
  expect_sound(r);
  EXPECT_TRUE(r.sound);
  EXPECT_EQ(r.moved, 0);
  EXPECT_EQ(r.rounds, 1U);
  EXPECT_EQ(r.mesh.triangles, exact.triangles);
  EXPECT_EQ(r.sources, exact.sources);
  EXPECT_EQ(solid_laws::volume_of(r.mesh), Rational(15));
}

TEST(Round, TorusTurnedAgainstItself) {
  const TriangleMesh a = torus(3, 1, 24, 12), b = turned(torus(3, 1, 23, 11));
  const Rational of_a = solid_laws::volume_of(a), of_b = solid_laws::volume_of(b);
  const ExactMesh both = unite(a, b), common = intersect(a, b);
  EXPECT_EQ(of_a + of_b, exact_volume(both) + exact_volume(common));
  for (const ExactMesh* m : {&both, &common}) {
    const RoundedMesh r = round(*m);
    expect_sound(r);
    EXPECT_TRUE(r.sound);
    EXPECT_GT(r.moved, 0);
    EXPECT_LT(r.moved, 1e-14);
  }
}

TEST(Round, HeapsOfTetrahedra) {
  std::size_t sound = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const RoundedMesh r = round(unite(heap(random, 4, 3), heap(random, 4, 3)));
    expect_sound(r);
    sound += r.sound;
    EXPECT_LT(r.moved, 1e-13);
  }
  RecordProperty("sound", static_cast<int>(sound));
  EXPECT_GE(sound, 55U);
}

TEST(Round, OneUlpApart) {
  std::size_t sound = 0, all = 0;
  const TriangleMesh a = turned(torus(3, 1, 16, 8));
  for (int k = 0; k < 3; ++k) {
    TriangleMesh b = a;
    for (Point3& p : b.vertices) {
      double& x = k == 0 ? p.x : k == 1 ? p.y : p.z;
      x = std::nextafter(x, 10);
    }
    for (const ExactMesh& m : {unite(a, b), intersect(a, b), subtract(a, b)}) {
      const RoundedMesh r = round(m);
      expect_sound(r);
      ++all;
      sound += r.sound;
    }
  }
  EXPECT_EQ(sound, all);
}

TriangleMesh tetrahedron_mesh(const std::array<double, 12>& q) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < 12; i += 3) mesh.vertices.push_back({q[i], q[i + 1], q[i + 2]});
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

void expect_all_sound(const std::array<double, 12>& a, const std::array<double, 12>& b) {
  const TriangleMesh first = tetrahedron_mesh(a), second = tetrahedron_mesh(b);
  for (const ExactMesh& made : {unite(first, second), intersect(first, second), subtract(first, second)}) {
    const RoundedMesh r = round(made);
    expect_sound(r);
    EXPECT_TRUE(r.sound);
  }
}

TEST(Round, TetrahedraAnUlpAside) {
  // Finer grids are left in time for the coarse one on which this is sound.
  constexpr double up = 0x1.3333333333334p-1, tiny = -0x0.0000000000001p-1022;
  expect_all_sound({0, 0.2, 0.4, -0.1, -0.6, 0.8, -0.5, 0.6, -0.3, -0.8, 0, -0.3},
                   {0, std::nextafter(0.2, 0), std::nextafter(0.4, 1), std::nextafter(-0.1, 0), std::nextafter(-0.6, 0),
                    0.8, std::nextafter(-0.5, -1), up, -0.3, std::nextafter(-0.8, 0), tiny, std::nextafter(-0.3, 0)});
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::array<double, 12> a{}, b{};
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = static_cast<double>(random() % 19) / 10 - 0.9;
      const std::uint64_t ulp = random() % 3;
      b[i] = ulp == 0 ? a[i] : std::nextafter(a[i], ulp == 1 ? -2 : 2);
    }
    const std::vector<Point3> corners = tetrahedron_mesh(a).vertices;
    if (orient3d(corners[0], corners[1], corners[2], corners[3]) == Sign::negative) expect_all_sound(a, b);
  }
}

}  // namespace
}  // namespace plumb
