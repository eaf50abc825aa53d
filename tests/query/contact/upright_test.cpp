// Boxes that are not turned: is their contact the exact one, each number rounded once, as they rest, hover, overlap and
// stand flush?
#include "query/contact/upright.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "query/contact/rounded_contact.hpp"

namespace plumb {
namespace {

using UprightBody = Posed<Aabb3, RigidPose>;

double drawn_number(Entropy& e, bool is_long) {
  return is_long ? 4 * 0x1p-53 * static_cast<double>(e.bits(53)) - 2 : 0.5 * static_cast<double>(e.within(3));
}
UprightBody drawn_upright(Entropy& e) {
  const bool is_long = e.below(3) == 0, is_far = e.coin();
  const auto number = [&] { return drawn_number(e, is_long); };
  const Point3 low{number(), number(), number()};
  const auto size = [&] { return e.below(20) == 0 ? 0.0 : 0.5 * static_cast<double>(1 + e.below(4)); };
  // Half of them are moved by what no double holds with their corners.
  const auto by = [&] { return is_far ? 0.1 * static_cast<double>(e.within(9)) : number(); };
  return {{low, {low.x + size(), low.y + size(), low.z + size()}}, RigidPose{{2, 0, 0, 0}, {by(), by(), by()}}};
}
/// b onto a face of a, aside by little.
void put_on(const UprightBody& a, UprightBody& b, Entropy& e) {
  b.pose.translation = a.pose.translation;
  std::array<double*, 3> by{&b.pose.translation.x, &b.pose.translation.y, &b.pose.translation.z};
  const std::array high{a.shape.max.x - b.shape.min.x, a.shape.max.y - b.shape.min.y, a.shape.max.z - b.shape.min.z};
  const std::size_t k = e.below(3);
  *by[k] += high[k];
  *by[(k + 1) % 3] += 0.25 * static_cast<double>(e.within(2));
  if (e.below(4) == 0) *by[k] += 0x1p-50 * static_cast<double>(e.within(1));
}

TEST(UprightContact, IsTheExactOneRounded) {
  std::array<int, 3> seen{};
  int known = 0, none = 0, asked = 0;
  for (std::uint64_t run = 0; run < (battery::sanitized ? 200U : 3000U); ++run) {
    const std::string replay = "replay: Entropy(4400, " + std::to_string(run) + ")";
    Entropy e(4400, run);
    const UprightBody a = drawn_upright(e);
    UprightBody b = drawn_upright(e);
    if (e.coin()) put_on(a, b, e);
    const double margin = std::array{0.0, 0.25, 0.5}[e.below(3)];
    const query::touching::UprightContact told =
        query::touching::upright_contact(query::body_view(a), query::body_view(b), margin);
    ++asked;
    if (!told.is_known) continue;
    ++known;
    const auto exact = exact_contact(a, b, margin);
    ASSERT_EQ(told.manifold.has_value(), exact.has_value()) << replay;
    if (!exact) {
      ++none;
      continue;
    }
    expect_rounded(*told.manifold, *exact, replay);
    EXPECT_EQ(contact(a, b, {.margin = margin}), told.manifold) << replay;
    const auto widest = contact(a, b, {.margin = margin, .at_most = 2});
    EXPECT_EQ(widest->corners.size(), 2U) << replay;
    ++seen[static_cast<std::size_t>(static_cast<int>(told.manifold->relation) + 1)];
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("%d of %d known: %d none, %d apart, %d touching, %d overlapping\n", known, asked, none, seen[0], seen[1],
              seen[2]);
  EXPECT_GT(known * 3, asked);
  for (const int n : {none, seen[0], seen[1], seen[2]}) EXPECT_GT(n * 40, asked);
}

TEST(UprightContact, LeavesWhatIsTurnedFlatOrNoNumber) {
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  const auto is_known = [&](const auto& a) {
    return query::touching::upright_contact(query::body_view(a), query::body_view(box), 0).is_known;
  };
  const double nan = __builtin_nan("");
  EXPECT_TRUE(is_known(Aabb3{{0, 0, 1}, {1, 1, 2}}));
  EXPECT_TRUE(is_known(Posed{box, RigidPose{{-3, 0, 0, 0}, {0, 0.5, 1}}}));
  EXPECT_FALSE(is_known(Aabb3{{0, 0, 1}, {1, 1, 1}}));
  EXPECT_FALSE(is_known(Posed{box, RigidPose{{1, 0, 0, 1}, {0, 0, 1}}}));
  EXPECT_FALSE(is_known(Posed{box, RigidPose{{0, 0, 0, 0}, {0, 0, 1}}}));
  EXPECT_FALSE(is_known(Posed{box, RigidPose{{nan, 0, 0, 0}, {0, 0, 1}}}));
  EXPECT_FALSE(is_known(Posed{box, RigidPose{{}, {0, 0, nan}}}));
  EXPECT_FALSE(is_known(Sphere3{{0, 0, 2}, 1}));
  EXPECT_FALSE(is_known(box));  // as deep along every axis
  EXPECT_THROW(static_cast<void>(contact(Posed{box, RigidPose{{}, {0, 0, nan}}}, box)), NonFinite);
}

}  // namespace
}  // namespace plumb
