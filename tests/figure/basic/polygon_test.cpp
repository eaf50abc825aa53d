// Polygons: the figures of RTCD 3.7, and random ones against rationals and CGAL.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "figure/basic/rational_polygon.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "oracle/polygons.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/containment/polygon_location.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using shape_cases::on_shapes;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Five points of a regular pentagon, rounded to integers, in the order of a star.
const std::vector<Point2> kPentagram{{0, 100}, {59, -81}, {-95, 31}, {95, 31}, {-59, -81}};

TEST(Figure3_13, SimpleAndNot) {
  const Polygon2 simple{{{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}}};
  EXPECT_EQ(locate(simple, {2, 0.5}), Location::inside);
  EXPECT_EQ(locate(simple, {2, 2}), Location::outside);
  EXPECT_EQ(locate(simple, {2, 1}), Location::boundary);
  EXPECT_EQ(winding_number(simple, {1, 1}), 1);
  const Polygon2 crossing{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}};
  EXPECT_EQ(locate(crossing, {1, 2}), Location::inside);
  EXPECT_EQ(locate(crossing, {2, 1}), Location::outside);
  EXPECT_EQ(locate(crossing, {2, 2}), Location::boundary);
  EXPECT_EQ(winding_number(crossing, {3, 2}), -1);
  EXPECT_EQ(winding_number(crossing, {3, 3}), std::nullopt);
  EXPECT_EQ(winding_number(crossing, {1, 2}), 1);
}

TEST(Figure3_14, ConvexAndConcave) {
  EXPECT_EQ(convexity(Polygon2{{{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}}}),
            (PolygonConvexity{PolygonKind::strictly_convex, Sign::positive, 1}));
  const PolygonConvexity notched = convexity(Polygon2{{{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}}});
  EXPECT_EQ(notched, (PolygonConvexity{PolygonKind::concave, Sign::positive, 0}));
  EXPECT_FALSE(notched.is_convex());
}

TEST(Figure3_16, ATriangleOfThreeHalfspaces) {
  const Polygon2 triangle{{{1, 2}, {9, 0}, {5, 8}}};
  for (int x = -1; x <= 10; ++x) {
    for (int y = -1; y <= 9; ++y) {
      const int least = std::min({x + 4 * y - 9, 36 - 4 * x - 2 * y, 3 * x - 2 * y + 1});
      EXPECT_EQ(static_cast<int>(locate(triangle, {double(x), double(y)})), (least > 0) - (least < 0));
    }
  }
}

TEST(Figure3_17, FourKindsOfQuadrilaterals) {
  const auto everywhere = [](const Quadrilateral2& q, QuadrilateralKind kind) {
    const std::array<Point2, 4> p{q.a, q.b, q.c, q.d};
    for (std::size_t k = 0; k < 4; ++k) {  // from every corner, both ways, in the plane and in three planes of space
      const Quadrilateral2 on{p[k], p[(k + 1) % 4], p[(k + 2) % 4], p[(k + 3) % 4]}, back{on.d, on.c, on.b, on.a};
      for (const Quadrilateral2& r : {on, back}) {
        EXPECT_EQ(quadrilateral_kind(r), kind);
        EXPECT_EQ(is_convex(r), kind == QuadrilateralKind::convex);
        const auto lifted = [&](auto lift) {
          const Quadrilateral3 s{lift(r.a), lift(r.b), lift(r.c), lift(r.d)};
          EXPECT_EQ(quadrilateral_kind(s), kind);
          EXPECT_EQ(is_convex(s), kind == QuadrilateralKind::convex);
          EXPECT_EQ(diagonals_part(s), kind == QuadrilateralKind::convex);
          EXPECT_TRUE(is_planar(s));
        };
        lifted([](const Point2& v) { return Point3{v.x, v.y, v.x + 2 * v.y}; });
        lifted([](const Point2& v) { return Point3{5, v.x, v.y}; });
        lifted([](const Point2& v) { return Point3{v.y, 1, v.x}; });
      }
    }
  };
  everywhere({{0, 1}, {2, 0}, {4, 1}, {2, 3}}, QuadrilateralKind::convex);
  everywhere({{0, 0}, {2, 1}, {4, 0}, {2, 3}}, QuadrilateralKind::concave);
  everywhere({{0, 0}, {4, 3}, {4, 0}, {0, 3}}, QuadrilateralKind::bowtie);
  everywhere({{0, 0}, {3, 0}, {2, 0}, {1, 0}}, QuadrilateralKind::degenerate);
  everywhere({{2, 2}, {2, 2}, {2, 2}, {2, 2}}, QuadrilateralKind::degenerate);
  everywhere({{0, 0}, {2, 0}, {4, 0}, {2, 3}}, QuadrilateralKind::three_collinear);
  everywhere({{0, 0}, {2, 0}, {2, 0}, {2, 3}}, QuadrilateralKind::three_collinear);
  everywhere({{0, 0}, {2, 0}, {0, 0}, {2, 3}}, QuadrilateralKind::three_collinear);
  const Quadrilateral3 skew{{0, 0, 0}, {1, 0, 0x1p-1074}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(quadrilateral_kind(skew), QuadrilateralKind::not_planar);
  EXPECT_FALSE(is_planar(skew));
  EXPECT_FALSE(is_convex(skew));
  EXPECT_TRUE(diagonals_part(skew));
  EXPECT_FALSE(diagonals_part({{0, 0, 0}, {1, 0, 3}, {1, 1, 0}, {0, 1, 3}}));  // folded by more than a right angle
}

TEST(Figure3_18, HardInputs) {
  const auto kind = [](const std::vector<Point2>& v) { return convexity(Polygon2{v}); };
  using K = PolygonKind;
  EXPECT_EQ(kind({{0, 0}, {2, 2}, {5, 5}, {1, 1}}), (PolygonConvexity{K::degenerate, Sign::zero, 0}));
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {4, 0}, {0, 3}}), (PolygonConvexity{K::convex, Sign::positive, 1}));
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {0, 3}, {0, 0}}), (PolygonConvexity{K::convex, Sign::positive, 1}));
  EXPECT_EQ(kind(kPentagram), (PolygonConvexity{K::self_winding, Sign::negative, 2}));
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {1, 3}, {0, 3}}), (PolygonConvexity{K::convex, Sign::positive, 1}));
  // A triangle passed twice; a spike; there and back on two sides of a corner.
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {0, 3}, {0, 0}, {4, 0}, {0, 3}}),
            (PolygonConvexity{K::self_winding, Sign::positive, 2}));
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {6, 0}, {4, 0}, {0, 3}}).kind, K::concave);
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {0, 0}, {0, 3}}), (PolygonConvexity{K::concave, Sign::zero, 0}));
  EXPECT_EQ(kind({{1, 1}, {1, 1}, {1, 1}}).kind, K::degenerate);
  // The pentagram: its core is wound around twice, so it is outside by the rule of odd turns.
  EXPECT_EQ(winding_number(Polygon2{kPentagram}, {0, 0}), -2);
  EXPECT_EQ(locate(Polygon2{kPentagram}, {0, 0}), Location::outside);
  EXPECT_EQ(locate(Polygon2{kPentagram}, {0, 90}), Location::inside);
}

// Exact points of one circle (products of Gaussian integers), by their angle.
std::vector<Point2> exact_circle(double radius_squared, std::int64_t radius) {
  std::vector<Point2> upper;
  for (std::int64_t x = radius; x >= -radius; --x) {
    const double rest = radius_squared - static_cast<double>(x * x), y = std::floor(std::sqrt(rest));
    if (y * y == rest) upper.push_back({static_cast<double>(x), y});
  }
  std::vector<Point2> all = upper;
  for (std::size_t k = upper.size(); k-- > 0;) {
    if (upper[k].y != 0) all.push_back({upper[k].x, -upper[k].y});
  }
  return all;
}

TEST(Figure3_18, ThousandsOfCocircularPoints) {
  // 5 * 13 * 17 * 29 * 37 squared has 4 * 3^5 = 972 points.
  const std::vector<Point2> exact = exact_circle(1185665.0 * 1185665.0, 1185665);
  ASSERT_EQ(exact.size(), 972u);
  EXPECT_EQ(convexity(Polygon2{exact}), (PolygonConvexity{PolygonKind::strictly_convex, Sign::positive, 1}));
  std::vector<Point2> rounded;
  for (int k = 0; k < 5000; ++k)
    rounded.push_back({std::cos(k * 0x1.921fb54442d18p+2 / 5000), std::sin(k * 0x1.921fb54442d18p+2 / 5000)});
  EXPECT_EQ(convexity(Polygon2{rounded}).kind, PolygonKind::strictly_convex);
  // So near to one another that rounding decides: whatever is said, brute force says it.
  std::map<PolygonKind, int> seen;
  for (const double radius : {0x1p-1060, 0x1p-1066, 1e8, 3e5, 1.0}) {
    std::vector<Point2> near;
    for (int k = 0; k < 120; ++k) {
      const double angle = radius == 1 ? 0.7 + k * 1e-9 : k * 0x1.921fb54442d18p+2 / 120;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      near.push_back(radius == 3e5 ? Point2{std::round(x), std::round(y)} : Point2{x, y});
    }
    const PolygonConvexity said = convexity(Polygon2{near});
    EXPECT_EQ(said, plumb_test::convexity(near)) << radius;
    ++seen[said.kind];
  }
  EXPECT_GE(seen.size(), 2u);
  // One of thousands moved inward by an ulp, two swapped, one repeated, one on an edge.
  std::vector<Point2> moved = rounded;
  moved[1234].x = std::nextafter(moved[1234].x, -moved[1234].x);
  EXPECT_EQ(convexity(Polygon2{moved}).kind, PolygonKind::strictly_convex);  // far less than the sagitta
  std::vector<Point2> swapped = exact;
  std::swap(swapped[500], swapped[501]);
  EXPECT_EQ(convexity(Polygon2{swapped}).kind, PolygonKind::concave);
  std::vector<Point2> again = exact;
  again.insert(again.begin() + 500, exact[500]);
  EXPECT_EQ(convexity(Polygon2{again}).kind, PolygonKind::convex);
  std::vector<Point2> twice = exact;
  twice.insert(twice.end(), exact.begin(), exact.end());
  EXPECT_EQ(convexity(Polygon2{twice}), (PolygonConvexity{PolygonKind::self_winding, Sign::positive, 2}));
  std::vector<Point2> star;
  for (std::size_t k = 0; k < exact.size(); ++k) star.push_back(exact[k * 385 % exact.size()]);
  EXPECT_EQ(convexity(Polygon2{star}).kind, PolygonKind::self_winding);
  EXPECT_EQ(convexity(Polygon2{star}).turns, 385);
}

TEST(Convexity, IsThatOfTheDefinition) {
  std::map<PolygonKind, int> seen;
  int simple = 0;
  on_shapes(31, 6000, [&](Material& m) {
    Polygon2 polygon = m.shape<Polygon2>();
    const bool star = m.below(3) == 0;
    if (star) {  // more convex ones: a rounded regular star polygon, with some vertices repeated
      const std::size_t n = 3 + m.below(8), step = 1 + m.below(3);
      polygon.vertices.clear();
      for (std::size_t k = 0; k < n; ++k) {
        const double angle = 6.283185307179586 * static_cast<double>(k * step) / static_cast<double>(n);
        const double scale = m.below(2) == 0 ? 4 : 100;
        polygon.vertices.push_back({std::round(scale * std::cos(angle)), std::round(scale * std::sin(angle))});
        if (m.below(6) == 0) polygon.vertices.push_back(polygon.vertices.back());
      }
    }
    const PolygonConvexity said = convexity(polygon), truth = plumb_test::convexity(polygon.vertices);
    EXPECT_EQ(said, truth) << m.about();
    ++seen[said.kind];
    const Sign area = Sign{static_cast<signed char>(sgn(plumb_test::twice_area(polygon.vertices)))};
    EXPECT_EQ(orientation(polygon), area) << m.about();
    if (const auto cgal = oracle::simple_polygon(polygon.vertices, {0, 0})) {
      ++simple;
      EXPECT_EQ(said.is_convex(), cgal->convex) << m.about();
      EXPECT_EQ(orientation(polygon), cgal->orientation) << m.about();
      EXPECT_EQ(said.orientation, cgal->orientation) << m.about();
    }
    // Law 2; and the same polygon in space.
    Polygon2 turned = polygon, reversed{{polygon.vertices.rbegin(), polygon.vertices.rend()}};
    std::rotate(turned.vertices.begin(), turned.vertices.begin() + 2, turned.vertices.end());
    EXPECT_EQ(convexity(turned), said) << m.about();
    EXPECT_EQ(convexity(reversed), (PolygonConvexity{said.kind, -said.orientation, said.turns})) << m.about();
    Polygon3 wall, table;
    for (const Point2& v : polygon.vertices) {
      wall.vertices.push_back({3, v.x, v.y});
      table.vertices.push_back({v.x, v.y, v.x});
    }
    EXPECT_EQ(convexity(wall), said) << m.about();
    EXPECT_EQ(convexity(table), said) << m.about();
  });
  for (const PolygonKind kind : {PolygonKind::strictly_convex, PolygonKind::convex, PolygonKind::concave,
                                 PolygonKind::self_winding, PolygonKind::degenerate})
    EXPECT_GE(seen[kind], 60) << static_cast<int>(kind);
  EXPECT_GE(simple, 500);
}

TEST(Location, OfLongChainsIsThatOfRationals) {
  // Longer than what is looked at together, with corners and edges as high as p at either end of it.
  std::array<int, 3> seen{};
  for (std::uint64_t index = 0; index < 3000; ++index) {
    Entropy entropy(33, index);
    const std::int64_t most = std::int64_t{1} << (1 + entropy.below(9));
    const double scale = entropy.below(4) == 0 ? std::ldexp(1, static_cast<int>(entropy.within(1000))) : 0.1;
    const auto any = [&] {
      return Point2{scale * static_cast<double>(entropy.within(most)),
                    scale * static_cast<double>(entropy.within(most))};
    };
    Polygon2 polygon;
    for (std::size_t n = 3 + entropy.below(200); n-- > 0;) {
      if (entropy.below(4) == 0 && !polygon.vertices.empty()) {
        const Point2 last = polygon.vertices.back();  // a level edge, or an upright one
        polygon.vertices.push_back(entropy.coin() ? Point2{any().x, last.y} : Point2{last.x, any().y});
      } else {
        polygon.vertices.push_back(any());
      }
    }
    const Point2 p = entropy.below(4) == 0 ? polygon.vertices[entropy.below(polygon.vertices.size())] : any();
    const auto exact = plumb_test::winding(polygon.vertices, p);
    EXPECT_EQ(winding_number(polygon, p), exact) << index;
    const Location said = locate(polygon, p);
    EXPECT_EQ(said, !exact ? Location::boundary : *exact % 2 != 0 ? Location::inside : Location::outside) << index;
    ++seen[static_cast<std::size_t>(static_cast<int>(said) + 1)];
  }
  for (const int n : seen) EXPECT_GE(n, 300);
}

TEST(Location, OfAnyPolygonIsByOddTurns) {
  std::map<Location, int> seen;
  on_shapes(32, 8000, [&](Material& m) {
    const auto polygon = m.shape<HoledPolygon2>();
    const Point2 p = m.probe2();
    std::vector<std::span<const Point2>> chains{polygon.outer.vertices};
    for (const Polygon2& hole : polygon.holes) chains.emplace_back(hole.vertices);
    const Location said = locate(polygon, p);
    EXPECT_EQ(said, plumb_test::location(chains, p)) << m.about(p);
    EXPECT_EQ(contains(polygon, p), said != Location::outside);
    ++seen[said];
    EXPECT_EQ(winding_number(polygon.outer, p), plumb_test::winding(polygon.outer.vertices, p)) << m.about(p);
    if (const auto cgal = oracle::simple_polygon(polygon.outer.vertices, p)) {
      EXPECT_EQ(locate(polygon.outer, p), cgal->location) << m.about(p);
    }
    const auto q = m.shape<Quadrilateral2>();
    const Point2 r = m.probe2();
    EXPECT_EQ(locate(q, r), locate(Polygon2{{q.a, q.b, q.c, q.d}}, r)) << m.about(q, r);
    // In a plane of space, and beside it.
    const auto lift = [](const Point2& v) { return Point3{v.y, v.x, v.x}; };
    HoledPolygon3 lifted;
    for (const Point2& v : polygon.outer.vertices) lifted.outer.vertices.push_back(lift(v));
    for (const Polygon2& hole : polygon.holes) {
      lifted.holes.emplace_back();
      for (const Point2& v : hole.vertices) lifted.holes.back().vertices.push_back(lift(v));
    }
    EXPECT_EQ(locate_in_plane(lifted, lift(p)), said) << m.about(p);
    EXPECT_EQ(locate(lifted, lift(p)), said == Location::outside ? Location::outside : Location::boundary);
    const Point3 beside{p.y, p.x, std::nextafter(p.x, 1e308)};
    EXPECT_EQ(locate_in_plane(lifted, beside), Location::outside) << m.about(p);
    EXPECT_FALSE(contains(lifted, beside));
  });
  EXPECT_GE(seen[Location::outside], 1000);
  EXPECT_GE(seen[Location::boundary], 1000);
  EXPECT_GE(seen[Location::inside], 300);
}

TEST(Location, OfCocircularPolygons) {
  const Polygon2 circle{exact_circle(1185665.0 * 1185665.0, 1185665)};
  for (std::size_t k = 0; k < circle.vertices.size(); ++k) {
    const Point2 v = circle.vertices[k];
    EXPECT_EQ(locate(circle, v), Location::boundary);
    EXPECT_EQ(locate(circle, {std::nextafter(v.x, 0), v.y}), v.x == 0 ? Location::boundary : Location::inside) << k;
    EXPECT_EQ(locate(circle, {v.x, std::nextafter(v.y, v.y * 2)}), v.y == 0 ? Location::boundary : Location::outside)
        << k;
  }
}

TEST(Location, InSpaceOnOneLineIsOnTheChain) {
  std::map<Location, int> seen;
  on_shapes(33, 500, [&](Material& m) {
    const auto along = [&] { return static_cast<double>(static_cast<int>(m.below(9)) - 4); };
    const auto at = [](double t) { return Point3{1 + t, 2 - 2 * t, 3 * t}; };
    Polygon3 polygon;
    double least = 9, most = -9;
    for (int k = 0; k < 4; ++k) {
      const double t = along();
      least = std::min(least, t), most = std::max(most, t);
      polygon.vertices.push_back(at(t));
    }
    const double t = along();
    const Location said = locate_in_plane(polygon, at(t));
    EXPECT_EQ(said, least <= t && t <= most ? Location::boundary : Location::outside) << m.about();
    EXPECT_EQ(locate(polygon, {1 + t, 2 - 2 * t, 3 * t + 0x1p-40}), Location::outside);
    ++seen[said];
  });
  EXPECT_GE(seen[Location::boundary], 100);
  EXPECT_GE(seen[Location::outside], 50);
}

TEST(BadInput, IsRefusedByName) {
  const Polygon2 two{{{0, 0}, {1, 1}}};
  EXPECT_EQ(text_of<Error>([&] {
              locate(two, {0, 0});
            }),
            "locate: polygon.vertices has 2 vertices; a polygon has three at least");
  EXPECT_EQ(text_of<Error>([&] { convexity(two); }),
            "convexity: polygon.vertices has 2 vertices; a polygon has three at least");
  const Polygon2 bad{{{0, 0}, {1, 0}, {0, kNan}}};
  const Polygon2 good{{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(text_of<Error>([&] {
              locate(bad, {0, 0});
            }),
            "locate: polygon.vertices[2].y is nan, not a real number; give a finite double");
  EXPECT_THROW(locate(bad, {0, 0}), NonFinite);
  Polygon2 late{std::vector<Point2>(200, Point2{1, 2})};  // though the point is a corner before it
  late.vertices[199].x = -kInfinity;
  EXPECT_THROW(locate(late, {1, 2}), NonFinite);
  EXPECT_THROW(winding_number(late, {1, 2}), NonFinite);
  EXPECT_THROW(is_convex(bad), NonFinite);
  EXPECT_EQ(text_of<Error>([&] {
              locate(good, {kInfinity, 0});
            }),
            "locate: p.x is inf, not a real number; give a finite double");
  EXPECT_EQ(text_of<Error>([&] {
              locate(HoledPolygon2{good, {good, two}}, {0, 0});
            }),
            "locate: holed_polygon.holes[1].vertices has 2 vertices; a polygon has three at least");
  EXPECT_EQ(text_of<Error>([&] {
              quadrilateral_kind(Quadrilateral2{{0, 0}, {1, 0}, {0, -kInfinity}, {0, 0}});
            }),
            "quadrilateral_kind: quadrilateral.c.y is -inf, not a real number; give a finite double");
  const Polygon3 skew{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}};
  EXPECT_EQ(
      text_of<Error>([&] {
        locate(skew, {0, 0, 0});
      }),
      "locate: the polygon is not planar: its vertex 4 is off the plane of the vertices 0, 2 and 3; triangulate it");
  EXPECT_EQ(convexity(skew).kind, PolygonKind::not_planar);
  EXPECT_FALSE(is_planar(skew));
}

}  // namespace
}  // namespace plumb
