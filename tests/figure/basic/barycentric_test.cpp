// Barycentric coordinates against rational normal equations, on shapes of every kind; figures 3.9 and 3.10 by hand.
#include "plumb/figure/basic/barycentric.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <map>

#include "figure/basic/rationals.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "oracle/shapes.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

using rationals::exact, rationals::is_nearest, rationals::Vector;
using rationals::operator+, rationals::operator*;
using shape_cases::Material, shape_cases::on_shapes;
using testing::ElementsAre, testing::HasSubstr;

std::vector<Vector> corners(const Segment2& s) { return {exact(s.a), exact(s.b)}; }
std::vector<Vector> corners(const Segment3& s) { return {exact(s.a), exact(s.b)}; }
std::vector<Vector> corners(const Triangle2& s) { return {exact(s.a), exact(s.b), exact(s.c)}; }
std::vector<Vector> corners(const Triangle3& s) { return {exact(s.a), exact(s.b), exact(s.c)}; }
std::vector<Vector> corners(const Tetrahedron3& s) { return {exact(s.a), exact(s.b), exact(s.c), exact(s.d)}; }

struct Seen {
  int flat = 0, beyond = 0, on_a_line = 0, within = 0, outside = 0;
};

template <class Shape, class Point>
void check(const Material& m, const Shape& shape, const Point& p, Seen& seen) {
  SCOPED_TRACE(m.about(shape, p));
  const auto weights = rationals::weights_of(corners(shape), exact(p));
  if (!weights) {
    ++seen.flat;
    EXPECT_THROW(barycentric(shape, p), InvalidShape);
    EXPECT_THROW(barycentric_signs(shape, p), InvalidShape);
    return;
  }
  const auto signs = barycentric_signs(shape, p);
  const auto made = exact_barycentric(shape, p, [](double x) { return BigRational{mpq_class(x)}; });
  bool zero = false, negative = false, beyond = false;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const mpq_class& w = (*weights)[i];
    EXPECT_EQ(static_cast<int>(signs[i]), sgn(w));
    EXPECT_EQ(made.coordinate[i].value / made.weight.value, w);
    zero |= w == 0;
    negative |= w < 0;
    beyond |= rationals::overflows(w);
  }
  ++(zero ? seen.on_a_line : negative ? seen.outside : seen.within);
  if (beyond) {
    ++seen.beyond;
    EXPECT_THROW(barycentric(shape, p), BeyondDoubles);
    return;
  }
  const auto told = barycentric(shape, p);
  for (std::size_t i = 0; i < signs.size(); ++i) EXPECT_TRUE(is_nearest(told[i], (*weights)[i])) << told[i];
}

template <class Shape, class Point>
void check_shapes(std::uint64_t start) {
  Seen seen;
  on_shapes(start, 1500, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    check(m, shape, m.probe<Point>(), seen);
  });
  EXPECT_GT(seen.flat, 50);
  EXPECT_GT(seen.on_a_line, 50);
  EXPECT_GT(seen.within, 5);
  EXPECT_GT(seen.outside, 200);
}

TEST(BarycentricTest, OfSegments) {
  check_shapes<Segment2, Point2>(11);
  check_shapes<Segment3, Point3>(12);
}
TEST(BarycentricTest, OfTriangles) {
  check_shapes<Triangle2, Point2>(13);
  check_shapes<Triangle3, Point3>(14);
}
TEST(BarycentricTest, OfTetrahedra) { check_shapes<Tetrahedron3, Point3>(15); }

// Permuting corners permutes coordinates, bit for bit.
TEST(BarycentricTest, PermutesWithTheCorners) {
  on_shapes(16, 300, [](Material& m) {
    const auto t = m.shape<Triangle3>();
    const Point3 p = m.probe3();
    std::array<double, 3> x{};
    try {
      x = barycentric(t, p);
    } catch (const Error&) {
      return;
    }
    EXPECT_THAT(barycentric(Triangle3{t.b, t.a, t.c}, p), ElementsAre(x[1], x[0], x[2])) << m.about(t, p);
    EXPECT_THAT(barycentric(Triangle3{t.c, t.a, t.b}, p), ElementsAre(x[2], x[0], x[1])) << m.about(t, p);
  });
}

// For points of the plane, areas and all projections agree; the exact numbers do, so the nearest doubles do.
TEST(BarycentricTest, AreasAndProjectionAgreeInThePlane) {
  int in_plane = 0, seen_as_line = 0, off_plane = 0;
  on_shapes(17, 4000, [&](Material& m) {
    const auto t = m.shape<Triangle3>();
    const Point3 p = m.probe3();
    std::array<double, 3> by_areas{};
    try {
      by_areas = barycentric(t, p);
    } catch (const Error&) {
      return;
    }
    const auto weights = rationals::weights_of(corners(t), exact(p));
    const auto c = corners(t);
    const Vector nearest = (*weights)[0] * c[0] + (*weights)[1] * c[1] + (*weights)[2] * c[2];
    if (nearest != exact(p)) {
      ++off_plane;
      return;
    }
    ++in_plane;
    EXPECT_EQ(barycentric_by_projection(t, p), by_areas) << m.about(t, p);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      try {
        EXPECT_EQ(barycentric_along_axis(t, p, axis), by_areas) << m.about(t, p) << axis;
      } catch (const InvalidShape& e) {
        ++seen_as_line;
        EXPECT_THAT(e.what(), HasSubstr("take another axis"));
      }
    }
  });
  EXPECT_GT(in_plane, 300);
  EXPECT_GT(off_plane, 300);
  EXPECT_GT(seen_as_line, 30);
}

TEST(BarycentricTest, ProjectionOffThePlaneIsAlongTheAxis) {
  const Triangle3 t{{0, 0, 0}, {4, 0, 4}, {0, 4, 0}};  // seen equally large along x and z; x comes first
  EXPECT_THAT(barycentric_along_axis(t, {1, 1, 9}, 2), ElementsAre(0.5, 0.25, 0.25));
  EXPECT_THAT(barycentric_along_axis(t, {9, 1, 1}, 0), ElementsAre(0.5, 0.25, 0.25));
  EXPECT_EQ(barycentric_by_projection(t, {9, 1, 1}), barycentric_along_axis(t, {9, 1, 1}, 0));
  EXPECT_THAT(barycentric(t, {2, 1, 0}), ElementsAre(0.5, 0.25, 0.25));  // perpendicular to the plane
  EXPECT_THROW(barycentric_along_axis(t, {1, 1, 1}, 1), InvalidShape);
  EXPECT_THROW(barycentric_along_axis(t, {1, 1, 1}, 3), InvalidShape);
}

// Figure 3.9: a coordinate is the height over its edge, one at the corner.
TEST(BarycentricTest, IsTheHeightOverTheEdge) {
  const Triangle2 t{{0, 6}, {-3, 0}, {3, 0}};
  EXPECT_THAT(barycentric(t, t.a), ElementsAre(1, 0, 0));
  EXPECT_THAT(barycentric(t, t.b), ElementsAre(0, 1, 0));
  EXPECT_THAT(barycentric(t, t.c), ElementsAre(0, 0, 1));
  for (const double x : {-100.0, 0.0, 7.0}) {
    EXPECT_EQ(barycentric(t, Point2{x, 0})[0], 0);
    EXPECT_EQ(barycentric(t, Point2{x, 6})[0], 1);
    EXPECT_EQ(barycentric(t, Point2{x, 3})[0], 0.5);
    EXPECT_EQ(barycentric(t, Point2{x, -6})[0], -1);
  }
  const double third = 1.0 / 3;
  EXPECT_THAT(barycentric(t, Point2{0, 2}), ElementsAre(third, third, third));
}

// Figure 3.10: seven regions by the signs, for both senses of turning, and closed where the triangle is.
TEST(BarycentricTest, SevenRegions) {
  using enum BarycentricRegion;
  for (const bool turned : {false, true}) {
    const Triangle2 t{{0, 0}, turned ? Point2{0, 4} : Point2{4, 0}, turned ? Point2{4, 0} : Point2{0, 4}};
    const auto at = [&](double along_b, double along_c) {
      return turned ? Point2{along_c, along_b} : Point2{along_b, along_c};
    };
    const std::map<BarycentricRegion, Point2> inside_of{
        {triangle, at(1, 1)},   {beyond_bc, at(3, 3)}, {beyond_ca, at(-1, 2)}, {beyond_ab, at(2, -1)},
        {beyond_a, at(-1, -1)}, {beyond_b, at(6, -1)}, {beyond_c, at(-1, 6)}};
    for (const auto& [region, p] : inside_of) {
      EXPECT_EQ(barycentric_region(t, p), region);
      const auto lift = [](const Point2& q) { return Point3{q.x, 5, q.y}; };
      EXPECT_EQ(barycentric_region(Triangle3{lift(t.a), lift(t.b), lift(t.c)}, Point3{p.x, -77, p.y}), region);
    }
    for (const Point2& p : {t.a, t.b, t.c, at(2, 2), at(0, 2), at(2, 0)}) EXPECT_EQ(barycentric_region(t, p), triangle);
    EXPECT_EQ(barycentric_region(t, at(5, 0)), beyond_bc);  // on the line ab: that coordinate counts as not negative
    EXPECT_EQ(barycentric_region(t, at(-1, 0)), beyond_ca);
  }
}

TEST(BarycentricTest, CenterOfGravity) {
  int beyond = 0, none = 0, made = 0;
  on_shapes(18, 2000, [&](Material& m) {
    const auto t = m.shape<Tetrahedron3>();
    const std::array<double, 4> w{m.multiple(), m.multiple(), m.multiple(), m.multiple()};
    SCOPED_TRACE(m.about(t, w));
    const mpq_class sum = mpq_class(w[0]) + mpq_class(w[1]) + mpq_class(w[2]) + mpq_class(w[3]);
    if (sum == 0) {
      ++none;
      EXPECT_THROW(from_barycentric(t, w), DegeneratePoint);
      return;
    }
    Vector center(3);
    for (std::size_t i = 0; i < 4; ++i) center = center + mpq_class(w[i]) * corners(t)[i];
    bool finite = true;
    for (mpq_class& x : center) {
      x /= sum;
      finite &= !rationals::overflows(x);
    }
    if (!finite) {
      ++beyond;
      EXPECT_THROW(from_barycentric(t, w), BeyondDoubles);
      return;
    }
    ++made;
    const auto told = coordinates(from_barycentric(t, w));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(is_nearest(told[i], center[i])) << told[i];
  });
  EXPECT_GT(made, 1000);
  EXPECT_GT(none, 10);
  int by_cgal = 0;
  on_shapes(19, 500, [&](Material& m) {
    const auto t = m.shape<Triangle3>();
    const auto flat = m.shape<Triangle2>();
    const std::array<double, 3> w{m.multiple(), m.multiple(), m.multiple()};
    try {
      EXPECT_TRUE(oracle::is_barycenter(t, w, from_barycentric(t, w))) << m.about(t, w);
      EXPECT_TRUE(oracle::is_barycenter(flat, w, from_barycentric(flat, w))) << m.about(flat, w);
      ++by_cgal;
    } catch (const Error&) {  // no weight at all, or beyond all doubles
    }
  });
  EXPECT_GT(by_cgal, 300);
  EXPECT_EQ(from_barycentric(Segment2{{0, 0}, {3, 6}}, {2, 1}), (Point2{1, 2}));
  EXPECT_EQ(from_barycentric(Segment3{{0, 0, 0}, {3, 6, 9}}, {2, 1}), (Point3{1, 2, 3}));
  EXPECT_EQ(from_barycentric(Triangle2{{0, 0}, {3, 0}, {0, 3}}, {1, 1, 1}), (Point2{1, 1}));
  EXPECT_EQ(from_barycentric(Triangle3{{0, 0, 0}, {3, 0, 0}, {0, 3, 3}}, {-1, 1, 1}), (Point3{3, 3, 3}));
}

TEST(BarycentricTest, BadInputIsNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Triangle2 t{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(text_of<NonFinite>([&] {
              barycentric(Triangle2{t.a, {1, nan}, t.c}, Point2{0, 0});
            }),
            "barycentric: triangle.b.y is nan, not a real number; give a finite double");
  EXPECT_THAT(text_of<NonFinite>([&] {
                barycentric_signs(t, Point2{inf, 0});
              }),
              HasSubstr("barycentric_signs: p.x is inf"));
  EXPECT_THAT(text_of<NonFinite>([&] { from_barycentric(t, {1, 1, -inf}); }), HasSubstr("weights[2] is -inf"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                barycentric_by_projection({{0, 0, nan}, {}, {}}, {});
              }),
              HasSubstr("triangle.a.z is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                barycentric(Triangle2{t.a, t.b, {7, 0}}, Point2{0, 0});
              }),
              HasSubstr("lie on one line"));
  EXPECT_THAT(text_of<InvalidShape>([&] { barycentric(Segment3{}, Point3{}); }), HasSubstr("ends of the segment"));
  EXPECT_THAT(text_of<InvalidShape>([&] { barycentric_signs(Tetrahedron3{}, Point3{}); }), HasSubstr("in one plane"));
  EXPECT_THAT(text_of<BeyondDoubles>([&] {
                barycentric(Segment2{{0, 0}, {0x1p-1074, 0}}, Point2{1, 0});
              }),
              HasSubstr("the coordinate of corner a is beyond"));
}

}  // namespace
}  // namespace plumb
