// Batches of boxes and balls: the answers of one by one, on every instruction set that this machine has.
#include "plumb/figure/aabb/box_batch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "certify/batch/take_instruction_set.hpp"
#include "figure/basic/shape_cases.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/sphere/sphere.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using shape_cases::on_shapes;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Calls check() with each instruction set in turn as the only one.
template <class Check>
void on_each_target(Check check) {
  for (const std::string_view set : batch_instruction_sets()) {
    certify::batch::take_instruction_set(set);
    check(set);
  }
  certify::batch::take_instruction_set({});
}

template <class Shape, class Batch>
void answers_agree(std::uint64_t start) {
  on_each_target([&](std::string_view target) {
    std::size_t met = 0, apart = 0;
    on_shapes(start, 120, [&](Material& m) {
      std::vector<Shape> a, b;
      for (std::size_t i = m.below(40); i-- > 0;) a.push_back(m.shape<Shape>()), b.push_back(m.shape<Shape>());
      const auto one = m.shape<Shape>();
      const Batch many_a(a), many_b(b);
      std::vector<std::uint8_t> pairs(a.size(), 7), to_one(a.size(), 7);
      intersects(many_a, many_b, pairs);
      intersects(one, many_b, to_one);
      for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(pairs[i], intersects(a[i], b[i]) ? 1 : 0) << target << " " << m.about(a[i], b[i]);
        ASSERT_EQ(to_one[i], intersects(one, b[i]) ? 1 : 0) << target << " " << m.about(one, b[i]);
        ++(pairs[i] == 1 ? met : apart);
      }
    });
    EXPECT_GT(met, 300u) << target;
    EXPECT_GT(apart, 300u) << target;
  });
}

TEST(BoxBatch, AnswersAsOneByOne) { answers_agree<Aabb3, BoxBatch>(701); }
TEST(SphereBatch, AnswersAsOneByOne) { answers_agree<Sphere3, SphereBatch>(702); }

// More than a chunk of pairs, all in doubt: balls that touch by the last bit.
TEST(SphereBatch, LongBatchesOfDoubt) {
  std::vector<Sphere3> a, b;
  for (int i = 0; i < 3000; ++i) {
    a.push_back({{0.1 * i, 0, 0}, 0.3});
    b.push_back({{0.1 * i, 0.3 + 0.4, 0}, 0.4});
  }
  std::vector<std::uint8_t> out(a.size());
  intersects(SphereBatch(a), SphereBatch(b), out);
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(out[i], intersects(a[i], b[i]) ? 1 : 0) << i;
}

TEST(FourBoxes, AnswerAsOneByOne) {
  std::array<int, 5> count{};
  on_shapes(703, 2000, [&](Material& m) {
    std::array<Aabb3, 4> a, b;
    for (std::size_t i = 0; i < 4; ++i) a[i] = m.shape<Aabb3>(), b[i] = m.shape<Aabb3>();
    unsigned expected = 0;
    for (std::size_t i = 0; i < 4; ++i) expected |= (intersects(a[i], b[i]) ? 1u : 0u) << i;
    ASSERT_EQ(intersects(FourBoxes(a), FourBoxes(b)), expected) << m.about(a, b);
    ++count[static_cast<std::size_t>(std::popcount(expected))];
  });
  for (const int n : count) EXPECT_GT(n, 20);
}

TEST(BoxBatch, BadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Aabb3 good{{0, 0, 0}, {1, 1, 1}}, bad{{0, 0, 0}, {1, nan, 1}};
  const auto number = [](const char* text) { return ThrowsMessage<NonFinite>(HasSubstr(text)); };
  EXPECT_THAT([&] { static_cast<void>(BoxBatch(std::array{good, bad})); }, number("BoxBatch: boxes[1].max.y is nan"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(FourBoxes({good, good, bad, good}));
      },
      number("FourBoxes: boxes[2].max.y is nan"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(SphereBatch(std::array{Sphere3{{0, 0, -inf}, 1}}));
      },
      number("SphereBatch: spheres[0].center.z is -inf"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(SphereBatch(std::array{Sphere3{{0, 0, 0}, -1}}));
      },
      ThrowsMessage<InvalidShape>(HasSubstr("SphereBatch: spheres[0].radius is negative")));
  std::vector<std::uint8_t> out(2);
  EXPECT_THAT(
      [&] {
        intersects(BoxBatch(std::array{good}), BoxBatch(std::array{good, good}), out);
      },
      ThrowsMessage<UnequalLengths>(HasSubstr("intersects: b has 2 items, not 1")));
  EXPECT_THAT([&] { intersects(good, BoxBatch(std::array{good}), out); },
              ThrowsMessage<UnequalLengths>(HasSubstr("intersects: out has 2 items, not 1")));
  EXPECT_THAT([&] { intersects(bad, BoxBatch(std::array{good, good}), out); }, number("intersects: one.max.y is nan"));
}

}  // namespace
}  // namespace plumb
