// Reports about the side of a line or plane on which a point is, and about where two segments cross.
#include <gtest/gtest.h>

#include <array>

#include "docs/bugs_of_others/case.hpp"
#include "docs/bugs_of_others/proved.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/intersection2.hpp"
#include "plumb/query/section/intersection_result.hpp"

namespace plumb::docs {
namespace {

/// The one point that two segments have in common, not rounded; it is on the lines of both, exactly.
std::string crossing(const Segment2& s, const Segment2& t) {
  proved_flat(s, t);
  const Intersection2 common = intersection(s, t);
  if (common.kind != IntersectionKind::point) return "no point";
  const ExactPoint2& p = common.vertices[0];
  EXPECT_EQ(orient2d(s.a, s.b, p), Sign::zero);
  EXPECT_EQ(orient2d(t.a, t.b, p), Sign::zero);
  const RationalPoint2 exact = rational_point(p);
  return "(" + exact.x.text() + ", " + exact.y.text() + ")";
}

/// The sign of a sum of products, in rationals.
Sign sign_in_rationals(const Point2& a, const Point2& b, const Point2& c) {
  const auto [x, y] = std::pair{Rational(b.x) - Rational(a.x), Rational(b.y) - Rational(a.y)};
  return ((Rational(c.y) - Rational(a.y)) * x - (Rational(c.x) - Rational(a.x)) * y).sign();
}

std::string side(const Point2& a, const Point2& b, const Point2& c) {
  const Sign sign = orient2d(a, b, c);
  EXPECT_EQ(sign, sign_in_rationals(a, b, c));
  return sign == Sign::positive ? "counterclockwise" : sign == Sign::negative ? "clockwise" : "on one line";
}

/// The sign of the determinant of three vectors.
Sign turn(const Point3& a, const Point3& b, const Point3& c) {
  const Sign sign = orient3d(a, b, c, {0, 0, 0});
  const auto minor = [](double p, double q, double r, double s) {
    return Rational(p) * Rational(s) - Rational(q) * Rational(r);
  };
  const Rational exact = Rational(a.x) * minor(b.y, b.z, c.y, c.z) - Rational(a.y) * minor(b.x, b.z, c.x, c.z) +
                         Rational(a.z) * minor(b.x, b.y, c.x, c.y);
  EXPECT_EQ(sign, exact.sign());
  return sign;
}

constexpr std::array cases{
    Case{"dimforge/parry#99",
         [] {
           return side({-0.5, 0.8660254037844387}, {1, 1.7320508075688772}, {-2, 0});
         }},
    Case{"ironwallaby/delaunay#9",
         [] {
           return side({552, 364.25}, {552, 533}, {553, 402});
         }},
    Case{"artem-ogre/CDT#172",
         [] {
           return side({0.99999, 0.09999}, {0, 0.1}, {0.499995, 0.099995});
         }},
    Case{"harry7557558/spirula-studio#60",
         [] {
           return std::string{
               to_char(turn({36569, 5957284, 600211}, {-10110, 2276334, 232673}, {39676, 6450463, 649889}))};
         }},
    Case{"golang/geo#263",
         [] {
           return std::string{to_char(turn({1, 1.9535722048627587e-90, 7.4882501322554515e-80},
                                           {1, 9.6702373087191359e-127, 3.706704857169321e-116},
                                           {1, 3.8163353663361477e-142, 1.4628419538608985e-131}))};
         }},
    Case{"locationtech/jts#270",
         [] {
           const Segment2 a{{0, 0}, {-10, 1.2246467991473533e-15}};
           const Segment2 b{{-9.999143275740073, -0.13089595571333978}, {-10, 1.0535676356486768e-13}};
           const Intersection2 common = intersection(a, b);
           EXPECT_EQ(common.kind, IntersectionKind::point);
           EXPECT_GT(rational_point(common.vertices[0]).x, Rational(-10));  // within both, though it rounds to an end
           EXPECT_EQ(approximate(common.vertices[0]).x, -10);
           return proved_flat(a, b);
         }},
    Case{"shapely/shapely#2308",
         [] {
           return crossing({{0, 0}, {10, 10}}, {{0, 20}, {10, 0}});
         }},
    Case{"shapely/shapely#2126",
         [] {
           return crossing({{0, 0}, {2, 2}}, {{1, 0}, {-1, 1}});
         }},
    Case{"JuliaGeometry/Meshes.jl#29",
         [] {
           return crossing({{1.5, 1.5}, {3, 1.5}}, {{3, 1}, {2, 2}});
         }},
    Case{"JuliaGeometry/GeometryTypes.jl#133",
         [] {
           return proved_flat(Segment2{{0.88033, 1.28211}, {3.525, 1.28211}},
                              Segment2{{2.0375, 1.1625}, {2.0375, 1.2875}});
         }},
    Case{"godotengine/godot#86651",
         [] {
           return crossing({{585, 95}, {581, 98}}, {{585, 105}, {585, 45}});
         }},
    Case{"Ramarren/cl-geometry#3",
         [] {
           return proved_flat(Segment2{{0, 0}, {50, 50}}, Segment2{{51, 51}, {100, 100}});
         }},
    Case{"lace/polliwog#216",
         [] {
           const Line3 lower{{1, 0, 0}, {-1, 1, 0}}, upper{{0, 0, 1}, {1, 1, 0}};
           EXPECT_TRUE(intersection(lower, upper).empty());
           EXPECT_EQ(squared_distance_exact(lower, upper), Rational(1));
           return told(relate(lower, upper));
         }},
    Case{"RiSearcher/GeometRi.CSharp#15",
         [] {
           const Segment2 a{{399.83, 255.06}, {453.16, 255.06}}, b{{389.99, 255.06}, {421.64, 255.06}};
           const Intersection2 common = intersection(a, b);
           EXPECT_EQ(common, intersection(b, a));
           EXPECT_EQ(common.kind, IntersectionKind::segment);
           proved_flat(a, b);
           return told(approximate(common.vertices[0])) + " to " + told(approximate(common.vertices[1]));
         }},
};

}  // namespace

std::span<const Case> crossing_cases() { return cases; }

}  // namespace plumb::docs
