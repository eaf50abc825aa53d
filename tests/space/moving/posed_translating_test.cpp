// Is the first contact of posed meshes that of all pairs of exactly posed triangles, and that of two triangles the one
// that rationals have?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/gmp.hpp"
#include "plumb/space/moving/translating_mesh.hpp"
#include "query/time_of_impact/posed_contact.hpp"
#include "query/time_of_impact/translating_oracle.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;
namespace oracle = translating_oracle;

oracle::Vector vector_of(const RationalPoint& p) { return {p[0], p[1], p[2]}; }
oracle::Body body_of(const Posed<Triangle3>& t) {
  oracle::Body b;
  std::vector<oracle::Vector> corners;
  for (const Point3& p : {t.shape.a, t.shape.b, t.shape.c}) corners.push_back(vector_of(image(p, t.pose)));
  b.add_points(corners);
  for (std::size_t i = 0; i < 3; ++i) b.add(FeatureKind::edge, i, {i, (i + 1) % 3});
  b.add(FeatureKind::face, 0, {0, 1, 2});
  return b;
}
oracle::Vector way_of(const Posed<Vector3>& by) {
  const Pose turn{by.pose.columns, {0, 0, 0}};
  return vector_of(image({by.shape.x, by.shape.y, by.shape.z}, turn));
}
/// From p to q, as a rule, or twice as far: so that they meet, often corner on corner.
Vector3 aimed(Material& m, const Point3& p, const Pose& pose_p, const Point3& q, const Pose& pose_q) {
  if (m.below(4) == 0) return m.vector3();
  const RationalPoint from = image(p, pose_p), to = image(q, pose_q);
  const double times = m.below(2) == 0 ? 1 : 2;
  std::array<double, 3> way{};
  for (std::size_t k = 0; k < 3; ++k) way[k] = times * mpq_class(to[k] - from[k]).get_d();
  const double sum = way[0] + way[1] + way[2];
  return sum - sum == 0 ? Vector3{way[0], way[1], way[2]} : m.vector3();
}

mpq_class number(const Root& root) { return root.rational()->value().value; }

/// Of all pairs of features that meet then, the first is told.
void expect_first_features(const oracle::Body& a, const oracle::Body& b, const oracle::Vector& way,
                           const oracle::Surd& time, const Contact& contact, const std::string& about) {
  const auto rank = [](const Feature& p, const Feature& q) {
    return std::tuple(static_cast<int>(p.kind) + static_cast<int>(q.kind), p.kind, p.index, q.kind, q.index);
  };
  const auto told = rank(contact.feature_a, contact.feature_b);
  for (const oracle::Part& p : a.parts) {
    for (const oracle::Part& q : b.parts) {
      if (rank(p.feature, q.feature) > told) continue;
      const auto when = oracle::first_time(a.part(p), b.part(q), way);
      ASSERT_EQ(when && compare(*when, time) == 0, rank(p.feature, q.feature) == told) << about;
    }
  }
}

TEST(PosedContact, IsThatOfRationals) {
  int never = 0, at_start = 0, later = 0;
  shape_cases::on_shapes(3301, battery::fitting(400), [&](Material& m) {
    const Pose pose = any_pose(m);
    const Posed<Triangle3> a{m.shape<Triangle3>(), pose}, b{m.shape<Triangle3>(), pose_like(m, pose)};
    const Posed<Vector3> by = m.below(2) == 0
                                  ? Posed{aimed(m, a.shape.a, a.pose, b.shape.b, b.pose), identity_pose}
                                  : Posed{aimed(m, a.shape.a, identity_pose, b.shape.b, identity_pose), pose};
    const oracle::Body of_a = body_of(a), of_b = body_of(b);
    const auto truth = oracle::first_time(of_a, of_b, way_of(by));
    const auto contact = query::first_contact(a, by, b);
    const auto time = query::first_contact_time(a, by, b);
    ASSERT_EQ(contact.has_value(), truth.has_value()) << m.about(a, b, by);
    ASSERT_EQ(time.has_value(), truth.has_value()) << m.about(a, b, by);
    if (!truth) {
      ++never;
      return;
    }
    ASSERT_EQ(number(*time), truth->a) << m.about(a, b, by);
    ASSERT_EQ(contact->time, time->rounded(Rounding::down)) << m.about(a, b, by);
    if (contact->feature_a.kind == FeatureKind::interior) {
      ASSERT_EQ(truth->a, 0) << m.about(a, b, by);
    } else {
      expect_first_features(of_a, of_b, way_of(by), *truth, *contact, m.about(a, b, by));
    }
    ++(truth->a == 0 ? at_start : later);
  });
  for (const int n : {never, at_start, later}) EXPECT_TRUE(!battery::reaches_rare || n > 40) << n;
}

struct FirstOfAll {
  std::optional<MeshContact> contact;
  std::optional<Root> time;
};

FirstOfAll by_brute_force(const TriangleMesh& a, const Pose& pose_a, const Posed<Vector3>& by, const TriangleMesh& b,
                          const Pose& pose_b) {
  FirstOfAll first;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
      const auto s = posed_triangle(a, i, pose_a), t = posed_triangle(b, k, pose_b);
      const auto contact = query::first_contact(s, by, t);
      if (!contact || (first.time && *first.time <= Rational(contact->time))) continue;
      auto time = query::first_contact_time(s, by, t);
      if (!first.time || *time < *first.time) first = {MeshContact{i, k, *contact}, std::move(time)};
    }
  }
  return first;
}

void expect_same(const std::optional<Root>& time, const std::optional<Root>& expected, const std::string& about) {
  ASSERT_EQ(time.has_value(), expected.has_value()) << about;
  EXPECT_TRUE(!time || *time == *expected) << about;
}

TEST(PosedTranslating, MeetsFirstWhatAllExactlyPosedPairsMeetFirst) {
  std::array<std::size_t, 3> counts{};  // never, at the start, later
  shape_cases::on_shapes(3302, battery::fitting(150), [&](Material& m) {
    const TriangleMesh a = meshes::soup(m, 1 + m.below(4), m.below(4)), b = meshes::soup(m, 1 + m.below(4), m.below(4));
    const Pose pose_a = any_pose(m), pose_b = pose_like(m, pose_a);
    const bool along_a = m.below(3) == 0;
    const Vector3 by = along_a ? aimed(m, a.vertices[0], identity_pose, b.vertices[0], identity_pose)
                               : aimed(m, a.vertices[0], pose_a, b.vertices[0], pose_b);
    const Posed<Vector3> way{by, along_a ? pose_a : identity_pose};
    const FirstOfAll expected = by_brute_force(a, pose_a, way, b, pose_b);
    const Bvh tree_a = build_bvh(a, {.most_in_leaf = 1}), tree_b = build_bvh(b);
    const MotionAlong along = along_a ? MotionAlong::mesh_a : MotionAlong::world;
    EXPECT_EQ(first_contact({tree_a, pose_a}, by, {tree_b, pose_b}, along), expected.contact) << m.about(by);
    expect_same(first_contact_time({tree_a, pose_a}, by, {tree_b, pose_b}, along), expected.time, m.about(by));
    ++counts[!expected.contact ? 0 : expected.contact->contact.time == 0 ? 1 : 2];
  });
  for (const std::size_t n : counts) EXPECT_TRUE(!battery::reaches_rare || n > 5) << n;
}

/// A common pose changes nothing where its matrix is regular and maps the motion too; nor does it where another pose
/// says the same, so that posed triangles are asked.
TEST(PosedTranslating, AskedUnderOnePoseOrNoneMeetsAlike) {
  std::size_t met = 0;
  shape_cases::on_shapes(3303, battery::fitting(100), [&](Material& m) {
    const TriangleMesh a = meshes::soup(m, 1 + m.below(4), m.below(4)), b = meshes::soup(m, 1 + m.below(4), m.below(4));
    const Vector3 by = aimed(m, a.vertices[0], identity_pose, b.vertices[0], identity_pose);
    const Bvh tree_a = build_bvh(a), tree_b = build_bvh(b);
    const auto contact = first_contact(tree_a, by, tree_b);
    const auto time = first_contact_time(tree_a, by, tree_b);
    met += contact ? 1 : 0;
    const Pose pose = turn(m);
    EXPECT_EQ(first_contact({tree_a, pose}, by, {tree_b, pose}, MotionAlong::mesh_a), contact) << m.about(by);
    EXPECT_EQ(first_contact(PosedMesh(tree_a), by, PosedMesh(tree_b)), contact) << m.about(by);
    // Every triangle is asked under the pose: the poses differ, but neither mesh knows.
    const FirstOfAll posed = by_brute_force(a, pose, {by, pose}, b, pose);
    EXPECT_EQ(posed.contact, contact) << m.about(by);
    expect_same(posed.time, time, m.about(by));
    // One mesh given elsewhere, and moved back by its pose: the search of posed boxes.
    const Pose back{identity_pose.columns, {8, 0, -4}};
    TriangleMesh moved = b;
    for (Point3& p : moved.vertices) {
      const Point3 to{p.x - 8, p.y, p.z + 4};
      if (exact_point(to, back) != p) return;
      p = to;
    }
    const Bvh elsewhere = build_bvh(moved);
    EXPECT_EQ(first_contact(tree_a, by, {elsewhere, back}), contact) << m.about(by);
    expect_same(first_contact_time(tree_a, by, {elsewhere, back}), time, m.about(by));
  });
  EXPECT_TRUE(!battery::reaches_rare || met > 30) << met;
}

TriangleMesh square(std::uint32_t n) {
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

/// Turned alike by a rotation in doubles they land flat on each other, all at once; the poses differ in what z = 0 does
/// not show.
TEST(PosedTranslating, LandsFlatWhereBothAreTurned) {
  const std::uint32_t n = battery::sanitized ? 3 : 8;
  const Bvh floor = build_bvh(square(n)), above = build_bvh(square(n));
  const Pose turn{{{{0.8, 0.6, 0}, {-0.36, 0.48, 0.8}, {0.48, -0.64, 0.6}}}, {0.1, 0.2, 0.3}};
  const Pose mirrored{{{{0.8, 0.6, 0}, {-0.36, 0.48, 0.8}, {-0.48, 0.64, -0.6}}}, {0.1, 0.2, 0.3}};
  for (const Vector3& by : {Vector3{0, 0, -3}, Vector3{0.25, 0.5, -3}}) {
    TriangleMesh high = square(n);
    for (Point3& p : high.vertices) p.z = 1;
    const Bvh lifted = build_bvh(high);
    const auto hit = first_contact({lifted, turn}, by, {floor, mirrored}, MotionAlong::mesh_a);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(*hit, *first_contact(lifted, by, floor));
    EXPECT_TRUE(*first_contact_time({lifted, turn}, by, {floor, mirrored}, MotionAlong::mesh_a) ==
                Rational(1) / Rational(3));
  }
}

/// Doubled, flattened to a plane, a line and a point, and beyond the largest double.
TEST(PosedTranslating, UnderMatricesOfAnyKind) {
  const Bvh tile = build_bvh(square(1));
  const Pose doubled{{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}, {0, 0, 4}};
  EXPECT_EQ(first_contact({tile, doubled}, {0, 0, -8}, tile)->contact.time, 0.5);
  const Pose plane{{{{1, 0, 0}, {0, 0, 0}, {0, 0, 1}}}, {0, 0.5, 4}}, line{{{{0, 0, 0}, {0, 1, 0}}}, {0.5, 0, 4}};
  const Pose point{{}, {0.5, 0.25, 4}}, outside{{}, {2, 2, 4}};
  for (const Pose& pose : {plane, line, point}) {
    const auto hit = first_contact({tile, pose}, {0, 0, -16}, tile);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->contact.time, 0.25);
    EXPECT_EQ(first_contact({tile, pose}, {0, 0, -16}, {tile, outside}), std::nullopt);
  }
  EXPECT_EQ(first_contact({tile, point}, {1.5, 1.75, 0}, {tile, outside})->contact.time, 1);
  EXPECT_EQ(first_contact({tile, point}, {1.5, 1.75 - 0x1p-50, 0}, {tile, outside}), std::nullopt);
  const double most = std::numeric_limits<double>::max();
  const Pose far{{{{most, 0, 0}, {0, most, 0}, {0, 0, most}}}, {0, 0, most}};
  const auto hit = first_contact({tile, far}, {0, 0, -2}, {tile, doubled}, MotionAlong::mesh_a);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->contact.time, 0.5 - 0x1p-54);  // the floor lies above zero by a part of the largest double
}

TEST(PosedTranslating, OfNothingMeetsNothing) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(square(1));
  const Pose away{identity_pose.columns, {1, 2, 3}};
  EXPECT_EQ(first_contact({none, away}, {0, 0, 0}, some), std::nullopt);
  EXPECT_FALSE(first_contact_time(some, {0, 0, 0}, {none, away}).has_value());
  Pose wrong = away;
  wrong.translation.x = std::numeric_limits<double>::quiet_NaN();
  const auto posed = [&] { (void)first_contact({some, wrong}, {0, 0, 0}, some); };
  EXPECT_THAT(text_of<NonFinite>(posed), ::testing::HasSubstr("first_contact: a.pose.translation.x is nan"));
  const auto moved = [&] {
    (void)first_contact_time({some, away}, {0, std::numeric_limits<double>::infinity(), 0}, some);
  };
  EXPECT_THAT(text_of<NonFinite>(moved), ::testing::HasSubstr("first_contact_time: by.y is inf"));
}

}  // namespace
}  // namespace plumb
