// Proxies of bodies and plans of worlds: does what misses a proxy miss the body, does a plan change no answer, and does it
// take what pays and nothing else?
#include "plumb/world/plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "plumb/query/variant/questions.hpp"
#include "world/drawn_body.hpp"

namespace plumb {
namespace {

using drawn_world::Drawn;

constexpr std::array kinds{ProxyKind::sphere, ProxyKind::obb, ProxyKind::hull};

/// A closed ring of square section around the z axis, of which the hull has much more than it.
TriangleMesh ring(double radius, double thickness, std::uint32_t sides) {
  constexpr double turn = 6.283185307179586;
  TriangleMesh m;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = turn * i / sides, c = std::cos(angle), s = std::sin(angle);
    for (const double r : {radius, radius + thickness})
      for (const double z : {-thickness, thickness}) m.vertices.push_back({r * c, r * s, z});
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t a = 4 * i, b = 4 * ((i + 1) % sides);
    const std::array<std::uint32_t, 4> around{0, 2, 3, 1};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t p = around[k], q = around[(k + 1) % 4];
      m.triangles.push_back({a + p, a + q, b + q});
      m.triangles.push_back({a + p, b + q, b + p});
    }
  }
  return m;
}

TEST(ProxyOf, HoldsTheBody) {
  int made = 0, missed = 0;
  for (std::uint64_t run = 0; run < 100; ++run) {
    SCOPED_TRACE("replay: Entropy(4200, " + std::to_string(run) + ")");
    Entropy e(4200, run);
    const Drawn drawn = drawn_world::body(e);
    const AnyFigure probe = drawn_world::figure(e);
    for (const ProxyKind kind : kinds) {
      const auto proxy = proxy_of(AnyBody::of(drawn.body.parts(), {}), kind);
      if (!proxy) continue;
      ++made;
      const AnyFigure there = proxy->under(drawn.body.pose());
      const bool misses = !intersects(there, probe);
      missed += misses ? 1 : 0;
      for (const auto& part : drawn.figures) {
        for (const AnyFigure& f : part) {
          EXPECT_TRUE(intersects(there, f)) << name_of(kind) << " misses " << to_string(f);
          EXPECT_FALSE(misses && intersects(probe, f)) << name_of(kind) << " misses what hits " << to_string(f);
        }
      }
    }
  }
  std::printf("%d proxies, %d of which miss\n", made, missed);
  EXPECT_GT(made, 200);
  EXPECT_GT(missed, 120);
}

TEST(ProxyOf, IsMadeOfAMeshOnceAndOfAFlatOneHasNoHull) {
  const SharedMesh mesh(ring(2, 0.5, 12));
  EXPECT_EQ(&mesh.proxy(ProxyKind::hull), &SharedMesh(mesh).proxy(ProxyKind::hull));
  EXPECT_EQ(proxy_of(mesh, ProxyKind::hull)->kind(), FigureKind::convex_polyhedron);
  EXPECT_FALSE(proxy_of(mesh, ProxyKind::none));
  const SharedMesh flat(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  EXPECT_FALSE(proxy_of(flat, ProxyKind::hull));
  EXPECT_TRUE(proxy_of(flat, ProxyKind::obb));
  CollisionWorld world;
  try {
    world.add(flat, {.user_id = 7, .proxy = ProxyKind::hull});
    ADD_FAILURE();
  } catch (const InvalidShape& error) {
    EXPECT_NE(std::string(error.what()).find("body 7"), std::string::npos) << error.what();
  }
  EXPECT_EQ(world.size(), 0U);
}

void expect_same(CollisionWorld& with, CollisionWorld& without, const AnyFigure& probe, const AnyRay& ray) {
  const WorldEvents now = with.commit(), then = without.commit();
  EXPECT_EQ(now.begun, then.begun);
  EXPECT_EQ(now.kept, then.kept);
  EXPECT_EQ(now.ended, then.ended);
  EXPECT_EQ(with.pairs(), without.pairs());
  EXPECT_EQ(with.contact_events().begun, without.contact_events().begun);
  EXPECT_EQ(with.contacts().size(), without.contacts().size());
  EXPECT_EQ(with.overlaps(probe), without.overlaps(probe));
  EXPECT_EQ(with.hits(ray), without.hits(ray));
  EXPECT_EQ(with.any_hit(ray), without.any_hit(ray));
  EXPECT_EQ(with.first_hit(ray), without.first_hit(ray));
}

TEST(CollisionWorld, AnswersAlikeWithProxiesAndPlans) {
  std::size_t taken = 0, pairs = 0;
  for (std::uint64_t run = 0; run < 8; ++run) {
    SCOPED_TRACE("replay: Entropy(4201, " + std::to_string(run) + ")");
    Entropy e(4201, run);
    CollisionWorld with({.contacts = true}), without({.contacts = true});
    std::vector<BodyHandle> handles;
    for (std::uint64_t id = 0; id < 12; ++id) {
      const Drawn drawn = drawn_world::body(e);
      BodyOptions options{.user_id = id, .margin = e.below(3) == 0 ? 0.5 : 0.0};
      static_cast<void>(without.add(drawn.body, options));
      const ProxyKind kind = static_cast<ProxyKind>(e.below(proxy_kinds));
      if (proxy_of(AnyBody::of(drawn.body.parts(), {}), kind)) options.proxy = kind;
      handles.push_back(with.add(drawn.body, options));
    }
    for (int frame = 0; frame < 4; ++frame) {
      const Vector3 way{double(e.within(2)), double(e.within(2)), 1};
      expect_same(with, without, drawn_world::figure(e), Ray3{{-2, -2, -2}, way});
      pairs += with.pairs().size();
      for (int i = 0; i < 4; ++i) {
        const BodyHandle body = handles[e.below(handles.size())];
        const RigidPose pose = drawn_world::pose(e);
        with.move(body, pose), without.move(body, pose);
      }
      if (frame != 1) continue;
      const WorldPlan scene = plan(with);
      EXPECT_LE(scene.questions_with, scene.questions_without);
      for (const BodyPlan& b : scene.bodies) taken += b.proxy != ProxyKind::none ? 1 : 0;
      adopt(with, scene);
      EXPECT_TRUE(with.check(4).empty());
    }
  }
  std::printf("%zu proxies taken, %zu pairs\n", taken, pairs);
  EXPECT_GT(taken, 4U);
  EXPECT_GT(pairs, 200U);
}

TEST(Plan, TakesWhatPays) {
  Heightfield slope{.columns = 17, .heights = {}};
  for (std::size_t i = 0; i < 17 * 5; ++i) slope.heights.push_back(double(i % 17) + 0.25 * double(i % 2));
  const SharedMesh land(mesh_of(slope));
  CollisionWorld world;
  // One slope below another: boxes of triangles overlap, and the slopes do not.
  const BodyHandle a = world.add(AnyBody(land), {.user_id = 1});
  const BodyHandle b = world.add(AnyBody(land, RigidPose{{}, {0.5, 0, -1}}), {.user_id = 2});
  const WorldPlan scene = plan(world);
  ASSERT_EQ(scene.bodies.size(), 2U);
  EXPECT_EQ(scene.bodies[0].body, a);
  EXPECT_EQ(scene.bodies[1].body, b);
  EXPECT_GT(scene.questions_without, 1U);
  EXPECT_EQ(scene.questions_with, 1U);
  for (const BodyPlan& body : scene.bodies) {
    EXPECT_EQ(body.told_apart, 1U);
    EXPECT_EQ(body.saved > 0, body.proxy != ProxyKind::none);
  }
  EXPECT_NE(scene.bodies[0].proxy, ProxyKind::none);
  EXPECT_EQ(scene.index->traits.count, 2U);
  adopt(world, scene);
  EXPECT_EQ(world.options(a).proxy, scene.bodies[0].proxy);
  EXPECT_TRUE(world.commit().begun.empty());
}

TEST(Plan, TakesNothingThatDoesNotPay) {
  // A ball in the middle of a wheel, and figures that are asked as soon as their proxies.
  CollisionWorld world;
  world.add(SharedMesh(ring(4, 0.5, 24)), {.user_id = 1});
  world.add(Sphere3{{0, 0, 0}, 4.25}, {.user_id = 2});
  world.add(Aabb3{{-1, -1, -1}, {1, 1, 1}}, {.user_id = 3});
  const WorldPlan scene = plan(world);
  EXPECT_EQ(scene.questions_with, scene.questions_without);
  ASSERT_EQ(scene.bodies.size(), 1U);
  EXPECT_EQ(scene.bodies[0].proxy, ProxyKind::none);
  EXPECT_EQ(scene.bodies[0].saved, 0U);
  EXPECT_EQ(plan(CollisionWorld()).bodies.size(), 0U);
}

TEST(Plan, LeavesNoBodyThatWouldGainByAnotherProxy) {
  for (std::uint64_t run = 0; run < 3; ++run) {
    SCOPED_TRACE("replay: Entropy(4202, " + std::to_string(run) + ")");
    Entropy e(4202, run);
    CollisionWorld world;
    const SharedMesh wheel(ring(1, 0.25, 8));
    for (std::uint64_t id = 0; id < 10; ++id) {
      world.add(AnyBody(wheel, drawn_world::pose(e)), {.user_id = id, .is_static = e.coin()});
    }
    const WorldPlan scene = plan(world), again = plan(world);
    EXPECT_EQ(scene.bodies, again.bodies);
    for (const BodyPlan& b : scene.bodies) EXPECT_EQ(b.saved > 0, b.proxy != ProxyKind::none) << b.user_id;
  }
}

}  // namespace
}  // namespace plumb
