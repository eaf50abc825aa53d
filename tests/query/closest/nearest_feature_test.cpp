// Which world answers?  The nearest features of triangles and oriented boxes over doubles, pairs and exact numbers,
// on every family of inputs, against voronoi_region; and the bounds that are derived and confirmed.
#include "query/closest/nearest_feature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "certify/exact_axes.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "certify/written_axes.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/stack_dyadic.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::query {
namespace {

namespace feature = nearest_feature::HWY_NAMESPACE;
namespace lanes = certify::three_lanes::HWY_NAMESPACE;
using Integers = certify::exact_axes::ExactAxes<StackDyadic, WorldKind::integers>;
using Rationals = certify::exact_axes::ExactAxes<BigDyadic, WorldKind::rationals>;
template <class Statement, Precision precision, class Listener = NoBoundListener>
using Lanes = lanes::Floats<lanes::Three, Statement::highest, Statement::scales, Listener, precision>;

/// What doubles, pairs, integers and rationals say, where they are certain.
template <class Statement, class... Input>
auto ask(const Statement& statement, const Input&... input) {
  using Doubles = Lanes<Statement, Precision::doubles>;
  using Pairs = Lanes<Statement, Precision::pairs>;
  return std::array{lanes::told_by_worlds<Doubles>(NoWorldRecorder{}, statement, input...),
                    lanes::told_by_worlds<Pairs>(NoWorldRecorder{}, statement, input...),
                    lanes::told_by_worlds<Integers>(NoWorldRecorder{}, statement, input...),
                    lanes::told_by_worlds<Rationals>(NoWorldRecorder{}, statement, input...)};
}

void take(PromisedShare& share, const std::array<int, 4>& told, int cases, const FamilyInfo& info) {
  std::printf("%s: of %d doubles tell %d, pairs %d, integers %d, rationals %d\n", info.name.data(), cases, told[0],
              told[1], told[2], told[3]);
  share.add(info.family, told[0], cases);
  EXPECT_GE(told[3], told[0]) << info.name;
}

TEST(NearestFeature, OfATriangleEveryWorldTellsTheSame) {
  PromisedShare share("nearest_of_triangle");
  for (const FamilyInfo& info : families) {
    std::array<int, 4> told{};
    for (std::uint64_t i = 0; i < 300; ++i) {
      SCOPED_TRACE(testing::Message() << info.name << ", Entropy(19, " << i << ")");
      Entropy entropy(19, i);
      std::array<double, 12> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Triangle3 t{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}};
      const Point3 p{x[9], x[10], x[11]};
      const auto answers = ask(feature::OfTriangle{}, t, p);
      for (std::size_t w = 0; w < answers.size(); ++w) {
        if (!answers[w]) continue;
        ++told[w];
        ASSERT_EQ(*answers[w], voronoi_region(t, p));
      }
    }
    take(share, told, 300, info);
  }
}

/// A guess of each axis: 0 and 1 at an end, 2 between them.
struct Guess {
  std::array<int, 3> place;

  [[nodiscard]] Feature feature() const {
    std::uint32_t ends = 0, fixed = 0, free_axis = 0, fixed_axis = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (place[i] == 2) {
        free_axis = i;
      } else {
        fixed_axis = i, ends |= static_cast<std::uint32_t>(place[i]) << fixed++;
      }
    }
    if (fixed == 3) return {FeatureKind::vertex, ends};
    if (fixed == 2) return {FeatureKind::edge, 4 * free_axis + ends};
    if (fixed == 1) return {FeatureKind::face, 2 * fixed_axis + ends};
    return {FeatureKind::interior, 0};
  }
};

auto ask(const Guess& guess, const Obb3& box, const Point3& p, const auto& asked) {
  std::size_t free = 0, first = 0;
  for (const int at : guess.place) free += at == 2 ? 1 : 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (free == 1 ? guess.place[i] == 2 : free == 2 && guess.place[i] != 2) first = i;
  }
  const std::array<double, 3> half{box.half.x, box.half.y, box.half.z};
  std::array<const Vector3*, 3> axes{};
  std::array<double, 3> end{};
  unsigned upper = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (first + k) % 3;
    axes[k] = &box.axes[i];
    end[k] = guess.place[i] == 0 ? -half[i] : half[i];
    upper |= guess.place[i] == 1 ? 1U << k : 0U;
  }
  const Vector3 ends{end[0], end[1], end[2]};
  if (free == 0) return asked(feature::OfBox<0>{}, p, box.center, axes, ends, upper);
  if (free == 1) return asked(feature::OfBox<1>{}, p, box.center, axes, ends, upper);
  if (free == 2) return asked(feature::OfBox<2>{}, p, box.center, axes, ends, upper);
  return asked(feature::OfBox<3>{}, p, box.center, axes, ends, upper);
}

TEST(NearestFeature, OfAnOrientedBoxOneGuessOf27IsRight) {
  PromisedShare share("nearest_of_obb");
  for (const FamilyInfo& info : families) {
    std::array<int, 4> told{};
    int cases = 0;
    for (std::uint64_t i = 0; i < 125; ++i) {
      SCOPED_TRACE(testing::Message() << info.name << ", Entropy(20, " << i << ")");
      Entropy entropy(20, i);
      std::array<double, 18> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const auto vector = [&x](std::size_t k) { return Vector3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
      const Obb3 box{{x[0], x[1], x[2]},
                     {vector(1), vector(2), vector(3)},
                     {std::fabs(x[12]), std::fabs(x[13]), std::fabs(x[14])}};
      const Point3 p{x[15], x[16], x[17]};
      if (box.half.x == 0 || box.half.y == 0 || box.half.z == 0) continue;  // the two ends of an axis are one
      ++cases;
      const Feature right = voronoi_region(box, p);
      for (int g = 0; g < 27; ++g) {
        const Guess guess{{g / 9, g / 3 % 3, g % 3}};
        const auto answers = ask(guess, box, p, [](const auto&... what) { return ask(what...); });
        for (std::size_t w = 0; w < answers.size(); ++w) {
          if (!answers[w]) continue;
          ++told[w];
          ASSERT_EQ(guess.feature(), right) << "guess " << g << ", world " << w;
        }
      }
    }
    take(share, told, cases, info);
  }
}

template <class Statement, class... Input>
void judge(std::vector<std::string>& scripts, const Statement& statement, const Input&... input) {
  Lanes<Statement, Precision::doubles, BoundListener> world;
  static_cast<void>(statement(world, input...));
  std::ranges::copy(certify::written::axes_proofs("the nearest feature", statement, input...),
                    std::back_inserter(scripts));
}
void expect_bounds(const char* name, const std::vector<std::string>& scripts) {
  const std::vector<std::string> bounds = BoundListener::taken();
  expect_golden(name, bounds);
  expect_proved(bounds, scripts);
}
TEST(NearestFeature, DerivedBoundsAreAsRecordedAndProved) {
  BoundListener::taken();
  std::vector<std::string> of_triangle, of_box;
  judge(of_triangle, feature::OfTriangle{}, Triangle3{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, Point3{1, 1, 2});
  expect_bounds("nearest_of_triangle", of_triangle);
  const std::array<Vector3, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<const Vector3*, 3> axes{&v[0], &v[1], &v[2]};
  const Point3 center{0, 0, 0};
  const Vector3 ends{1, 1, 1};
  judge(of_box, feature::OfBox<0>{}, Point3{2, 2, 2}, center, axes, ends, 7U);
  judge(of_box, feature::OfBox<1>{}, Point3{0, 2, 2}, center, axes, ends, 6U);
  judge(of_box, feature::OfBox<2>{}, Point3{2, 0, 0}, center, axes, ends, 1U);
  judge(of_box, feature::OfBox<3>{}, Point3{0, 0, 0}, center, axes, ends, 0U);
  expect_bounds("nearest_of_obb", of_box);
}

TEST(NearestFeature, MutantsAreNoticed) {
  using mutants::unnoticed, mutants::Draw;
  const auto told = [](const auto&... what) { return mutants::told<mutants::Axes>(what...); };
  mutants::expect_noticed("nearest_of_triangle",
                          unnoticed(
                              [](Draw& d) {
                                return std::pair{Triangle3{d.point(), d.point(), d.point()}, d.point()};
                              },
                              [&](const auto& input) { return told(feature::OfTriangle{}, input.first, input.second); },
                              [](const auto& input) { return voronoi_region(input.first, input.second); }));
  // Within a box nobody asks how far along its axes (1 to 5), and nothing is within less than none (23).
  for (int free = 0; free < 4; ++free) {
    mutants::expect_noticed(
        "nearest_of_obb",
        unnoticed(
            [&](Draw& d) {
              Guess guess{};
              const int first = static_cast<int>(d.positive()) - 1;
              for (int i = 0; i < 3; ++i) {
                const bool is_free = (i + first) % 3 < free;
                guess.place[static_cast<std::size_t>(i)] = is_free ? 2 : d.number() > 0 ? 1 : 0;
              }
              Obb3 box = d.turned_box();
              for (double* half : {&box.half.x, &box.half.y, &box.half.z}) *half = std::fabs(*half);
              const Point3 c = box.center, p = d.point();
              const bool is_near = d.number() > 0;
              return std::tuple{guess, box, is_near ? Point3{c.x + p.x / 4, c.y + p.y / 4, c.z + p.z / 4} : p};
            },
            [&](const auto& input) {
              const auto& [guess, box, p] = input;
              return ask(guess, box, p, told);
            },
            [](const auto& input) {
              const auto& [guess, box, p] = input;
              return guess.feature() == voronoi_region(box, p);
            }),
        free == 3 ? "1 2 3 4 5 23 " : "");
  }
}

}  // namespace
}  // namespace plumb::query
