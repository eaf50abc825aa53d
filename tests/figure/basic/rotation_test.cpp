// Are turns of the lattice what they are said to be, and as near to what was asked?  Against integers, rational numbers
// and long series.
#include "plumb/figure/basic/rotation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "figure/basic/rigid_poses.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

using rigid_poses::TurnKind;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

__extension__ using Wide = __int128;

/// How many, short by default: as many as PLUMB_ROTATIONS says.
std::uint64_t how_many() {
  const char* asked = std::getenv("PLUMB_ROTATIONS");
  return asked == nullptr ? 200'000 : std::strtoull(asked, nullptr, 10);
}

Wide whole(double x) { return static_cast<Wide>(x * 0x1p50); }

TEST(TurnLattice, MatricesAreOrthogonalInIntegers) {
  for (std::uint64_t index = 0; index < how_many(); ++index) {
    Entropy entropy(841, index);
    const Rotation q = rigid_poses::turn(entropy.coin() ? TurnKind::lattice : TurnKind::long_lattice, entropy);
    const auto made = exact_matrix(q);
    ASSERT_TRUE(made) << "start 841 index " << index;
    const auto number = [](double x) { return static_cast<Wide>(x * 0x1p25); };
    const Wide w = number(q.w), x = number(q.x), y = number(q.y), z = number(q.z), s = whole(made->weight);
    EXPECT_TRUE(s == w * w + x * x + y * y + z * z) << "start 841 index " << index;
    const auto& c = made->columns;
    const auto is = [](const Vector3& v, Wide a, Wide b, Wide d) {
      return whole(v.x) == a && whole(v.y) == b && whole(v.z) == d;
    };
    EXPECT_TRUE(is(c[0], w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)) &&
                is(c[1], 2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)) &&
                is(c[2], 2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z))
        << "start 841 index " << index;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Wide product =
            whole(c[i].x) * whole(c[j].x) + whole(c[i].y) * whole(c[j].y) + whole(c[i].z) * whole(c[j].z);
        EXPECT_TRUE(product == (i == j ? s * s : 0)) << "start 841 index " << index;
      }
    }
  }
}

TEST(TurnLattice, HasNoQuaternionWhoseWeightIsRounded) {
  // The squares of these integers have the sum 2^53 + 1, which doubles round to 2^53: a length that is said to be the
  // root of 8 and is not.
  EXPECT_FALSE(exact_matrix(Rotation{0x1p-25 * 94906265, 0x1p-25 * 10884, 0x1p-25 * 136, 0x1p-25 * 104}));
}

TEST(TurnLattice, TakesMultiplesByPowersOfTwo) {
  for (std::uint64_t index = 0; index < how_many() / 20; ++index) {
    Entropy entropy(846, index);
    const Rotation q = rigid_poses::turn(entropy.coin() ? TurnKind::lattice : TurnKind::long_lattice, entropy);
    const int exponent = static_cast<int>(entropy.within(900));
    const auto scaled = [exponent](double a) { return std::ldexp(a, exponent); };
    const auto made = exact_matrix(Rotation{scaled(q.w), scaled(q.x), scaled(q.y), scaled(q.z)});
    ASSERT_TRUE(made) << "start 846 index " << index;
    const TurnMatrix given = *exact_matrix(q);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto is_multiple = [&](double a, double b) {
        return mpq_class(a) * mpq_class(given.weight) == mpq_class(b) * mpq_class(made->weight);
      };
      const Vector3 &a = made->columns[i], &b = given.columns[i];
      EXPECT_TRUE(is_multiple(a.x, b.x) && is_multiple(a.y, b.y) && is_multiple(a.z, b.z))
          << "start 846 index " << index;
    }
  }
  EXPECT_EQ(exact_matrix(Rotation{3, 0, 0, 1}).value().weight, 2.5);
  EXPECT_EQ(exact_matrix(Rotation2{3, 1}).value().weight, 2.5);
  EXPECT_TRUE(exact_matrix(Rotation{33554431, 33554431, 33554431, 33554431}));
  EXPECT_FALSE(exact_matrix(Rotation{1, 0x1p-27, 0, 0}));
  EXPECT_FALSE(exact_matrix(Rotation{std::numeric_limits<double>::denorm_min(), 0, 0, 0}));
  EXPECT_FALSE(exact_matrix(Rotation{0, 0, 0, 0}));
}

mpq_class squared_tangent(const Rotation& a, const Rotation& b) {
  // The tangent is that of half the angle between both: the vector part of the quotient over the scalar part.
  const mpq_class aw(a.w), ax(a.x), ay(a.y), az(a.z), bw(b.w), bx(b.x), by(b.y), bz(b.z);
  const mpq_class scalar = aw * bw + ax * bx + ay * by + az * bz;
  const mpq_class all = (aw * aw + ax * ax + ay * ay + az * az) * (bw * bw + bx * bx + by * by + bz * bz);
  return (all - scalar * scalar) / (scalar * scalar);
}

bool is_same(const Rotation& a, const Rotation& b) { return squared_tangent(a, b) == 0; }

TEST(OnTurnLattice, IsNearAndSaysHowNear) {
  int exact = 0, near = 0;
  for (std::uint64_t index = 0; index < 3000; ++index) {
    Entropy entropy(842, index);
    const std::string about = "start 842 index " + std::to_string(index);
    const Rotation q = rigid_poses::turn(entropy);
    const auto [made, off] = on_turn_lattice(q);
    ASSERT_TRUE(exact_matrix(made)) << about;
    EXPECT_LE(off, 0x1p-23) << about;
    const mpq_class tangent2 = squared_tangent(q, made), half = mpq_class(off) / 2;
    // The arc is at least t - t^3 / 3, and not longer than t.
    EXPECT_LE(tangent2 * (1 - tangent2 / 3) * (1 - tangent2 / 3), half * half) << about;
    EXPECT_LE(off, 2 * std::sqrt(tangent2.get_d()) * (1 + 0x1p-20) + 0x1p-49) << about;
    (off == 0 ? exact : near) += 1;
    EXPECT_EQ(off == 0, is_same(q, made)) << about;
    const auto again = on_turn_lattice(made);
    EXPECT_EQ(again.turn, made) << about;
    EXPECT_EQ(again.off, 0) << about;
    const Rotation2 flat = rigid_poses::turn2(entropy);
    const auto in_plane = on_turn_lattice(flat);
    const auto in_space = on_turn_lattice(Rotation{flat.w, 0, 0, flat.z});
    EXPECT_EQ((Rotation{in_plane.turn.w, 0, 0, in_plane.turn.z}), in_space.turn) << about;
    EXPECT_EQ(in_plane.off, in_space.off) << about;
  }
  EXPECT_GT(exact, 1000);
  EXPECT_GT(near, 500);
}

TEST(OnTurnLattice, HoldsMultiplesExactly) {
  const Rotation q{3, -1, 2, 7};
  for (const double by : {1.0, -1.0, 0x1p1000, 0x1p-1074, 3 * 0x1p-500}) {
    const auto [made, off] = on_turn_lattice(Rotation{q.w * by, q.x * by, q.y * by, q.z * by});
    EXPECT_TRUE(is_same(made, q)) << by;
    EXPECT_EQ(off, 0) << by;
  }
  const auto [far, off] = on_turn_lattice(Rotation{0x1p1000, 0x1p-1074, 0, 0});
  EXPECT_EQ(far, Rotation{});
  EXPECT_GT(off, 0);
  EXPECT_LT(off, 0x1p-500);  // the square of what is off is below the doubles
}

/// Sine and cosine of half an angle below 32, each within 2^-180, by series in rational numbers.
struct Series {
  mpq_class cosine, sine;
};
Series long_series(const mpq_class& angle) {
  Series s{1, angle / 2};
  mpq_class term = angle / 2;
  for (int n = 2; abs(term) > mpq_class(std::ldexp(1.0, -190)) || n < 64; ++n) {
    term *= angle / 2 / n;
    (n % 2 == 0 ? s.cosine : s.sine) += n % 4 < 2 ? term : mpq_class(-term);
  }
  return s;
}

TEST(Rotation, IsByTheAngleThatWasAsked) {
  for (std::uint64_t index = 0; index < 600; ++index) {
    Entropy entropy(843, index);
    const std::string about = "start 843 index " + std::to_string(index);
    const auto number = [&] { return static_cast<double>(entropy.within(1 << 20)) * 0x1p-18 / 3; };
    const double angle = entropy.below(4) == 0 ? number() * 0x1p-40 : number() * (entropy.coin() ? 1 : 7);
    const int by = static_cast<int>(entropy.within(1000));
    Vector3 axis{std::ldexp(number(), by), std::ldexp(number(), by), std::ldexp(number(), by)};
    if (axis == Vector3{0, 0, 0}) axis.z = 1;
    const auto [made, off] = rotation(axis, angle);
    ASSERT_TRUE(exact_matrix(made)) << about;
    EXPECT_LE(off, 0x1p-23) << about;
    // The length of the axis is known within 2^-200 of itself; what counts is the quotient of what is asked and made.
    const mpq_class ax(axis.x), ay(axis.y), az(axis.z);
    const mpq_class square = ax * ax + ay * ay + az * az;
    const mpz_class unit = mpz_class(1) << 2400;
    const mpq_class length(sqrt(mpz_class(square * unit * unit)), unit);
    const auto [cosine, sine] = long_series(angle);
    const mpq_class w = cosine, x = sine * ax / length, y = sine * ay / length, z = sine * az / length;
    const mpq_class mw(made.w), mx(made.x), my(made.y), mz(made.z);
    const mpq_class scalar = mw * w + mx * x + my * y + mz * z;
    const mpq_class i = mw * x - w * mx - (my * z - mz * y), j = mw * y - w * my - (mz * x - mx * z),
                    k = mw * z - w * mz - (mx * y - my * x);
    const mpq_class tangent2 = (i * i + j * j + k * k) / (scalar * scalar), half = mpq_class(off) / 2;
    const mpq_class slack(0x1p-150);  // for the series
    EXPECT_LE(tangent2 * (1 - tangent2 / 3) * (1 - tangent2 / 3), half * half + slack) << about;
    EXPECT_LE(off, 2 * std::sqrt(tangent2.get_d()) + 0x1p-44) << about;
    const auto flat = rotation(angle);
    const auto upright = rotation(Vector3{0, 0, 3}, angle);
    EXPECT_EQ((Rotation{flat.turn.w, 0, 0, flat.turn.z}), upright.turn) << about;
  }
}

TEST(Rotation, TakesAnglesOfAnySize) {
  const auto tangent_of_half = [](double angle) {
    const Rotation2 q = rotation(angle).turn;
    return q.z / q.w;
  };
  EXPECT_EQ(rotation(0.0).turn, Rotation2{});
  EXPECT_EQ(rotation(0.0).off, 0);
  for (const double angle : {1e-300, 1.0, 3.0, 63.9, 64.0, 100.0, 1e6, 1e15, 1e22, 0x1.fffffffffffffp+1023}) {
    for (const double sign : {1.0, -1.0}) {
      EXPECT_LE(rotation(sign * angle).off, 0x1p-23) << angle;
      const double tangent = std::tan(sign * angle / 2);  // the C library takes no rounded pi either
      EXPECT_NEAR(tangent_of_half(sign * angle) / tangent, 1,
                  1e-5 * (1 + std::fabs(tangent)) * (1 + 1 / std::fabs(tangent)))
          << angle;
    }
  }
}

Pose rounded_cosines(double angle, const Vector3& translation) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}, translation};
}

mpq_class squared_difference(const Pose& pose, const Rotation& turn) {
  mpq_class sum;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto image = rigid_poses::turned(turn, {j == 0 ? 1 : 0, j == 1 ? 1 : 0, j == 2 ? 1 : 0});
    const Vector3& c = pose.columns[j];
    sum +=
        (image[0] - c.x) * (image[0] - c.x) + (image[1] - c.y) * (image[1] - c.y) + (image[2] - c.z) * (image[2] - c.z);
  }
  return sum;
}

TEST(NearestRotation, IsNearAndSaysHowNear) {
  for (std::uint64_t index = 0; index < 600; ++index) {
    Entropy entropy(844, index);
    const std::string about = "start 844 index " + std::to_string(index);
    const auto number = [&] { return static_cast<double>(entropy.within(1 << 20)) * 0x1p-20; };
    const Rotation q = rigid_poses::turn(TurnKind::beside, entropy);
    Pose pose{};
    for (std::size_t j = 0; j < 3; ++j) {
      const auto c = rigid_poses::turned(q, {j == 0 ? 1 : 0, j == 1 ? 1 : 0, j == 2 ? 1 : 0});
      pose.columns[j] = {c[0].get_d(), c[1].get_d(), c[2].get_d()};
    }
    const bool bent = entropy.coin();
    if (bent) pose.columns[entropy.below(3)].y += number();
    const auto near = nearest_rotation(pose);
    if (!bent) {
      ASSERT_TRUE(near) << about;
      EXPECT_LE(near->off, 0x1p-23) << about;
      EXPECT_LE(squared_tangent(near->turn, q), mpq_class(0x1p-48)) << about;
    }
    if (!near) continue;
    EXPECT_LE(squared_difference(pose, near->turn), mpq_class(near->off) * mpq_class(near->off)) << about;
    // None of the turns beside it is nearer by more than the lattice.
    for (int k = 0; k < 6; ++k) {
      const double step = (k < 3 ? 1 : -1) * 0x1p-20;
      const auto& [w, x, y, z] = near->turn;
      const Rotation beside{w + (k % 3 == 0 ? step : 0), x + (k % 3 == 1 ? step : 0), y + (k % 3 == 2 ? step : 0), z};
      EXPECT_GE(squared_difference(pose, beside).get_d() + 0x1p-45,
                squared_difference(pose, near->turn).get_d() - 0x1p-22)
          << about;
    }
  }
}

TEST(NearestRotation, OfAMultipleOfALatticeTurnIsThatTurn) {
  for (std::uint64_t index = 0; index < 400; ++index) {
    Entropy entropy(845, index);
    const std::string about = "start 845 index " + std::to_string(index);
    const Rotation q = rigid_poses::turn(static_cast<TurnKind>(1 + entropy.below(3)), entropy);
    const auto made = exact_matrix(on_turn_lattice(q).turn);
    ASSERT_TRUE(made) << about;
    const double by = std::ldexp(1.0, static_cast<int>(entropy.within(900)));
    Pose pose{made->columns, {1, 2, 3}};
    for (Vector3& c : pose.columns) c = {c.x * by, c.y * by, c.z * by};
    const auto near = nearest_rotation(pose);
    ASSERT_TRUE(near) << about;
    EXPECT_TRUE(is_same(near->turn, q)) << about;

    const Rotation2 flat = rigid_poses::turn2(static_cast<TurnKind>(1 + entropy.below(3)), entropy);
    const auto in_plane = exact_matrix(on_turn_lattice(flat).turn);
    const auto near2 = nearest_rotation(Pose2{in_plane->columns, {0, 0}});
    ASSERT_TRUE(near2) << about;
    EXPECT_TRUE(is_same({near2->turn.w, 0, 0, near2->turn.z}, {flat.w, 0, 0, flat.z})) << about;
  }
  const Pose quarter{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {0, 0, 0}};
  EXPECT_EQ(nearest_rotation(quarter)->off, 0);
  EXPECT_EQ(nearest_rotation(identity_pose)->turn, Rotation{});
}

TEST(NearestRotation, OfThePlaneIsNear) {
  for (std::uint64_t index = 0; index < 300; ++index) {
    Entropy entropy(846, index);
    const std::string about = "start 846 index " + std::to_string(index);
    const double angle = static_cast<double>(entropy.within(1 << 20)) * 0x1p-17;
    const Pose space = rounded_cosines(angle, {0, 0, 0});
    const Pose2 pose{{{{space.columns[0].x, space.columns[0].y}, {space.columns[1].x, space.columns[1].y}}}, {0, 0}};
    const auto near = nearest_rotation(pose);
    ASSERT_TRUE(near) << about;
    EXPECT_LE(near->off, 0x1p-23) << about;
    const auto asked = rotation(angle).turn;
    EXPECT_LE(squared_tangent({near->turn.w, 0, 0, near->turn.z}, {asked.w, 0, 0, asked.z}), mpq_class(0x1p-46))
        << about;
    EXPECT_LE(squared_difference(space, {near->turn.w, 0, 0, near->turn.z}),
              mpq_class(near->off) * mpq_class(near->off))
        << about;
  }
}

TEST(NearestRotation, OfAMirrorAndOfWhatFlattensIsNothing) {
  EXPECT_FALSE(nearest_rotation(Pose{{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, {0, 0, 0}}));
  EXPECT_FALSE(nearest_rotation(Pose{{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {0, 0, 0}}));
  EXPECT_FALSE(nearest_rotation(Pose{}));
  EXPECT_FALSE(nearest_rotation(Pose2{{{{1, 0}, {0, -1}}}, {0, 0}}));
  EXPECT_FALSE(nearest_rotation(Pose2{}));
  // A stretch is not a turn; how far images of unit vectors are off is said.
  const auto near = nearest_rotation(Pose{{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}, {0, 0, 0}});
  EXPECT_EQ(near->turn, Rotation{});
  EXPECT_NEAR(near->off, std::sqrt(3.0), 1e-15);
  const auto huge = nearest_rotation(Pose{{{{0x1p1023, 0, 0}, {0, 0x1p-1074, 0}, {0, 0, 0x1p1023}}}, {0, 0, 0}});
  ASSERT_TRUE(huge);
  EXPECT_GE(huge->off, 0x1p1023);
}

TEST(RigidPoses, AreNamedWhereTheyAreNone) {
  const auto text = [](const auto& pose) { return text_of<Error>([&] { figure::require_sound("asked", pose); }); };
  EXPECT_EQ(text(Rotation{}), "nothing thrown");
  EXPECT_EQ(text(RigidPose2{{0x1p1023, 0x1p1023}, {0x1p1023, 0x1p1023}}), "nothing thrown");
  EXPECT_EQ(text(RigidPose{{-0x1p-1074, 0, 0, 0}}), "nothing thrown");
  EXPECT_THAT(text(RigidPose{{nan, 0, 0, 0}}), testing::StartsWith("asked: pose.turn.w is nan"));
  EXPECT_THAT(text(RigidPose{{1, 0, infinite, 0}}), testing::StartsWith("asked: pose.turn.y is inf"));
  EXPECT_THAT(text(RigidPose{{}, {0, 0, nan}}), testing::StartsWith("asked: pose.translation.z is nan"));
  EXPECT_THAT(text(RigidPose2{{1, -infinite}}), testing::StartsWith("asked: pose.turn.z is -inf"));
  EXPECT_THAT(text(Rotation{0, 0, 0, nan}), testing::StartsWith("asked: turn.z is nan"));
  EXPECT_THAT(text(RigidPose{{0, 0, -0.0, 0}}), testing::StartsWith("asked: pose.turn is zero, which is no turn"));
  EXPECT_THAT(text(Rotation2{0, 0}), testing::StartsWith("asked: turn is zero, which is no turn"));
  EXPECT_EQ(text(RigidChain{}), "nothing thrown");
  EXPECT_THAT(text(RigidChain{{{}, {}, {{1, nan, 0, 0}}}}), testing::StartsWith("asked: pose.links[2].turn.x is nan"));
  EXPECT_THAT(text(RigidChain2{{{}, {{0, 0}}}}), testing::StartsWith("asked: pose.links[1].turn is zero"));
}

TEST(Rotation, NamesWhatItRefuses) {
  const auto text = [](auto call) { return text_of<Error>(call); };
  EXPECT_THAT(text([] { (void)rotation(Vector3{0, 0, 0}, 1); }), testing::StartsWith("rotation: axis is zero"));
  EXPECT_THAT(text([] { (void)rotation(Vector3{0, nan, 0}, 1); }), testing::StartsWith("rotation: axis.y is nan"));
  EXPECT_THAT(text([] { (void)rotation(infinite); }), testing::StartsWith("rotation: angle is inf"));
  EXPECT_THAT(text([] {
                (void)on_turn_lattice(Rotation{0, 0, 0, 0});
              }),
              testing::StartsWith("on_turn_lattice: turn is zero"));
  EXPECT_THAT(text([] {
                Pose bad = identity_pose;
                bad.columns[2].y = nan;
                (void)nearest_rotation(bad);
              }),
              testing::StartsWith("nearest_rotation: pose.columns[2].y is nan"));
}

}  // namespace
}  // namespace plumb
