// Which bounds were derived, and do doubles tell what is so?  Statements of rays, of one number at a time.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/golden_statements.hpp"
#include "certify/mutant_statements.hpp"
#include "certify/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/ray/box_passed.hpp"

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

TEST(RayStatements, WhatDoublesTellOfABoxIsSo) {
  for (const FamilyInfo& info : families) {
    int told = 0;
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
      told += apart || meets ? 1 : 0;
    }
    const bool is_plain = info.family == Family::uniform || info.family == Family::float32;
    EXPECT_GE(told, is_plain ? 395 : info.family == Family::extreme ? 0 : 150) << info.name;
  }
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
  EXPECT_EQ(mutants::unnoticed(
                line_and_box,
                [](const auto& input) { return mutants::told<mutants::World>(Hits{}, input.first, input.second); },
                [](const auto& input) { return hits(input.first, input.second); }),
            "6 7 8 ");  // from the direction nothing is taken away
}

}  // namespace
}  // namespace plumb::query
