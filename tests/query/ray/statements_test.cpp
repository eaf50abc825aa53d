// Which bounds were derived, and do doubles tell what is so?  Statements of rays, of one number at a time.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/ray/batch_lanes.hpp"
#include "query/ray/box_passed.hpp"
#include "query/ray/triangle_passed.hpp"

namespace plumb::query {
namespace {

using Passed = box_passed::HWY_NAMESPACE::BoxPassed;
/// Of a line: is it told to be apart, to meet?
struct OfLine {
  static constexpr int highest = Passed::highest;
  static constexpr Scales scales = Passed::scales;
  std::pair<bool, bool> operator()(auto& world, const Line3& l, const Aabb3& box) const {
    const BoxBatchRay ray{
        {l.point.x, l.point.y, l.point.z}, {l.direction.x, l.direction.y, l.direction.z}, {}, {}, false, false};
    const double min[3] = {box.min.x, box.min.y, box.min.z}, max[3] = {box.max.x, box.max.y, box.max.z};
    bool apart = false, meets = true;
    Passed{}(world, ray, min, max, apart, meets);
    return {apart, meets};
  }
};
std::pair<bool, bool> passed(const Line3& l, const Aabb3& box) {
  FloatWorld<OfLine> world;
  const auto [apart, meets] = OfLine{}(world, l, box);
  return {apart && world.in_range(), meets && world.in_range()};
}

TEST(RayStatements, DerivedBoundsAreAsRecordedAndProved) {
  const Line3 line{{-1, 0.25, 0.5}, {1, 0.5, 0.25}};
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  const std::vector<std::string> bounds = judged_bounds(OfLine{}, line, box);
  expect_golden("box_passed", bounds);
  expect_proved(bounds, judged_proofs("box_passed", OfLine{}, line, box));
}

using AtTriangle = triangle_passed::HWY_NAMESPACE::TrianglePassed;
template <class Listener = NoBoundListener>
using TriangleWorld = certify::one_lane::Floats<double, AtTriangle::highest, AtTriangle::scales, Listener>;

/// A number that a statement judges: what was computed, how far it may be off, and how its sign was judged.
struct Judged {
  double value, reach;
  bool positive, negative;
};
struct SegmentAtTriangle {
  Judged least, most, sum, height, beyond_end;
  bool in_range;
};

template <class Listener = NoBoundListener>
SegmentAtTriangle judged(const Segment3& s, const Triangle3& t) {
  TriangleWorld<Listener> world;
  const auto judge = [&](const auto& x) -> Judged {
    using Number = std::remove_cvref_t<decltype(x)>;
    return {x.value, world.template reach<Number::track>(), world.positive(x), world.negative(x)};
  };
  const Vector3 direction{s.b.x - s.a.x, s.b.y - s.a.y, s.b.z - s.a.z};
  const auto seen = AtTriangle::seen(world, s.a, t.a, t.b, t.c);
  const auto sides = AtTriangle::sides(world, direction, seen);
  const auto height = seen.height();
  return {judge(sides.least),
          judge(sides.most),
          judge(sides.sum),
          judge(height),
          judge(AtTriangle::beyond_end(height, sides.sum)),
          world.in_range() && world.is_real(sides.sum)};
}

/// The same numbers exactly: three times three determinants.
std::array<Rational, 5> exactly(const Segment3& s, const Triangle3& t) {
  using Row = std::array<Rational, 3>;
  const auto row = [&](const Point3& to) -> Row {
    const auto less = [](double x, double y) { return Rational(x) - Rational(y); };
    return {less(to.x, s.a.x), less(to.y, s.a.y), less(to.z, s.a.z)};
  };
  const auto volume = [](const Row& u, const Row& v, const Row& w) {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  };
  const Row d = row(s.b), a = row(t.a), b = row(t.b), c = row(t.c);
  const Rational ab = volume(d, b, a), bc = volume(d, c, b), ca = volume(d, a, c), sum = ab + bc + ca,
                 height = volume(a, c, b);
  return {smaller(smaller(ab, bc), ca), larger(larger(ab, bc), ca), sum, height, height - sum};
}

/// The height, in which no direction has a part.
struct HeightOfTriangle {
  static constexpr int highest = AtTriangle::highest;
  static constexpr Scales scales{.count = 4, .maxima = 0b1110};
  Sign operator()(auto& world, const Point3& origin, const Triangle3& t) const {
    return world.sign(AtTriangle::seen(world, origin, t.a, t.b, t.c).height());
  }
};
TEST(RayStatements, TheBoundOfAHeightIsProved) {
  const Triangle3 t{{0, 0, 0}, {1, 1, 1}, {1, 2, 4}};
  const std::vector<std::string> bounds = judged_bounds(HeightOfTriangle{}, Point3{-1, 0.25, 0.5}, t);
  ASSERT_EQ(bounds.size(), 1);
  std::ifstream file(PLUMB_SOURCE_DIR "/tests/certify/statements/golden_statements.txt");
  const std::string recorded{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(recorded.find("triangle_passed " + bounds[0] + '\n'), std::string::npos) << bounds[0];
  expect_proved(bounds, judged_proofs("height", HeightOfTriangle{}, Point3{-1, 0.25, 0.5}, t));
}

TEST(RayStatements, DerivedBoundsAtATriangleAreAsRecorded) {
  BoundListener::taken();
  judged<BoundListener>({{-1, 0.25, 0.5}, {1, 0.5, 0.25}}, {{0, 0, 0}, {1, 1, 1}, {1, 2, 4}});
  expect_golden("triangle_passed");
}

TEST(RayStatements, NumbersOfATriangleAreAsNearAsTheyAreSaidToBe) {
  PromisedShare share("triangle_passed");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      Entropy entropy(25, i);
      std::array<double, 15> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Segment3 s{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
      const Triangle3 t{{x[6], x[7], x[8]}, {x[9], x[10], x[11]}, {x[12], x[13], x[14]}};
      const SegmentAtTriangle found = judged(s, t);
      if (!found.in_range) share.add(info.family, 0, 5);
      if (!found.in_range) continue;
      const std::array<Rational, 5> exact = exactly(s, t);
      const Judged* const all[5] = {&found.least, &found.most, &found.sum, &found.height, &found.beyond_end};
      for (std::size_t k = 0; k < 5; ++k) {
        const Rational off = magnitude(Rational(all[k]->value) - exact[k]);
        EXPECT_FALSE(Rational(all[k]->reach) < off) << info.name << ", number " << k << ", replay: " << i;
        EXPECT_FALSE(all[k]->positive && exact[k].sign() != Sign::positive) << info.name << ", replay: " << i;
        EXPECT_FALSE(all[k]->negative && exact[k].sign() != Sign::negative) << info.name << ", replay: " << i;
        share.add(info.family, all[k]->positive || all[k]->negative);
      }
    }
  }
}

TEST(RayStatements, LanesTellOfATriangleWhatIsSoAndWhereItIsHit) {
  for (const FamilyInfo& info : families) {
    int told = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
      Entropy entropy(26, i);
      std::array<double, 30> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Segment3 s{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
      std::array<std::array<double, 8>, 9> numbers{};
      std::array<const double*, 9> at{};
      for (std::size_t k = 0; k < 9; ++k) {
        for (std::size_t j = 0; j < 8; ++j) numbers[k][j] = x[6 + (k + 3 * (j % 6)) % 24];
        at[k] = numbers[k].data();
      }
      std::array<std::uint8_t, 8> answers{};
      std::array<double, 8> least{}, most{};
      if (s.a == s.b) continue;
      ask_lanes(batch_ray(s), at.data(), 8, {answers.data(), least.data(), most.data()});
      for (std::size_t j = 0; j < 8; ++j) {
        const auto corner = [&](std::size_t k) { return Point3{numbers[k][j], numbers[k + 1][j], numbers[k + 2][j]}; };
        const Triangle3 t{corner(0), corner(3), corner(6)};
        const bool truth = hits(s, t);
        told += answers[j] != 2 ? 1 : 0;
        EXPECT_TRUE(answers[j] == 2 || (answers[j] == 1) == truth) << info.name << ", replay: " << i;
        const std::array<Rational, 5> exact = exactly(s, t);
        if (!truth || exact[2].sign() == Sign::zero) continue;
        const Rational time = exact[3] / exact[2];
        const double infinity = std::numeric_limits<double>::infinity();
        EXPECT_FALSE(least[j] > -infinity && time < Rational(least[j])) << info.name << ", replay: " << i;
        EXPECT_FALSE(most[j] < infinity && Rational(most[j]) < time) << info.name << ", replay: " << i;
      }
    }
    const bool is_plain = info.family == Family::uniform || info.family == Family::float32;
    EXPECT_GE(told, is_plain ? 450 : 0) << info.name;
  }
}

TEST(RayStatements, NothingIsToldOfATriangleWithoutNumbers) {
  const double none = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double x : {none, infinity, -infinity, 1e300}) {
    for (std::size_t k = 0; k < 15; ++k) {
      std::array<double, 15> all{0, 0, 0, 0, 0, 5, 1, 1, 2, -3, 1, 2, 1, -4, 2};
      all[k] = x;
      EXPECT_FALSE(judged({{all[0], all[1], all[2]}, {all[3], all[4], all[5]}},
                          {{all[6], all[7], all[8]}, {all[9], all[10], all[11]}, {all[12], all[13], all[14]}})
                       .in_range)
          << x << ' ' << k;
    }
  }
}

TEST(RayStatements, WhatDoublesTellOfABoxIsSo) {
  PromisedShare share("box_passed");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 400; ++i) {
      Entropy entropy(24, i);
      std::array<double, 12> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Line3 line{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
      if (x[3] == 0 && x[4] == 0 && x[5] == 0) continue;
      const Aabb3 box{{std::fmin(x[6], x[9]), std::fmin(x[7], x[10]), std::fmin(x[8], x[11])},
                      {std::fmax(x[6], x[9]), std::fmax(x[7], x[10]), std::fmax(x[8], x[11])}};
      const auto [apart, meets] = passed(line, box);
      const bool truth = hits(line, box);
      EXPECT_FALSE(apart && truth) << info.name << ", replay: " << i;
      EXPECT_FALSE(meets && !truth) << info.name << ", replay: " << i;
      share.add(info.family, apart || meets);
    }
  }
}

/// Numbers across the axes, of which mutants are made like others.
struct MutantsOfTriangles : mutants::World {
  using Number = mutants::Number;
  template <std::size_t>
  static Number crosswise(double b, double a) {
    return Number(b) - Number(a);
  }
  static Number sum_crosswise(const Number& x, const Number& a, const Number& y, const Number& b, const Number& z,
                              const Number& c) {
    return x * a + y * b + z * c;
  }
};
TEST(RayStatements, MutantsOfATriangleAreNoticed) {
  struct Drawn {
    Point3 from, a, b, c;
    Vector3 way;
  };
  const auto volume = [](const Vector3& u, const Vector3& v, const Vector3& w) {
    return u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) + u.z * (v.x * w.y - v.y * w.x);
  };
  const auto sign = [](double x) { return static_cast<Sign>((x > 0) - (x < 0)); };
  mutants::expect_noticed(
      "triangle_passed",
      mutants::unnoticed(
          [](mutants::Draw& d) {
            return Drawn{d.point(), d.point(), d.point(), d.point(), d.vector()};
          },
          [](const Drawn& x) {
            MutantsOfTriangles w;
            const auto seen = AtTriangle::seen(w, x.from, x.a, x.b, x.c);
            const auto sides = AtTriangle::sides(w, x.way, seen);
            const auto height = seen.height();
            return std::optional(std::array{sides.least.sign(), sides.most.sign(), sides.sum.sign(), height.sign(),
                                            AtTriangle::beyond_end(height, sides.sum).sign()});
          },
          [&](const Drawn& x) {
            const auto row = [&](const Point3& p) { return Vector3{p.x - x.from.x, p.y - x.from.y, p.z - x.from.z}; };
            const Vector3 a = row(x.a), b = row(x.b), c = row(x.c);
            const double ab = volume(x.way, b, a), bc = volume(x.way, c, b), ca = volume(x.way, a, c);
            const double sum = ab + bc + ca, height = volume(a, c, b);
            return std::array{sign(std::fmin(std::fmin(ab, bc), ca)), sign(std::fmax(std::fmax(ab, bc), ca)), sign(sum),
                              sign(height), sign(height - sum)};
          }),
      "36 37 38 ");  // from the direction nothing is taken away
}

/// Does it meet the box?
struct Hits : OfLine {
  bool operator()(auto& world, const Line3& line, const Aabb3& box) const {
    const auto [apart, meets] = OfLine::operator()(world, line, box);
    if (!apart && !meets) world.leave_open();
    return !apart;
  }
};
TEST(RayStatements, MutantsAreNoticed) {
  const auto line_and_box = [](mutants::Draw& d) {
    const Vector3 v = d.vector();
    return std::pair{Line3{d.point(), v == Vector3{} ? Vector3{1, 0, 0} : v}, d.box()};
  };
  mutants::expect_noticed(
      "box_passed",
      mutants::unnoticed(
          line_and_box,
          [](const auto& input) { return mutants::told<mutants::World>(Hits{}, input.first, input.second); },
          [](const auto& input) { return hits(input.first, input.second); }),
      "6 7 8 ");  // from the direction nothing is taken away
}

}  // namespace
}  // namespace plumb::query
