// Is each number of a composition, an inverse, an image under rigid poses the exact one, rounded once?  Against products
// of quaternions in rational numbers.
#include "plumb/figure/basic/rigid_poses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "figure/basic/rigid_poses.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/figure/basic/rotation.hpp"
#include "plumb/figure/basic/rounded_poses.hpp"

namespace plumb {
namespace {

using rationals::is_nearest, rationals::overflows;
using rigid_poses::TurnKind;
using Numbers = rationals::Vector;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Numbers parts_of(const Rotation& q) { return {q.w, q.x, q.y, q.z}; }

/// Hamilton's product by the table of i, j and k.
Numbers product(const Numbers& p, const Numbers& q) {
  constexpr std::array<std::array<int, 4>, 4> unit{{{1, 2, 3, 4}, {2, -1, 4, -3}, {3, -4, -1, 2}, {4, 3, -2, -1}}};
  Numbers made(4);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      mpq_class& to = made[static_cast<std::size_t>(std::abs(unit[i][j]) - 1)];
      to += unit[i][j] > 0 ? mpq_class(p[i] * q[j]) : mpq_class(-p[i] * q[j]);
    }
  }
  return made;
}

bool are_parallel(const Numbers& p, const Numbers& q) {
  for (std::size_t i = 0; i < 16; ++i) {
    if (p[i % 4] * q[i / 4] != p[i / 4] * q[i % 4]) return false;
  }
  return true;
}

/// Is made, times some power of two, each number of q rounded once, but for those below the doubles?
bool is_rounded_multiple(const Rotation& made, const Numbers& q) {
  const Numbers got = parts_of(made);
  std::size_t most = 0;
  for (std::size_t i = 1; i < 4; ++i) most = abs(q[i]) > abs(q[most]) ? i : most;
  mpq_class by = abs(got[most] / q[most]);  // near to a power of two
  long exponent = static_cast<long>(mpz_sizeinbase(by.get_num_mpz_t(), 2)) -
                  static_cast<long>(mpz_sizeinbase(by.get_den_mpz_t(), 2));
  for (long e = exponent - 1; e <= exponent + 1; ++e) {
    mpq_class power = 1;
    if (e > 0) mpq_mul_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(e));
    if (e < 0) mpq_div_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(-e));
    const std::array numbers{made.w, made.x, made.y, made.z};
    bool all = true;
    for (std::size_t i = 0; i < 4; ++i) all = all && is_nearest(numbers[i], q[i] * power);
    if (all) return true;
  }
  return false;
}

bool is_held(const mpq_class& x) { return !overflows(x) && mpq_class(x.get_d()) == x; }

TEST(RigidPoses, CompositionsAreTheExactOnesRoundedOnce) {
  int exact = 0, rounded = 0;
  for (std::uint64_t index = 0; index < 2000; ++index) {
    Entropy entropy(851, index);
    const std::string about = "start 851 index " + std::to_string(index);
    const RigidPose a = rigid_poses::pose(entropy), b = rigid_poses::pose(entropy);
    const Numbers ab = product(parts_of(a.turn), parts_of(b.turn));
    const Numbers there = rigid_poses::image(a, rationals::exact(b.translation));

    const RigidPose made = rounded_composition(a, b);
    EXPECT_TRUE(is_rounded_multiple(made.turn, ab)) << about;
    EXPECT_EQ(rounded_composition(a.turn, b.turn), made.turn) << about;
    EXPECT_TRUE(is_nearest(made.translation.x, there[0])) << about;
    EXPECT_TRUE(is_nearest(made.translation.y, there[1])) << about;
    EXPECT_TRUE(is_nearest(made.translation.z, there[2])) << about;

    const auto turn = exact_composition(a.turn, b.turn);
    EXPECT_EQ(turn.has_value(), are_parallel(parts_of(made.turn), ab)) << about;
    if (turn) {
      EXPECT_EQ(*turn, made.turn) << about;
    }
    const auto kept = exact_composition(a, b);
    EXPECT_EQ(kept.has_value(), turn && is_held(there[0]) && is_held(there[1]) && is_held(there[2])) << about;
    if (kept) {
      EXPECT_EQ(*kept, made) << about;
    }
    (kept ? exact : rounded) += 1;

    // The chain is the composition, and links it.
    EXPECT_EQ(rounded_link(RigidChain{{a, b}}), made) << about;
    EXPECT_EQ(exact_link(RigidChain{{a, b}}), kept) << about;
  }
  EXPECT_GT(exact, 20);
  EXPECT_GT(rounded, 500);
}

TEST(RigidPoses, InversesUndoExactly) {
  int exact = 0;
  for (std::uint64_t index = 0; index < 1000; ++index) {
    Entropy entropy(852, index);
    const std::string about = "start 852 index " + std::to_string(index);
    const RigidPose a = rigid_poses::pose(entropy), b = rigid_poses::pose(entropy);
    const RigidChain chain = rigid_poses::chain(entropy);
    const Numbers p{static_cast<double>(entropy.within(9)), static_cast<double>(entropy.within(9)), 1};
    EXPECT_EQ(rigid_poses::image(inverse(a), rigid_poses::image(a, p)), p) << about;
    EXPECT_EQ(rigid_poses::image(chain, rigid_poses::image(inverse(chain), p)), p) << about;
    EXPECT_EQ(rigid_poses::image(a, rigid_poses::image(relative(a, b), p)), rigid_poses::image(b, p)) << about;
    EXPECT_EQ(rigid_poses::image(chain, rigid_poses::image(relative(chain, RigidChain{{a}}), p)),
              rigid_poses::image(a, p))
        << about;

    const Numbers back = rigid_poses::image(inverse(a), {0, 0, 0});
    const RigidPose undone = rounded_inverse(a);
    EXPECT_TRUE(same_turn(undone.turn, inverse(a.turn))) << about;
    EXPECT_TRUE(is_nearest(undone.translation.x, back[0])) << about;
    EXPECT_TRUE(is_nearest(undone.translation.y, back[1])) << about;
    EXPECT_TRUE(is_nearest(undone.translation.z, back[2])) << about;
    const auto kept = exact_inverse(a);
    EXPECT_EQ(kept.has_value(), is_held(back[0]) && is_held(back[1]) && is_held(back[2])) << about;
    exact += kept ? 1 : 0;

    const RigidPose seen = rounded_relative(a, b);
    const Numbers at = rigid_poses::image(inverse(a), rationals::exact(b.translation));
    EXPECT_TRUE(is_nearest(seen.translation.x, at[0])) << about;
    EXPECT_TRUE(is_nearest(seen.translation.y, at[1])) << about;
    EXPECT_TRUE(is_nearest(seen.translation.z, at[2])) << about;
    const RigidPose same = rounded_relative(a, a);
    EXPECT_TRUE(same_turn(same.turn, {})) << about;
    EXPECT_EQ(same.translation, (Vector3{0, 0, 0})) << about;
  }
  EXPECT_GT(exact, 80);
}

TEST(RigidPoses, CompositionIsAssociative) {
  for (std::uint64_t index = 0; index < 500; ++index) {
    Entropy entropy(853, index);
    const std::string about = "start 853 index " + std::to_string(index);
    const auto small = [&] { return rigid_poses::turn(static_cast<TurnKind>(entropy.below(2)), entropy); };
    const Rotation p = small(), q = small(), r = small();
    EXPECT_EQ(exact_composition(*exact_composition(p, q), r), exact_composition(p, *exact_composition(q, r))) << about;
    // Two of the lattice always are composed exactly.
    const Rotation u = rigid_poses::turn(TurnKind::long_lattice, entropy);
    const Rotation v = rigid_poses::turn(TurnKind::lattice, entropy);
    EXPECT_TRUE(exact_composition(u, v)) << about;
    // As chains all are, whatever the numbers.
    const RigidPose a = rigid_poses::pose(entropy), b = rigid_poses::pose(entropy), c = rigid_poses::pose(entropy);
    const Numbers x{1, 2, 3};
    const RigidChain chain{{a, b, c}};
    EXPECT_EQ(rigid_poses::image(chain, x), rigid_poses::image(a, rigid_poses::image(RigidChain{{b, c}}, x))) << about;
  }
}

TEST(RigidPoses, ImagesAreTheExactOnesRoundedOnce) {
  int exact = 0;
  for (std::uint64_t index = 0; index < 1500; ++index) {
    Entropy entropy(854, index);
    const std::string about = "start 854 index " + std::to_string(index);
    const auto number = [&] { return rigid_poses::pose(entropy).translation.x; };
    const Point3 p{number(), number(), number()};
    const auto check = [&](const auto& pose) {
      const Numbers there = rigid_poses::image(pose, rationals::exact(p));
      const Point3 made = rounded_image(pose, p);
      EXPECT_TRUE(is_nearest(made.x, there[0]) && is_nearest(made.y, there[1]) && is_nearest(made.z, there[2]))
          << about;
      const auto kept = exact_image(pose, p);
      EXPECT_EQ(kept.has_value(), is_held(there[0]) && is_held(there[1]) && is_held(there[2])) << about;
      exact += kept ? 1 : 0;
      const Numbers origin = rigid_poses::image(pose, {0, 0, 0});
      const Vector3 turned = rounded_image(pose, Vector3{p.x, p.y, p.z});
      EXPECT_TRUE(is_nearest(turned.x, there[0] - origin[0]) && is_nearest(turned.y, there[1] - origin[1]) &&
                  is_nearest(turned.z, there[2] - origin[2]))
          << about;
    };
    check(rigid_poses::pose(entropy));
    check(rigid_poses::chain(entropy));
    const auto check_plane = [&](const auto& pose) {
      const Point2 q{p.x, p.y};
      const Numbers there = rigid_poses::image(pose, rationals::exact(q));
      const Point2 made = rounded_image(pose, q);
      EXPECT_TRUE(is_nearest(made.x, there[0]) && is_nearest(made.y, there[1])) << about;
      EXPECT_EQ(exact_image(pose, q).has_value(), is_held(there[0]) && is_held(there[1])) << about;
    };
    check_plane(rigid_poses::pose2(entropy));
    check_plane(rigid_poses::chain2(entropy));
  }
  EXPECT_GT(exact, 200);
}

TEST(RigidPoses, OfThePlaneAreThoseOfSpace) {
  const auto raised = [](const RigidPose2& p) {
    return RigidPose{{p.turn.w, 0, 0, p.turn.z}, {p.translation.x, p.translation.y, 0}};
  };
  const auto lowered = [](const RigidPose& p) {
    return RigidPose2{{p.turn.w, p.turn.z}, {p.translation.x, p.translation.y}};
  };
  for (std::uint64_t index = 0; index < 400; ++index) {
    Entropy entropy(855, index);
    const std::string about = "start 855 index " + std::to_string(index);
    const RigidPose2 a = rigid_poses::pose2(entropy), b = rigid_poses::pose2(entropy);
    const RigidPose x = raised(a), y = raised(b);
    const auto lowered_if = [&](const std::optional<RigidPose>& p) {
      return p ? std::optional(lowered(*p)) : std::nullopt;
    };
    EXPECT_EQ(rounded_composition(a, b), lowered(rounded_composition(x, y))) << about;
    EXPECT_EQ(exact_composition(a, b), lowered_if(exact_composition(x, y))) << about;
    EXPECT_EQ(rounded_inverse(a), lowered(rounded_inverse(x))) << about;
    EXPECT_EQ(exact_inverse(a), lowered_if(exact_inverse(x))) << about;
    EXPECT_EQ(rounded_relative(a, b), lowered(rounded_relative(x, y))) << about;
    EXPECT_EQ(same_turn(a.turn, b.turn), same_turn(x.turn, y.turn)) << about;
    const Pose2 matrix = rounded_pose(a);
    const Pose of_space = rounded_pose(x);
    EXPECT_EQ(matrix.columns[0], (Vector2{of_space.columns[0].x, of_space.columns[0].y})) << about;
    EXPECT_EQ(exact_pose(a).has_value(), exact_pose(x).has_value()) << about;
  }
}

TEST(RigidPoses, MatricesAreTheExactOnesRoundedOnce) {
  int exact = 0;
  for (std::uint64_t index = 0; index < 800; ++index) {
    Entropy entropy(856, index);
    const std::string about = "start 856 index " + std::to_string(index);
    const RigidPose pose = rigid_poses::pose(entropy);
    const Pose made = rounded_pose(pose);
    bool held = true;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto column = rigid_poses::turned(pose.turn, {j == 0 ? 1 : 0, j == 1 ? 1 : 0, j == 2 ? 1 : 0});
      EXPECT_TRUE(is_nearest(made.columns[j].x, column[0]) && is_nearest(made.columns[j].y, column[1]) &&
                  is_nearest(made.columns[j].z, column[2]))
          << about;
      for (const mpq_class& x : column) held = held && is_held(x);
    }
    EXPECT_EQ(made.translation, pose.translation) << about;
    EXPECT_EQ(exact_pose(pose), held ? std::optional(made) : std::nullopt) << about;
    if (held) {
      ++exact;
      EXPECT_TRUE(keeps_lengths(made)) << about;
      EXPECT_EQ(handedness(made), Sign::positive) << about;
    }
    EXPECT_TRUE(same_turn(pose.turn, {-pose.turn.w, -pose.turn.x, -pose.turn.y, -pose.turn.z})) << about;
    const Rotation other = rigid_poses::turn(entropy);
    EXPECT_EQ(same_turn(pose.turn, other), are_parallel(parts_of(pose.turn), parts_of(other))) << about;
  }
  EXPECT_GT(exact, 50);
}

TEST(RigidPoses, Laws) {
  const Pose quarter{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {0, 0, 0}};
  // Multiples as far as doubles go, whose squares are beyond them.
  for (const double f : {1.0, -3.0, 0x1p1000, -0x1p-1074}) {
    EXPECT_EQ(exact_pose(RigidPose{{f, 0, 0, f}}), quarter);
    EXPECT_TRUE(same_turn({f, 0, 0, f}, {1, 0, 0, 1}));
  }
  EXPECT_FALSE(same_turn({1, 0, 0, 1}, {1, 0, 0, std::nextafter(1.0, 2)}));
  EXPECT_EQ(exact_composition(Rotation{0, 1, 0, 0}, Rotation{0, 0, 1, 0}), (Rotation{0, 0, 0, 1}));
  EXPECT_EQ(exact_composition(Rotation{1, 2, 3, 4}, inverse(Rotation{1, 2, 3, 4})), (Rotation{30, 0, 0, 0}));
  // First the right factor: a quarter about x takes z to -y, a quarter about z that to x.
  const Rotation both = *exact_composition(Rotation{1, 0, 0, 1}, Rotation{1, 1, 0, 0});
  EXPECT_EQ(rounded_image(RigidPose{both}, Vector3{0, 0, 1}), (Vector3{1, 0, 0}));
  EXPECT_EQ(rounded_link(RigidChain{}), RigidPose{});
  // A product of parts far apart, which no power of two brings among the doubles.
  const Rotation far{0x1p1000, 0x1p-1074, 0, 0};
  EXPECT_TRUE(exact_composition(far, Rotation{}));
  EXPECT_FALSE(exact_composition(far, far));
  EXPECT_EQ(rounded_composition(far, far), (Rotation{0x1p1023, 0x1p-1050, 0, 0}));
}

TEST(RigidPoses, NameWhatIsNone) {
  const auto text = [](auto call) { return text_of<Error>(call); };
  const RigidPose none{{0, 0, 0, 0}}, bad{{1, 0, nan, 0}};
  EXPECT_THAT(text([&] { (void)rounded_composition(RigidPose{}, bad); }),
              testing::StartsWith("rounded_composition: inner.turn.y is nan"));
  EXPECT_THAT(text([&] { (void)exact_composition(none.turn, Rotation{}); }),
              testing::StartsWith("exact_composition: outer is zero, which is no turn"));
  EXPECT_THAT(text([&] { (void)inverse(none); }), testing::StartsWith("inverse: pose.turn is zero"));
  EXPECT_THAT(text([&] {
                (void)relative(RigidChain{{{}, none}}, RigidChain{});
              }),
              testing::StartsWith("relative: in.links[1].turn is zero"));
  EXPECT_THAT(text([&] {
                (void)rounded_image(none, Point3{1, 2, 3});
              }),
              testing::StartsWith("rounded_image: pose.turn is zero"));
  EXPECT_THAT(text([&] { (void)rounded_pose(bad); }), testing::StartsWith("rounded_pose: pose.turn.y is nan"));
  EXPECT_THAT(text([&] { (void)same_turn(Rotation{}, none.turn); }), testing::StartsWith("same_turn: q is zero"));
  constexpr double most = std::numeric_limits<double>::max();
  const RigidPose large{{1, 0, 0, 0.5}, {most, most, 0}};
  EXPECT_THAT(text([&] { (void)rounded_composition(large, large); }),
              testing::StartsWith("rounded_composition: a number of it is beyond all doubles"));
  EXPECT_FALSE(exact_composition(large, large));
}

}  // namespace
}  // namespace plumb
