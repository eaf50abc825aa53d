// What operations on solids promise of any input: of meshes from the wild with themselves, moved by steps and ulps and
// turned by rigid poses, of mirrors and powers of two, and of chains in any order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "plumb/figure/basic/rounded_poses.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/solid/evaluate.hpp"
#include "plumb/surface/solid/round.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::expect_closed, solid_laws::expect_equal;
using solids::box, solids::heap;

enum class Volumes : bool { compared, left };

struct RoundedCount {
  std::size_t all = 0, unsound = 0;
};

/// All four operations by one arrangement, and against those that are asked for alone.
void expect_identities(const TriangleMesh& a, const TriangleMesh& b, Volumes volumes, RoundedCount& count) {
  const std::vector<TriangleMesh> meshes{a, b};
  const Arrangement all = arrange(meshes);
  const auto where = [&](bool (*rule)(bool, bool)) {
    return solid_where(all, [rule](std::span<const std::int32_t> w) { return rule(w[0] > 0, w[1] > 0); });
  };
  const ExactMesh both = where([](bool l, bool r) { return l || r; }),
                  common = where([](bool l, bool r) { return l && r; }),
                  first = where([](bool l, bool r) { return l && !r; }),
                  second = where([](bool l, bool r) { return r && !l; });
  for (const ExactMesh* m : {&both, &common, &first, &second}) expect_closed(*m);
  if (volumes == Volumes::compared) {
    const Rational of_a = exact_volume(resolve(a)), of_b = exact_volume(resolve(b));
    EXPECT_EQ(of_a + of_b, exact_volume(both) + exact_volume(common));
    EXPECT_EQ(of_a, exact_volume(common) + exact_volume(first));
    EXPECT_EQ(of_b, exact_volume(common) + exact_volume(second));
  }
  expect_equal(unite(b, a), both);  // commutation
  expect_equal(intersect(b, a), common);
  for (const ExactMesh* m : {&both, &common, &first}) {
    const RoundedMesh rounded = round(*m);
    ++count.all;
    count.unsound += rounded.sound ? 0 : 1;
    EXPECT_TRUE(rounded.sound || !rounded.meeting.empty());
    if (!rounded.sound || rounded.mesh.triangles.empty()) continue;
    EXPECT_TRUE(is_oriented_closed(rounded.mesh));
  }
}

TriangleMesh moved(TriangleMesh mesh, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}
TriangleMesh turned(TriangleMesh mesh, const RigidPose& pose) {
  for (Point3& p : mesh.vertices) p = rounded_image(pose, p);
  return mesh;
}
TriangleMesh one_ulp_up(TriangleMesh mesh) {
  for (Point3& p : mesh.vertices)
    if (p.x != 0) p.x = std::nextafter(p.x, std::numeric_limits<double>::infinity());
  return mesh;
}
/// What is mirrored is turned as well, so that it is wound outward again.
TriangleMesh mirrored(TriangleMesh mesh) {
  for (Point3& p : mesh.vertices) p.x = -p.x;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TEST(SolidIdentities, MeshesFromTheWild) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
#ifdef PLUMB_LONG_TESTS
  const std::vector<const char*> names{"cow.obj",    "spot.obj",        "fandisk.obj",   "suzanne.obj",
                                       "beetle.obj", "cheburashka.obj", "horse.ply",     "igea.ply",
                                       "teapot.obj", "rocker-arm.obj",  "nefertiti.obj", "stanford-bunny.obj"};
#else
  const std::vector<const char*> names{"spot.obj", "suzanne.obj"};
#endif
  std::size_t tried = 0, missing = 0;
  RoundedCount count;
  for (const char* const name : names) {
    if (!std::filesystem::exists(folder / name)) {
      std::printf("skipped: there is no %s\n", (folder / name).c_str());
      ++missing;
      continue;
    }
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_mesh(folder / name);
    if (!is_oriented_closed(mesh)) {
      std::printf("skipped: %s bounds nothing\n", name);
      continue;
    }
    ++tried;
    const ExactMesh alone = resolve(mesh);
    expect_equal(unite(mesh, mesh), alone);
    expect_equal(intersect(mesh, mesh), alone);
    EXPECT_TRUE(subtract(mesh, mesh).triangles.empty());
    EXPECT_TRUE(symmetric_difference(mesh, mesh).triangles.empty());
    double low = mesh.vertices[0].x, high = low;
    for (const Point3& p : mesh.vertices) low = std::min(low, p.x), high = std::max(high, p.x);
    const double step = std::ldexp(1.0, std::ilogb(high - low) - 3);
    expect_identities(mesh, moved(mesh, {step, 0, step}), Volumes::left, count);
    expect_identities(mesh, turned(mesh, {{3, 1, 0.5, 0.25}, {0, 0, 0}}), Volumes::left, count);
    expect_identities(mesh, one_ulp_up(mesh), Volumes::left, count);
  }
  std::printf("%zu of %zu are not sound when they are rounded\n", count.unsound, count.all);
  EXPECT_EQ(count.unsound, 0U);
  EXPECT_TRUE(tried > 0 || missing == names.size());
}

TEST(SolidIdentities, HeapsUnderShiftsTurnsMirrorsAndPowersOfTwo) {
  RoundedCount count;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = heap(random, 2, 2), b = heap(random, 2, 2);
    expect_identities(a, b, Volumes::compared, count);
    expect_identities(a, one_ulp_up(a), Volumes::compared, count);
    expect_identities(a, one_ulp_up(b), Volumes::compared, count);
    expect_identities(a, turned(b, {{1, 0.25, 0.125, 0.5}, {0.25, 0, 0}}), Volumes::compared, count);
    const std::vector<TriangleMesh> plain{a, b}, seen{mirrored(a), mirrored(b)};
    EXPECT_EQ(exact_volume(subtract(plain)), exact_volume(subtract(seen)));
    EXPECT_EQ(exact_volume(unite(plain)), exact_volume(unite(seen)));
    for (const int exponent : {-300, 300}) {
      std::vector<TriangleMesh> scaled{a, one_ulp_up(b)};
      const ExactMesh unscaled = unite(scaled);
      for (TriangleMesh& mesh : scaled)
        for (Point3& p : mesh.vertices)
          p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
      const ExactMesh made = unite(scaled);
      EXPECT_EQ(made.triangles, unscaled.triangles);
    }
    if (HasFailure()) return;
  }
  // What surfaces an ulp apart enclose is thinner than the grids of the first rounds, and gone on coarser ones.
  std::printf("%zu of %zu are not sound when they are rounded\n", count.unsound, count.all);
  EXPECT_EQ(count.unsound, 0U);
}

TEST(SolidIdentities, ChainsOfSixtyInAnyOrder) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> at(0, 9), size(1, 3);
    std::vector<Csg3> leaves;
    for (int i = 0; i < 60; ++i) {
      const Point3 p{double(at(random)), double(at(random)), double(at(random))};
      leaves.push_back(csg(Aabb3{p, {p.x + size(random), p.y + size(random), p.z + size(random)}}));
    }
    const auto folded = [&](const std::vector<Csg3>& all) {
      Csg3 made = all[0];
      for (std::size_t i = 1; i < all.size(); ++i) made = std::move(made) | all[i];
      return made;
    };
    const ExactMesh in_turn = evaluate(folded(leaves));
    expect_closed(in_turn);
    // Associativity: by halves, and backward.
    std::vector<Csg3> first(leaves.begin(), leaves.begin() + 30), rest(leaves.begin() + 30, leaves.end());
    expect_equal(evaluate(folded(first) | folded(rest)), in_turn);
    std::vector<Csg3> others(leaves);
    std::ranges::shuffle(others, random);
    expect_equal(evaluate(folded(others)), in_turn);
    // De Morgan, and what is taken away in turn or at once.
    const Csg3 all_of_it = csg(Aabb3{{-1, -1, -1}, {14, 14, 14}});
    Csg3 less = all_of_it;
    for (const Csg3& leaf : leaves) less = std::move(less) - leaf;
    expect_equal(evaluate(less), evaluate(all_of_it - folded(leaves)));
    expect_equal(evaluate(less), evaluate(all_of_it & ~folded(others)));
    EXPECT_EQ(exact_volume(evaluate(less)) + exact_volume(in_turn), Rational(15 * 15 * 15));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace plumb
