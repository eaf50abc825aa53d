// Experiments on questions of figures: the exact way fails nothing, and the float ways do fail where textbooks say so.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tool/stability/experiment.hpp"

namespace plumb::tool::stability {
namespace {

/// What an experiment found, by scene and method.
using Found = std::map<std::string, std::map<std::string, std::vector<Count>>>;

/// All scenes, quickly.  Of ours nothing may fail; whatever can fail was tried, by every method as often.
Found run(const Experiment& experiment) {
  Found found;
  for (const Scene& scene : experiment.scenes({.seed = 2026, .quick = true, .ccd = {}, .models = {}})) {
    const Findings findings = scene.run();
    int ours = 0;
    std::uint64_t tried = 0;
    for (const MethodOutcome& outcome : findings.outcomes) {
      const std::string where = experiment.name + ", " + scene.name + ", " + outcome.method + ": ";
      found[scene.name][outcome.method] = outcome.counts;
      ours += outcome.exact ? 1 : 0;
      const std::vector<Count>& first = findings.outcomes[0].counts;
      EXPECT_EQ(outcome.counts.size(), first.size()) << where;
      for (std::size_t i = 0; i < outcome.counts.size(); ++i) {
        const Count& count = outcome.counts[i];
        EXPECT_EQ(count.failure, first.at(i).failure) << where;
        EXPECT_LE(count.failures, count.of) << where << count.failure;
        if (!outcome.exact) continue;
        EXPECT_EQ(count.failures, 0U) << where << count.failure;
        tried += count.of;
      }
    }
    EXPECT_EQ(ours, 1) << experiment.name << ", " << scene.name;
    EXPECT_GE(tried, 40U) << experiment.name << ", " << scene.name;
    for (const Picture& picture : findings.pictures) {
      EXPECT_TRUE(picture.svg.starts_with("<svg ") && picture.svg.ends_with("</svg>\n")) << picture.name;
      EXPECT_EQ(picture.svg.find("nan"), std::string::npos) << picture.name;
    }
  }
  return found;
}

/// How often the method failed at question number `count` of the scene.
std::uint64_t failures(const Found& found, const std::string& scene, const std::string& method, std::size_t count) {
  return found.at(scene).at(method).at(count).failures;
}

TEST(QueriesTest, FloatsLosePointsOfPolygonsAndSolids) {
  const Found found = run(location_experiment());
  for (const char* method : {"float32", "double", "long-double"}) {
    EXPECT_GT(failures(found, "cut-square", method, 0), 0U) << method;  // neither half holds them
    EXPECT_GT(failures(found, "octahedron", method, 0), 0U) << method;
    EXPECT_GT(failures(found, "in-ball", method, 0), 0U) << method;  // three rays tell different things
  }
  EXPECT_GT(failures(found, "cut-square", "absolute", 2), 0U);  // the wrong half holds them
}

TEST(QueriesTest, FloatRaysLeakThroughClosedMeshes) {
  const Found found = run(leak_experiment());
  for (const char* mesh : {"ball", "flange", "far-flange"}) {
    for (const char* method : {"float32", "double"}) EXPECT_GT(failures(found, mesh, method, 0), 0U) << mesh << method;
    EXPECT_GT(failures(found, mesh, "double", 2), 0U) << mesh;
  }
}

TEST(QueriesTest, EpsilonsPartBoxesAndJoinThem) {
  const Found found = run(box_experiment());
  EXPECT_GT(failures(found, "stacked", "double", 0), 0U);
  EXPECT_EQ(failures(found, "stacked", "absolute", 0), 0U);  // what the epsilon is for
  EXPECT_GT(failures(found, "beside", "absolute", 1), 0U);   // and what it costs
  EXPECT_GT(failures(found, "beside", "float32", 0), 0U);
}

TEST(QueriesTest, FloatAnswersChangeWithTheScene) {
  const Found found = run(move_experiment());
  for (std::size_t kind = 0; kind < 3; ++kind) {
    EXPECT_GT(failures(found, "translated", "float32", kind), 0U);
    EXPECT_GT(failures(found, "scaled", "absolute", kind), 0U);
    EXPECT_GT(failures(found, "turned", "float32", kind), 0U);
    EXPECT_GT(failures(found, "turned-and-rounded", "double", kind), 0U);
  }
  EXPECT_GT(failures(found, "scaled", "double", 0), 0U);
}

TEST(QueriesTest, RoundedPosesLoseContacts) {
  const Found found = run(pose_experiment());
  for (const char* scene : {"bricks", "parts"}) {
    for (const char* way :
         {"float32", "double", "exact, rounded points", "float32, in one's space", "exact, in one's space"})
      EXPECT_GT(failures(found, scene, way, 0), 0U) << scene << ' ' << way;
  }
}

TEST(QueriesTest, FloatsTakeTheFartherForTheNearer) {
  const Found found = run(distance_experiment());
  for (const char* scene : {"far-segments", "far-triangles"}) {
    EXPECT_GT(failures(found, scene, "float32", 2), 0U) << scene;
    EXPECT_GT(failures(found, scene, "float32", 3), 0U) << scene;
  }
  EXPECT_GT(failures(found, "crossing-segments", "double", 0), 0U);
  EXPECT_GT(failures(found, "nearly-in-plane", "double", 1), 0U);
}

TEST(QueriesTest, FloatBallsLeaveCornersOut) {
  const Found found = run(ball_experiment());
  for (const char* method : {"float32", "double"}) {
    EXPECT_GT(failures(found, "pivots-in-tenths", method, 0), 0U) << method;  // round in a circle
    EXPECT_GT(failures(found, "pivots", method, 1), 0U) << method;
    EXPECT_GT(failures(found, "recursion", method, 0), 0U) << method;
    EXPECT_GT(failures(found, "far-recursion", method, 2), 0U) << method;
  }
}

TEST(QueriesTest, CubicSolversMissContactsAndInventThem) {
  const Found found = run(motion_experiment());
  for (const std::string kind : {"vertex-face", "edge-edge"}) {
    EXPECT_GT(failures(found, kind + "-meeting", "double", 0), 0U) << kind;
    EXPECT_GT(failures(found, kind + "-double-root", "double", 0), 0U) << kind;
    EXPECT_GT(failures(found, kind + "-in-plane", "double", 0), 0U) << kind;  // the cubic is zero
    EXPECT_GT(failures(found, kind + "-meeting", "float32", 0), 0U) << kind;
  }
}

}  // namespace
}  // namespace plumb::tool::stability
