// Boxes under rigid poses: is their contact the exact one, each number rounded once, where they are turned about one axis and
// rest, hover and sink, where they lie anyhow, and beside what has another pose?
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/contact/rounded_contact.hpp"
#include "query/penetration/box_axes.hpp"
#include "query/penetration/near_axes.hpp"

namespace plumb {
namespace {

using TurnedBody = Posed<Aabb3, RigidPose>;

/// Multiples of 2^-25, of a few bits or of all.
Rotation drawn_turn(Entropy& e) {
  const auto few = [&] { return 0.25 * static_cast<double>(e.within(4)); };
  const auto many = [&] { return 0x1p-25 * static_cast<double>(e.bits(26)) - 1; };
  switch (e.below(5)) {
    case 0:
      return {1, 0, 0, few()};
    case 1:
      return {1, few(), 0, 0};
    case 2:
      return {1, few(), few(), few()};
    case 3:
      return {1, 0, many(), 0};
    default:
      return {1, many(), many(), many()};
  }
}
double drawn_length(Entropy& e) { return e.below(30) == 0 ? 0.0 : 0.25 * static_cast<double>(1 + e.below(4)); }
TurnedBody drawn_turned(Entropy& e) {
  const auto number = [&] {
    return e.below(3) == 0 ? 0x1p-52 * static_cast<double>(e.bits(53)) - 1 : 0.5 * static_cast<double>(e.within(2));
  };
  const Point3 low{-drawn_length(e), -drawn_length(e), e.coin() ? 0 : -drawn_length(e)};
  return {{low, {drawn_length(e), drawn_length(e), drawn_length(e)}}, {drawn_turn(e), {number(), number(), number()}}};
}
/// On b's upper face, or a bit above or in it; both are turned about the axis that leads up.
void stand_on(TurnedBody& a, TurnedBody& b, Entropy& e) {
  b.pose.turn = {1, 0, 0, 0.125 * static_cast<double>(e.within(8))};
  a.pose.turn = e.below(3) == 0 ? b.pose.turn : Rotation{1, 0, 0, 0.125 * static_cast<double>(e.within(8))};
  a.pose.translation = b.pose.translation;
  a.pose.translation.x += 0.25 * static_cast<double>(e.within(2));
  a.pose.translation.z += b.shape.max.z - a.shape.min.z;
  const int shift = static_cast<int>(e.below(4));
  if (shift == 1) a.pose.translation.z += 0x1p-50 * static_cast<double>(e.within(2));
  if (shift == 2) a.pose.translation.z += 0.0625 * static_cast<double>(e.within(1));
}

TEST(PosedBoxContact, IsTheExactOneRounded) {
  std::array<int, 3> seen{};
  int none = 0, asked = 0;
  for (std::uint64_t run = 0; run < (battery::sanitized ? 100U : 1500U); ++run) {
    const std::string replay = "replay: Entropy(4600, " + std::to_string(run) + ")";
    Entropy e(4600, run);
    TurnedBody a = drawn_turned(e), b = drawn_turned(e);
    const bool does_stand = e.below(3) != 0;
    if (does_stand) stand_on(a, b, e);
    const double margin = std::array{0.0, 0.25, 0.5}[e.below(3)];
    // The second as it is, as a box of given axes under its pose, or as one that stands.
    const std::size_t form = e.below(4);
    const Aabb3& s = b.shape;
    const Vector3 half{(s.max.x - s.min.x) / 2, (s.max.y - s.min.y) / 2, (s.max.z - s.min.z) / 2};
    const Obb3 oriented{{s.min.x + half.x, s.min.y + half.y, s.min.z + half.z},
                        {Vector3{0, 1, 0}, Vector3{-1, 0, 0}, Vector3{0, 0, 1}},
                        {half.y, half.x, half.z}};
    const AnyFigure first = a;
    const AnyFigure second = form == 0   ? AnyFigure(b)
                             : form == 1 ? AnyFigure(Posed{oriented, b.pose})
                             : form == 2 ? AnyFigure(oriented)
                                         : AnyFigure(s);
    ++asked;
    ContactCache cache;
    const auto m = contact(first, second, {.margin = margin}, &cache);
    const auto exact = exact_contact(first, second, margin);
    ASSERT_EQ(m.has_value(), exact.has_value()) << replay;
    EXPECT_EQ(contact(first, second, {.margin = margin}, &cache), m) << replay;
    if (!exact) {
      ++none;
      continue;
    }
    expect_rounded(*m, *exact, replay);
    ++seen[static_cast<std::size_t>(static_cast<int>(m->relation) + 1)];
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("of %d asked %d none, %d apart, %d touching, %d overlapping\n", asked, none, seen[0], seen[1], seen[2]);
  for (const int n : {none, seen[0], seen[1], seen[2]}) EXPECT_GT(n * 30, asked);
}

/// What doubles and pairs of them tell of the axes of two boxes is what rational numbers tell.
TEST(PosedBoxContact, AxesAreThoseOfRationalNumbers) {
  using query::PosedBox, query::parting::NearAxes, query::parting::NearAxesOf;
  int several = 0, certain = 0, by_lanes = 0, asked = 0;
  for (std::uint64_t run = 0; run < (battery::sanitized ? 30U : 300U); ++run) {
    Entropy e(4601, run);
    TurnedBody a = drawn_turned(e), b = drawn_turned(e);
    if (e.coin()) stand_on(a, b, e);
    auto p = query::CoreCorners::of(query::body_view(a)), q = query::CoreCorners::of(query::body_view(b));
    bring_to_one_weight(*p, *q);
    const auto first = p->posed_box(), second = q->posed_box();
    ASSERT_TRUE(first && second) << run;
    std::vector<NearAxes::Pair> pairs;
    for (std::uint32_t i = 0; i < 6; ++i) {
      for (std::uint32_t j = i + 1; j < 6; ++j) pairs.push_back({i, j});
    }
    const auto picked = static_cast<std::uint32_t>(e.below(15));
    const auto pick = [&](const auto&, const auto&) { return picked; };
    FloatWorld<NearAxesOf<PosedBox>> floats;
    RationalWorld rationals;
    const auto told = NearAxesOf<PosedBox>{}(floats, *first, *second, pairs, pick);
    const auto exact = NearAxesOf<PosedBox>{}(rationals, *first, *second, pairs, pick);
    ASSERT_TRUE(floats.certain()) << run;
    EXPECT_EQ(told.near & exact.near, exact.near) << run;
    several += told.near != exact.near ? 1 : 0;
    const auto expect_sign = [&](Sign s, Sign of_exact) {
      EXPECT_TRUE(s == Sign::zero || s == of_exact) << run;
      ++asked, certain += s == of_exact ? 1 : 0;
    };
    expect_sign(told.overlap, exact.overlap), expect_sign(told.middle, exact.middle);
    for (std::size_t k = 0; k < 6; ++k) expect_sign(told.along[k], exact.along[k]);
    // The picked one alone, so that it is the least.
    const auto fine = query::parting::near_axis_signs(*first, *second, std::span(pairs).subspan(picked, 1));
    const auto expect_fine = [&](Sign s, Sign of_exact) {
      EXPECT_TRUE(s == Sign::zero || s == of_exact) << run;
      by_lanes += s != Sign::zero ? 1 : 0;
    };
    expect_fine(fine.overlap, exact.overlap), expect_fine(fine.middle, exact.middle);
    for (std::size_t k = 0; k < 6; ++k) {
      if (k != pairs[picked][0] && k != pairs[picked][1]) expect_fine(fine.along[k], exact.along[k]);
    }
  }
  std::printf("of 300 pairs %d leave more axes than there are; %d of %d signs are told, by lanes %d\n", several,
              certain, asked, by_lanes);
  EXPECT_GT(certain * 10, 9 * asked);
}

}  // namespace
}  // namespace plumb
