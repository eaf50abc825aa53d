// Is the first contact of a mesh that moves along a line that of all pairs of triangles, equal times by numbers?
#include "plumb/space/moving/translating_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

Triangle3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

struct FirstOfAll {
  std::optional<MeshContact> contact;
  std::optional<Root> time;
};

FirstOfAll by_brute_force(const TriangleMesh& a, const Vector3& by, const TriangleMesh& b) {
  FirstOfAll first;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
      const Translating<Triangle3> moving{at(a, i), by};
      const auto contact = first_contact(moving, at(b, k));
      if (!contact || (first.time && *first.time <= Rational(contact->time))) continue;
      auto time = first_contact_time(moving, at(b, k));
      if (!first.time || *time < *first.time) first = {MeshContact{i, k, *contact}, std::move(time)};
    }
  }
  return first;
}

std::size_t expect_first(const TriangleMesh& a, const Vector3& by, const TriangleMesh& b, const std::string& about) {
  const FirstOfAll expected = by_brute_force(a, by, b);
  const Bvh tree_a = build_bvh(a, {.most_in_leaf = 1}), tree_b = build_bvh(b);
  EXPECT_EQ(first_contact(tree_a, by, tree_b), expected.contact) << about;
  const auto time = first_contact_time(build_bvh(a, {.method = BvhMethod::linear}), by, tree_b);
  EXPECT_EQ(time.has_value(), expected.time.has_value()) << about;
  EXPECT_TRUE(!time || !expected.time || *time == *expected.time) << about;
  return !expected.contact ? 0 : expected.contact->contact.time == 0 ? 1 : 2;
}

TEST(TranslatingMesh, MeetsFirstWhatAllPairsMeetFirst) {
  std::array<std::size_t, 3> counts{};  // never, at the start, later
  shape_cases::on_shapes(981, battery::fitting(200), [&](shape_cases::Material& m) {
    const TriangleMesh a = meshes::soup(m, 1 + m.below(6), 1 + m.below(5));
    TriangleMesh b = meshes::soup(m, 1 + m.below(6), 1 + m.below(5));
    const Vector3 by = m.vector3();
    if (m.below(3) != 0) {  // apart at first, as a rule
      for (Point3& p : b.vertices) {
        const Point3 moved{p.x + 0.75 * by.x, p.y + 0.75 * by.y, p.z + 0.75 * by.z};
        if (moved.x - moved.x == 0 && moved.y - moved.y == 0 && moved.z - moved.z == 0) p = moved;
      }
    }
    ++counts[expect_first(a, by, b, m.about(by))];
  });
  for (const std::size_t n : counts) EXPECT_TRUE(!battery::reaches_rare || n > 20) << n;
}

/// A square of 2 n^2 triangles.
TriangleMesh tiles(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) mesh.vertices.push_back({1.0 * k, 1.0 * i, 0});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = (n + 1) * i + k;
      mesh.triangles.insert(mesh.triangles.end(), {{a, a + 1, a + n + 2}, {a, a + n + 2, a + n + 1}});
    }
  }
  return mesh;
}

/// Lattices meet in many triangles at the same time.
TEST(TranslatingMesh, TellsEqualTimes) {
  const TriangleMesh floor = tiles(2);
  TriangleMesh above = floor;
  for (Point3& p : above.vertices) p.z = 1;
  for (const Vector3& by : {Vector3{0, 0, -3}, Vector3{1, 0.5, -3}, Vector3{0, 0, -1}, Vector3{7, 0, -0.875}}) {
    expect_first(above, by, floor, "floor");
  }
  TriangleMesh tipped = above;  // one corner is lower by the last bit of its height
  tipped.vertices[8].z = std::nextafter(1.0, 0.0);
  expect_first(tipped, {0, 0, -3}, floor, "tipped");
  const auto hit = first_contact(build_bvh(tipped), {0, 0, -3}, build_bvh(floor));
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->a, 6u);
  EXPECT_EQ(hit->contact.time, std::nextafter(1 / 3.0, 0.0));
}

/// Numbers in another order.
TriangleMesh shuffled(TriangleMesh mesh, std::uint64_t index) {
  Entropy entropy(77, index);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i)
    std::swap(mesh.triangles[i - 1], mesh.triangles[entropy.below(i)]);
  return mesh;
}

/// Three times a rotation, of integers: planes that lie askew, and stay planes.
Point3 turned(const Point3& p) { return {2 * p.x - p.y + 2 * p.z, 2 * p.x + 2 * p.y - p.z, -p.x + 2 * p.y + 2 * p.z}; }
TriangleMesh turned(TriangleMesh mesh) {
  for (Point3& p : mesh.vertices) p = turned(p);
  return mesh;
}

/// Planes, ridges and steps that land on each other, in any order of the numbers, along axes and askew: what stops at
/// a wall is asked all the same where it comes first.
TEST(TranslatingMesh, LandsInAnyOrderOfNumbers) {
  const auto cases = static_cast<std::uint64_t>(battery::fitting(60));
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(78, i);
    TriangleMesh floor = tiles(2), above = floor;
    for (Point3& p : above.vertices) p = {p.x + 0.25 * static_cast<double>(entropy.within(6)), p.y + 0.5, 2 + p.z};
    const std::uint64_t shape = entropy.below(4);
    if (shape == 1) floor.vertices[4].z = 1;                        // a tip below a plane
    if (shape == 2) above.vertices[1].z = above.vertices[4].z = 1;  // part of a ridge above one
    if (shape == 3) above.vertices[8].z = floor.vertices[0].z = 1;  // a corner alone
    const Point3 way{0.5 * static_cast<double>(entropy.within(2)), 0.25 * static_cast<double>(entropy.within(2)), -4};
    const bool is_turned = entropy.coin();
    const Point3 by = is_turned ? turned(way) : way;
    const auto placed = [&](const TriangleMesh& mesh, std::uint64_t number) {
      return shuffled(is_turned ? turned(mesh) : mesh, number);
    };
    expect_first(placed(above, 2 * i), {by.x, by.y, by.z}, placed(floor, 2 * i + 1), "case " + std::to_string(i));
    const auto in_touch = placed(floor, 2 * i);  // at the start, in all pairs that have a corner in common
    expect_first(in_touch, {by.x, by.y, by.z}, placed(floor, 2 * i + 1), "in touch, case " + std::to_string(i));
  }
}

/// In thousands of pairs at once, whatever their order.
TEST(TranslatingMesh, LandsFlat) {
  TriangleMesh floor = tiles(battery::sanitized ? 4 : 16);
  for (int turned = 0; turned < 2; ++turned, std::ranges::reverse(floor.triangles)) {
    TriangleMesh above = floor;
    for (Point3& p : above.vertices) p.z = 1;
    for (const Vector3& by : {Vector3{0, 0, -3}, Vector3{0.3, 0.1, -3}}) {
      const Bvh a = build_bvh(above), b = build_bvh(floor);
      const auto hit = first_contact(a, by, b);
      ASSERT_TRUE(hit.has_value());
      EXPECT_EQ(hit->a, 0u);
      EXPECT_EQ(hit->b, 0u);
      EXPECT_TRUE(*first_contact_time(a, by, b) == Rational(1) / Rational(3));
    }
  }
}

TEST(TranslatingMesh, ThatOnlyTouchesInPassingMeets) {
  const TriangleMesh post{{{0, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}}};
  const TriangleMesh tip{{{-4, 0, 0.25}, {-5, 2, 0}, {-5, 2, 1}}, {{0, 1, 2}}};
  const Bvh a = build_bvh(tip), b = build_bvh(post);
  const auto hit = first_contact(a, {8, 0, 0}, b);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->contact.time, 0.5);
  EXPECT_EQ(first_contact(a, {8, 0x1p-1074, 0}, b).has_value(), false);
  EXPECT_EQ(first_contact(a, {4, 0, 0}, b)->contact.time, 1);
  EXPECT_EQ(first_contact(a, {std::nextafter(4.0, 0.0), 0, 0}, b), std::nullopt);
  EXPECT_EQ(first_contact(b, {0, 0, 0}, b)->contact.time, 0);
}

TEST(TranslatingMesh, OfSurfacesAndOfTreesInOtherFrames) {
  TriangleMesh ring = meshes::ring(3);
  if (battery::sanitized) ring.triangles.resize(12);
  TriangleMesh apart = ring;
  for (Point3& p : apart.vertices) p = {p.x + 3, p.y + 0.25, p.z};
  expect_first(ring, {1, 0, 0}, apart, "rings");
  expect_first(ring, {0.125, 0, 0}, apart, "rings that stay apart");
  const auto own = first_contact(build_bvh(ring), {0.5, 0, 0}, build_bvh(ring));
  EXPECT_EQ(own, (MeshContact{0, 0, {0, {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}}));
  TriangleMesh far = ring;
  for (Point3& p : far.vertices) p = {p.x * 0x1p60 + 0x1p62, p.y * 0x1p60, p.z * 0x1p60};
  expect_first(ring, {0x1p63, 0, 0}, far, "far");
  expect_first(far, {-0x1p63, 0, 0}, ring, "from afar");
  EXPECT_EQ(expect_first(meshes::repeated(9), {0, 0, -1}, meshes::repeated(3), "repeated"), 1u);
}

TEST(TranslatingMesh, OfNothingMeetsNothing) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::ring(3));
  EXPECT_EQ(first_contact(none, {0, 0, 0}, some), std::nullopt);
  EXPECT_EQ(first_contact(some, {0, 0, 0}, none), std::nullopt);
  EXPECT_FALSE(first_contact_time(none, {0, 0, 0}, none).has_value());
  const auto wrong = [&] { (void)first_contact(some, {0, std::numeric_limits<double>::infinity(), 0}, some); };
  EXPECT_THAT(text_of<NonFinite>(wrong), ::testing::HasSubstr("first_contact: by.y is inf"));
}

}  // namespace
}  // namespace plumb
