// What do batches refuse, and by which name?  Laws 2 and 3 of certify/batch.hpp, law 2 of certify/side.hpp.
#include <limits>

#include "certify/batch/batch_cases.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::batches {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

template <class Do>
std::string refused(Do run) {
  try {
    run();
  } catch (const NonFinite& error) {
    return error.what();
  }
  return "nothing";
}

template <class Do>
std::string unequal(Do run) {
  try {
    run();
  } catch (const UnequalLengths& error) {
    return error.what();
  }
  return "nothing";
}

std::string expected_text(std::string_view formula, std::size_t argument, std::size_t axis, std::size_t item,
                          std::string_view what) {
  std::string text(formula);
  text.append(": ").push_back("abcde"[argument]);
  text.append(".").push_back("xyz"[axis]);
  text.append(" of item ").append(std::to_string(item)).append(" is ").append(what);
  return text.append(", not a real number; give a finite double");
}

TYPED_TEST(EveryFormula, RefusesWhatIsNoNumberByItemArgumentAndAxis) {
  using F = TypeParam;
  const std::size_t count = battery::sanitized ? 10 : 37;
  constexpr std::size_t dimension = certify::side::dimension<F>;
  for (const Family family : {Family::uniform, Family::repeated}) {
    const std::vector<Coordinates<F>> good = cases_of<F>(family, count);
    on_each_instruction_set([&] {
      std::vector<Sign> out(count);
      for (std::size_t item = 0; item < count; ++item) {
        for (std::size_t k = 0; k < arity<F>; ++k) {
          std::vector<Coordinates<F>> cases = good;
          const double bad = item % 3 == 0 ? nan : item % 3 == 1 ? inf : -inf;
          cases[item][k] = bad;
          const Arrays<F> arrays(cases);
          const std::string text = expected_text(F::name, k / dimension, k % dimension, item,
                                                 item % 3 == 0   ? "nan"
                                                 : item % 3 == 1 ? "inf"
                                                                 : "-inf");
          ASSERT_EQ(refused([&] { ask_points<F>(arrays, 0, count, out); }), text);
          ASSERT_EQ(refused([&] { ask_views<F>(arrays, 0, count, out); }), text);
        }
      }
    });
  }
}

TYPED_TEST(EveryFormula, NamesTheFirstOfSeveral) {
  using F = TypeParam;
  const std::size_t count = battery::sanitized ? 10 : 24;
  const std::vector<Coordinates<F>> good = cases_of<F>(Family::uniform, count);
  on_each_instruction_set([&] {
    std::vector<Sign> out(count);
    for (std::size_t one = 0; one < count; ++one) {
      for (std::size_t other = one + 1; other < count; ++other) {
        std::vector<Coordinates<F>> cases = good;
        cases[one][arity<F> - 1] = inf;
        cases[other][0] = nan;
        const Arrays<F> arrays(cases);
        const std::string text =
            expected_text(F::name, certify::side::points<F> - 1, certify::side::dimension<F> - 1, one, "inf");
        ASSERT_EQ(refused([&] { ask_points<F>(arrays, 0, count, out); }), text);
        ASSERT_EQ(refused([&] { ask_views<F>(arrays, 0, count, out); }), text);
      }
    }
  });
}

TYPED_TEST(EveryFormula, NamesTheFirstOfSeveralOnManyThreads) {
  using F = TypeParam;
  constexpr std::size_t count = 100'000;
  std::vector<Coordinates<F>> cases(count, cases_of<F>(Family::uniform, 1)[0]);
  for (const std::size_t item : std::array<std::size_t, 5>{99'999, 70'003, 31'415, 31'416, 65'000})
    cases[item][1] = nan;
  const Arrays<F> arrays(cases);
  std::vector<Sign> out(count);
  for (int again = 0; again < battery::fitting(20); ++again) {
    ASSERT_EQ(refused([&] { ask_points<F>(arrays, 0, count, out, Execution::parallel); }),
              expected_text(F::name, 0, 1, 31'415, "nan"));
  }
}

TEST(BatchErrors, UnequalSpansAreRefusedBeforeAnythingIsWritten) {
  const std::vector<Point3> four(4), three(3);
  std::vector<Sign> out(4, Sign{7});
  EXPECT_EQ(unequal([&] { orient3d(four, four, three, four, out); }),
            "orient3d: c has 3 items, but a has 4; give spans of equal length");
  EXPECT_EQ(unequal([&] { orient3d(three, four, three, three, out); }),
            "orient3d: b has 4 items, but a has 3; give spans of equal length");
  EXPECT_EQ(unequal([&] { orient3d(three, three, three, three, out); }),
            "orient3d: out has 4 items, but a has 3; give spans of equal length");
  EXPECT_EQ(unequal([&] { insphere(four, four, four, four, std::vector<Point3>{}, out); }),
            "insphere: e has 0 items, but a has 4; give spans of equal length");
  EXPECT_EQ(out, std::vector<Sign>(4, Sign{7}));
}

TEST(BatchErrors, UnequalViewsAreRefusedByAxis) {
  const std::vector<double> four(4), three(3);
  std::vector<Sign> out(4, Sign{7});
  const Points2View good{four, four}, bad{four, three};
  EXPECT_EQ(unequal([&] { orient2d(good, bad, good, out); }),
            "orient2d: b.y has 3 items, but a.x has 4; give spans of equal length");
  EXPECT_EQ(unequal([&] { incircle(good, good, good, bad, out); }),
            "incircle: d.y has 3 items, but a.x has 4; give spans of equal length");
  EXPECT_EQ(unequal([&] { incircle(good, good, good, good, std::span(out).first(2)); }),
            "incircle: out has 2 items, but a.x has 4; give spans of equal length");
  EXPECT_EQ(out, std::vector<Sign>(4, Sign{7}));
}

TEST(BatchErrors, AreErrorsOfTheLibrary) {
  std::vector<Sign> out(1);
  EXPECT_THROW(orient2d(std::vector<Point2>(2), std::vector<Point2>(2), std::vector<Point2>(2), out), Error);
  EXPECT_NO_THROW(orient2d(std::span<const Point2>(), {}, {}, std::span<Sign>()));
}

TEST(SideErrors, GivenPointsAreRefusedWhenTheSideIsMade) {
  EXPECT_EQ(refused([] {
              PlaneSide({0, 0, 0}, {1, nan, 0}, {0, 1, 0});
            }),
            "orient3d: b.y is nan, not a real number; give a finite double");
  EXPECT_EQ(refused([] {
              SphereSide({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -inf});
            }),
            "insphere: d.z is -inf, not a real number; give a finite double");
}

TEST(SideErrors, QueriesAreRefusedByName) {
  const LineSide line({0, 0}, {1, 1});
  EXPECT_EQ(refused([&] { line({nan, 0}); }), "orient2d: c.x is nan, not a real number; give a finite double");
  on_each_instruction_set([&] {
    std::vector<Point2> points(20, {1, 2});
    std::vector<Sign> out(20);
    points[17].y = inf;
    points[18].x = nan;
    EXPECT_EQ(refused([&] { line(points, out); }),
              "orient2d: c.y of item 17 is inf, not a real number; give a finite double");
    EXPECT_EQ(unequal([&] { line(points, std::span(out).first(19)); }),
              "orient2d: out has 19 items, but points has 20; give spans of equal length");
  });
}

}  // namespace
}  // namespace plumb::batches
