// The functions of plain names, on figures that a reader can draw, and on arguments that are no numbers.
#include <gtest/gtest.h>

#include <limits>

#include "certify/battery.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/determinant_sign.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/certify/power.hpp"
#include "plumb/certify/side_of_plane.hpp"
#include "plumb/certify/smallest_sphere.hpp"
#include "plumb/predicates.hpp"

namespace plumb::battery {
namespace {

constexpr Sign plus = Sign::positive, zero = Sign::zero, minus = Sign::negative;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

TEST(DirectionTest, OrdersPoints) {
  const Point2 a{0, 5}, b{1, -5};
  EXPECT_EQ(compare_x(a, b), minus);
  EXPECT_EQ(compare_y(a, b), plus);
  EXPECT_EQ(compare_z(Point3{0, 0, -0.0}, Point3{0, 0, 0.0}), zero);
  EXPECT_EQ(compare_x(Point3{0x1p-1074, 0, 0}, Point3{}), plus);
  EXPECT_EQ(compare_y(Point3{0, 1.7e308, 0}, Point3{0, -1.7e308, 0}), plus);
  EXPECT_EQ(compare_lexicographically(a, b), minus);
  EXPECT_EQ(compare_lexicographically(Point3{1, 2, 3}, Point3{1, 2, 4}), minus);
  EXPECT_EQ(compare_lexicographically(Point3{1, 2, 3}, Point3{1, 1, 4}), plus);
  EXPECT_EQ(compare_lexicographically(a, a), zero);
  EXPECT_EQ(compare_along_direction(a, b, Vector2{1, 0}), minus);
  EXPECT_EQ(compare_along_direction(a, b, Vector2{10, 1}), zero);
  EXPECT_EQ(compare_along_direction(Point3{1, 1, 1}, Point3{}, Vector3{-1, 0, 0}), minus);
  EXPECT_EQ(compare_along_line(a, b, Point2{7, 7}, Point2{7, 8}), plus);
  EXPECT_EQ(compare_along_line(Point3{1, 1, 1}, Point3{}, Point3{5, 5, 5}, Point3{5, 5, 6}), plus);
  EXPECT_TRUE(are_ordered_along_line(Point2{0, 0}, Point2{1, 2}, Point2{2, 4}));
  EXPECT_TRUE(are_ordered_along_line(Point2{0, 0}, Point2{0, 0}, Point2{2, 4}));
  EXPECT_FALSE(are_ordered_along_line(Point2{1, 2}, Point2{0, 0}, Point2{2, 4}));
  EXPECT_FALSE(are_ordered_along_line(Point2{0, 0}, Point2{1, 2.5}, Point2{2, 4}));
  EXPECT_TRUE(are_ordered_along_line(Point3{0, 0, 0}, Point3{1, 2, 3}, Point3{2, 4, 6}));
  EXPECT_FALSE(are_ordered_along_line(Point3{0, 0, 0}, Point3{3, 6, 9}, Point3{2, 4, 6}));
  EXPECT_FALSE(are_ordered_along_line(Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 0, 0}));
}

TEST(DirectionTest, TellsAngles) {
  EXPECT_EQ(dot_sign(Vector2{1, 0}, Vector2{1, 5}), plus);
  EXPECT_EQ(dot_sign(Vector3{1, 1, 1}, Vector3{1, 1, -2}), zero);
  EXPECT_EQ(angle_sign(Point2{1, 0}, Point2{0, 0}, Point2{-1, 1}), minus);
  EXPECT_EQ(angle_sign(Point3{1, 0, 0}, Point3{0, 0, 0}, Point3{0, 0, 3}), zero);
  EXPECT_EQ(cross_sign(Vector2{1, 0}, Vector2{0, 1}), plus);
  EXPECT_TRUE(perpendicular(Vector2{3, 4}, Vector2{-4, 3}));
  EXPECT_TRUE(perpendicular(Vector3{0, 0, 0}, Vector3{1, 2, 3}));
  EXPECT_FALSE(perpendicular(Vector3{1, 0, 0x1p-1074}, Vector3{0, 0, 0x1p-1074}));
  EXPECT_TRUE(parallel(Vector2{1e-300, 2e-300}, Vector2{-0.5, -1}));
  EXPECT_TRUE(parallel(Vector3{1, 2, 3}, Vector3{0x1p-1000, 0x1p-999, 3 * 0x1p-1000}));
  EXPECT_FALSE(parallel(Vector3{0.1, 0.2, 0.3}, Vector3{1, 2, 3}));  // 0.3 is not thrice 0.1 in doubles
  EXPECT_TRUE(parallel(Vector3{0, 0, 0}, Vector3{1, 2, 3}));
}

TEST(DirectionTest, CollinearInSpaceAsCgalSays) {
  std::array<int, 2> answers{};
  for (std::uint64_t i = 0; i < 4'000; ++i) {
    Entropy entropy(11, i);
    std::array<double, 9> p{};
    if (i % 4 == 0) {
      fill_tiny(1 + static_cast<std::int64_t>(i % 3), p, entropy);
    } else {
      fill_points(any_family(entropy), Degeneracy::collinear, 3, p, entropy);
    }
    const Point3 a{p[0], p[1], p[2]}, b{p[3], p[4], p[5]}, c{p[6], p[7], p[8]};
    const bool truth = oracle::cgal_sign("collinear", p) == zero;
    const bool said = collinear(a, b, c);
    ASSERT_EQ(said, truth) << to_string(CaseLine{"collinear", {p.begin(), p.end()}, {}});
    ASSERT_EQ(parallel(Vector3{a.x, a.y, a.z}, Vector3{b.x, b.y, b.z}), collinear(Point3{}, a, b));
    ++answers[said ? 1 : 0];
  }
  EXPECT_GT(answers[0], 1'000);
  EXPECT_GT(answers[1], 1'000);
}

TEST(DistanceTest, ComparesDistancesOfFigures) {
  const Point2 o{0, 0};
  EXPECT_EQ(compare_distance(o, Point2{3, 4}, 5.0), zero);
  EXPECT_EQ(compare_distance(o, Point2{3, 4}, -6.0), plus);
  EXPECT_EQ(compare_distance(o, Point2{1e200, 0}, 2e200), minus);
  EXPECT_EQ(compare_distance(o, Point2{3, 4}, Point2{0, -5}), zero);
  EXPECT_EQ(compare_distance(o, Point2{3, 4}, Point2{7, 7}, Point2{8, 7}), plus);
  const Point3 a{0, 0, 0}, b{10, 0, 0};
  EXPECT_EQ(compare_distance_to_line(a, b, Point3{99, 3, 4}, Point3{-7, 0, 5}), zero);
  EXPECT_EQ(compare_distance_to_segment(a, b, Point3{13, 4, 0}, 5.0), zero);
  EXPECT_EQ(compare_distance_to_segment(a, b, Point3{5, 4, 3}, Point3{-3, 4, 0}), zero);
  EXPECT_EQ(compare_distance_to_segment(a, a, Point3{3, 4, 0}, 5.0), zero);
  EXPECT_EQ(compare_distance_to_segments(a, b, Point3{5, 2, 0}, a, b, Point3{11, 0, 0}), plus);
  EXPECT_EQ(compare_signed_distance_to_line(o, Point2{1, 0}, Point2{0, -2}, Point2{0, 1}), minus);
  const Point3 c{0, 10, 0};  // seen from above, a, b, c turn counterclockwise
  EXPECT_EQ(compare_distance_to_plane(a, b, c, Point3{1, 1, -3}, 3.0), zero);
  EXPECT_EQ(compare_distance_to_plane(a, b, c, Point3{1, 1, -3}, Point3{1, 1, 2}), plus);
  EXPECT_EQ(compare_signed_distance_to_plane(a, b, c, Point3{1, 1, -3}, Point3{1, 1, 2}), minus);
  EXPECT_EQ(compare_distance_to_plane(a, b, b, Point3{7, 3, 4}, 5.0), zero);  // a line
  EXPECT_EQ(compare_distance_to_planes(a, b, c, Point3{0, 0, 2}, a, a, a, Point3{0, 0, -2}), zero);
}

TEST(SideOfPlaneTest, TakesTheNumbersAsTheyAre) {
  EXPECT_EQ(side_of_line(Vector2{0, 2}, 4, Point2{9, 3}), plus);
  EXPECT_EQ(side_of_plane(Vector3{0, 0, 1}, 0.1, Point3{5, 5, 0.1}), zero);
  EXPECT_EQ(side_of_plane(Vector3{0.1, 0, 0}, 0.3, Point3{3, 0, 0}), plus);  // 3 times the double 0.1 exceeds 0.3
  EXPECT_EQ(compare_distance_to_plane(Vector3{0, 0, 7}, 14, Point3{1, 2, 5}, 3), zero);
  EXPECT_EQ(compare_distance_to_line(Vector2{3, 4}, 0, Point2{3, 4}, 5), zero);
  EXPECT_EQ(compare_distance_to_line(Vector2{3, 4}, 0, Point2{3, 4}, -5), plus);
}

TEST(SmallestSphereTest, IsPositiveInside) {
  EXPECT_EQ(in_smallest_circle(Point2{-1, 0}, Point2{1, 0}, Point2{0, 0.5}), plus);
  EXPECT_EQ(in_smallest_circle(Point2{-1, 0}, Point2{1, 0}, Point2{0, 1}), zero);
  EXPECT_EQ(in_smallest_circle(Point2{-1, 0}, Point2{0, 1}, Point2{1, 0}, Point2{0, -1}), zero);
  EXPECT_EQ(in_smallest_circle(Point2{1, 0}, Point2{0, 1}, Point2{-1, 0}, Point2{0, 0}), plus);
  EXPECT_EQ(in_smallest_circle(Point2{0, 0}, Point2{1, 1}, Point2{2, 2}, Point2{5, 5}), zero);  // there is none
  const Point3 a{1, 0, 0}, b{-1, 0, 0}, c{0, 1, 0};
  EXPECT_EQ(in_smallest_sphere(a, b, Point3{0, 0, 1}), zero);
  EXPECT_EQ(in_smallest_sphere(a, b, c, Point3{0, 0, 1}), zero);
  EXPECT_EQ(in_smallest_sphere(a, b, c, Point3{0, 0, 0.5}), plus);
  EXPECT_EQ(in_smallest_sphere(a, b, c, Point3{0, 0, -1.5}), minus);
  EXPECT_EQ(in_smallest_sphere(a, b, b, Point3{0, -1, 0}), zero);
}

TEST(PowerTest, OfEqualWeightsIsThatOfDistances) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Entropy entropy(3, i);
    const std::vector<Point3> p = points3(any_family(entropy), Degeneracy::cospherical, 5, entropy);
    const auto at = [&](std::size_t k) { return WeightedPoint3{p[k], 7}; };
    ASSERT_EQ(in_power_sphere(at(0), at(1), at(2), at(3), at(4)), insphere(p[0], p[1], p[2], p[3], p[4])) << i;
    ASSERT_EQ(compare_power(p[0], at(1), at(2)), compare_distance(p[0], p[1], p[2])) << i;
    ASSERT_EQ(power_sign(p[0], WeightedPoint3{p[1], 0}) == zero, p[0] == p[1]) << i;
  }
}

TEST(PowerTest, WeighsPoints) {
  const WeightedPoint2 a{{0, 0}, 0}, b{{4, 0}, 0}, c{{0, 4}, 0};
  EXPECT_EQ(in_power_circle(a, b, c, {{4, 4}, 0}), zero);
  EXPECT_EQ(in_power_circle(a, b, c, {{4, 4}, 0x1p-1000}), plus);
  EXPECT_EQ(in_power_circle(a, b, c, {{1, 1}, -100}), minus);
  EXPECT_EQ(compare_power(Point2{2, 0}, a, {{4, 0}, 1}), plus);
  EXPECT_EQ(power_sign(Point2{3, 4}, {{0, 0}, 25}), zero);
  EXPECT_EQ(power_sign(Point2{3, 4}, {{0, 0}, 26}), minus);
  EXPECT_EQ(power_sign(WeightedPoint2{{3, 4}, 9}, {{0, 0}, 16}), zero);
}

TEST(DeterminantTest, OfRows) {
  EXPECT_EQ(determinant_sign(Rows<2>{{{1, 2}, {2, 4}}}), zero);
  EXPECT_EQ(determinant_sign(Rows<3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0x1p-1074}}}), plus);
  EXPECT_EQ(determinant_sign(Rows<4>{{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}), minus);
  EXPECT_EQ(
      determinant_sign(Rows<5>{{{1, 0, 0, 0, 0}, {5, 1, 0, 0, 0}, {5, 5, 1, 0, 0}, {5, 5, 5, 1, 0}, {5, 5, 5, 5, 1}}}),
      plus);
}

template <class Ask>
std::string refused(const Ask& ask) {
  try {
    ask();
  } catch (const NonFinite& error) {
    return error.what();
  }
  return "nothing";
}

// Also where the answer does not depend on what is no number.
TEST(PlainFunctionsTest, RefuseWhatIsNoNumber) {
  const std::string mend = ", not a real number; give a finite double";
  const Point2 a{0, 0}, b{1, 0}, c{0, 1};
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0};
  EXPECT_EQ(refused([&] { compare_x(Point2{nan, 0}, a); }), "order_on_axis: a is nan" + mend);
  EXPECT_EQ(refused([&] {
              compare_lexicographically(x, Point3{0, 0, inf});
            }),
            "compare_lexicographically: b.z is inf" + mend);
  EXPECT_EQ(refused([&] { collinear(o, x, Point3{0, 1, nan}); }), "collinear: c.z is nan" + mend);
  EXPECT_EQ(refused([&] { parallel(Vector3{1, 2, -inf}, Vector3{2, 1, 0}); }), "parallel: a.z is -inf" + mend);
  EXPECT_EQ(refused([&] { compare_distance(a, b, nan); }), "distance_against2d: c is nan" + mend);
  EXPECT_EQ(refused([&] { compare_distance(Point2{0, nan}, b, -1.0); }), "distance_against2d: a.y is nan" + mend);
  EXPECT_EQ(refused([&] {
              compare_distance_to_segment(a, Point2{inf, 0}, c, -1.0);
            }),
            "compare_distance_to_segment: b.x is inf" + mend);
  EXPECT_EQ(refused([&] {
              compare_distance_to_segments(o, x, y, o, x, Point3{0, 0, nan});
            }),
            "compare_distance_to_segments: f.z is nan" + mend);
  EXPECT_EQ(refused([&] {
              compare_distance_to_planes(o, o, o, x, o, x, y, Point3{0, nan, 0});
            }),
            "compare_distance_to_planes: h.y is nan" + mend);
  EXPECT_EQ(refused([&] {
              in_smallest_circle(a, b, Point2{2, 0}, Point2{nan, 0});
            }),
            "in_smallest_circle: d.x is nan" + mend);
  EXPECT_EQ(refused([&] { in_power_circle({a, 0}, {b, 0}, {c, 0}, {a, inf}); }), "power_circle: d.w is inf" + mend);
  EXPECT_EQ(refused([&] { side_of_plane(Vector3{0, 0, 0}, nan, o); }), "side_of_plane: b is nan" + mend);
  EXPECT_EQ(refused([&] {
              determinant_sign(Rows<4>{{{0, 0, 0, 0}, {0, 0, 0, nan}}});
            }),
            "determinant4: coordinate 7 is nan" + mend);
}

}  // namespace
}  // namespace plumb::battery
