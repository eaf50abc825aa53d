// Is the worked example of docs/add_a_decision.md decided exactly?  Each world against the other, the share that doubles
// answer, and mutants of the statement.
#include <gtest/gtest.h>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "docs/sees_box.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/judged_bounds.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::docs {
namespace {

using mine::SeesBox, mine::View;

/// The same by the nearest and farthest corner in the view's frame: the axis is that of z, and the box around it.
bool sees_centered(double half, double z, double numerator, double denominator) {
  const Rational x(half), at(z);
  return at.sign() != Sign::negative &&
         at * at * (Rational(denominator) - Rational(numerator)) >= Rational(numerator) * (x * x + x * x);
}

struct Case {
  View view;
  Aabb3 box;
};
Case drawn(Family family, std::uint64_t i) {
  Entropy entropy(18, i);
  std::array<double, 12> x{};
  fill_points(family, Degeneracy::coplanar, 3, x, entropy);
  const View view{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, static_cast<double>(i % 4), 4};
  return {view,
          {{std::min(x[6], x[9]), std::min(x[7], x[10]), std::min(x[8], x[11])},
           {std::max(x[6], x[9]), std::max(x[7], x[10]), std::max(x[8], x[11])}}};
}

TEST(OwnDecision, WorldsAgreeAndDoublesAnswerTheirShare) {
  PromisedShare share("sees_box");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      const auto [view, box] = drawn(info.family, i);
      RationalWorld exact;
      WorldCounts worlds;
      ASSERT_EQ(certainly_recorded(worlds, SeesBox{}, view, box), SeesBox{}(exact, view, box))
          << info.name << ", replay: " << i;
      share.add(info.family, worlds.last() == WorldKind::floats);
    }
  }
}

TEST(OwnDecision, SaysWhatTheFormulaOfACenteredBoxSays) {
  int seen = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Entropy e(19, i);
    const auto half = static_cast<double>(e.below(40)), z = static_cast<double>(e.within(40));
    const auto over = static_cast<double>(2 + e.below(6));
    const View view{{0, 0, 0}, {0, 0, 3}, 1, over};
    const bool sees = certainly(SeesBox{}, view, Aabb3{{-half, -half, z}, {half, half, z + 1}});
    ASSERT_EQ(sees, sees_centered(half, z, 1, over)) << "replay: " << i;
    seen += sees ? 1 : 0;
  }
  EXPECT_GT(seen, 50);
}

TEST(OwnDecision, MutantsAreNoticed) {
  struct Drawn {
    View view;
    Aabb3 box;
  };
  mutants::expect_noticed(
      "sees_box",
      mutants::unnoticed(
          [](mutants::Draw& d) {
            const Vector3 axis = d.number() > 0 ? Vector3{0, 0, d.positive()} : d.vector();
            return Drawn{{d.point(), axis, 4 * d.quarter(), 1 + d.positive()}, d.box()};
          },
          [](const Drawn& x) { return mutants::told<mutants::World>(SeesBox{}, x.view, x.box); },
          [](const Drawn& x) {
            // By the sizes of what is along the axis and across it, of each corner; of numbers that doubles hold.
            const auto [eye, axis, above, below] = x.view;
            for (int corner = 0; corner < 8; ++corner) {
              const Vector3 p{(corner & 1 ? x.box.max : x.box.min).x - eye.x,
                              (corner & 2 ? x.box.max : x.box.min).y - eye.y,
                              (corner & 4 ? x.box.max : x.box.min).z - eye.z};
              const Vector3 c{p.y * axis.z - p.z * axis.y, p.z * axis.x - p.x * axis.z, p.x * axis.y - p.y * axis.x};
              const double along = p.x * axis.x + p.y * axis.y + p.z * axis.z;
              const double across = c.x * c.x + c.y * c.y + c.z * c.z;  // the square of the cross product
              if (along < 0 || along * along * (below - above) < above * across) return false;
            }
            return true;
          }));
}

TEST(OwnDecision, BoundsAreProved) {
  const View view{{0, 0, 0}, {0, 0, 1}, 1, 2};
  const Aabb3 box{{-1, -1, 2}, {1, 1, 3}};
  const std::vector<std::string> scripts = judged_proofs("sees_box", SeesBox{}, view, box);
  EXPECT_EQ(scripts.size(), 2);
  const std::vector<std::string> bounds = judged_bounds(SeesBox{}, view, box);
  expect_golden("sees_box", bounds);
  expect_proved(bounds, scripts);
}

/// All that a statement of one scale may compute with.
struct Everything {
  static constexpr int highest = 8;
  template <class W>
  Sign operator()(W& w, const std::array<double, 5>& x) const {
    const auto a = w.difference(x[0], x[1]), c = w.difference(x[3], x[4]);
    const auto b = w.number(x[2]);
    const auto e = larger(magnitude(a), b) + twice(smaller(a, c));
    const auto f = negated(a * b) - c * c;
    return w.sign(e * e * f - select(w.sign(b) == Sign::positive, a, c) * (a + c) * f);
  }
};
std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? "nowhere: " + what : text.replace(at, what.size(), by);
}
TEST(OwnDecision, WhatIsNotSoIsNotProved) {
  for (std::uint64_t i = 0; i < 3; ++i) {
    Entropy e(22, i);
    std::array<double, 5> x{};
    for (double& one : x) one = static_cast<double>(e.within(9));
    const std::vector<std::string> bounds = judged_bounds(Everything{}, x),
                                   scripts = judged_proofs("", Everything{}, x);
    expect_proved(bounds, scripts);
    if (!gappa::is_installed() || battery::sanitized) return;
    const std::string& script = scripts.back();
    EXPECT_FALSE(gappa::refuses(script)) << script;
    EXPECT_TRUE(gappa::refuses(replaced(script, "ieee_64", "ieee_32"))) << script;
    EXPECT_TRUE(gappa::refuses(replaced(script, "| <= 1", "| <= 8"))) << script;
  }
}

TEST(OwnDecision, RefusesWhatIsNoNumber) {
  const View view{{0, 0, 0}, {0, 0, 1}, 1, 2};
  EXPECT_THROW(certainly(SeesBox{}, view, Aabb3{{std::numeric_limits<double>::quiet_NaN(), 0, 5}, {3, 4, 9}}),
               NonFinite);
}

}  // namespace
}  // namespace plumb::docs
