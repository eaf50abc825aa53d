// Which world answers?  Statements of one number at a time, over doubles and exact numbers, on every family of inputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/body/axis_shape.hpp"
#include "query/body/past_cylinder.hpp"
#include "query/overlap/beside_box.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/straight_and_ball.hpp"

namespace plumb::query {
namespace {

/// The answers of these worlds, each by itself, where they are certain: doubles, pairs, integers, rationals.
template <class Statement, class... Input>
std::array<std::optional<Relation>, 4> ask_each(const Statement& statement, const Input&... input) {
  using namespace certify::one_lane;
  return {told_by_worlds<FloatWorld<Statement>>(NoWorldRecorder{}, statement, input...),
          told_by_worlds<PairWorld<Statement>>(NoWorldRecorder{}, statement, input...),
          told_by_worlds<IntegerWorld>(NoWorldRecorder{}, statement, input...),
          told_by_worlds<RationalWorld>(NoWorldRecorder{}, statement, input...)};
}

template <class Statement, class... Input>
void expect_bounds_of_pairs(const std::string& name, const Statement& statement, const Input&... input) {
  BoundListener::taken();
  certify::one_lane::Floats<double, highest_power<Statement>, scales_of<Statement>, BoundListener, Precision::pairs> w;
  static_cast<void>(statement(w, input...));
  expect_golden(name + "_pairs");
}
template <class Statement, class... Input>
void expect_bounds_of(const char* name, const Statement& statement, const Input&... input) {
  const std::vector<std::string> bounds = judged_bounds(statement, input...);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, statement, input...));
}
TEST(OverlapStatements, DerivedBoundsAreAsRecordedAndProved) {
  const Sphere3 ball{{0, 0, 0}, 1};
  const Point3 p{-3, 0.25, 0.25}, q{3, 0.5, 0.25};
  expect_bounds_of("segment_ball", StraightAndBall<true, true>{}, p, q, ball);
  expect_bounds_of("ray_ball", StraightAndBall<true, false>{}, p, Vector3{1, 0, 0}, ball);
  expect_bounds_of("line_ball", StraightAndBall<false, false>{}, p, Vector3{1, 0, 0}, ball);
  expect_bounds_of_pairs("segment_ball", StraightAndBall<true, true>{}, p, q, ball);
  expect_bounds_of_pairs("ray_ball", StraightAndBall<true, false>{}, p, Vector3{1, 0, 0}, ball);
  expect_bounds_of_pairs("line_ball", StraightAndBall<false, false>{}, p, Vector3{1, 0, 0}, ball);
}

/// What is told of a gap, or more.
struct TellGaps {
  bool apart = false, meet = true;
  template <class W, class Gap>
  void operator()(const W& w, const Gap& gap) {
    apart = apart || w.positive(gap);
    meet = w.negative(gap) && meet;
  }
};
TEST(OverlapStatements, BoundsOfWhatPassesACylinderAreAsRecordedAndProved) {
  const Cylinder3 cylinder{{0, 0, -1}, {0, 0, 1}, 1};
  const Point3 p{-3, 0.25, 0.25};
  expect_bounds_of("segment_past_cylinder", PastCylinder<true, true>{}, p, Point3{3, 0.5, 0.25}, cylinder);
  // Of rays and lines the text is the same, and Gappa takes as long again.
  const Vector3 d{1, 0, 0.25};
  expect_golden("ray_past_cylinder", judged_bounds(PastCylinder<true, false>{}, p, d, cylinder));
  expect_golden("line_past_cylinder", judged_bounds(PastCylinder<false, false>{}, p, d, cylinder));
}

namespace beside = beside_box::HWY_NAMESPACE;
using At = beside::Place<double>;
At place(const Point3& p) { return {p.x, p.y, p.z}; }
/// What the statement itself answers, where its gaps are told.
template <class Statement>
struct Telling {
  static constexpr int highest = Statement::highest;
  static constexpr Scales scales = Statement::scales;
  bool operator()(auto& w, const auto&... input) const {
    TellGaps told;
    Statement{}(w, input..., told);
    return told.apart;
  }
};
template <class Statement, class... Input>
std::pair<bool, bool> tell_gaps(const Input&... input) {
  FloatWorld<Statement> world;
  TellGaps told;
  Statement{}(world, input..., told);
  return {told.apart && world.in_range(), told.meet && world.in_range()};
}

TEST(OverlapStatements, BoundsBesideABoxAreAsRecordedAndProved) {
  const At a{-3, 0.25, 0.25}, b{3, 0.5, 0.25}, c{1, 2, 3}, min{0, 0, 0}, max{1, 1, 1};
  expect_bounds_of("triangle_beside_box", Telling<beside::TriangleBesideBox>{}, a, b, c, min, max);
  const bool across[3] = {true, true, true};
  expect_bounds_of("segment_beside_box", Telling<beside::SegmentBesideBox>{}, a, b, min, max, across);
}

TEST(OverlapStatements, WhatDoublesTellOfABoxIsSo) {
  std::array<int, 2> sure{};
  PromisedShare of_triangles("triangle_beside_box"), of_segments("segment_beside_box");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      Entropy entropy(25, i);
      std::array<double, 15> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Triangle3 t{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}};
      const Aabb3 box{{std::fmin(x[9], x[12]), std::fmin(x[10], x[13]), std::fmin(x[11], x[14])},
                      {std::fmax(x[9], x[12]), std::fmax(x[10], x[13]), std::fmax(x[11], x[14])}};
      const auto [apart, meet] =
          tell_gaps<beside::TriangleBesideBox>(place(t.a), place(t.b), place(t.c), place(box.min), place(box.max));
      const Relation truth = relate(t, box);
      if (apart) {
        EXPECT_EQ(truth, Relation::disjoint) << info.name << ", replay: " << i;
      }
      // Along the box's own axes they may be apart.
      const auto clear = [](double a, double b, double c, double low, double high) {
        return std::fmin(std::fmin(a, b), c) < high && low < std::fmax(std::fmax(a, b), c);
      };
      const bool meets = meet && clear(t.a.x, t.b.x, t.c.x, box.min.x, box.max.x) &&
                         clear(t.a.y, t.b.y, t.c.y, box.min.y, box.max.y) &&
                         clear(t.a.z, t.b.z, t.c.z, box.min.z, box.max.z);
      if (meets) {
        EXPECT_NE(truth, Relation::disjoint) << info.name << ", replay: " << i;
      }
      sure[0] += apart, sure[1] += meets;
      of_triangles.add(info.family, apart || meet);
      const Segment3 s{t.a, t.b};
      const bool across[3] = {true, true, true};
      const auto [segment_apart, segment_meets] =
          tell_gaps<beside::SegmentBesideBox>(place(s.a), place(s.b), place(box.min), place(box.max), across);
      EXPECT_TRUE(!segment_apart || relate(s, box) == Relation::disjoint) << info.name << ", replay: " << i;
      of_segments.add(info.family, segment_apart || segment_meets);
    }
  }
  for (const int n : sure) EXPECT_GE(n, 100);
}

/// Of what is straight and a ball.
std::string unnoticed_of(const auto& statement, const auto& drawn) {
  return mutants::unnoticed(
      [&](mutants::Draw& d) {
        return std::pair{drawn(d), Sphere3{d.point(), d.positive()}};
      },
      [&](const auto& input) {
        const auto& [from, to] = input.first;
        return mutants::told<mutants::World>(statement, from, to, input.second);
      },
      [](const auto& input) { return relate(input.first, input.second); });
}
template <bool begins, bool ends>
std::string unnoticed_past_cylinder(const auto& drawn) {
  return mutants::unnoticed(
      [&](mutants::Draw& d) {
        return std::pair{drawn(d), Cylinder3{d.point(), d.point(), d.positive()}};
      },
      [](const auto& input) {
        const auto& [from, to] = input.first;
        return mutants::told<mutants::World>(PastCylinder<begins, ends>{}, from, to, input.second);
      },
      [](const auto& input) { return relate(input.first, input.second); });
}
/// Of a figure and a box: what the box's own axes do not tell.
struct BesideBox {
  bool operator()(auto& w, const Triangle3& t, const Aabb3& box) const {
    TellGaps told;
    beside::TriangleBesideBox{}(w, place(t.a), place(t.b), place(t.c), place(box.min), place(box.max), told);
    return say(w, told, std::array{t.a, t.b, t.c}, box);
  }
  bool operator()(auto& w, const Segment3& s, const Aabb3& box) const {
    TellGaps told;
    const bool y = s.a.y != s.b.y, x = s.a.x != s.b.x, z = s.a.z != s.b.z, across[3] = {y || z, z || x, x || y};
    beside::SegmentBesideBox{}(w, place(s.a), place(s.b), place(box.min), place(box.max), across, told);
    return say(w, told, std::array{s.a, s.b}, box);
  }
  static bool say(auto& w, const TellGaps& told, const auto& points, const Aabb3& box) {
    const auto clear = [&](auto axis) {
      return std::ranges::any_of(points, [&](const Point3& p) { return p.*axis < box.max.*axis; }) &&
             std::ranges::any_of(points, [&](const Point3& p) { return box.min.*axis < p.*axis; });
    };
    const bool meets = told.meet && clear(&Point3::x) && clear(&Point3::y) && clear(&Point3::z);
    if (!told.apart && !meets) w.leave_open();
    return told.apart;
  }
};
std::string unnoticed_beside_box(const auto& drawn) {
  return mutants::unnoticed(
      [&](mutants::Draw& d) {
        return std::pair{drawn(d), d.box()};
      },
      [](const auto& input) { return mutants::told<mutants::World>(BesideBox{}, input.first, input.second); },
      [](const auto& input) { return relate(input.first, input.second) == Relation::disjoint; });
}
TEST(OverlapStatements, MutantsAreNoticed) {
  const auto segment = [](mutants::Draw& d) { return Segment3{d.point(), d.point()}; };
  const auto ray = [](mutants::Draw& d) { return Ray3{d.point(), d.vector()}; };
  const auto line = [](mutants::Draw& d) { return Line3{d.point(), d.vector()}; };
  const auto triangle = [](mutants::Draw& d) { return Triangle3{d.point(), d.point(), d.point()}; };
  mutants::expect_noticed("segment_ball", unnoticed_of(StraightAndBall<true, true>{}, segment));
  mutants::expect_noticed("ray_ball", unnoticed_of(StraightAndBall<true, false>{}, ray));
  mutants::expect_noticed("line_ball", unnoticed_of(StraightAndBall<false, false>{}, line));
  // Not noticed is what leaves more open: both of what is asked in the place of either, a height from the other end that
  // is a sum, a sum for the product of the axis' square, which is larger, and a shorter axis of lines.
  mutants::expect_noticed("segment_past_cylinder", unnoticed_past_cylinder<true, true>(segment), "28 76 97 106 107 ");
  mutants::expect_noticed("ray_past_cylinder", unnoticed_past_cylinder<true, false>(ray), "66 75 76 ");
  mutants::expect_noticed("line_past_cylinder", unnoticed_past_cylinder<false, false>(line),
                          mutants::by_compiler("9 10 61 62 ", "8 10 61 62 "));
  mutants::expect_noticed("segment_beside_box", unnoticed_beside_box(segment));
  mutants::expect_noticed("triangle_beside_box", unnoticed_beside_box(triangle));
}

TEST(OverlapStatements, VolumesFromAnyCornerAreOffByEightTimesAsMuch) {
  EXPECT_EQ(from_any_corner, 0x1.0000000300000p+3);
  double most = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 400; ++i) {
      Entropy entropy(27, i);
      const std::vector<Point3> p = points3(info.family, Degeneracy::coplanar, 4, entropy);
      const Difference u = difference(p[0], p[1]), v = difference(p[0], p[2]), w = difference(p[0], p[3]);
      const auto largest_of = [](double x, double y, double z) {
        return Pair{std::fmax(std::fabs(x), std::fabs(y)), std::fabs(z)};
      };
      const double error = from_any_corner * error_bound<Volume>(largest_of(u.x, v.x, w.x), largest_of(u.y, v.y, w.y),
                                                                 largest_of(u.z, v.z, w.z), 0);
      if (!(error < std::numeric_limits<double>::infinity())) continue;
      const auto volume = [&]<class N>(N) {
        const auto way = [&](std::size_t k) {
          const auto less = [](double x, double y) { return N(x) - N(y); };
          return predicates::Triple<N>{less(p[k].x, p[1].x), less(p[k].y, p[1].y), less(p[k].z, p[1].z)};
        };
        return predicates::dot(way(0), predicates::cross(way(2), way(3)));
      };
      const double computed = volume(0.0);
      if (!std::isfinite(computed)) continue;
      const Rational off = magnitude(Rational(computed) - volume(Rational(0.0)));
      EXPECT_FALSE(Rational(error) < off) << info.name << ", replay: " << i;
      if (off.sign() != Sign::zero) most = std::fmax(most, (off / Rational(error)).rounded());
    }
  }
  EXPECT_GE(most, 0.01) << "no case comes near to the bound";
  std::printf("volumes from other corners: off by up to %g of their bound\n", most);
}

// Every ninth is made to touch.
TEST(OverlapStatements, EveryWorldGivesTheRelationToBalls) {
  std::array by_floats{PromisedShare("segment_ball"), PromisedShare("ray_ball"), PromisedShare("line_ball")};
  std::array by_pairs{PromisedShare("segment_ball_pairs"), PromisedShare("ray_ball_pairs"),
                      PromisedShare("line_ball_pairs")};
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      Entropy entropy(23, i);
      std::array<double, 12> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Point3 p{x[0], x[1], x[2]}, q{x[3], x[4], x[5]};
      const Vector3 d{q.x, q.y, q.z};
      // Now and then a radius with which something surely touches along an axis.
      const double radius = entropy.below(3) == 0 ? std::fabs(x[0]) : std::fabs(x[9]);
      const Sphere3 ball{entropy.below(3) == 0 ? Point3{0, x[1], x[2]} : Point3{x[6], x[7], x[8]}, radius};
      if (radius == 0) continue;  // a point, of which touching is told otherwise
      const std::array told{ask_each(StraightAndBall<true, true>{}, p, q, ball),
                            ask_each(StraightAndBall<true, false>{}, p, d, ball),
                            ask_each(StraightAndBall<false, false>{}, p, d, ball)};
      const std::array truth{relate(Segment3{p, q}, ball), relate(Ray3{p, d}, ball), relate(Line3{p, d}, ball)};
      for (std::size_t k = 0; k < 3; ++k) {
        by_floats[k].add(info.family, told[k][0].has_value());
        by_pairs[k].add(info.family, told[k][1].has_value());
        for (const auto& t : told[k]) EXPECT_EQ(t.value_or(truth[k]), truth[k]) << info.name << k << ", replay: " << i;
        EXPECT_TRUE(told[k][3].has_value());
      }
    }
  }
}

/// Against exact numbers, which know nothing of what doubles tell at once.
TEST(OverlapStatements, WhatDoublesTellOfACylinderIsSo) {
  std::array<int, 3> disjoint{}, overlapping{}, left{};
  std::array shares{PromisedShare("segment_past_cylinder"), PromisedShare("ray_past_cylinder"),
                    PromisedShare("line_past_cylinder")};
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      Entropy entropy(31, i);
      std::array<double, 15> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Point3 p{x[0], x[1], x[2]}, q{x[3], x[4], x[5]};
      const Vector3 d{q.x, q.y, q.z};
      const Cylinder3 c{{x[6], x[7], x[8]}, {x[9], x[10], x[11]}, std::fabs(x[12])};
      if (c.a == c.b || c.radius == 0 || p == q || d == Vector3{0, 0, 0}) continue;
      const auto doubles = []<class Statement>(const Statement& statement, const auto&... input) {
        return certify::one_lane::told_by_worlds<FloatWorld<Statement>>(NoWorldRecorder{}, statement, input...);
      };
      const std::array told{doubles(PastCylinder<true, true>{}, p, q, c), doubles(PastCylinder<true, false>{}, p, d, c),
                            doubles(PastCylinder<false, false>{}, p, d, c)};
      const std::array truth{relate_exact_line(straight<Rational>(Segment3{p, q}), axis_of(c)),
                             relate_exact_line(straight<Rational>(Ray3{p, d}), axis_of(c)),
                             relate_exact_line(straight<Rational>(Line3{p, d}), axis_of(c))};
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(told[k].value_or(truth[k]), truth[k]) << info.name << k << ", replay: " << i;
        shares[k].add(info.family, told[k].has_value());
        (!told[k] ? left : *told[k] == Relation::disjoint ? disjoint : overlapping)[k] += 1;
      }
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    std::printf("of cylinders doubles tell %d disjoint, %d overlapping, and leave %d\n", disjoint[k], overlapping[k],
                left[k]);
    EXPECT_GE(std::min(disjoint[k], overlapping[k]), 300);
    EXPECT_GE(left[k], 50);
  }
}

}  // namespace
}  // namespace plumb::query
