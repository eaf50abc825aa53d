// Heightfields: are their corners where they are said to be, are their cells found again, and are pairs, rays and distances
// those of asking each cell's triangles?
#include "plumb/world/heightfield.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/variant/questions.hpp"
#include "plumb/world.hpp"

namespace plumb {
namespace {

Heightfield drawn_field(Entropy& e) {
  Heightfield field{.columns = 4 + e.below(3), .heights = {}, .spacing = {1, 0.5}, .origin = {-2, -1, 0}};
  for (std::size_t n = field.columns * (4 + e.below(3)); n > 0; --n) field.heights.push_back(double(e.within(2)));
  return field;
}

/// By the definition: two triangles of the cell's corners.
Triangle3 triangle_of(const Heightfield& f, std::uint32_t number) {
  const auto [i, j] = cell_of(f, number);
  const auto at = [&](std::size_t column, std::size_t row) {
    return Point3{f.origin.x + double(column) * f.spacing.x, f.origin.y + double(row) * f.spacing.y,
                  f.origin.z + f.heights[row * f.columns + column]};
  };
  if (number % 2 == 0) return {at(i, j), at(i + 1, j), at(i + 1, j + 1)};
  return {at(i, j), at(i + 1, j + 1), at(i, j + 1)};
}

TEST(Heightfield, StandsInAWorldAsItsCells) {
  int met = 0, hit = 0;
  for (std::uint64_t run = 0; run < 60; ++run) {
    SCOPED_TRACE("replay: Entropy(4300, " + std::to_string(run) + ")");
    Entropy e(4300, run);
    const Heightfield field = drawn_field(e);
    const TriangleMesh mesh = mesh_of(field);
    const auto cells = (field.columns - 1) * (field.heights.size() / field.columns - 1);
    ASSERT_EQ(mesh.triangles.size(), 2 * cells);
    const RigidPose pose{e.coin() ? Rotation{} : Rotation{1, 0, 0, 1}, {0.5, 0, 0}};
    CollisionWorld world;
    const BodyHandle land = world.add(AnyBody(SharedMesh(mesh), pose), {.user_id = 1, .is_static = true});
    const Sphere3 ball{{double(e.within(1)), double(e.within(1)), double(e.within(2))}, double(e.below(3)) / 2};
    world.add(ball, {.user_id = 2});
    const Ray3 ray{{double(e.within(1)), double(e.within(1)), 4},
                   {double(e.within(1)) / 8, double(e.within(1)) / 8, -1}};
    Relation most = Relation::disjoint;
    double first = std::numeric_limits<double>::infinity(), nearest = first;
    for (std::uint32_t t = 0; t < 2 * cells; ++t) {
      const AnyFigure triangle = AnyFigure(triangle_of(field, t)).under(pose);
      most = std::max(most, relate(AnyFigure(ball), triangle));
      nearest = std::min(nearest, distance(AnyFigure(Point3{9, 9, 9}), triangle));
      if (const auto h = first_hit(AnyFigure(ray), triangle)) first = std::min(first, h->t);
    }
    world.commit();
    ASSERT_EQ(world.pairs().size(), most == Relation::disjoint ? 0U : 1U);
    if (most != Relation::disjoint) {
      EXPECT_EQ(world.pairs()[0].relation, most);
    }
    const auto near = world.within(Point3{9, 9, 9}, 100);
    const auto far_land = std::ranges::find(near, land, &WorldNear::body);
    ASSERT_NE(far_land, near.end());
    EXPECT_EQ(far_land->distance, nearest);
    const auto hits = world.hits(ray);
    const auto of_land = std::ranges::find(hits, 1U, &WorldHit::user_id);
    EXPECT_EQ(of_land == hits.end() ? std::numeric_limits<double>::infinity() : of_land->hit.t, first);
    met += most == Relation::disjoint ? 0 : 1;
    hit += of_land == hits.end() ? 0 : 1;
  }
  std::printf("%d met, %d hit\n", met, hit);
  EXPECT_GT(met, 15);
  EXPECT_GT(hit, 15);
}

TEST(Heightfield, RoundsEachGridLineOnce) {
  const Heightfield field{.columns = 3, .heights = {0, 0, 0, 0, 0, 0}, .spacing = {0.1, -0.1}, .origin = {0.3, 0, 0}};
  const TriangleMesh mesh = mesh_of(field);
  EXPECT_EQ(mesh.vertices[2].x, (Rational(0.1) * 2 + Rational(0.3)).rounded());
  EXPECT_EQ(mesh.vertices[5].x, mesh.vertices[2].x);
  EXPECT_EQ(mesh.vertices[5].y, -0.1);
  EXPECT_EQ(cell_of(field, 3), (HeightfieldCell{1, 0}));
}

TEST(Heightfield, RefusesWhatIsNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), most = std::numeric_limits<double>::max();
  EXPECT_THROW(mesh_of({.columns = 1, .heights = {1, 2}}), InvalidShape);
  EXPECT_THROW(mesh_of({.columns = 2, .heights = {1, 2}}), InvalidShape);
  EXPECT_THROW(mesh_of({.columns = 2, .heights = {1, 2, 3, 4, 5}}), InvalidShape);
  EXPECT_THROW(mesh_of({.columns = 2, .heights = {1, 2, 3, 4}, .spacing = {0, 1}}), InvalidShape);
  EXPECT_THROW(mesh_of({.columns = 2, .heights = {1, 2, 3, 4}, .spacing = {1, nan}}), NonFinite);
  EXPECT_THROW(mesh_of({.columns = 2, .heights = {1, 2, 3, 4}, .spacing = {most, 1}, .origin = {most, 0, 0}}),
               BeyondDoubles);
  EXPECT_THROW(cell_of({.columns = 2, .heights = {1, 2, 3, 4}}, 2), InvalidShape);
  try {
    mesh_of({.columns = 2, .heights = {1, 2, nan, 4}});
    ADD_FAILURE();
  } catch (const NonFinite& error) {
    EXPECT_NE(std::string(error.what()).find("heights[2]"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace plumb
