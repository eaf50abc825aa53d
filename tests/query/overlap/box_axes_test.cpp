// Which world answers?  The statements of boxes against what is straight, triangles and balls, over doubles and over exact
// numbers, on every family of inputs.
#include "query/overlap/box_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/exact_axes.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "certify/written_axes.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/stack_dyadic.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/box_quick.hpp"

namespace plumb::query {
namespace {

namespace axes = box_axes::HWY_NAMESPACE;
namespace lanes = certify::three_lanes::HWY_NAMESPACE;
using Integers = certify::exact_axes::ExactAxes<StackDyadic, WorldKind::integers>;
using Rationals = certify::exact_axes::ExactAxes<BigDyadic, WorldKind::rationals>;

/// The answers of both worlds, where they are certain, and who is.
struct Answers {
  std::optional<Relation> floats, pairs, integers, exact;

  [[nodiscard]] bool are(Relation truth) const {
    for (const auto& told : {floats, pairs, integers, exact}) {
      if (told && told != truth) return false;
    }
    return true;
  }
};
template <class Statement, class... Input>
Answers ask(const Statement& statement, const Input&... input) {
  using Floats = lanes::Floats<lanes::Three, Statement::highest, Statement::scales>;
  using Pairs = lanes::Floats<lanes::Three, Statement::highest, Statement::scales, NoBoundListener, Precision::pairs>;
  return {lanes::told_by_worlds<Floats>(NoWorldRecorder{}, statement, input...),
          lanes::told_by_worlds<Pairs>(NoWorldRecorder{}, statement, input...),
          lanes::told_by_worlds<Integers>(NoWorldRecorder{}, statement, input...),
          lanes::told_by_worlds<Rationals>(NoWorldRecorder{}, statement, input...)};
}

Aabb3 box_of(const Point3& p, const Point3& q) {
  return {{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
          {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
}

struct Case {
  std::string_view name;
  Answers (*ask)(const std::array<Point3, 5>&);
  Relation (*relate)(const std::array<Point3, 5>&);
};
constexpr std::array cases{Case{"segment",
                                [](const auto& p) {
                                  return ask(axes::SegmentAndBox{}, Segment3{p[0], p[1]}, box_of(p[2], p[3]));
                                },
                                [](const auto& p) {
                                  return relate(Segment3{p[0], p[1]}, box_of(p[2], p[3]));
                                }},
                           Case{"ray",
                                [](const auto& p) {
                                  return ask(axes::UnboundedAndBox<LinearKind::ray>{}, p[0],
                                             Vector3{p[1].x, p[1].y, p[1].z}, box_of(p[2], p[3]));
                                },
                                [](const auto& p) {
                                  return relate(Ray3{p[0], {p[1].x, p[1].y, p[1].z}}, box_of(p[2], p[3]));
                                }},
                           Case{"line",
                                [](const auto& p) {
                                  return ask(axes::UnboundedAndBox<LinearKind::line>{}, p[0],
                                             Vector3{p[1].x, p[1].y, p[1].z}, box_of(p[2], p[3]));
                                },
                                [](const auto& p) {
                                  return relate(Line3{p[0], {p[1].x, p[1].y, p[1].z}}, box_of(p[2], p[3]));
                                }},
                           Case{"triangle",
                                [](const auto& p) {
                                  return ask(axes::TriangleAndBox{}, Triangle3{p[0], p[1], p[4]}, box_of(p[2], p[3]));
                                },
                                [](const auto& p) {
                                  return relate(Triangle3{p[0], p[1], p[4]}, box_of(p[2], p[3]));
                                }}};

template <class Statement, class... Input>
void expect_bounds_of_doubles(const char* name, const Statement& statement, const Input&... input) {
  lanes::Floats<lanes::Three, Statement::highest, Statement::scales, BoundListener> world;
  BoundListener::taken();
  static_cast<void>(statement(world, input...));
  const std::vector<std::string> bounds = BoundListener::taken();
  expect_golden(name, bounds);
  expect_proved(bounds, certify::written::axes_proofs(name, statement, input...));
}
template <class Statement, class... Input>
void expect_bounds(const char* name, const Statement& statement, const Input&... input) {
  expect_bounds_of_doubles(name, statement, input...);
  if (Statement::scales.weights == 0) return;  // pairs are asked of turned boxes alone
  lanes::Floats<lanes::Three, Statement::highest, Statement::scales, BoundListener, Precision::pairs> of_pairs;
  static_cast<void>(statement(of_pairs, input...));
  expect_golden(name + std::string("_pairs"));
}
TEST(BoxAxes, DerivedBoundsAreAsRecordedAndProved) {
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  const Point3 p{0.3, 0.4, 2}, q{0.2, 0.7, -1}, r{-1, 0.25, 0.5};
  expect_bounds("segment_box", axes::SegmentAndBox{}, Segment3{p, q}, box);
  expect_bounds("ray_box", axes::UnboundedAndBox<LinearKind::ray>{}, p, Vector3{1, 2, -3}, box);
  expect_bounds("line_box", axes::UnboundedAndBox<LinearKind::line>{}, p, Vector3{1, 2, -3}, box);
  expect_bounds("triangle_box", axes::TriangleAndBox{}, Triangle3{p, q, r}, box);
  const Obb3 turned{{0, 0, 0}, {Vector3{0.6, 0.8, 0}, Vector3{-0.8, 0.6, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
  expect_bounds("segment_obb", axes::StraightAndObb<LinearKind::segment>{}, p, q, turned);
  expect_bounds("ray_obb", axes::StraightAndObb<LinearKind::ray>{}, p, Vector3{1, 2, -3}, turned);
  expect_bounds("line_obb", axes::StraightAndObb<LinearKind::line>{}, p, Vector3{1, 2, -3}, turned);
  expect_bounds("triangle_obb", axes::TriangleAndObb{}, Triangle3{p, q, r}, turned);
  expect_bounds_of_doubles("ball_obb", axes::BallAndObb{}, Sphere3{{0, 0, 4}, 1}, turned, Vector3{0, 0, 1},
                           Vector3{0, 0, 3});
}

/// A box that is turned, of short numbers; now and then flat or skew.
Obb3 turned_box(Entropy& e) {
  const auto number = [&](std::int64_t most) { return static_cast<double>(e.within(most)); };
  const auto vector = [&] { return Vector3{number(4), number(4), number(4)}; };
  return {{number(3), number(3), number(3)}, {vector(), vector(), vector()}, {number(1), number(2), number(1)}};
}
/// What each world tells of the segment, the ray, the line and the triangle, and what is so.
struct OfTurned {
  std::array<Answers, 4> answers;
  std::array<Relation, 4> truths;
};
OfTurned all_of_turned(const Point3& p, const Point3& q, const Point3& r, const Vector3& d, const Obb3& box) {
  return {
      {ask(axes::StraightAndObb<LinearKind::segment>{}, p, q, box),
       ask(axes::StraightAndObb<LinearKind::ray>{}, p, d, box),
       ask(axes::StraightAndObb<LinearKind::line>{}, p, d, box), ask(axes::TriangleAndObb{}, Triangle3{p, q, r}, box)},
      {relate(Segment3{p, q}, box), relate(Ray3{p, d}, box), relate(Line3{p, d}, box),
       relate(Triangle3{p, q, r}, box)}};
}

TEST(BoxAxes, EveryWorldGivesTheRelationToTurnedBoxes) {
  std::array<int, 4> by_floats{}, by_pairs{}, by_exact{};
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Entropy e(21, i);
    const Obb3 box = turned_box(e);
    const auto number = [&] { return static_cast<double>(e.within(1 << 10)) * 0x1p-6; };
    const Point3 p{number(), number(), number()}, q{number(), number(), number()}, r{number(), number(), number()};
    const Vector3 d{q.x, q.y, q.z};
    const auto [answers, truths] = all_of_turned(p, q, r, d, box);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [floats, pairs, integers, exact] = answers[k];
      by_floats[k] += floats.has_value(), by_pairs[k] += pairs.has_value(), by_exact[k] += exact.has_value();
      ASSERT_TRUE(answers[k].are(truths[k])) << k << ", replay: " << i;
      ASSERT_EQ(integers, exact) << k << ", replay: " << i;
    }
  }
  for (std::size_t k = 0; k < 4; ++k) EXPECT_GE(by_floats[k], 600) << k;
  for (std::size_t k = 0; k < 4; ++k) EXPECT_GE(by_exact[k], 450) << k;
  for (std::size_t k = 0; k < 4; ++k) EXPECT_GE(by_pairs[k], by_floats[k]) << k;
}

// What doubles leave is as a rule touching, a box without an inside, or among the ends of the doubles.
TEST(BoxAxes, EveryWorldGivesTheRelationAndDoublesTheirShare) {
  std::array shares{PromisedShare("segment_box"), PromisedShare("ray_box"), PromisedShare("line_box"),
                    PromisedShare("triangle_box")};
  for (const FamilyInfo& info : families) {
    for (std::size_t which = 0; which < cases.size(); ++which) {
      const Case& c = cases[which];
      int by_floats = 0, by_pairs = 0, by_exact = 0;
      for (std::uint64_t i = 0; i < 1000; ++i) {
        Entropy entropy(18, i);
        std::array<double, 15> x{};
        fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
        std::array<Point3, 5> p;
        for (std::size_t k = 0; k < 5; ++k) p[k] = {x[3 * k], x[3 * k + 1], x[3 * k + 2]};
        const Answers told = c.ask(p);
        by_floats += told.floats.has_value(), by_pairs += told.pairs.has_value(), by_exact += told.exact.has_value();
        ASSERT_TRUE(told.are(c.relate(p))) << c.name << ' ' << info.name << ", replay: " << i;
      }
      shares[which].add(info.family, by_floats, 1000);
      if (info.family != Family::extreme && info.family != Family::mixture) {
        EXPECT_GE(by_pairs, by_floats) << c.name << ' ' << info.name;
      }
      EXPECT_GE(by_exact, by_floats) << c.name << ' ' << info.name;
    }
  }
}

/// As a rule a parallelepiped that is no box.
TEST(BoxAxes, TurnedBoxesOfEveryFamilyAreAnsweredInTheirShare) {
  std::array by_floats{PromisedShare("segment_obb"), PromisedShare("ray_obb"), PromisedShare("line_obb"),
                       PromisedShare("triangle_obb")};
  std::array by_pairs{PromisedShare("segment_obb_pairs"), PromisedShare("ray_obb_pairs"),
                      PromisedShare("line_obb_pairs"), PromisedShare("triangle_obb_pairs")};
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      Entropy entropy(22, i);
      std::array<double, 24> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const auto point = [&](std::size_t k) { return Point3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
      const auto vector = [&](std::size_t k) { return Vector3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
      const Obb3 box{point(0), {vector(1), vector(2), vector(3)}, vector(4)};
      const Point3 p = point(5), q = point(6), r = point(7);
      const Vector3 d = vector(6);
      const auto [answers, truths] = all_of_turned(p, q, r, d, box);
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_TRUE(answers[k].are(truths[k])) << k << ' ' << info.name << ", replay: " << i;
        by_floats[k].add(info.family, answers[k].floats.has_value());
        by_pairs[k].add(info.family, answers[k].pairs.has_value());
      }
    }
  }
}

/// The guess is for axes at right angles, which these are not.
TEST(BoxAxes, BallsBesideTurnedBoxesOfEveryFamilyAreAnsweredInTheirShare) {
  PromisedShare share("ball_obb");
  int meet = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      Entropy entropy(21, i);
      std::array<double, 18> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const auto vector = [&](std::size_t k) { return Vector3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
      const Obb3 box{{x[0], x[1], x[2]}, {vector(1), vector(2), vector(3)}, vector(4)};
      const Sphere3 ball{{x[15], x[16], x[17]}, std::fabs(entropy.coin() ? x[14] : x[14] - x[2])};
      const auto told = quick_relation(ball, box);
      share.add(info.family, told.has_value());
      meet += told == Relation::overlapping ? 1 : 0;
      if (!told) continue;
      const Sign gap = compare_distance(ball.center, box, ball.radius);
      ASSERT_EQ(static_cast<Relation>(-gap), *told) << info.name << ", replay: " << i;
    }
  }
  EXPECT_GE(meet, 100);
}

/// Of a figure and a box, as the statement takes them.
std::string unnoticed_of(const auto& statement, const auto& drawn, const auto& box) {
  return mutants::unnoticed(
      [&](mutants::Draw& d) {
        return std::pair{drawn(d), box(d)};
      },
      [&](const auto& input) {
        const auto told = [&](const auto&... figure) {
          return mutants::told<mutants::Axes>(statement, figure..., input.second);
        };
        if constexpr (requires { input.first.c; }) {
          return told(input.first);
        } else {
          const auto& [from, to] = input.first;
          if constexpr (std::is_same_v<decltype(statement), const axes::SegmentAndBox&>) {
            return told(input.first);
          } else {
            return told(from, to);
          }
        }
      },
      [](const auto& input) { return relate(input.first, input.second); });
}
TEST(BoxAxes, MutantsAreNoticed) {
  using mutants::Draw;
  const auto segment = [](Draw& d) { return Segment3{d.point(), d.point()}; };
  const auto ray = [](Draw& d) { return Ray3{d.point(), d.vector()}; };
  const auto line = [](Draw& d) { return Line3{d.point(), d.vector()}; };
  const auto triangle = [](Draw& d) { return Triangle3{d.point(), d.point(), d.point()}; };
  const auto box = [](Draw& d) { return d.box(); };
  const auto turned = [](Draw& d) { return d.turned_box(); };
  mutants::expect_noticed("segment_box", unnoticed_of(axes::SegmentAndBox{}, segment, box));
  mutants::expect_noticed("ray_box", unnoticed_of(axes::UnboundedAndBox<LinearKind::ray>{}, ray, box));
  mutants::expect_noticed("line_box", unnoticed_of(axes::UnboundedAndBox<LinearKind::line>{}, line, box));
  mutants::expect_noticed("triangle_box", unnoticed_of(axes::TriangleAndBox{}, triangle, box));
  mutants::expect_noticed("segment_obb", unnoticed_of(axes::StraightAndObb<LinearKind::segment>{}, segment, turned));
  // Of a direction that is zero nothing is told at all: its size is the last that is computed.
  mutants::expect_noticed("ray_obb", unnoticed_of(axes::StraightAndObb<LinearKind::ray>{}, ray, turned), "43 44 45 ");
  mutants::expect_noticed("line_obb", unnoticed_of(axes::StraightAndObb<LinearKind::line>{}, line, turned),
                          "40 41 42 ");
  mutants::expect_noticed("triangle_obb", unnoticed_of(axes::TriangleAndObb{}, triangle, turned));
  const std::string of_ball = mutants::unnoticed(
      [&](Draw& d) {
        const auto part = [&] { return Vector3{d.quarter(), d.quarter(), d.quarter()}; };
        const Vector3 v = d.vector();
        const double by = d.number() > 0 ? 0.25 : 1;
        return std::tuple{Sphere3{d.point(), d.positive()}, d.turned_box(), part(),
                          Vector3{v.x * by, v.y * by, v.z * by}};
      },
      [](const auto& input) {
        const auto& [ball, obb, part, direction] = input;
        return mutants::told<mutants::Axes>(axes::BallAndObb{}, ball, obb, part, direction);
      },
      [](const auto& input) { return relate(std::get<0>(input), std::get<1>(input)); });
  // A box has the opposite of each of its points, seen from its center: it need not be this side.
  mutants::expect_noticed("ball_obb", of_ball, "3 5 7 ");
}

}  // namespace
}  // namespace plumb::query
