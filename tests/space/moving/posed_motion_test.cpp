// Are the contacts of a mesh in motion from pose to pose those of the exactly posed places, and of every pair?
#include "query/time_of_impact/posed_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/space/moving/motion_contacts.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;
using query::moving::MovingKind;
using Contacts = std::vector<MotionContact>;

std::optional<Contact> contact_of(const MovingMesh& mesh, const Pose& pose_0, const Pose& pose_1, MovingKind kind,
                                  const std::array<std::uint32_t, 4>& v, double separation) {
  const auto at = [&](const std::vector<Point3>& places) {
    return std::array{places[v[0]], places[v[1]], places[v[2]], places[v[3]]};
  };
  const auto exact = query::moving::posed_first_contact(
      {{kind, at(mesh.from), at(mesh.to)}, {&pose_0, &pose_1}, {&pose_0, &pose_1}}, separation);
  if (!exact) return {};
  return Contact{arith::rounded(Rounding::down, exact->time), exact->a, exact->b};
}

/// Every vertex against every triangle, every edge against every edge.
Contacts by_brute_force(const MovingMesh& mesh, const Pose& pose_0, const Pose& pose_1, double separation) {
  Contacts all;
  for (const std::uint32_t v : mesh.corners) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      if (v == a || v == b || v == c) continue;
      const auto contact = contact_of(mesh, pose_0, pose_1, MovingKind::vertex_triangle, {v, a, b, c}, separation);
      if (contact) all.push_back({ContactPair::vertex_triangle, v, t, *contact});
    }
  }
  for (std::uint32_t i = 0; i < mesh.edges.size(); ++i) {
    for (std::uint32_t k = i + 1; k < mesh.edges.size(); ++k) {
      const auto [a, b] = mesh.edges[i];
      const auto [c, d] = mesh.edges[k];
      if (a == c || a == d || b == c || b == d) continue;
      const auto contact = contact_of(mesh, pose_0, pose_1, MovingKind::edge_edge, {a, b, c, d}, separation);
      if (contact) all.push_back({ContactPair::edge_edge, i, k, *contact});
    }
  }
  return all;
}

MovingMesh drawn(Material& m) {
  const TriangleMesh mesh = meshes::soup(m, 4 + m.below(4), 1 + m.below(4));
  std::vector<Point3> to = mesh.vertices;
  for (Point3& p : to) p = m.below(2) == 0 ? p : m.point3();
  return build_moving_mesh(mesh.vertices, to, mesh.triangles, {.most_in_leaf = 2});
}

/// The mesh at its posed places, where these are doubles.
std::optional<MovingMesh> exactly_posed(const MovingMesh& mesh, const Pose& pose_0, const Pose& pose_1) {
  const auto from = exact_mesh({mesh.from, {}}, pose_0), to = exact_mesh({mesh.to, {}}, pose_1);
  if (!from || !to) return {};
  return build_moving_mesh(from->vertices, to->vertices, mesh.triangles);
}

void expect_contacts(const MovingMeshView& posed, double separation, const Contacts& expected,
                     const std::string& about) {
  EXPECT_EQ(contacts_in_motion(posed, {.separation = separation, .execution = Execution::serial}), expected) << about;
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(contacts_in_motion(posed, {.separation = separation}), expected) << about;
  }
}

/// Integer poses of any rank: doubled, mirrored, sheared, flattened to a plane, a line or a point.
TEST(PosedMotion, HasTheContactsOfTheExactlyPosedMesh) {
  std::size_t asked = 0, met = 0;
  shape_cases::on_shapes(3311, battery::fitting(120), [&](Material& m) {
    const MovingMesh mesh = drawn(m);
    const Pose pose_0 = integer_pose(m), pose_1 = m.below(3) == 0 ? pose_0 : pose_like(m, pose_0);
    const auto there = exactly_posed(mesh, pose_0, pose_1);
    if (!there) return;
    const double separation = m.below(4) == 0 ? std::abs(m.number()) / 8 : 0;
    const Contacts expected = contacts_in_motion(*there, {.separation = separation});
    const MovingMeshView posed{mesh, pose_0, pose_1};
    expect_contacts(posed, separation, expected, m.about());
    EXPECT_EQ(contacts_by_time(posed, {.separation = separation}), contacts_by_time(*there, {.separation = separation}))
        << m.about();
    EXPECT_EQ(first_contact(posed, {.separation = separation}), first_contact(*there, {.separation = separation}))
        << m.about();
    ++asked, met += expected.size();
  });
  EXPECT_TRUE(!battery::reaches_rare || (asked > 40 && met > 100)) << asked << ' ' << met;
}

/// Poses whose images are no doubles, and such as lead beyond them.
TEST(PosedMotion, HasThoseOfEveryPair) {
  std::size_t met = 0;
  shape_cases::on_shapes(3312, battery::fitting(40), [&](Material& m) {
    const MovingMesh mesh = drawn(m);
    const Pose pose_0 = any_pose(m), pose_1 = pose_like(m, pose_0);
    const double separation = m.below(6) == 0 ? std::abs(m.number()) / 8 : 0;
    const Contacts expected = by_brute_force(mesh, pose_0, pose_1, separation);
    expect_contacts({mesh, pose_0, pose_1}, separation, expected, m.about());
    met += expected.size();
  });
  EXPECT_TRUE(!battery::reaches_rare || met > 30) << met;
}

TEST(PosedMotion, UnderOneRegularPoseIsThatWithoutIt) {
  std::size_t met = 0;
  shape_cases::on_shapes(3313, battery::fitting(40), [&](Material& m) {
    const MovingMesh mesh = drawn(m);
    const Contacts expected = contacts_in_motion(mesh);
    const Pose pose = turn(m);
    EXPECT_EQ(by_brute_force(mesh, pose, pose, 0), expected) << m.about();
    EXPECT_EQ(contacts_in_motion({mesh, pose, pose}), expected) << m.about();
    EXPECT_EQ(first_contact({mesh, pose, pose}), first_contact(mesh)) << m.about();
    met += expected.size();
  });
  EXPECT_TRUE(!battery::reaches_rare || met > 30) << met;
}

/// Flattened, and mirrored through its own plane: places are the same before and after, poses are not.
TEST(PosedMotion, MovesByItsPosesAlone) {
  const std::vector<Point3> places{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {2, 1, 2}, {1, 2, 2}};
  const MovingMesh mesh = build_moving_mesh(places, places, std::vector<Bvh::Corners>{{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(contacts_in_motion(mesh), Contacts{});
  const Pose squeezed{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 0}},
      mirrored{{{{1, 0, 0}, {0, 1, 0}, {0, 0, -3}}}, {}};
  const auto flat = first_contact({mesh, identity_pose, squeezed});
  ASSERT_TRUE(flat.has_value());
  EXPECT_EQ(flat->contact.time, 1);
  const Contacts all = contacts_by_time({mesh, identity_pose, mirrored});
  ASSERT_FALSE(all.empty());
  for (const MotionContact& c : all) EXPECT_EQ(c.contact.time, 0.25);
  EXPECT_EQ(contacts_in_motion({mesh, squeezed, squeezed}, {.separation = 0.5}).front().contact.time, 0);
}

TEST(PosedMotion, NamesWhatIsWrong) {
  const MovingMesh none = build_moving_mesh({}, {}, {});
  EXPECT_EQ(contacts_in_motion({none, identity_pose, Pose{}}), Contacts{});
  EXPECT_EQ(first_contact({none, identity_pose, Pose{}}), std::nullopt);
  Pose wrong = identity_pose;
  wrong.columns[1].z = std::numeric_limits<double>::infinity();
  const auto posed = [&] { (void)first_contact({none, identity_pose, wrong}); };
  EXPECT_THAT(text_of<NonFinite>(posed), ::testing::HasSubstr("first_contact: mesh.to.columns[1].z is inf"));
  const auto negative = [&] { (void)contacts_by_time({none, Pose{}, Pose{}}, {.separation = -1}); };
  EXPECT_THAT(text_of<InvalidShape>(negative),
              ::testing::HasSubstr("contacts_by_time: options.separation is negative"));
}

}  // namespace
}  // namespace plumb
