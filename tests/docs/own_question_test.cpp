// Is the worked example of docs/add_a_question.md true?  Its table against the compiler, its answers against rationals.
#include <gtest/gtest.h>

#include <vector>

#include "docs/is_above.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::docs {
namespace {

template <class... Shapes>
void expect_as_compiled() {
  const auto expect = []<class Shape>(const Shape*) {
    constexpr bool compiles = requires(const Plane3& plane, const Shape& shape) { mine::is_above(plane, shape); };
    EXPECT_EQ(compiles, mine::above_pairs.answers(FigureKind::plane, figure_kind<Shape>, 3))
        << "is_above.hpp: the letter of " << name_of(figure_kind<Shape>);
  };
  (expect(static_cast<const Shapes*>(nullptr)), ...);
}

TEST(OwnQuestion, TheTableSaysWhatCompiles) {
  expect_as_compiled<Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3,
                     Polygon3, HoledPolygon3, Rectangle3, Tetrahedron3, Sphere3, Aabb3, Obb3, Capsule3, Lozenge3,
                     Cylinder3, Cone3, KDop3, HalfspaceIntersection3, ConvexPolyhedron3>();
  constexpr auto takes = []<class A, class B>(const A*, const B*) {
    return requires(const A& a, const B& b) { mine::is_above(a, b); };
  };
  EXPECT_FALSE(takes(static_cast<Point3*>(nullptr), static_cast<Plane3*>(nullptr)));
  EXPECT_FALSE(takes(static_cast<Plane3*>(nullptr), static_cast<Point2*>(nullptr)));
}

Rational height(const Plane3& plane, const Point3& p) {
  const auto& [x, y, z] = plane.normal;
  return Rational(x) * Rational(p.x) + Rational(y) * Rational(p.y) + Rational(z) * Rational(p.z) -
         Rational(plane.offset);
}

TEST(OwnQuestion, AnswersAreThoseOfRationals) {
  int above = 0, touching = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Entropy e(20, i);
    const auto number = [&e] { return static_cast<double>(e.within(4)); };
    const auto point = [&number] { return Point3{number(), number(), number()}; };
    const Plane3 plane{{number(), number(), number()}, number()};
    const std::vector<Point3> p{point(), point(), point(), point()};
    bool all = true;
    for (std::size_t k = 0; k < 4; ++k) {
      const Sign sign = height(plane, p[k]).sign();
      all = all && sign == Sign::positive;
      touching += sign == Sign::zero ? 1 : 0;
      ASSERT_EQ(mine::is_above(plane, p[k]), sign == Sign::positive) << "replay: " << i;
    }
    ASSERT_EQ(mine::is_above(plane, Tetrahedron3{p[0], p[1], p[2], p[3]}), all) << "replay: " << i;
    above += all ? 1 : 0;

    const Rational h = height(plane, p[0]);
    const auto radius = static_cast<double>(e.below(4));
    const auto& [x, y, z] = plane.normal;
    const Rational reach = Rational(radius) * Rational(radius) * Rational(x * x + y * y + z * z);
    ASSERT_EQ(mine::is_above(plane, Sphere3{p[0], radius}), h.sign() == Sign::positive && h * h > reach)
        << "replay: " << i;
  }
  EXPECT_GT(above, 100);
  EXPECT_GT(touching, 100);
}

}  // namespace
}  // namespace plumb::docs
