// Experiments on questions of figures: the exact way fails nothing, and the float ways do fail where textbooks say so.
#include <gtest/gtest.h>

#include <string>

#include "lab/found.hpp"

namespace plumb::lab::stability {
namespace {

TEST(QueriesTest, FloatsLosePointsOfPolygonsAndSolids) {
  const Found found = found_by(location_experiment());
  for (const char* method : {"float32", "double", "long-double"}) {
    EXPECT_GT(found.in("cut-square", method, 0), 0U) << method;  // neither half holds them
    EXPECT_GT(found.in("octahedron", method, 0), 0U) << method;
    EXPECT_GT(found.in("in-ball", method, 0), 0U) << method;  // three rays tell different things
  }
  EXPECT_GT(found.in("cut-square", "absolute", 2), 0U);  // the wrong half holds them
}

TEST(QueriesTest, FloatRaysLeakThroughClosedMeshes) {
  const Found found = found_by(leak_experiment());
  for (const char* mesh : {"ball", "flange", "far-flange"}) {
    for (const char* method : {"float32", "double"}) EXPECT_GT(found.in(mesh, method, 0), 0U) << mesh << method;
    EXPECT_GT(found.in(mesh, "double", 2), 0U) << mesh;
  }
}

TEST(QueriesTest, EpsilonsPartBoxesAndJoinThem) {
  const Found found = found_by(box_experiment());
  EXPECT_GT(found.in("stacked", "double", 0), 0U);
  EXPECT_EQ(found.in("stacked", "absolute", 0), 0U);  // what the epsilon is for
  EXPECT_GT(found.in("beside", "absolute", 1), 0U);   // and what it costs
  EXPECT_GT(found.in("beside", "float32", 0), 0U);
}

TEST(QueriesTest, FloatAnswersChangeWithTheScene) {
  const Found found = found_by(move_experiment());
  for (std::size_t kind = 0; kind < 3; ++kind) {
    EXPECT_GT(found.in("translated", "float32", kind), 0U);
    EXPECT_GT(found.in("scaled", "absolute", kind), 0U);
    EXPECT_GT(found.in("turned", "float32", kind), 0U);
    EXPECT_GT(found.in("turned-and-rounded", "double", kind), 0U);
  }
  EXPECT_GT(found.in("scaled", "double", 0), 0U);
}

TEST(QueriesTest, RoundedPosesLoseContacts) {
  const Found found = found_by(pose_experiment());
  for (const char* scene : {"bricks", "parts"}) {
    for (const char* way :
         {"float32", "double", "exact, rounded points", "float32, in one's space", "exact, in one's space"})
      EXPECT_GT(found.in(scene, way, 0), 0U) << scene << ' ' << way;
  }
}

TEST(QueriesTest, FloatsTakeTheFartherForTheNearer) {
  const Found found = found_by(distance_experiment());
  for (const char* scene : {"far-segments", "far-triangles"}) {
    EXPECT_GT(found.in(scene, "float32", 2), 0U) << scene;
    EXPECT_GT(found.in(scene, "float32", 3), 0U) << scene;
  }
  EXPECT_GT(found.in("crossing-segments", "double", 0), 0U);
  EXPECT_GT(found.in("nearly-in-plane", "double", 1), 0U);
}

TEST(QueriesTest, FloatBallsLeaveCornersOut) {
  const Found found = found_by(ball_experiment());
  for (const char* method : {"float32", "double"}) {
    EXPECT_GT(found.in("pivots-in-tenths", method, 0), 0U) << method;  // round in a circle
    EXPECT_GT(found.in("pivots", method, 1), 0U) << method;
    EXPECT_GT(found.in("recursion", method, 0), 0U) << method;
    EXPECT_GT(found.in("far-recursion", method, 2), 0U) << method;
  }
}

TEST(QueriesTest, CubicSolversMissContactsAndInventThem) {
  const Found found = found_by(motion_experiment());
  for (const std::string kind : {"vertex-face", "edge-edge"}) {
    EXPECT_GT(found.in(kind + "-meeting", "double", 0), 0U) << kind;
    EXPECT_GT(found.in(kind + "-double-root", "double", 0), 0U) << kind;
    EXPECT_GT(found.in(kind + "-in-plane", "double", 0), 0U) << kind;  // the cubic is zero
    EXPECT_GT(found.in(kind + "-meeting", "float32", 0), 0U) << kind;
  }
}

}  // namespace
}  // namespace plumb::lab::stability
