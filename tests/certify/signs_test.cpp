// What the signs mean, on figures that a reader can draw; the face, the catalog and the oracles say the same.
#include <gtest/gtest.h>

#include <thread>

#include "certify/battery.hpp"
#include "plumb/predicates.hpp"

namespace plumb::battery {
namespace {

TEST(SignsTest, Orient2dIsPositiveWhenCounterclockwise) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), Sign::positive);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), Sign::negative);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {2, 2}), Sign::zero);
}

TEST(SignsTest, Orient3dIsPositiveBelowThePlane) {
  // Seen from above (+z), a, b, c turn counterclockwise.
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), Sign::positive);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Sign::negative);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 5, 0}), Sign::zero);
}

TEST(SignsTest, IncircleIsPositiveInside) {
  const Point2 a{1, 0}, b{0, 1}, c{-1, 0};
  EXPECT_EQ(incircle(a, b, c, {0, 0}), Sign::positive);
  EXPECT_EQ(incircle(a, b, c, {2, 0}), Sign::negative);
  EXPECT_EQ(incircle(a, b, c, {0, -1}), Sign::zero);
  EXPECT_EQ(incircle(c, b, a, {0, 0}), Sign::negative);
}

TEST(SignsTest, InsphereIsPositiveInside) {
  const Point3 a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, d{-1, 0, 0};
  ASSERT_EQ(orient3d(a, b, c, d), Sign::positive);
  EXPECT_EQ(insphere(a, b, c, d, {0, 0, 0}), Sign::positive);
  EXPECT_EQ(insphere(a, b, c, d, {2, 0, 0}), Sign::negative);
  EXPECT_EQ(insphere(a, b, c, d, {0, -1, 0}), Sign::zero);
}

TEST(CatalogTest, ListsTheManifestInOrder) {
  std::size_t i = 0;
#define PLUMB_EXPECT_ENTRY(formula)                                         \
  EXPECT_EQ(catalog()[i].name, predicates::formula::name);                  \
  EXPECT_EQ(catalog()[i].arity(), arity<predicates::formula>);              \
  EXPECT_EQ(catalog()[i].homogeneous, is_homogeneous<predicates::formula>); \
  EXPECT_EQ(find_predicate(predicates::formula::name), &catalog()[i]);      \
  ++i;
  PLUMB_PREDICATES(PLUMB_EXPECT_ENTRY)
#undef PLUMB_EXPECT_ENTRY
  EXPECT_EQ(catalog().size(), i);
  i = 0;
#define PLUMB_EXPECT_DEGREE(formula)                              \
  EXPECT_EQ(classics()[i].name, predicates::formula::name);       \
  EXPECT_EQ(classics()[i].degree, degree<predicates::formula>()); \
  ++i;
  PLUMB_CLASSICS(PLUMB_EXPECT_DEGREE)
#undef PLUMB_EXPECT_DEGREE
  EXPECT_EQ(classics().size(), i);
  EXPECT_EQ(find_predicate("orient"), nullptr);
  EXPECT_EQ(find_predicate(""), nullptr);
}

TEST(StageCountsTest, CountEveryDecisionOnceAndAddUp) {
  StageCounts counts, others;
  const Coordinates<predicates::Orient2d> easy{0, 0, 1, 0, 0, 1}, flat{0, 0, 1, 1, 2, 2},
      equal{1, 1e-300, 1, 1, 1, 1e-300};
  EXPECT_EQ(decide<predicates::Orient2d>(easy, counts), Sign::positive);
  EXPECT_EQ(decide<predicates::Orient2d>(easy, counts), Sign::positive);
  EXPECT_EQ(decide<predicates::Orient2d>(flat, counts), Sign::zero);
  EXPECT_EQ(decide<predicates::Orient2d>(equal, others), Sign::zero);
  EXPECT_EQ(counts.of(Stage::filter), 2U);
  EXPECT_EQ(counts.of(Stage::integer), 1U);
  EXPECT_EQ(counts.total(), 3U);
  counts += others;
  EXPECT_EQ(counts.of(Stage::structural_zero), 1U);
  EXPECT_EQ(counts.total(), 4U);
}

TEST(StageCountsTest, StagesHaveDistinctNames) {
  for (const Stage s : stages)
    for (const Stage t : stages) EXPECT_EQ(s == t, to_string(s) == to_string(t));
}

// Law 4: threads share nothing, so many at once answer as one does.
TEST(ThreadsTest, AnswerAsOneDoes) {
  for (const CatalogEntry& e : classics()) {
    std::vector<std::vector<double>> inputs;
    std::vector<Decision> expected;
    for (const FamilyInfo& f : families) {
      for (std::uint64_t i = 0; i < 200; ++i) {
        inputs.push_back(coordinates_of(e, f.family, i));
        expected.push_back(e.decide(inputs.back()));
      }
    }
    std::array<std::size_t, 8> wrong{};
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < wrong.size(); ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = 0; i < inputs.size(); ++i) {
          const std::size_t k = (i * 7 + t * 101) % inputs.size();
          wrong[t] += e.decide(inputs[k]) != expected[k];
        }
      });
    }
    for (std::thread& t : threads) t.join();
    for (const std::size_t w : wrong) EXPECT_EQ(w, 0U) << e.name;
  }
}

}  // namespace
}  // namespace plumb::battery
