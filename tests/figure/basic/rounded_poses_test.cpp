// Is each number of an image, a composition, an inverse the exact one, rounded once?  Against rational numbers.
#include "plumb/figure/basic/rounded_poses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plumb/arith/rational.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using Column = std::array<Rational, 3>;
using Columns = std::array<Column, 4>;  // the last is the translation

constexpr double largest = std::numeric_limits<double>::max();

Column exact(const Vector3& v) { return {v.x, v.y, v.z}; }
Columns exact(const Pose& p) {
  return {exact(p.columns[0]), exact(p.columns[1]), exact(p.columns[2]), exact(p.translation)};
}

Column image(const Columns& m, const Column& x, bool moved) {
  Column y{};
  for (std::size_t i = 0; i < 3; ++i) {
    y[i] = m[0][i] * x[0] + m[1][i] * x[1] + m[2][i] * x[2] + (moved ? m[3][i] : Rational(0));
  }
  return y;
}

Columns product(const Columns& outer, const Columns& inner) {
  return {image(outer, inner[0], false), image(outer, inner[1], false), image(outer, inner[2], false),
          image(outer, inner[3], true)};
}

/// By Gauss and Jordan; nothing for a singular matrix.
std::optional<Columns> inverse(Columns m) {
  Columns x{};
  for (std::size_t j = 0; j < 3; ++j) x[j][j] = 1;
  const auto each_row = [&](auto change) {
    for (std::size_t j = 0; j < 3; ++j) change(m[j]), change(x[j]);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t pivot = i;
    while (pivot < 3 && m[i][pivot] == 0) ++pivot;
    if (pivot == 3) return {};
    each_row([&](Column& c) { std::swap(c[i], c[pivot]); });
    const Rational by = m[i][i];
    each_row([&](Column& c) { c[i] = c[i] / by; });
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == i) continue;
      const Rational factor = m[i][k];
      each_row([&](Column& c) { c[k] = c[k] - factor * c[i]; });
    }
  }
  x[3] = image(x, {-m[3][0], -m[3][1], -m[3][2]}, false);
  return x;
}

bool in_doubles(const Rational& x) { return std::isfinite(x.rounded()); }
bool in_doubles(const Columns& m) {
  for (const Column& c : m) {
    for (const Rational& x : c) {
      if (!in_doubles(x)) return false;
    }
  }
  return true;
}
bool held(const Columns& m) {
  for (const Column& c : m) {
    for (const Rational& x : c) {
      if (!in_doubles(x) || Rational(x.rounded()) != x) return false;
    }
  }
  return true;
}

void expect_rounded(const Vector3& made, const Column& wanted, const std::string& about) {
  const std::array<double, 3> x{made.x, made.y, made.z};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(x[i], wanted[i].rounded()) << about;
    EXPECT_FALSE(x[i] == 0 && std::signbit(x[i])) << about;
  }
}
void expect_rounded(const Pose& made, const Columns& wanted, const std::string& about) {
  for (std::size_t j = 0; j < 3; ++j) expect_rounded(made.columns[j], wanted[j], about);
  expect_rounded(made.translation, wanted[3], about);
}

Pose drawn_pose(Entropy& entropy) {
  const auto kind = static_cast<CoordinateClass>(entropy.below(coordinate_class_count));
  const bool small = entropy.coin();
  const auto number = [&] {
    return small ? 1.0 * static_cast<int>(entropy.below(5)) - 2 : coordinate_of(kind, entropy);
  };
  const auto vector = [&] {
    const double x = number(), y = number(), z = number();
    return Vector3{x, y, z};
  };
  Pose p{{vector(), vector(), vector()}, vector()};
  if (entropy.below(4) == 0) p.columns[2] = p.columns[0];
  return p;
}

Pose2 flat(const Pose& p) {
  return {{{{p.columns[0].x, p.columns[0].y}, {p.columns[1].x, p.columns[1].y}}}, {p.translation.x, p.translation.y}};
}
/// The flat pose as one of space that leaves z alone.
Pose raised(const Pose2& p) {
  return {{{{p.columns[0].x, p.columns[0].y, 0}, {p.columns[1].x, p.columns[1].y, 0}, {0, 0, 1}}},
          {p.translation.x, p.translation.y, 0}};
}
/// What `made` says, or nothing where it throws that a number is beyond the doubles.
template <class Made>
auto unless_beyond(Made made) -> std::optional<decltype(made())> {
  try {
    return made();
  } catch (const BeyondDoubles&) {
    return {};
  }
}

TEST(RoundedPoses, AreTheExactOnesRoundedOnce) {
  int beyond = 0, singular = 0, kept = 0, lost = 0;
  for (std::uint64_t index = 0; index < 1500; ++index) {
    Entropy entropy(811, index);
    const std::string about = "start 811 index " + std::to_string(index);
    const Pose a = drawn_pose(entropy), b = drawn_pose(entropy);
    const Columns p = exact(a), q = exact(b), ab = product(p, q);

    const auto composed = unless_beyond([&] { return rounded_composition(a, b); });
    ASSERT_EQ(composed.has_value(), in_doubles(ab)) << about;
    if (composed) expect_rounded(*composed, ab, about);
    const auto kept_pose = exact_composition(a, b);
    ASSERT_EQ(kept_pose.has_value(), held(ab)) << about;
    if (kept_pose) {
      EXPECT_EQ(*kept_pose, *composed) << about;
    }
    (kept_pose ? kept : lost) += 1;

    const Point3 point{b.columns[0].x, b.columns[1].y, b.columns[2].z};
    const Column there = image(p, exact(Vector3{point.x, point.y, point.z}), true);
    if (const auto moved = unless_beyond([&] { return rounded_image(a, point); })) {
      expect_rounded(Vector3{moved->x, moved->y, moved->z}, there, about);
      if (const auto same = exact_image(a, point)) {
        EXPECT_EQ(*same, *moved) << about;
      }
    } else {
      EXPECT_FALSE(exact_image(a, point)) << about;
    }

    const auto back = inverse(p);
    EXPECT_EQ(handedness(a) == Sign::zero, !back) << about;
    const auto undone = unless_beyond([&] { return rounded_inverse(a); });
    const auto seen = unless_beyond([&] { return rounded_relative(a, b); });
    if (!back) {
      ++singular;
      ASSERT_TRUE(undone && seen) << about;
      EXPECT_FALSE(*undone) << about;
      EXPECT_FALSE(*seen) << about;
      continue;
    }
    ASSERT_EQ(undone.has_value(), in_doubles(*back)) << about;
    if (undone) expect_rounded(undone->value(), *back, about);
    const Columns relative = product(*back, q);
    ASSERT_EQ(seen.has_value(), in_doubles(relative)) << about;
    if (seen) expect_rounded(seen->value(), relative, about);
    beyond += undone && seen && composed ? 0 : 1;
  }
  EXPECT_GT(beyond, 50);
  EXPECT_GT(singular, 100);
  EXPECT_GT(kept, 100);
  EXPECT_GT(lost, 100);
}

TEST(RoundedPoses, OfThePlaneAreThoseOfSpace) {
  for (std::uint64_t index = 0; index < 500; ++index) {
    Entropy entropy(812, index);
    const std::string about = "start 812 index " + std::to_string(index);
    const Pose2 a = flat(drawn_pose(entropy)), b = flat(drawn_pose(entropy));
    const Pose a3 = raised(a), b3 = raised(b);
    const auto same = [&](const auto& in_plane, const auto& in_space) {
      const auto x = unless_beyond(in_plane);
      const auto y = unless_beyond(in_space);
      ASSERT_EQ(x.has_value(), y.has_value()) << about;
      if (x) {
        EXPECT_EQ(*x, *y) << about;
      }
    };
    const auto flattened = [](const std::optional<Pose>& p) { return p ? std::optional(flat(*p)) : std::nullopt; };
    same([&] { return rounded_composition(a, b); }, [&] { return flat(rounded_composition(a3, b3)); });
    same([&] { return exact_composition(a, b); }, [&] { return flattened(exact_composition(a3, b3)); });
    same([&] { return rounded_inverse(a); }, [&] { return flattened(rounded_inverse(a3)); });
    same([&] { return rounded_relative(a, b); }, [&] { return flattened(rounded_relative(a3, b3)); });
    const Point2 p{b.translation.x, b.translation.y};
    const Vector2 v = b.columns[0];
    same([&] { return rounded_image(a, p); },
         [&] {
           const Point3 q = rounded_image(a3, Point3{p.x, p.y, 0});
           return Point2{q.x, q.y};
         });
    same([&] { return rounded_image(a, v); },
         [&] {
           const Vector3 q = rounded_image(a3, Vector3{v.x, v.y, 0});
           return Vector2{q.x, q.y};
         });
    EXPECT_EQ(exact_image(a, p).has_value(), exact_image(a3, Point3{p.x, p.y, 0}).has_value()) << about;
    EXPECT_EQ(handedness(a), handedness(a3)) << about;
    EXPECT_EQ(keeps_lengths(a), keeps_lengths(a3)) << about;
  }
}

TEST(RoundedPoses, Laws) {
  const Pose turn{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {1, 2, 3}};
  EXPECT_TRUE(keeps_lengths(turn));
  EXPECT_EQ(handedness(turn), Sign::positive);
  EXPECT_EQ(rounded_composition(turn, *rounded_inverse(turn)), identity_pose);
  EXPECT_EQ(rounded_relative(turn, turn), identity_pose);
  EXPECT_EQ(exact_image(turn, Point3{1, 1, 1}), (Point3{0, 3, 4}));
  EXPECT_EQ(rounded_image(turn, Vector3{1, 1, 1}), (Vector3{-1, 1, 1}));
  // 0.6 and 0.8 are no doubles: the turn by them keeps no lengths.
  EXPECT_FALSE(keeps_lengths(Pose2{{{{0.6, 0.8}, {-0.8, 0.6}}}, {0, 0}}));
  EXPECT_EQ(handedness(Pose2{{{{0, 1}, {1, 0}}}, {0, 0}}), Sign::negative);
  EXPECT_EQ(handedness(Pose2{{{{1, 0.1}, {10, 1}}}, {0, 0}}), Sign::negative);  // 0.1 is a little more
  EXPECT_FALSE(rounded_inverse(Pose2{{{{1, 2}, {2, 4}}}, {0, 0}}));
  // By two roundings the translations, which are all but equal, would leave nothing.
  const Pose near{identity_pose.columns, {0x1p53, 0, 0}}, far{{{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}}, {0x1p53 + 2, 0, 0}};
  EXPECT_EQ(rounded_relative(near, far)->translation, (Vector3{2, 0, 0}));
}

TEST(RoundedPoses, NameWhatIsNoNumberAndWhatIsNoDouble) {
  Pose bad = identity_pose;
  bad.columns[1].z = std::nan("");
  EXPECT_THAT([&] { (void)rounded_composition(identity_pose, bad); },
              ThrowsMessage<NonFinite>(HasSubstr("rounded_composition: inner.columns[1].z is nan")));
  EXPECT_THAT([&] { (void)rounded_inverse(bad); },
              ThrowsMessage<NonFinite>(HasSubstr("rounded_inverse: pose.columns[1].z is nan")));
  EXPECT_THAT(
      [&] {
        (void)rounded_image(identity_pose, Point3{0, INFINITY, 0});
      },
      ThrowsMessage<NonFinite>(HasSubstr("rounded_image: p.y is inf")));
  const Pose large{{{{largest, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {largest, 0, 0}};
  EXPECT_THAT([&] { (void)rounded_composition(large, large); },
              ThrowsMessage<BeyondDoubles>(HasSubstr("rounded_composition: a number of the image is beyond")));
  EXPECT_FALSE(exact_composition(large, large));
}

}  // namespace
}  // namespace plumb
