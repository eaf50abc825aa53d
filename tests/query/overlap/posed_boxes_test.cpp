// Boxes under poses: is how they lie what a linear program in rationals says of their corners?  As they rest on one
// another, a rounding apart, turned alike or not, flat, of few digits and of many.
#include "query/convex/posed_boxes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/query.hpp"
#include "query/body/parting_axes.hpp"
#include "query/overlap/rational_relation.hpp"

namespace plumb {
namespace {

using oracle::RationalPoint;

RationalPoint image(const RigidPose& pose, const RationalPoint& p) {
  const mpq_class w = pose.turn.w, x = pose.turn.x, y = pose.turn.y, z = pose.turn.z;
  const mpq_class square = w * w + x * x + y * y + z * z;
  const std::array<std::array<mpq_class, 3>, 3> m{
      {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
       {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
       {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
  const std::array t{pose.translation.x, pose.translation.y, pose.translation.z};
  RationalPoint q;
  for (std::size_t k = 0; k < 3; ++k) q[k] = (m[k][0] * p[0] + m[k][1] * p[1] + m[k][2] * p[2]) / square + t[k];
  return q;
}

template <class Box>
oracle::Spanned corners_of(const Box& box, const RigidPose& pose) {
  oracle::Spanned all = oracle::spanned(box);
  for (RationalPoint& p : all.points) p = image(pose, p);
  return all;
}

double between(Entropy& e, double low, double high) {
  return low + (high - low) * 0x1p-53 * double(e.below(1ULL << 53));
}

/// One of a few numbers, so that a box is as often on another as beside it.
double coordinate(Entropy& e, bool is_long) { return is_long ? between(e, -1, 1) : 0.5 * double(e.within(2)); }

Rotation drawn_turn(Entropy& e, bool is_long) {
  if (is_long) return {between(e, -1, 1), between(e, -1, 1), between(e, -1, 1), between(e, -1, 1)};
  constexpr std::array turns{Rotation{1, 0, 0, 0}, Rotation{1, 0, 0, 1},   Rotation{2, 0, 0, 1},
                             Rotation{3, 0, 0, 1}, Rotation{1, 0.5, 0, 0}, Rotation{2, 1, -1, 3}};
  return turns[e.below(turns.size())];
}

Aabb3 drawn_box(Entropy& e, bool is_long) {
  const Point3 low{coordinate(e, is_long), coordinate(e, is_long), coordinate(e, is_long)};
  const auto size = [&] { return is_long ? between(e, 0.5, 2) : e.below(16) == 0 ? 0 : 0.5 * double(1 + e.below(4)); };
  return {low, {low.x + size(), low.y + size(), low.z + size()}};
}
/// The same, or sheared.
Obb3 as_obb(const Aabb3& b, Entropy& e) {
  const Point3 c{0.5 * (b.min.x + b.max.x), 0.5 * (b.min.y + b.max.y), 0.5 * (b.min.z + b.max.z)};
  const Vector3 half{0.5 * (b.max.x - b.min.x), 0.5 * (b.max.y - b.min.y), 0.5 * (b.max.z - b.min.z)};
  return {c, {{{1, 0, 0}, {e.coin() ? 0.0 : 0.5, 1, 0}, {0, 0, 1}}}, half};
}

struct Counts {
  std::array<int, 3> relations{};
  int left = 0;
};

template <class A, class B>
void expect_relation(const Posed<A, RigidPose>& a, const Posed<B, RigidPose>& b, Counts& counts,
                     const std::string& replay) {
  const Relation expected = oracle::relation(corners_of(a.shape, a.pose), corners_of(b.shape, b.pose));
  EXPECT_EQ(relate(a, b), expected) << replay;
  EXPECT_EQ(relate(b, a), expected) << replay;
  ++counts.relations[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
  const auto quick = query::relate_posed_boxes(query::posed_view(a), query::posed_view(b));
  if (quick) {
    EXPECT_EQ(*quick, expected) << replay;
  } else {
    ++counts.left;
  }
}

/// b put on a face of a: exactly, where numbers allow it.
Vector3 to_rest(const Posed<Aabb3, RigidPose>& a, const Aabb3& b) {
  return {a.pose.translation.x, a.pose.translation.y, a.pose.translation.z + (a.shape.max.z - b.min.z)};
}

TEST(PosedBoxes, LieAsARationalProgramSays) {
  Counts counts;
  for (std::uint64_t run = 0; run < 1500; ++run) {
    const std::string replay = "replay: Entropy(4300, " + std::to_string(run) + ")";
    Entropy e(4300, run);
    const bool is_long = run % 3 == 0;
    const Aabb3 box_a = drawn_box(e, is_long), box_b = drawn_box(e, is_long);
    const auto at = [&] { return Vector3{coordinate(e, is_long), coordinate(e, is_long), coordinate(e, is_long)}; };
    const Posed a{box_a, RigidPose{drawn_turn(e, is_long), at()}};
    RigidPose pose{e.coin() ? a.pose.turn : drawn_turn(e, is_long), at()};
    if (e.coin()) pose.translation = to_rest(a, box_b);
    if (e.below(8) == 0) pose.translation.z += 0x1p-45;
    const Posed b{box_b, pose};
    switch (e.below(3)) {
      case 0:
        expect_relation(a, b, counts, replay);
        break;
      case 1:
        expect_relation(Posed{as_obb(box_a, e), a.pose}, b, counts, replay);
        break;
      default:
        expect_relation(Posed{as_obb(box_a, e), a.pose}, Posed{as_obb(box_b, e), pose}, counts, replay);
    }
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("%d apart, %d touch, %d overlap; %d without an inside\n", counts.relations[0], counts.relations[1],
              counts.relations[2], counts.left);
  for (const int n : counts.relations) EXPECT_GT(n, 150);
  EXPECT_GT(counts.left, 50);
  EXPECT_LT(counts.left, 1000);
}

/// The turn's matrix must be one of doubles.
query::PosedBox in_space(const Posed<Aabb3, RigidPose>& box) {
  const auto& [low, high] = box.shape;
  const TurnMatrix turn = exact_matrix(box.pose.turn).value();
  return {.axes = turn.columns,
          .columns = turn.columns,
          .length = {{{low.x, high.x}, {low.y, high.y}, {low.z, high.z}}},
          .local = {{{-low.x, high.x}, {-low.y, high.y}, {-low.z, high.z}}},
          .at = box.pose.translation,
          .weight = turn.weight};
}

// What doubles tell of fifteen axes is what rational numbers tell; they leave what touches, and little else.
TEST(PosedBoxes, AxesOverDoublesAreThoseOfRationalNumbers) {
  int told = 0, left = 0, touching = 0;
  for (std::uint64_t run = 0; run < 600; ++run) {
    Entropy e(4301, run);
    const bool is_long = run % 2 == 0;
    const auto part = [&] { return 0x1p-25 * double(e.bits(26)) - 1; };
    const auto turn = [&] {
      if (is_long) return Rotation{1, part(), part(), part()};
      const auto [w, x, y, z] = drawn_turn(e, false);
      return Rotation{0.25 * w, 0.25 * x, 0.25 * y, 0.25 * z};  // short enough for a matrix of doubles
    };
    const auto at = [&] { return Vector3{coordinate(e, is_long), coordinate(e, is_long), coordinate(e, is_long)}; };
    const Posed a{drawn_box(e, is_long), RigidPose{turn(), at()}};
    Posed b{drawn_box(e, is_long), RigidPose{e.below(4) == 0 ? a.pose.turn : turn(), at()}};
    if (e.below(4) == 0) b.pose.translation = to_rest(a, b.shape);
    FloatWorld<query::PartingAxes> floats;
    RationalWorld rationals;
    const query::PosedBox p = in_space(a), q = in_space(b);
    const std::uint32_t parallel = query::PartingAxes::parallel(p, q);
    const auto quick = query::PartingAxes{}(floats, p, q, parallel);
    const auto exact = query::PartingAxes{}(rationals, p, q, parallel);
    ASSERT_TRUE(floats.certain()) << "replay: Entropy(4301, " << run << ")";
    if (quick) {
      EXPECT_EQ(quick, exact) << "replay: Entropy(4301, " << run << ")";
    }
    ++(quick ? told : exact ? left : touching);
  }
  std::printf("%d told, %d left though apart or overlapping, %d touch or are flat\n", told, left, touching);
  EXPECT_GT(told, 10 * left);
  EXPECT_GT(touching, 20);
}

// A tower that leans.
TEST(PosedBoxes, TurnedAlikeTouchAndANudgePartsThem) {
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  const Rotation turn{1, 0, 0, 0};
  for (int k = 0; k < 100; ++k) {
    const Posed a{box, RigidPose{turn, {0.01 * k, 0.1, double(k)}}},
        b{box, RigidPose{turn, {0.01, 0.1, double(k + 1)}}};
    EXPECT_EQ(relate(a, b), Relation::touching);
    const Posed above{box, RigidPose{turn, {0.01, 0.1, double(k + 1) + 0x1p-40}}};
    EXPECT_EQ(relate(a, above), Relation::disjoint);
    const Posed below{box, RigidPose{turn, {0.01, 0.1, double(k + 1) - 0x1p-40}}};
    EXPECT_EQ(relate(a, below), Relation::overlapping);
  }
}

// What is left to other methods keeps its errors and its answers.
TEST(PosedBoxes, LeavesWhatIsNoSolidBox) {
  const auto quick = [](const auto& a, const auto& b) {
    return query::relate_posed_boxes(query::posed_view(a), query::posed_view(b));
  };
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  const Posed good{box, RigidPose{}};
  EXPECT_TRUE(quick(good, box));
  EXPECT_FALSE(quick(good, Posed{box, RigidPose{{0, 0, 0, 0}, {}}}));
  EXPECT_FALSE(quick(good, Posed{Aabb3{{0, 0, 0}, {1, 1, 0}}, RigidPose{}}));
  EXPECT_FALSE(quick(good, Posed{Aabb3{{2, 0, 0}, {1, 1, 1}}, RigidPose{}}));
  EXPECT_FALSE(quick(good, Posed{Sphere3{{0, 0, 0}, 1}, RigidPose{}}));
  const double nan = __builtin_nan(""), huge = 1e308;
  EXPECT_FALSE(quick(good, Posed{box, RigidPose{{}, {nan, 0, 0}}}));
  EXPECT_FALSE(quick(good, Posed{box, RigidPose{{nan, 0, 0, 1}, {}}}));
  EXPECT_FALSE(quick(Posed{Aabb3{{nan, 0, 0}, {1, 1, 1}}, RigidPose{}}, good));
  EXPECT_FALSE(quick(Posed{Aabb3{{-huge, 0, 0}, {huge, 1, 1}}, RigidPose{{2, 0, 0, 1}, {}}}, good));
  EXPECT_THROW(static_cast<void>(relate(good, Posed{box, RigidPose{{}, {nan, 0, 0}}})), NonFinite);
  EXPECT_THROW(static_cast<void>(relate(good, Posed{box, RigidPose{{0, 0, 0, 0}, {}}})), InvalidShape);
  EXPECT_EQ(relate(Posed{Aabb3{{-huge, 0, 0}, {huge, 1, 1}}, RigidPose{{2, 0, 0, 1}, {}}}, good),
            Relation::overlapping);
  EXPECT_EQ(relate(Posed{box, Pose{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 0}}}, good), Relation::touching);
}

}  // namespace
}  // namespace plumb
