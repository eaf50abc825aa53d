// Is a turn's matrix that of real arithmetic, each number rounded once?  Against products q v q^-1 in rational numbers.
#include "plumb/figure/basic/quaternion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plumb/arith/rational.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure/basic/rounded_poses.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using Four = std::array<Rational, 4>;

Four exact(const Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

/// By the table of i, j and k: the unit of two, and its sign.
Four product(const Four& p, const Four& q) {
  constexpr std::array<std::array<int, 4>, 4> unit{{{1, 2, 3, 4}, {2, -1, 4, -3}, {3, -4, -1, 2}, {4, 3, -2, -1}}};
  Four made{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const int u = unit[i][j];
      auto& to = made[static_cast<std::size_t>(std::abs(u) - 1)];
      to = u > 0 ? to + p[i] * q[j] : to - p[i] * q[j];
    }
  }
  return made;
}

/// q v q^-1.
Four turned(const Four& q, const std::array<Rational, 3>& v) {
  const Rational square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  Four made = product(product(q, {0, v[0], v[1], v[2]}), {q[0], -q[1], -q[2], -q[3]});
  for (Rational& x : made) x = x / square;
  return made;
}

bool held(const Rational& x) { return std::isfinite(x.rounded()) && Rational(x.rounded()) == x; }

void expect_rounded(double made, const Rational& wanted, const std::string& about) {
  EXPECT_EQ(made, wanted.rounded()) << about;
  EXPECT_FALSE(made == 0 && std::signbit(made)) << about;
}

Quaternion drawn(Entropy& entropy) {
  const auto kind = static_cast<CoordinateClass>(entropy.below(coordinate_class_count));
  const bool small = entropy.coin();
  const auto number = [&] {
    return small ? 1.0 * static_cast<int>(entropy.below(5)) - 2 : coordinate_of(kind, entropy);
  };
  const double w = number(), x = number(), y = number(), z = number();
  return {w, x, y, z};
}

TEST(Quaternion, NumbersAreTheExactOnesRoundedOnce) {
  int kept_turns = 0, lost_turns = 0, kept_products = 0, beyond = 0, nothing = 0;
  for (std::uint64_t index = 0; index < 800; ++index) {
    Entropy entropy(821, index);
    const std::string about = "start 821 index " + std::to_string(index);
    const Quaternion p = drawn(entropy), q = drawn(entropy);
    const Four pq = product(exact(p), exact(q));
    bool all_held = true, in_doubles = true;
    for (const Rational& x : pq) all_held = all_held && held(x), in_doubles = in_doubles && std::isfinite(x.rounded());
    if (in_doubles) {
      const Quaternion made = rounded_product(p, q);
      const std::array<double, 4> numbers{made.w, made.x, made.y, made.z};
      for (std::size_t i = 0; i < 4; ++i) expect_rounded(numbers[i], pq[i], about);
      EXPECT_EQ(exact_product(p, q), all_held ? std::optional(made) : std::nullopt) << about;
    } else {
      ++beyond;
      EXPECT_THROW((void)rounded_product(p, q), BeyondDoubles) << about;
      EXPECT_FALSE(exact_product(p, q)) << about;
    }
    kept_products += all_held ? 1 : 0;

    const auto pose = rounded_turn(q);
    ASSERT_EQ(pose.has_value(), q != Quaternion{}) << about;
    if (!pose) {
      ++nothing;
      EXPECT_FALSE(exact_turn(q) || rounded_turned(q, Vector3{1, 2, 3})) << about;
      continue;
    }
    bool whole = true;
    for (std::size_t j = 0; j < 3; ++j) {
      std::array<Rational, 3> unit{};
      unit[j] = 1;
      const Four column = turned(exact(q), unit);
      EXPECT_EQ(column[0], Rational(0)) << about;
      const Vector3& made = pose->columns[j];
      const std::array<double, 3> numbers{made.x, made.y, made.z};
      for (std::size_t i = 0; i < 3; ++i) {
        expect_rounded(numbers[i], column[i + 1], about);
        whole = whole && held(column[i + 1]);
      }
    }
    EXPECT_EQ(exact_turn(q), whole ? pose : std::nullopt) << about;
    if (whole) {
      EXPECT_TRUE(keeps_lengths(*pose)) << about;
      EXPECT_EQ(handedness(*pose), Sign::positive) << about;
    }
    (whole ? kept_turns : lost_turns) += 1;

    const Vector3 v{p.x, p.y, p.z};
    const Four there = turned(exact(q), {v.x, v.y, v.z});
    if (std::isfinite(there[1].rounded()) && std::isfinite(there[2].rounded()) && std::isfinite(there[3].rounded())) {
      const auto made = rounded_turned(q, v);
      ASSERT_TRUE(made) << about;
      expect_rounded(made->x, there[1], about);
      expect_rounded(made->y, there[2], about);
      expect_rounded(made->z, there[3], about);
    }
    EXPECT_TRUE(same_turn(q, {-q.w, -q.x, -q.y, -q.z})) << about;
    bool parallel_fours = rounded_turn(p).has_value();
    for (std::size_t i = 0; i < 16; ++i) {
      const Four a = exact(p), b = exact(q);
      parallel_fours = parallel_fours && a[i % 4] * b[i / 4] == a[i / 4] * b[i % 4];
    }
    EXPECT_EQ(same_turn(p, q), parallel_fours) << about;
  }
  EXPECT_GT(kept_turns, 40);
  EXPECT_GT(lost_turns, 300);
  EXPECT_GT(kept_products, 100);
  EXPECT_GT(beyond, 10);
  EXPECT_GE(nothing, 1);
}

TEST(Quaternion, Laws) {
  const Pose quarter{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {0, 0, 0}};
  EXPECT_EQ(exact_turn({1, 0, 0, 1}), quarter);
  // Multiples as far as doubles go, whose squares are beyond them.
  for (const double f : {-3.0, 0x1p1000, -0x1p-1074}) {
    EXPECT_EQ(exact_turn({f, 0, 0, f}), quarter);
    EXPECT_TRUE(same_turn({f, 0, 0, f}, {1, 0, 0, 1}));
  }
  EXPECT_FALSE(same_turn({1, 0, 0, 1}, {1, 0, 0, std::nextafter(1.0, 2)}));
  EXPECT_TRUE(same_turn({}, {}));
  EXPECT_FALSE(same_turn({}, {1, 0, 0, 0}));
  EXPECT_EQ(exact_product({0, 1, 0, 0}, {0, 0, 1, 0}), (Quaternion{0, 0, 0, 1}));
  EXPECT_EQ(exact_product({1, 2, 3, 4}, conjugate({1, 2, 3, 4})), (Quaternion{30, 0, 0, 0}));
  EXPECT_EQ(rounded_length({1, 1, 1, 1}), 2);
  // First the right factor: a quarter about x takes z to -y, a quarter about z that to x.
  EXPECT_EQ(rounded_turned(*exact_product({1, 0, 0, 1}, {1, 1, 0, 0}), Vector3{0, 0, 1}), (Vector3{1, 0, 0}));
}

TEST(Quaternion, NamesWhatIsNoNumberAndWhatIsNoDouble) {
  EXPECT_THAT(
      [] {
        (void)rounded_turn({1, 0, std::nan(""), 0});
      },
      ThrowsMessage<NonFinite>(HasSubstr("rounded_turn: q.y is nan")));
  EXPECT_THAT(
      [] {
        (void)rounded_product({1, 0, 0, 0}, {INFINITY, 0, 0, 0});
      },
      ThrowsMessage<NonFinite>(HasSubstr("rounded_product: q.w is inf")));
  const double largest = std::numeric_limits<double>::max();
  EXPECT_THAT(
      [&] {
        (void)rounded_turned({1, 0, 0, 0.5}, Vector3{largest, largest, 0});
      },
      ThrowsMessage<BeyondDoubles>(HasSubstr("rounded_turned: a number of the image is beyond all doubles")));
}

}  // namespace
}  // namespace plumb
