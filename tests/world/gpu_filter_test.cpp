// The GPU as a filter: is all that meets left, at every resolution, are the exact pairs through it those of a world,
// and is anything filtered out?  Where no EGL device is found the tests are skipped and say so.
#include "plumb/world/gpu_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/degenerate/ulps.hpp"
#include "plumb/query/variant/questions.hpp"
#include "world/drawn_body.hpp"

namespace plumb {
namespace {

constexpr std::array<std::uint32_t, 4> resolutions{16, 64, 256, 1024};

/// One a resolution, for all tests; nothing where there is no device.
GpuFilter* filter_of(std::uint32_t resolution) {
  static std::map<std::uint32_t, std::optional<GpuFilter>> known;
  auto& filter = known[resolution];
  if (!filter) {
    try {
      filter.emplace(GpuFilterOptions{.resolution = resolution});
    } catch (const NoGpu& e) {
      std::printf("%s\n", e.what());
      return nullptr;
    }
  }
  return &*filter;
}

class GpuFilterOnDevice : public testing::Test {
 protected:
  void SetUp() override {
    if (filter_of(64) == nullptr) GTEST_SKIP() << "no EGL device draws here";
  }
};

std::vector<MeetingBodies> meeting_in_world(const std::vector<AnyBody>& bodies) {
  CollisionWorld world;
  for (std::size_t i = 0; i < bodies.size(); ++i) world.add(bodies[i], {.user_id = i});
  world.commit();
  std::vector<MeetingBodies> pairs;
  for (const WorldPair& p : world.pairs())
    pairs.push_back({static_cast<std::uint32_t>(p.id_a), static_cast<std::uint32_t>(p.id_b), p.relation});
  return pairs;
}

/// The exact pairs, and how many pairs the filter has left.
struct Looked {
  std::vector<MeetingBodies> exact;
  std::size_t left = 0;
};
Looked look(const std::vector<AnyBody>& bodies, std::uint32_t resolution) {
  GpuFilter& gpu = *filter_of(resolution);
  SCOPED_TRACE("resolution " + std::to_string(resolution));
  Looked looked{meeting_in_world(bodies), 0};
  const std::vector<std::uint32_t> set = gpu.may_collide(bodies);
  const std::vector<BoxPair> pairs = gpu.may_meet(bodies);
  looked.left = pairs.size();
  for (const MeetingBodies& m : looked.exact) {
    EXPECT_TRUE(std::ranges::binary_search(set, m.a)) << m.a << " is not in the set";
    EXPECT_TRUE(std::ranges::binary_search(set, m.b)) << m.b << " is not in the set";
    EXPECT_TRUE(std::ranges::binary_search(pairs, BoxPair{m.a, m.b})) << m.a << " and " << m.b << " are filtered out";
  }
  EXPECT_EQ(gpu.meeting(bodies), looked.exact);
  EXPECT_EQ(gpu.counts().kept, looked.left);
  // Every pair, without what the set and the boxes say first, and in any order.
  std::vector<BoxPair> all;
  for (std::uint32_t a = 0; a < bodies.size(); ++a)
    for (std::uint32_t b = 0; b < a; ++b) all.push_back({a, b});
  const std::vector<BoxPair> asked = gpu.may_meet(bodies, all);
  for (const MeetingBodies& m : looked.exact)
    EXPECT_NE(std::ranges::find(asked, BoxPair{m.b, m.a}), asked.end()) << m.a << " and " << m.b << " are left out";
  return looked;
}

TEST_F(GpuFilterOnDevice, NothingThatMeetsIsFilteredOutOfDrawnScenes) {
  std::size_t met = 0, left = 0;
  for (std::uint64_t run = 0; run < 9; ++run) {
    SCOPED_TRACE("replay: Entropy(4300, " + std::to_string(run) + ")");
    Entropy e(4300, run);
    std::vector<AnyBody> bodies;
    const std::uint32_t resolution = resolutions[run % resolutions.size()];
    for (int i = resolution > 256 ? 6 : 12; i > 0; --i) {
      RigidPose at = drawn_world::pose(e);
      at.translation = {2 * at.translation.x, 2 * at.translation.y, 2 * at.translation.z};
      const AnyBody body = drawn_world::body(e).body;
      bodies.push_back(e.coin() ? body : body.under(at));
    }
    const Looked looked = look(bodies, resolution);
    met += looked.exact.size();
    left += looked.left;
  }
  EXPECT_GT(met, 30U);
  EXPECT_GT(left, met);
}

/// Bodies whose common points are corners, edges and faces to the last bit, some of them an ulp beside.
TEST_F(GpuFilterOnDevice, TouchingIsLeftAndSoIsAnUlpOfOverlap) {
  std::size_t touching = 0, apart = 0;
  for (std::uint64_t run = 0; run < 8; ++run) {
    SCOPED_TRACE("replay: Entropy(4301, " + std::to_string(run) + ")");
    Entropy e(4301, run);
    const double size = std::ldexp(1.0, std::array{0, -900, 900, -1060}[run % 4]);
    const auto number = [&] { return size * (1 + 0x1p-52 * double(e.bits(52))) * (e.coin() ? 1 : -1); };
    const auto beside = [&](double x) { return moved_by_ulps(x, e.within(1)); };
    std::vector<AnyBody> bodies;
    for (int i = 0; i < 3; ++i) {
      const Point3 p{number(), number(), number()}, q{number(), number(), number()}, r{number(), number(), number()};
      const Point3 low{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
      const Point3 high{std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)};
      const Point3 corner{beside(high.x), beside(high.y), beside(high.z)};
      bodies.push_back(Aabb3{low, high});
      bodies.push_back(Tetrahedron3{corner,
                                    {high.x + size, high.y, high.z},
                                    {high.x + size, high.y + size, high.z},
                                    {high.x + size, high.y, high.z + size}});
      bodies.push_back(AnyBody(SharedMesh(TriangleMesh{{p, q, r, corner}, {{0, 1, 2}, {1, 2, 3}}})));
    }
    const Looked looked = look(bodies, resolutions[run % resolutions.size()]);
    for (const MeetingBodies& m : looked.exact) touching += m.relation == Relation::touching;
    apart += looked.left - looked.exact.size();
  }
  EXPECT_GT(touching, 5U);
  EXPECT_GT(apart, 5U);
}

TEST_F(GpuFilterOnDevice, TurnedBodiesThatRestOnOneAnotherAreLeft) {
  const Rotation turn{3, 1, -2, 1};
  std::vector<AnyBody> bodies;
  for (int i = 0; i < 12; ++i) {
    const Aabb3 there{{i % 5 * 1.0, i / 5 * 1.0, 0}, {i % 5 + 1.0, i / 5 + 1.0, i % 2 + 1.0}};
    bodies.push_back(
        i % 3 != 0 ? AnyBody(Posed{there, RigidPose{turn, {0.1, 0.2, 0.3}}})
                   : AnyBody(Posed{Sphere3{{i % 5 + 0.5, i / 5 + 0.5, 0.5}, 0.5}, RigidPose{turn, {0.1, 0.2, 0.3}}}));
  }
  for (const std::uint32_t resolution : {16U, 64U, 512U}) EXPECT_GT(look(bodies, resolution).exact.size(), 20U);
}

/// A flat ring, of triangles, whose hole is most of its box.
TriangleMesh ring(double inner, double outer) {
  constexpr std::uint32_t sides = 24;
  TriangleMesh m;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 6.283185307179586 * i / sides;
    m.vertices.push_back({inner * std::cos(angle), inner * std::sin(angle), 0});
    m.vertices.push_back({outer * std::cos(angle), outer * std::sin(angle), 0.25});
  }
  for (std::uint32_t i = 0; i < 2 * sides; ++i)
    m.triangles.push_back({i, (i + 1) % (2 * sides), (i + 2) % (2 * sides)});
  return m;
}

TEST_F(GpuFilterOnDevice, WhatIsClearlyApartIsFilteredOut) {
  const RigidPose tilted{{5, 1, 2, 0}, {}};
  const std::vector<AnyBody> rings{AnyBody(SharedMesh(ring(3, 3.2)), tilted), AnyBody(SharedMesh(ring(4, 4.2)), tilted),
                                   Sphere3{{0, 0, 0}, 1}};
  const std::vector<AnyBody> links{SharedMesh(ring(3, 3.2)),
                                   AnyBody(SharedMesh(ring(3, 3.2)), RigidPose{{1, 0, 0, 1}, {3, 0, 0}}),
                                   AnyBody(SharedMesh(ring(3, 3.2)), RigidPose{{1, 1, 0, 0}, {3, 0, 0}})};
  const std::vector<AnyBody> plates{Posed{Aabb3{{-9, -9, 0}, {9, 9, 1}}, tilted},
                                    Posed{Aabb3{{-9, -9, 7}, {9, 9, 8}}, tilted}};
  for (const std::uint32_t resolution : {16U, 32U, 128U}) {
    SCOPED_TRACE(resolution);
    GpuFilter& gpu = *filter_of(resolution);
    EXPECT_EQ(look(rings, resolution).left, 0U);
    const Looked linked = look(links, resolution);
    EXPECT_EQ(linked.left, linked.exact.size());
    EXPECT_EQ(look(plates, resolution).left, 0U);
    const std::vector<AnyBody> row{Aabb3{{0, 0, 0}, {1, 1, 1}}, Aabb3{{2, 0, 0}, {3, 1, 1}},
                                   Aabb3{{2.5, 0.5, 0.5}, {4, 1, 1}}};
    EXPECT_EQ(gpu.may_collide(row), (std::vector<std::uint32_t>{1, 2}));
  }
}

TEST_F(GpuFilterOnDevice, MoreBodiesThanTilesAreAskedInBatches) {
  std::vector<AnyBody> bodies;
  for (int i = 0; i < 20; ++i) bodies.push_back(Sphere3{{i * 0.75, 0, 0}, 0.5});
  for (const std::uint32_t resolution : {16U, 1024U}) {
    EXPECT_EQ(look(bodies, resolution).exact.size(), 19U);
    filter_of(resolution)->may_meet(bodies);
    EXPECT_EQ(filter_of(resolution)->counts().asked, 19U);
    EXPECT_EQ(filter_of(resolution)->counts().readbacks > 20, resolution == 1024);
  }
}

TEST_F(GpuFilterOnDevice, EmptyScenesAndFiltersThatMoveAnswer) {
  GpuFilter gpu({.resolution = 32});
  GpuFilter moved = std::move(gpu);
  EXPECT_FALSE(moved.renderer().empty());
  EXPECT_TRUE(moved.may_collide({}).empty());
  EXPECT_TRUE(moved.meeting({}).empty());
  const std::vector<AnyBody> one{Sphere3{{0, 0, 0}, 1}};
  EXPECT_TRUE(moved.may_meet(one).empty());
  const std::vector<BoxPair> beyond{{0, 1}};
  EXPECT_THROW(moved.may_meet(one, beyond), Error);
  const std::vector<AnyBody> endless{Sphere3{{0, 0, 0}, 1}, Halfspace3{{0, 0, 1}, 0}};
  EXPECT_THROW(moved.meeting(endless), Error);
}

TEST(GpuFilter, RefusesResolutionsThatAreNoPowersOfTwoInRange) {
  for (const std::uint32_t r : {0U, 8U, 17U, 100U, 2048U}) EXPECT_THROW(GpuFilter({.resolution = r}), Error) << r;
}

}  // namespace
}  // namespace plumb
