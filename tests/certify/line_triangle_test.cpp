// Are the edge signs of the ray-triangle test exact, do they mean what they say, and does no line slip through an edge?
#include "plumb/certify/line_triangle.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "certify/space_cases.hpp"
#include "oracle/space.hpp"
#include "plumb/certify/coplanar.hpp"

namespace plumb::space_cases {
namespace {

using predicates::LineEdge, predicates::OrientSeenAlong, predicates::OrientSeenFrom;

constexpr Point3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};  // counterclockwise from above
constexpr Sign plus = Sign::positive, zero = Sign::zero, minus = Sign::negative;

TEST(LineTriangleTest, MeansWhatItSays) {
  const Vector3 down{0, 0, -3};
  EXPECT_EQ(edge_signs(Point3{1, 1, 5}, down, a, b, c), (EdgeSigns{plus, plus, plus}));
  EXPECT_EQ(edge_signs(Point3{1, 1, -5}, Vector3{0, 0, 3}, a, b, c), (EdgeSigns{minus, minus, minus}));
  EXPECT_EQ(edge_signs(Point3{1, 0, 5}, down, a, b, c), (EdgeSigns{zero, plus, plus}));
  EXPECT_EQ(edge_signs(Point3{2, 2, 5}, down, a, b, c), (EdgeSigns{plus, zero, plus}));
  EXPECT_EQ(edge_signs(Point3{0, 4, 5}, down, a, b, c), (EdgeSigns{plus, zero, zero}));
  EXPECT_EQ(edge_signs(Point3{1, -1, 5}, down, a, b, c), (EdgeSigns{minus, plus, plus}));
  EXPECT_EQ(edge_signs(Point3{1, 1, 0}, Vector3{1, 5, 0}, a, b, c), (EdgeSigns{zero, zero, zero}));
  EXPECT_EQ(edge_signs(Point3{1, 1, 5}, Point3{1, 1, 4}, a, b, c), (EdgeSigns{plus, plus, plus}));
  EXPECT_TRUE((EdgeSigns{plus, zero, plus}).agree());
  EXPECT_TRUE((EdgeSigns{zero, zero, zero}).agree());
  EXPECT_FALSE((EdgeSigns{plus, zero, minus}).agree());
}

TEST(LineTriangleTest, AgreesWithCgalOnGrids) {
  int met = 0, missed = 0, touched = 0;
  on_grids(5, 20'000, [&](const std::vector<Point3>& p) {
    const auto truth = oracle::line_meets_triangle(p[0], vector(p[1]), {p[2], p[3], p[4]});
    if (!truth) return;
    const EdgeSigns signs = edge_signs(p[0], vector(p[1]), p[2], p[3], p[4]);
    ASSERT_EQ(signs.agree(), *truth) << shown(p);
    ++(*truth ? met : missed);
    if (*truth && signs.ab * signs.bc * signs.ca == zero) ++touched;
    // On a grid the second point is exact, and the line through both is the same.
    const Point3 q{p[0].x + p[1].x, p[0].y + p[1].y, p[0].z + p[1].z};
    ASSERT_EQ(edge_signs(p[0], q, p[2], p[3], p[4]), signs) << shown(p);
    // Law 4, and the other sides of the edges.
    ASSERT_EQ(edge_signs(q, p[0], p[2], p[3], p[4]), -signs) << shown(p);
    ASSERT_EQ(line_edge(p[0], vector(p[1]), p[3], p[2]), -signs.ab) << shown(p);
    const Sign side = orient_seen_from(vector(p[1]), p[2], p[3], p[4]);
    ASSERT_EQ(decide<OrientSeenAlong>(gathered<OrientSeenAlong>(p[0], q, p[2], p[3], p[4])), side) << shown(p);
    if (signs.ab == plus && signs.bc == plus && signs.ca == plus) {
      ASSERT_EQ(side, minus) << shown(p);
    }
  });
  std::cout << "met " << met << ", of these at an edge " << touched << ", missed " << missed << '\n';
  EXPECT_GT(met, battery::fitting(1000));
  EXPECT_GT(missed, battery::fitting(1000));
  EXPECT_GT(touched, battery::fitting(500));
}

TEST(LineTriangleTest, IsExactOnEveryFamily) {
  Shares edges, facing, along;
  on_families(5, 1500, [&](const std::vector<Point3>& p) {
    const auto line = gathered<LineEdge>(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(line_edge(p[0], vector(p[1]), p[2], p[3]), edges(in_rationals<LineEdge>(line))) << shown(p);
    ASSERT_EQ(line_edge(p[0], vector(p[1]), p[3], p[2]), -in_rationals<LineEdge>(line)) << shown(p);
    const auto seen = gathered<OrientSeenFrom>(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(orient_seen_from(vector(p[0]), p[1], p[2], p[3]), facing(in_rationals<OrientSeenFrom>(seen))) << shown(p);
    const auto five = gathered<OrientSeenAlong>(p[0], p[1], p[2], p[3], p[4]);
    ASSERT_EQ(decide<OrientSeenAlong>(five), along(in_rationals<OrientSeenAlong>(five))) << shown(p);
  });
  EXPECT_GT(edges.least(), 0.1);
  EXPECT_GT(facing.least(), 0.1);
  EXPECT_GT(along.least(), 0.1);
}

// The three values of a triangle add up to minus direction . normal; each is orient3d of the line's points.
TEST(LineTriangleTest, ValuesAddUp) {
  on_families(5, 50, [&](const std::vector<Point3>& p) {
    const auto value = [&]<class F>(F, const auto&... t) {
      const auto x = gathered<F>(t...);
      return evaluate<F>([&](std::size_t i) { return big_rational(x[i]); }).value;
    };
    const LineEdge edge;
    const mpq_class sum =
        value(edge, p[0], p[1], p[2], p[3]) + value(edge, p[0], p[1], p[3], p[4]) + value(edge, p[0], p[1], p[4], p[2]);
    ASSERT_TRUE(sum == -value(OrientSeenFrom{}, p[1], p[2], p[3], p[4])) << shown(p);
    const predicates::Orient3d orient;
    const mpq_class by_points = value(orient, p[0], p[1], p[2], p[3]) + value(orient, p[0], p[1], p[3], p[4]) +
                                value(orient, p[0], p[1], p[4], p[2]);
    ASSERT_TRUE(by_points == -value(OrientSeenAlong{}, p[0], p[1], p[2], p[3], p[4])) << shown(p);
  });
}

TEST(LineTriangleTest, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(edge_signs(Point3{1, 1, nan}, Vector3{0, 0, 1}, a, b, c), NonFinite);
  EXPECT_THROW(edge_signs(Point3{1, 1, 1}, Vector3{0, infinity, 1}, a, b, c), NonFinite);
  EXPECT_THROW(edge_signs(Point3{1, 1, 1}, Point3{0, 0, 1}, a, b, Point3{0, nan, 0}), NonFinite);
}

}  // namespace
}  // namespace plumb::space_cases
