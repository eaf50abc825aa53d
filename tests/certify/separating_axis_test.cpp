// Is the gap of two boxes along a cross product exact, and do fifteen of them decide whether boxes meet?
#include "plumb/certify/separating_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/space_cases.hpp"
#include "oracle/space.hpp"
#include "plumb/predicates/cross_products.hpp"

namespace plumb::space_cases {
namespace {

using oracle::Box;

constexpr Box unit{{0, 0, 0}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};

Box moved(Box box, double x, double y, double z) {
  box.center = {box.center.x + x, box.center.y + y, box.center.z + z};
  return box;
}

/// All fifteen; those of zero vectors left out.
std::vector<Sign> gaps(const Box& a, const Box& b) {
  std::vector<Sign> all;
  const auto add = [&](std::optional<Sign> s) {
    if (s) all.push_back(*s);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    add(face_gap(a, b, i));
    add(face_gap(b, a, i));
    for (std::size_t j = 0; j < 3; ++j) add(edge_gap(a, b, i, j));
  }
  return all;
}

bool has(const std::vector<Sign>& signs, Sign s) { return std::ranges::find(signs, s) != signs.end(); }

TEST(SeparatingAxisTest, MeansWhatItSays) {
  EXPECT_EQ(face_gap(unit, moved(unit, 2, 0, 0), 0), Sign::zero);
  EXPECT_EQ(face_gap(unit, moved(unit, std::nextafter(2, 3), 0, 0), 0), Sign::positive);
  EXPECT_EQ(face_gap(unit, moved(unit, -std::nextafter(2, 1), 0, 0), 0), Sign::negative);
  EXPECT_EQ(face_gap(unit, moved(unit, 9, 0, 0), 1), Sign::negative);
  EXPECT_EQ(edge_gap(unit, moved(unit, 2, 0, 0), 1, 2), Sign::zero);
  EXPECT_EQ(edge_gap(unit, moved(unit, 2, 0, 0), 1, 1), std::nullopt);  // parallel edges
  Box reversed = moved(unit, 2, 0, 0);
  reversed.half.x = -1;
  reversed.axes[0].x = -1;
  EXPECT_EQ(face_gap(unit, reversed, 0), Sign::zero);
  // Turned by a right angle and 3-4-5: touching along a face, an edge, a corner.
  const Box turned{{7, 1.75, 0}, {Vector3{3, 4, 0}, Vector3{-4, 3, 0}, Vector3{0, 0, 5}}, {1, 0.75, 1}};
  EXPECT_EQ(face_gap(unit, turned, 0), Sign::zero);  // it reaches 3 + 3 from 7
  EXPECT_FALSE(has(gaps(unit, turned), Sign::positive));
  EXPECT_TRUE(has(gaps(unit, moved(turned, 0x1p-50, 0, 0)), Sign::positive));
}

// Two edges that nearly touch: only their cross product separates.
TEST(SeparatingAxisTest, SeesWhatOnlyEdgesSeparate) {
  const Box a{{0, 0, 0}, {Vector3{1, 1, 0}, Vector3{-1, 1, 0}, Vector3{0, 0, 8}}, {1, 1, 1}};  // edge at y = 2
  const Box b{{0, 0, 0}, {Vector3{0, 1, 1}, Vector3{0, -1, 1}, Vector3{8, 0, 0}}, {1, 1, 1}};  // edge along x
  const Box above = moved(b, 0, 4.5, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NE(face_gap(a, above, i), Sign::positive);
    EXPECT_NE(face_gap(above, a, i), Sign::positive);
  }
  EXPECT_EQ(edge_gap(a, above, 2, 2), Sign::positive);
  EXPECT_EQ(edge_gap(a, moved(b, 0, 4, 0), 2, 2), Sign::zero);
  EXPECT_FALSE(oracle::boxes_meet(a, above));
  EXPECT_TRUE(oracle::boxes_meet(a, moved(b, 0, 4, 0)));
}

Box box_of(const std::vector<Point3>& p, std::size_t at, double scale) {
  const auto size = [](double x) { return std::fabs(x); };
  return {{p[at].x * scale, p[at].y * scale, p[at].z * scale},
          {vector(p[at + 1]), vector(p[at + 2]), vector(p[at + 3])},
          {size(p[at + 4].x), size(p[at + 4].y), size(p[at + 4].z)}};
}

bool independent(const Box& b) {
  const auto& [u, v, w] = b.axes;
  using predicates::OrderAlongCross;
  return in_rationals<OrderAlongCross>(gathered<OrderAlongCross>(u, v, Point3{0, 0, 0}, w)) != Sign::zero;
}

TEST(SeparatingAxisTest, FifteenAxesDecideWhetherBoxesMeet) {
  int meet = 0, touch = 0, apart = 0, by_edges_alone = 0;
  on_grids(10, 1500, [&](const std::vector<Point3>& p) {
    const Box a = box_of(p, 0, 2), b = box_of(p, 5, 2);
    if (!independent(a) || !independent(b)) return;
    const auto signs = gaps(a, b);
    ASSERT_EQ(!has(signs, Sign::positive), oracle::boxes_meet(a, b)) << shown(p);
    // Law 1.
    ASSERT_EQ(edge_gap(a, b, 0, 1), edge_gap(b, a, 1, 0)) << shown(p);
    ++(has(signs, Sign::positive) ? apart : has(signs, Sign::zero) ? touch : meet);
    bool face = false;
    for (std::size_t i = 0; i < 3; ++i) {
      face = face || face_gap(a, b, i) == Sign::positive || face_gap(b, a, i) == Sign::positive;
    }
    if (!face && has(signs, Sign::positive)) ++by_edges_alone;
  });
  std::cout << "meet " << meet << ", touch " << touch << ", apart " << apart << ", by edges alone " << by_edges_alone
            << '\n';
  EXPECT_GT(meet, battery::fitting(100));
  EXPECT_GT(touch, battery::fitting(20));
  EXPECT_GT(apart, battery::fitting(100));
  EXPECT_GT(by_edges_alone, battery::fitting(5));
}

// |T . L| - sum of e |w . L| in rationals, from the cross product's coordinates.
std::optional<Sign> truth(const std::vector<Point3>& p, const std::array<double, 4>& half) {
  using Rational3 = std::array<mpq_class, 3>;
  const auto rational = [&](std::size_t i) { return Rational3{p[i].x, p[i].y, p[i].z}; };
  const Rational3 u = rational(2), v = rational(3);
  const Rational3 axis{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  if (axis == Rational3{}) return std::nullopt;
  const auto size = [&](const Rational3& w) {
    return mpq_class(abs(w[0] * axis[0] + w[1] * axis[1] + w[2] * axis[2]));
  };
  const Rational3 a = rational(0), b = rational(1);
  mpq_class gap = size({b[0] - a[0], b[1] - a[1], b[2] - a[2]});
  for (std::size_t k = 0; k < 4; ++k) gap -= abs(mpq_class(half[k])) * size(rational(4 + k));
  return sign_of_number(sgn(gap));
}

TEST(SeparatingAxisTest, IsExact) {
  Shares shares;
  int zero_axes = 0;
  const auto check = [&](const std::vector<Point3>& p, bool small) {
    const double scale = small ? 1 : 0.25;
    const std::array half{p[8].x * scale, p[8].y * scale, p[8].z * scale, p[0].x * scale};
    const auto said = axis_gap(p[0], p[1], vector(p[2]), vector(p[3]),
                               {vector(p[4]), vector(p[5]), vector(p[6]), vector(p[7])}, half);
    ASSERT_EQ(said, truth(p, half)) << shown(p);
    if (said) {
      shares(*said);
    } else {
      ++zero_axes;
    }
  };
  on_grids(9, 6000, [&](const std::vector<Point3>& p) { check(p, true); });
  on_families(9, 500, [&](const std::vector<Point3>& p) { check(p, false); });
  // Centers near another, so that the reach wins as often, and exact contacts: the reach measured in doubles that do
  // not round is set against the distance.
  on_grids(9, 6000, [&](std::vector<Point3> p) {
    p[1] = {p[0].x + p[4].x * p[8].x + p[5].x, p[0].y + p[4].y * p[8].x + p[5].y, p[0].z + p[4].z * p[8].x + p[5].z};
    p[8].y = 1;
    p[8].z = 0;
    check(p, true);
  });
  std::cout << "+ " << shares.of(Sign::positive) << ", 0 " << shares.of(Sign::zero) << ", - "
            << shares.of(Sign::negative) << ", zero axes " << zero_axes << '\n';
  EXPECT_GT(shares.least(), 0.1);
  EXPECT_GT(zero_axes, battery::fitting(500));
}

TEST(SeparatingAxisTest, RefusesWhatIsNoNumber) {
  Box bad = moved(unit, 2, 0, 0);
  bad.half.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)face_gap(unit, bad, 0), NonFinite);
  bad = moved(unit, 9, 0, 0);
  bad.axes[1].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)face_gap(unit, bad, 0), NonFinite);
  EXPECT_THROW((void)edge_gap(bad, unit, 0, 0), NonFinite);
}

}  // namespace
}  // namespace plumb::space_cases
