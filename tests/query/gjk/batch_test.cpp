// Batches of pairs: the answers of each pair alone, on one thread and on all, with caches and without; errors by the number.
#include "plumb/query/gjk/batch.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "certify/sanitized.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Boxes, balls, triangles and hulls of small integers, of which many touch.
class Bodies {
 public:
  explicit Bodies(std::size_t of_each) {
    Entropy e(77, 0);
    const auto at = [&] {
      return Point3{static_cast<double>(e.within(6)), static_cast<double>(e.within(6)),
                    static_cast<double>(e.within(6))};
    };
    const auto vector = [&] { return Vector3{at().x, at().y, at().z}; };
    for (std::size_t i = 0; i < of_each; ++i) {
      boxes_.push_back({at(), {vector(), vector(), vector()}, {0.25, 0.5, 0.125}});
      balls_.push_back({at(), static_cast<double>(e.below(3))});
      triangles_.push_back({at(), at(), at()});
      points_.push_back({at(), at(), at(), at(), at(), at()});
    }
    for (const Obb3& s : boxes_) all.push_back(any_body(s));
    for (const Sphere3& s : balls_) all.push_back(any_body(s));
    for (const Triangle3& s : triangles_) all.push_back(any_body(s));
    for (const auto& s : points_) all.push_back(any_body(VertexHull3{s}));
  }
  std::vector<AnyBody3> all;

 private:
  std::vector<Obb3> boxes_;
  std::vector<Sphere3> balls_;
  std::vector<Triangle3> triangles_;
  std::vector<std::vector<Point3>> points_;
};

std::vector<BodyPair> every_pair(std::size_t n) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i; j < n; ++j) pairs.push_back({i, j});
  }
  return pairs;
}

TEST(GjkBatch, SaysWhatEachPairSaysOnAnyThreads) {
  const Bodies bodies(battery::sanitized ? 3 : 8);
  const std::vector<BodyPair> pairs = every_pair(bodies.all.size());
  std::vector<std::uint8_t> alone(pairs.size()), serial(pairs.size()), parallel(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
    alone[i] = query::gjk_meets(bodies.all[pairs[i].a], bodies.all[pairs[i].b], {}) ? 1 : 0;
  std::vector<GjkCache> caches(pairs.size());
  gjk_intersects(bodies.all, pairs, serial);
  EXPECT_EQ(serial, alone);
  for (int frame = 0; frame < 2; ++frame) {
    gjk_intersects(bodies.all, pairs, parallel, {.execution = Execution::parallel, .caches = caches});
    EXPECT_EQ(parallel, alone) << frame;
  }
  const auto meeting = static_cast<std::size_t>(std::count(alone.begin(), alone.end(), 1));
  EXPECT_GT(meeting, pairs.size() / 10);
  EXPECT_LT(meeting, pairs.size() * 9 / 10);

  std::vector<GjkAnswer> answers(pairs.size()), again(pairs.size());
  gjk(bodies.all, pairs, answers);
  gjk(bodies.all, pairs, again, {.execution = Execution::parallel});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(answers[i].meets, alone[i] == 1) << i;
    EXPECT_EQ(answers[i].closest.distance, again[i].closest.distance) << i;
    EXPECT_EQ(answers[i].closest.on_a, again[i].closest.on_a) << i;
    EXPECT_EQ(answers[i].closest.on_b, again[i].closest.on_b) << i;
    EXPECT_EQ(answers[i].simplex, again[i].simplex) << i;
  }
}

TEST(GjkBatch, NamesTheFirstPairThatIsNone) {
  const std::vector<Sphere3> balls{{{0, 0, 0}, 1}, {{1, 0, 0}, -1}, {{NAN, 0, 0}, 1}};
  std::vector<AnyBody3> bodies;
  for (const Sphere3& ball : balls) bodies.push_back(any_body(ball));
  std::vector<BodyPair> pairs(200, BodyPair{0, 0});
  pairs[150] = {0, 2};
  pairs[140] = {0, 1};
  std::vector<std::uint8_t> out(pairs.size());
  for (const Execution execution : {Execution::serial, Execution::parallel}) {
    EXPECT_THAT([&] { gjk_intersects(bodies, pairs, out, {.execution = execution}); },
                ThrowsMessage<InvalidShape>(HasSubstr("gjk_intersects of pair 140: ")));
  }
  pairs[140] = {0, 0};
  EXPECT_THAT([&] { gjk_intersects(bodies, pairs, out); },
              ThrowsMessage<NonFinite>(HasSubstr("gjk_intersects of pair 150: ")));
  pairs[3] = {0, 7};
  EXPECT_THAT([&] { gjk_intersects(bodies, pairs, out); },
              ThrowsMessage<Error>(HasSubstr("pair 3 names body 7, but there are 3")));
  out.pop_back();
  EXPECT_THAT([&] { gjk_intersects(bodies, pairs, out); }, ThrowsMessage<UnequalLengths>(HasSubstr("out has 199")));
  std::vector<GjkCache> caches(2);
  EXPECT_THROW(gjk_intersects(bodies, pairs, out, {.caches = caches}), UnequalLengths);
  EXPECT_NO_THROW(gjk_intersects({}, {}, {}));
}

}  // namespace
}  // namespace plumb
