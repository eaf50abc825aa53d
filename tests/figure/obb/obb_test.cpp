// Is the relation of two oriented boxes exact, whatever boxes they are, and do merges and images enclose?
#include "plumb/figure/obb/obb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "figure/basic/powers_of_two.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/obb/cases.hpp"
#include "oracle/boxes.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::shape_cases {
namespace {

using obb_cases::lifted;

constexpr Obb3 unit{{0, 0, 0}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};

Obb3 moved(Obb3 box, double x, double y, double z) {
  box.center = {box.center.x + x, box.center.y + y, box.center.z + z};
  return box;
}
Obb3 halved(Obb3 box, double x, double y, double z) {
  box.half = {x, y, z};
  return box;
}

TEST(ObbTest, TellsTouchingFromOverlapping) {
  EXPECT_EQ(relate(unit, moved(unit, 2, 0, 0)), Relation::touching);
  EXPECT_EQ(relate(unit, moved(unit, 2, -2, 2)), Relation::touching);  // corner to corner
  EXPECT_EQ(relate(unit, moved(unit, std::nextafter(2, 3), 0, 0)), Relation::disjoint);
  EXPECT_EQ(relate(unit, moved(unit, std::nextafter(2, 1), 0, 0)), Relation::overlapping);
  EXPECT_TRUE(intersects(unit, moved(unit, 2, 0, 0)));
  // Two edges that cross: only their cross product separates (RTCD 4.4.1).
  const Obb3 a{{0, 0, 0}, {Vector3{1, 1, 0}, Vector3{-1, 1, 0}, Vector3{0, 0, 8}}, {1, 1, 1}};
  const Obb3 b{{0, 4, 0}, {Vector3{0, 1, 1}, Vector3{0, -1, 1}, Vector3{8, 0, 0}}, {1, 1, 1}};
  EXPECT_EQ(relate(a, b), Relation::touching);
  EXPECT_EQ(relate(a, moved(b, 0, 0x1p-50, 0)), Relation::disjoint);
  EXPECT_EQ(relate(a, moved(b, 0, -0x1p-50, 0)), Relation::overlapping);
}

// RTCD 4.4.2: edges that are parallel, or nearly so, say nothing; an epsilon is not needed to hear that.
TEST(ObbTest, IsNotMisledByParallelEdges) {
  for (const double tilt : {0.0, 0x1p-1074, 0x1p-600, 0x1p-60, 0x1p-52, 0x1p-30}) {
    const Obb3 tilted{{1.5, 0, 0}, {Vector3{1, tilt, 0}, Vector3{-tilt, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
    EXPECT_EQ(relate(unit, tilted), Relation::overlapping) << tilt;
    EXPECT_EQ(relate(tilted, unit), Relation::overlapping) << tilt;
    EXPECT_EQ(relate(unit, moved(tilted, 1, 0, 0)), Relation::disjoint) << tilt;
    EXPECT_EQ(relate(unit, moved(tilted, 0.5, 0, 0)),
              tilt == 0 ? Relation::touching : oracle::box_relation(unit, moved(tilted, 0.5, 0, 0)));
  }
}

TEST(ObbTest, TakesFlatBoxesSegmentsAndPoints) {
  const Obb3 square = halved(unit, 1, 1, 0), segment = halved(unit, 1, 0, 0), point = halved(unit, 0, 0, 0);
  EXPECT_EQ(relate(square, square), Relation::overlapping);  // of their relative interiors
  EXPECT_EQ(relate(square, moved(square, 2, 0, 0)), Relation::touching);
  EXPECT_EQ(relate(square, moved(square, 0, 0, 0x1p-1074)), Relation::disjoint);
  EXPECT_EQ(relate(square, segment), Relation::overlapping);
  EXPECT_EQ(relate(square, moved(segment, 0, 1, 0)), Relation::touching);
  EXPECT_EQ(relate(square, moved(segment, 2, 1, 0)), Relation::touching);
  EXPECT_EQ(relate(segment, moved(segment, 2, 0, 0)), Relation::touching);
  EXPECT_EQ(relate(segment, moved(segment, 1, 0, 0)), Relation::overlapping);
  EXPECT_EQ(relate(segment, moved(segment, 0, 0x1p-1074, 0)), Relation::disjoint);
  EXPECT_EQ(relate(segment, moved(segment, 2 + 0x1p-51, 0, 0)), Relation::disjoint);
  EXPECT_EQ(relate(point, point), Relation::overlapping);
  EXPECT_EQ(relate(point, moved(point, 0, 0, 0x1p-1074)), Relation::disjoint);
  EXPECT_EQ(relate(point, unit), Relation::overlapping);
  EXPECT_EQ(relate(moved(point, 1, 0, 0), unit), Relation::touching);
  EXPECT_EQ(relate(moved(square, 0, 0, 1), unit), Relation::touching);
  const Obb3 all_along_x{{0, 0, 0}, {Vector3{1, 0, 0}, Vector3{2, 0, 0}, Vector3{-4, 0, 0}}, {1, 1, 1}};
  EXPECT_EQ(relate(all_along_x, moved(segment, 8, 0, 0)), Relation::touching);
  EXPECT_EQ(relate(all_along_x, moved(segment, 7, 0, 0)), Relation::overlapping);
}

TEST(ObbTest, AgreesWithLinearPrograms) {
  std::map<Relation, int> count;
  int flat = 0;
  on_shapes(401, 4000, [&](Material& m) {
    const auto a = m.shape<Obb3>(), b = m.shape<Obb3>();
    const Relation r = relate(a, b);
    ASSERT_EQ(r, oracle::box_relation(a, b)) << m.about(a, b);
    ASSERT_EQ(r, relate(b, a)) << m.about(a, b);
    ASSERT_EQ(intersects(a, b), r != Relation::disjoint);
    ++count[r];
    flat += static_cast<int>(obb_cases::is_flat(a) || obb_cases::is_flat(b));
  });
  std::cout << "disjoint " << count[Relation::disjoint] << ", touching " << count[Relation::touching]
            << ", overlapping " << count[Relation::overlapping] << ", with a flat one " << flat << '\n';
  EXPECT_GT(count[Relation::disjoint], 400);
  EXPECT_GT(count[Relation::touching], 100);
  EXPECT_GT(count[Relation::overlapping], 400);
  EXPECT_GT(flat, 400);
}

// Parallelepipeds of small integers: parallel edges and exact contact are frequent.
TEST(ObbTest, AgreesWithLinearProgramsOnSolidBoxes) {
  std::map<Relation, int> count;
  for (std::uint64_t i = 0; i < 4000 * more; ++i) {
    Entropy entropy(405, i);
    const auto integer = [&](std::int64_t most) { return static_cast<double>(entropy.within(most)); };
    const auto half = [&] { return static_cast<double>(1 + entropy.below(2)); };
    const auto box = [&] {
      Obb3 b{{integer(5), integer(5), integer(5)}, {}, {half(), half(), half()}};
      for (Vector3& v : b.axes) v = {integer(2), integer(2), integer(2)};
      return b;
    };
    const Obb3 a = box(), b = box();
    if (obb_cases::is_flat(a) || obb_cases::is_flat(b)) continue;
    const Relation r = relate(a, b);
    ASSERT_EQ(r, oracle::box_relation(a, b)) << "405 " << i;
    ++count[r];
  }
  std::cout << "disjoint " << count[Relation::disjoint] << ", touching " << count[Relation::touching]
            << ", overlapping " << count[Relation::overlapping] << '\n';
  EXPECT_GT(count[Relation::disjoint], 200);
  EXPECT_GT(count[Relation::touching], 25);
  EXPECT_GT(count[Relation::overlapping], 200);
}

TEST(ObbTest, AgreesWithLinearProgramsInThePlane) {
  std::map<Relation, int> count;
  on_shapes(402, 2500, [&](Material& m) {
    const auto a = m.shape<Obb2>(), b = m.shape<Obb2>();
    const Relation r = relate(a, b);
    ASSERT_EQ(r, oracle::box_relation(lifted(a), lifted(b))) << m.about(a, b);
    ASSERT_EQ(r, relate(lifted(b), lifted(a))) << m.about(a, b);
    ++count[r];
  });
  EXPECT_GT(count[Relation::disjoint], 300);
  EXPECT_GT(count[Relation::touching], 80);
  EXPECT_GT(count[Relation::overlapping], 300);
}

// Boxes of right angles in doubles, near contact by ulps: what plain doubles get wrong.
TEST(ObbTest, IsExactNearContact) {
  std::map<Relation, int> count;
  for (std::uint64_t i = 0; i < 300; ++i) {
    Entropy entropy(403, i);
    const Obb3 a = obb_cases::turned(entropy);
    Obb3 b = obb_cases::turned(entropy);
    const auto ca = corners(a), cb = corners(b);
    const Point3 &p = ca[entropy.below(8)], &q = cb[entropy.below(8)];
    b.center = {b.center.x + (p.x - q.x), b.center.y + (p.y - q.y), b.center.z + (p.z - q.z)};
    const Relation r = relate(a, b);
    ASSERT_EQ(r, oracle::box_relation(a, b)) << "403 " << i;
    ++count[r];
  }
  EXPECT_GT(count[Relation::disjoint], 20);
  EXPECT_GT(count[Relation::overlapping], 20);
}

// Powers of two and permuted or reversed axes of space move nothing.
TEST(ObbTest, KeepsItsLaws) {
  on_shapes(404, 1500, [&](Material& m) {
    auto a = m.shape<Obb3>(), b = m.shape<Obb3>();
    const Relation r = relate(a, b);
    for (Obb3* box : {&a, &b}) {
      const auto turn = [](auto v) { return decltype(v){v.y, -v.z, v.x}; };
      box->center = turn(box->center);
      for (Vector3& v : box->axes) v = turn(v);
      std::swap(box->axes[0], box->axes[2]);
      std::swap(box->half.x, box->half.z);
      box->axes[1] = {-box->axes[1].x, -box->axes[1].y, -box->axes[1].z};
      box->half.y = -box->half.y;
    }
    ASSERT_EQ(relate(a, b), r) << m.about(a, b);
  });
}

TEST(ObbTest, IsTheSameTimesPowersOfTwo) { powers_of_two::expect_same_relation<Obb3, Obb3>(405, 600); }

TEST(ObbTest, RefusesWhatIsNoNumber) {
  for (std::size_t i = 0; i < 15; ++i) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Obb3 box = unit;
      std::array<double*, 15> numbers{&box.center.x,  &box.center.y,  &box.center.z,  &box.axes[0].x, &box.axes[0].y,
                                      &box.axes[0].z, &box.axes[1].x, &box.axes[1].y, &box.axes[1].z, &box.axes[2].x,
                                      &box.axes[2].y, &box.axes[2].z, &box.half.x,    &box.half.y,    &box.half.z};
      *numbers.at(i) = bad;
      for (const double far : {0.0, 9.0}) {
        EXPECT_THROW((void)relate(moved(unit, far, 0, 0), box), NonFinite) << i;
        EXPECT_THROW((void)relate(box, moved(unit, far, far, 0)), NonFinite) << i;
      }
      EXPECT_THROW((void)merge(unit, box), NonFinite);
      EXPECT_THROW((void)volume(box), NonFinite);
      EXPECT_THROW((void)surface_area(box), NonFinite);
      EXPECT_THROW((void)corners(box), NonFinite);
    }
  }
  try {
    Obb3 box = unit;
    box.axes[1].y = std::numeric_limits<double>::quiet_NaN();
    (void)relate(unit, box);
    FAIL();
  } catch (const NonFinite& e) {
    EXPECT_NE(std::string(e.what()).find("relate: b.axes[1].y is nan"), std::string::npos) << e.what();
  }
}

TEST(Obb, ProductsThatOverflowTellNothing) {
  const auto boxes = [](double s, double m) {
    return std::pair{
        Obb3{{0, 0, 0}, {Vector3{0, 0, s}, Vector3{s, -s, 0}, Vector3{s, s, 4 * s / 3}}, {m / s, m / s, 1.2 * m / s}},
        Obb3{{m, m, m}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {.1, .1, .1}}};
  };
  const auto [small, in_small] = boxes(1, 1);
  EXPECT_EQ(relate(small, in_small), Relation::overlapping);
  const auto [large, in_large] = boxes(1e100, 7.125e107);
  EXPECT_EQ(relate(large, in_large), Relation::overlapping);
  const double s = 4.146e102;
  const Obb3 a{{0, 0, 0}, {Vector3{s, s, s}, Vector3{s, -s, 0}, Vector3{s, s, 4 * s / 3}}, {.01, .01, .11}};
  const Obb3 b{
      {.112 * s, .088 * s, .4 * s / 3}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1e-3, 1e-3, 1e-3}};
  EXPECT_EQ(relate(a, b), Relation::disjoint);
  EXPECT_EQ(relate(b, a), Relation::disjoint);
}

}  // namespace
}  // namespace plumb::shape_cases
