// Do queries that begin at their last answer have the answers of those that do not, in every frame?
#include "plumb/space/coherence/last_answer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "space/closest/nearest_search.hpp"
#include "space/coherence/frames.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace frames;

void expect_a_pair(const std::optional<TrianglePair>& found, const std::vector<TrianglePair>& all,
                   const std::string& about) {
  ASSERT_EQ(found.has_value(), !all.empty()) << about;
  if (found) {
    ASSERT_THAT(all, ::testing::Contains(*found)) << about;
  }
}

std::optional<double> distance_of(const std::optional<ClosestTriangles>& near) {
  return near ? std::optional(near->closest.distance) : std::nullopt;
}

TEST(LastPair, OfMeshesThatBendAnswersAsWithoutIt) {
  std::size_t met = 0, apart = 0;
  shape_cases::on_shapes(1761, battery::fitting(120), [&](Material& m) {
    TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(12), m.below(14));
    TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(12), m.below(14));
    const std::vector<Point3> first_a = mesh_a.vertices, first_b = mesh_b.vertices;
    Bvh a = build_bvh(mesh_a), b = build_bvh(mesh_b, {.most_in_leaf = 1});
    LastPair witness, near, any;
    for (int frame = 0; frame < 10; ++frame) {
      const std::string about = m.about() + " frame " + std::to_string(frame);
      const PairOptions options{.touching = m.below(3) != 0};
      expect_a_pair(any_intersecting_pair(a, b, witness, options), intersecting_pairs(a, b, options), about);
      const auto expected = closest_triangles(a, b, {.first = true});
      ASSERT_EQ(closest_triangles(a, b, near, {.first = true}), expected) << about;
      ASSERT_EQ(distance_of(closest_triangles(a, b, any)), distance_of(expected)) << about;
      ++(expected && expected->closest.distance == 0 ? met : apart);
      if (m.below(3) != 0) refit(a, mesh_a.vertices = next_vertices(m, mesh_a.vertices, first_a));
      if (m.below(3) != 0) refit(b, mesh_b.vertices = next_vertices(m, mesh_b.vertices, first_b));
      if (m.below(8) == 0) b = build_bvh(mesh_b, {.method = BvhMethod::linear});
    }
  });
  if (battery::reaches_rare) {
    EXPECT_GT(met, 200u);
    EXPECT_GT(apart, 200u);
  }
}

TEST(LastPair, OfPosedMeshesAnswersAsWithoutIt) {
  std::size_t met = 0;
  shape_cases::on_shapes(1762, battery::fitting(40), [&](Material& m) {
    const Bvh a = build_bvh(meshes::soup(m, 1 + m.below(8), m.below(8)));
    const Bvh b = build_bvh(meshes::soup(m, 1 + m.below(8), m.below(8)));
    Pose pose_a = identity_pose, pose_b = identity_pose;
    LastPair witness, near;
    for (int frame = 0; frame < 8; ++frame) {
      const std::string about = m.about() + " frame " + std::to_string(frame);
      const PosedMesh p{a, pose_a}, q{b, pose_b};
      const auto all = intersecting_pairs(p, q);
      expect_a_pair(any_intersecting_pair(p, q, witness), all, about);
      ASSERT_EQ(closest_triangles(p, q, near, {.first = true}), closest_triangles(p, q, {.first = true})) << about;
      met += all.empty() ? 0 : 1;
      pose_a = next_pose(m, pose_a);
      if (m.below(3) == 0) pose_b = m.below(2) == 0 ? pose_a : next_pose(m, pose_b);
    }
  });
  if (battery::reaches_rare) {
    EXPECT_GT(met, 50u);
  }
}

TEST(LastTriangle, NearAPointAnswersAsWithoutIt) {
  shape_cases::on_shapes(1763, battery::fitting(300), [&](Material& m) {
    TriangleMesh mesh = meshes::soup(m, 1 + m.below(15), m.below(20));
    const std::vector<Point3> first = mesh.vertices;
    Bvh bvh = build_bvh(mesh);
    Pose pose = identity_pose;
    LastTriangle near, near_posed;
    Point3 p = m.point3();
    for (int frame = 0; frame < 10; ++frame) {
      ASSERT_EQ(closest_on_mesh(bvh, p, near), closest_on_mesh(bvh, p)) << m.about() << " frame " << frame;
      const PosedMesh posed{bvh, pose};
      ASSERT_EQ(closest_on_mesh(posed, p, near_posed), closest_on_mesh(posed, p)) << m.about() << " frame " << frame;
      if (m.below(2) == 0) refit(bvh, mesh.vertices = next_vertices(m, mesh.vertices, first));
      if (m.below(4) == 0) p = m.probe3();
      pose = next_pose(m, pose);
    }
  });
}

TEST(LastTriangle, OfARayAnswersAsWithoutIt) {
  std::size_t hit = 0, missed = 0;
  mesh_rays::on_shapes(1764, battery::fitting(300), [&](Material& m) {
    TriangleMesh mesh = mesh_rays::drawn_mesh(m, 20);
    const std::vector<Point3> first = mesh.vertices;
    Bvh bvh = build_bvh(mesh, mesh_rays::any_options(m));
    LastTriangle any;
    AnyRay ray = mesh_rays::ray_of(m);
    for (int frame = 0; frame < 10; ++frame) {
      const std::string about = m.about() + " frame " + std::to_string(frame) + " " + mesh_rays::text_of(ray);
      const HitRule rule = m.below(2) == 0 ? HitRule::closed : HitRule::half_open;
      const bool expected = any_hit(bvh, ray, rule);
      ASSERT_EQ(any_hit(bvh, ray, any, rule), expected) << about;
      ++(expected ? hit : missed);
      if (!mesh.vertices.empty() && m.below(2) == 0) {
        refit(bvh, mesh.vertices = next_vertices(m, mesh.vertices, first));
      }
      if (m.below(3) == 0) ray = mesh_rays::ray_of(m);
    }
  });
  if (battery::reaches_rare) {
    EXPECT_GT(hit, 500u);
    EXPECT_GT(missed, 500u);
  }
}

/// What is remembered may be of no mesh at all.
TEST(LastAnswers, AreGuesses) {
  const Bvh none = build_bvh(TriangleMesh{}), ring = build_bvh(meshes::ring(4));
  const Ray3 ray{{-9, 0.01, 0}, {1, 0, 0}};
  const Point3 p{0.25, 3, 1};
  for (const std::uint32_t slot : {0u, 5u, 63u, 64u, 1u << 31, 0xffffffffu}) {
    LastTriangle a{slot}, b{slot}, c{slot}, d{slot};
    EXPECT_EQ(closest_on_mesh(ring, p, a), closest_on_mesh(ring, p));
    EXPECT_EQ(closest_on_mesh(none, p, b), std::nullopt);
    EXPECT_TRUE(any_hit(ring, ray, c));
    EXPECT_FALSE(any_hit(none, ray, d));
    LastPair f{slot, 3}, g{3, slot}, h{slot, slot};
    EXPECT_EQ(closest_triangles(ring, ring, f, {.first = true}), closest_triangles(ring, ring, {.first = true}));
    EXPECT_EQ(closest_triangles(none, ring, g), std::nullopt);
    EXPECT_TRUE(any_intersecting_pair(ring, ring, h).has_value());
    EXPECT_FALSE(any_intersecting_pair(ring, none, h).has_value());
  }
  LastTriangle near;
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)closest_on_mesh(ring, Point3{NAN, 0, 0}, near);
            }),
            text_of<NonFinite>([&] {
              (void)closest_on_mesh(ring, Point3{NAN, 0, 0});
            }));
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)any_hit(ring, Ray3{{NAN, 0, 0}, {1, 0, 0}}, near);
            }),
            text_of<NonFinite>([&] {
              (void)any_hit(ring, Ray3{{NAN, 0, 0}, {1, 0, 0}});
            }));
}

/// The point goes round the ring in small steps: with a good guess less is looked at.
TEST(LastTriangle, LeavesOutTriangles) {
  const Bvh bvh = build_bvh(meshes::ring(battery::sanitized ? 12 : 40));
  std::size_t nodes = 0, triangles = 0, nodes_from_last = 0, triangles_from_last = 0;
  space::Nearest<space::Counted> plain(bvh, 1, {&nodes, &triangles});
  space::Nearest<space::Counted> guessed(bvh, 1, {&nodes_from_last, &triangles_from_last});
  std::uint32_t last = space::no_slot;
  for (int i = 0; i < 500; ++i) {
    const Point3 p{1.5 * std::cos(i * 0.01), 1.5 * std::sin(i * 0.01), 0.05};
    const std::uint32_t expected = plain.of(p)[0].item;
    const auto found = guessed.of(p, last)[0];
    ASSERT_EQ(found.item, expected) << i;
    last = found.slot;
  }
  EXPECT_LE(nodes_from_last, nodes);
  EXPECT_LT(triangles_from_last, triangles);
}

}  // namespace
}  // namespace plumb
