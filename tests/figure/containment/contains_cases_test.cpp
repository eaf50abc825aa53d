// Which laws do the places of points keep, what of each degenerate shape, and what is refused?
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/containment/contains.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;
using testing::HasSubstr;

constexpr Location outside = Location::outside, boundary = Location::boundary, inside = Location::inside;

/// The numbers of a shape, in the order of its struct.
template <class Shape>
using Numbers = std::array<double, sizeof(Shape) / sizeof(double)>;
template <class Shape>
Numbers<Shape> numbers_of(const Shape& shape) {
  Numbers<Shape> x;
  std::memcpy(x.data(), &shape, sizeof(Shape));
  return x;
}
template <class Shape>
Shape shape_of(const Numbers<Shape>& x) {
  Shape shape;
  std::memcpy(&shape, x.data(), sizeof(Shape));
  return shape;
}

/// What to do with a shape's numbers: its first `vectors` points and vectors have their coordinates permuted; the
/// numbers from `scaled_from` up to `scaled_to` are lengths.
struct Layout {
  std::size_t vectors, scaled_from, scaled_to;
};

template <class Shape, class Point>
void keep_laws(Layout layout, std::uint64_t cases = 2000) {
  constexpr std::size_t axes = sizeof(Point) / sizeof(double);
  std::uint64_t scalings = 0;
  on_shapes(43, cases, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const Point p = m.probe<Point>();
    const Location where = locate(shape, p);

    auto x = numbers_of(shape);
    auto q = numbers_of(p);
    for (std::size_t v = 0; v < layout.vectors; ++v) std::rotate(&x[v * axes], &x[v * axes] + 1, &x[v * axes] + axes);
    std::rotate(q.begin(), q.begin() + 1, q.end());
    EXPECT_EQ(locate(shape_of<Shape>(x), shape_of<Point>(q)), where) << "permuted " << m.about(shape, p);

    const auto exponent = static_cast<int>(m.entropy().within(200));
    bool exact = true;
    const auto scale = [&](double& t) {
      const double scaled = std::ldexp(t, exponent);
      exact = exact && std::ldexp(scaled, -exponent) == t;
      t = scaled;
    };
    x = numbers_of(shape), q = numbers_of(p);
    for (std::size_t i = layout.scaled_from; i < layout.scaled_to; ++i) scale(x[i]);
    for (double& t : q) scale(t);
    if (!exact) return;
    ++scalings;
    EXPECT_EQ(locate(shape_of<Shape>(x), shape_of<Point>(q)), where) << "scaled " << m.about(shape, p);
  });
  EXPECT_GT(scalings, cases / 2);
}

TEST(ContainsLaws, PermutedAxesAndPowersOfTwo) {
  keep_laws<Line2, Point2>({2, 0, 4});
  keep_laws<Line3, Point3>({2, 0, 6});
  keep_laws<Ray2, Point2>({2, 0, 4});
  keep_laws<Ray3, Point3>({2, 0, 6});
  keep_laws<Segment2, Point2>({2, 0, 4});
  keep_laws<Segment3, Point3>({2, 0, 6});
  keep_laws<Plane3, Point3>({1, 3, 4});
  keep_laws<ThreePointPlane3, Point3>({3, 0, 9});
  keep_laws<Halfspace2, Point2>({1, 2, 3});
  keep_laws<Halfspace3, Point3>({1, 3, 4});
  keep_laws<Slab2, Point2>({1, 2, 4});
  keep_laws<Slab3, Point3>({1, 3, 5});
  keep_laws<Triangle2, Point2>({3, 0, 6});
  keep_laws<Triangle3, Point3>({3, 0, 9});
  keep_laws<Tetrahedron3, Point3>({4, 0, 12});
  keep_laws<Circle2, Point2>({1, 0, 3});
  keep_laws<Sphere3, Point3>({1, 0, 4});
  keep_laws<Capsule2, Point2>({2, 0, 5});
  keep_laws<Capsule3, Point3>({2, 0, 7});
  keep_laws<Lozenge3, Point3>({3, 0, 10});
  keep_laws<Cylinder3, Point3>({2, 0, 7});
  keep_laws<Cone3, Point3>({2, 0, 7});
  keep_laws<Ellipsoid3, Point3>({4, 0, 12});
  keep_laws<Aabb2, Point2>({2, 0, 4});
  keep_laws<Aabb3, Point3>({2, 0, 6});
  keep_laws<AabbWidths3, Point3>({2, 0, 6});
  keep_laws<AabbCenter3, Point3>({2, 0, 6});
  keep_laws<Obb2, Point2>({3, 0, 6});
  keep_laws<Obb3, Point3>({4, 0, 12});
  keep_laws<Rectangle3, Point3>({3, 0, 9});
}

/// The other ways to write the same set.
template <class Shape, class Point, class Others>
void keep_under(Others others, std::uint64_t cases = 1500) {
  on_shapes(44, cases, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const Point p = m.probe<Point>();
    for (const Shape& other : others(shape)) EXPECT_EQ(locate(other, p), locate(shape, p)) << m.about(shape, other, p);
  });
}

TEST(ContainsLaws, EndsCornersAndAxesInAnyOrder) {
  keep_under<Segment3, Point3>([](const Segment3& s) { return std::array{Segment3{s.b, s.a}}; });
  keep_under<Segment2, Point2>([](const Segment2& s) { return std::array{Segment2{s.b, s.a}}; });
  keep_under<Capsule2, Point2>([](const Capsule2& s) { return std::array{Capsule2{s.b, s.a, s.radius}}; });
  keep_under<Capsule3, Point3>([](const Capsule3& s) { return std::array{Capsule3{s.b, s.a, s.radius}}; });
  keep_under<Cylinder3, Point3>([](const Cylinder3& s) { return std::array{Cylinder3{s.b, s.a, s.radius}}; });
  keep_under<Triangle2, Point2>([](const Triangle2& t) {
    return std::array{Triangle2{t.b, t.a, t.c}, Triangle2{t.b, t.c, t.a}};
  });
  keep_under<Triangle3, Point3>([](const Triangle3& t) {
    return std::array{Triangle3{t.b, t.a, t.c}, Triangle3{t.b, t.c, t.a}};
  });
  keep_under<ThreePointPlane3, Point3>([](const ThreePointPlane3& t) {
    return std::array{ThreePointPlane3{t.b, t.a, t.c}, ThreePointPlane3{t.b, t.c, t.a}};
  });
  keep_under<Tetrahedron3, Point3>([](const Tetrahedron3& t) {
    return std::array{Tetrahedron3{t.b, t.a, t.c, t.d}, Tetrahedron3{t.b, t.c, t.d, t.a}};
  });
  keep_under<Lozenge3, Point3>([](const Lozenge3& s) {
    return std::array{Lozenge3{s.corner, {s.edges[1], s.edges[0]}, s.radius}};
  });
  const auto other_axes = [](const auto& s) {
    auto turned = s, reversed = s;
    std::rotate(turned.axes.begin(), turned.axes.begin() + 1, turned.axes.end());
    turned.half = {s.half.y, s.half.z, s.half.x};
    reversed.half.y = -s.half.y;
    reversed.axes[2] = {-s.axes[2].x, -s.axes[2].y, -s.axes[2].z};
    return std::array{turned, reversed};
  };
  keep_under<Obb3, Point3>(other_axes);
  keep_under<Ellipsoid3, Point3>(other_axes);
  keep_under<Plane3, Point3>([](const Plane3& s) {
    return std::array{Plane3{{-s.normal.x, -s.normal.y, -s.normal.z}, -s.offset}};
  });
  keep_under<Slab3, Point3>([](const Slab3& s) {
    return std::array{Slab3{{-s.normal.x, -s.normal.y, -s.normal.z}, -s.max, -s.min}};
  });
}

TEST(ContainsCases, LinesAndPlanesWithoutDirection) {
  EXPECT_EQ(locate(Line2{{1, 2}, {0, 0}}, {1, 2}), boundary);
  EXPECT_EQ(locate(Line2{{1, 2}, {0, -0.0}}, {1, 3}), outside);
  EXPECT_EQ(locate(Line3{{0, 0, 0}, {1, 1, 1}}, {1e308, 1e308, 1e308}), boundary);
  EXPECT_EQ(locate(Line3{{0, 0, 0}, {1, 1, 1}}, {0.1, 0.1, 0x1.999999999999bp-4}), outside);
  EXPECT_EQ(locate(Ray3{{1, 0, 0}, {-0x1p-1074, 0, 0}}, {-1e308, 0, 0}), boundary);
  EXPECT_EQ(locate(Ray3{{1, 0, 0}, {-0x1p-1074, 0, 0}}, {1e308, 0, 0}), outside);
  EXPECT_EQ(locate(Segment3{{0, 0, 0}, {3, 3, 3}}, {1, 1, 1}), boundary);
  EXPECT_EQ(locate(Segment3{{3, 3, 3}, {3, 3, 3}}, {1, 1, 1}), outside);
  EXPECT_EQ(locate(Plane3{{0, 0, 0}, 0}, {1, 2, 3}), inside) << "all of space";
  EXPECT_EQ(locate(Plane3{{0, 0, 0}, 0x1p-1074}, {1, 2, 3}), outside) << "nothing";
  EXPECT_EQ(locate(Plane3{{1, 1, 1}, 6}, {1, 2, 3}), boundary);
  EXPECT_EQ(locate(Halfspace2{{0, 0}, 0}, {1, 2}), inside);
  EXPECT_EQ(locate(Halfspace2{{0, 0}, -1}, {1, 2}), outside);
  EXPECT_EQ(locate(Halfspace3{{0, 0, 1}, 3}, {1, 2, 3}), boundary);
  EXPECT_EQ(locate(Slab3{{0, 0, 0}, -1, 1}, {1, 2, 3}), inside);
  EXPECT_EQ(locate(Slab3{{0, 0, 0}, 1, 2}, {1, 2, 3}), outside);
  EXPECT_EQ(locate(Slab3{{0, 0, 1}, 3, 3}, {1, 2, 3}), boundary) << "a plane";
  EXPECT_EQ(locate(Slab3{{0, 0, 1}, 4, 2}, {1, 2, 3}), outside) << "empty";
  EXPECT_EQ(locate(HalfspaceIntersection3{}, {1, 2, 3}), inside);
  const ThreePointPlane3 line{{0, 0, 0}, {0, 0, 0}, {1, 2, 3}};
  EXPECT_EQ(locate(line, {-2, -4, -6}), boundary);
  EXPECT_EQ(locate(line, {1, 2, 4}), outside);
  EXPECT_EQ(locate(ThreePointPlane3{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {1, 2, 3}), boundary);
  EXPECT_EQ(locate(ThreePointPlane3{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {1, 2, 4}), outside);
}

TEST(ContainsCases, FlatSimplices) {
  const Triangle2 segment{{0, 0}, {4, 4}, {1, 1}};
  EXPECT_EQ(locate(segment, {3, 3}), boundary);
  EXPECT_EQ(locate(segment, {5, 5}), outside);
  EXPECT_EQ(locate(Triangle2{{0, 0}, {4, 0}, {0, 4}}, {2, 2}), boundary);
  EXPECT_EQ(locate(Triangle2{{0, 0}, {4, 0}, {0, 4}}, {2, 0x1.fffffffffffffp+0}), inside);
  const Triangle3 vertical{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}};
  EXPECT_EQ(locate(vertical, {1, 0, 1}), boundary);
  EXPECT_EQ(locate(vertical, {1, 0x1p-1074, 1}), outside);
  EXPECT_EQ(locate(vertical, {3, 0, 2}), outside);
  const Tetrahedron3 square{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
  for (const Point3& p : {Point3{1, 0.25, 0}, {0.25, 1, 0}, {1.75, 1, 0}, {1, 1.75, 0}, {1, 1, 0}, {2, 2, 0}}) {
    EXPECT_EQ(locate(square, p), boundary);
  }
  EXPECT_EQ(locate(square, {1, 1, 0x1p-1074}), outside);
  EXPECT_EQ(locate(square, {-0x1p-1074, 1, 0}), outside);
  const Tetrahedron3 hooded{{0, 0, 0}, {1, 1, 0}, {6, 0, 0}, {0, 6, 0}};
  EXPECT_EQ(locate(hooded, {2, 2, 0}), boundary) << "a triangle with a corner inside";
  EXPECT_EQ(locate(hooded, {0.25, 0.25, 0}), boundary);
  EXPECT_EQ(locate(hooded, {4, 3, 0}), outside);
}

TEST(ContainsCases, RoundShapes) {
  EXPECT_EQ(locate(Circle2{{1, 1}, 0}, {1, 1}), boundary);
  EXPECT_EQ(locate(Circle2{{1, 1}, 5}, {4, 5}), boundary);
  EXPECT_EQ(locate(Sphere3{{0, 0, 0}, -0.0}, {0, 0, 0}), boundary);
  EXPECT_EQ(locate(Sphere3{{0, 0, 0}, 0x1p-1074}, {0, 0, 0}), inside);
  EXPECT_EQ(locate(Sphere3{{1e308, 0, 0}, 1e308}, {0, 0, 0}), boundary);
  EXPECT_EQ(locate(Sphere3{{1e308, 0, 0}, 1e308}, {-0x1p-1074, 0, 0}), outside);
  EXPECT_EQ(locate(Capsule3{{0, 0, 0}, {8, 0, 0}, 5}, {11, 4, 0}), boundary);
  EXPECT_EQ(locate(Capsule3{{0, 0, 0}, {8, 0, 0}, 0}, {4, 0, 0}), boundary);
  EXPECT_EQ(locate(Cylinder3{{0, 0, 0}, {8, 0, 0}, 5}, {8, 4, 3}), boundary) << "on the rim";
  EXPECT_EQ(locate(Cylinder3{{0, 0, 0}, {8, 0, 0}, 5}, {8, 1, 1}), boundary) << "on an end";
  EXPECT_EQ(locate(Cylinder3{{0, 0, 0}, {8, 0, 0}, 5}, {0x1.0000000000001p+3, 1, 1}), outside);
  EXPECT_EQ(locate(Cylinder3{{0, 0, 0}, {0, 0, 0}, 3}, {2, 2, 1}), boundary) << "a ball";
  EXPECT_EQ(locate(Cone3{{0, 0, 4}, {0, 0, 0}, 2}, {0, 0, 4}), boundary) << "the apex";
  EXPECT_EQ(locate(Cone3{{0, 0, 4}, {0, 0, 0}, 2}, {1, 0, 2}), boundary);
  EXPECT_EQ(locate(Cone3{{0, 0, 4}, {0, 0, 0}, 2}, {1, 0, 1}), inside);
  EXPECT_EQ(locate(Cone3{{0, 0, 4}, {0, 0, 0}, 2}, {0, 0, 5}), outside) << "no second nappe";
  EXPECT_EQ(locate(Cone3{{0, 0, 4}, {0, 0, 0}, 0}, {0, 0, 1}), boundary) << "a segment";
  EXPECT_EQ(locate(Cone3{{0, 0, 4}, {0, 0, 4}, 1}, {0, 0, 4.5}), inside) << "a ball";
}

TEST(ContainsCases, LozengesOfAnyEdges) {
  const Lozenge3 plate{{0, 0, 0}, {{{4, 0, 0}, {0, 4, 0}}}, 3};
  EXPECT_EQ(locate(plate, {2, 2, 3}), boundary);
  EXPECT_EQ(locate(plate, {6, 6, 1}), boundary) << "around the far corner";
  EXPECT_EQ(locate(plate, {6, 2, 2}), inside);
  EXPECT_EQ(locate(plate, {2, 2, 0x1.8000000000001p+1}), outside);
  const Lozenge3 segment{{0, 0, 0}, {{{4, 0, 0}, {-2, 0, 0}}}, 0};
  EXPECT_EQ(locate(segment, {-2, 0, 0}), boundary) << "edges that overlap: from -2 to 4";
  EXPECT_EQ(locate(segment, {4, 0, 0}), boundary);
  EXPECT_EQ(locate(segment, {1, 0, 0}), boundary);
  EXPECT_EQ(locate(segment, {4.5, 0, 0}), outside);
  const Lozenge3 slanted{{0, 0, 0}, {{{4, 0, 0}, {4, 1, 0}}}, 1};
  EXPECT_EQ(locate(slanted, {8, 1, 1}), boundary);
  EXPECT_EQ(locate(slanted, {0, 1, 0}), inside) << "the edge beside it is nearer than the corner";
  EXPECT_EQ(locate(slanted, {0, -1, 0}), boundary);
  EXPECT_EQ(locate(Lozenge3{{0, 0, 0}, {{{0, 0, 0}, {0, 0, 0}}}, 3}, {1, 2, 2}), boundary);
}

TEST(ContainsCases, BoxesOfDependentAxes) {
  EXPECT_EQ(locate(Aabb3{{0, 0, 0}, {1, 1, 0}}, {0.5, 0.5, 0}), boundary) << "flat";
  EXPECT_EQ(locate(Aabb3{{0, 0, 1}, {1, 1, 0}}, {0.5, 0.5, 0.5}), outside) << "empty";
  EXPECT_EQ(locate(AabbWidths3{{1e308, 0, 0}, {-1e308, 1, 1}}, {0x1.fffffffffffffp+1023, 0.5, 0.5}), inside);
  EXPECT_EQ(locate(AabbWidths3{{1, 0, 0}, {0x1p-53, 1, 1}}, {1, 0.5, 0.5}), boundary);
  EXPECT_EQ(locate(AabbWidths3{{1, 0, 0}, {0x1.8p-53, 1, 1}}, {0x1.0000000000001p+0, 0.5, 0.5}), outside)
      << "the sum's nearest double is outside";
  EXPECT_EQ(locate(AabbCenter3{{1, 0, 0}, {0x1.8p-53, 1, 1}}, {0x1.0000000000001p+0, 0.5, 0.5}), outside);
  EXPECT_EQ(locate(AabbCenter3{{1, 0, 0}, {-0x1p-52, 1, 1}}, {0x1.0000000000001p+0, 0.5, 0.5}), boundary);

  const Obb3 hexagon{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {1, 1, 1}};
  EXPECT_EQ(locate(hexagon, {2, 2, 0}), boundary);
  EXPECT_EQ(locate(hexagon, {2, 0, 0}), boundary);
  EXPECT_EQ(locate(hexagon, {2, -0x1p-50, 0}), outside);
  EXPECT_EQ(locate(hexagon, {0, 0, 0}), boundary) << "flat: no inside";
  EXPECT_EQ(locate(hexagon, {0, 0, 0x1p-1074}), outside);
  const Obb3 rod{{0, 0, 0}, {{{1, 2, 3}, {-2, -4, -6}, {0, 0, 0}}}, {1, 1, 7}};
  EXPECT_EQ(locate(rod, {3, 6, 9}), boundary);
  EXPECT_EQ(locate(rod, {3.5, 7, 10.5}), outside);
  EXPECT_EQ(locate(rod, {3, 6, 8}), outside);
  EXPECT_EQ(locate(Obb3{{1, 2, 3}, {}, {1, 1, 1}}, {1, 2, 3}), boundary) << "a point";
  EXPECT_EQ(locate(Obb3{{1, 2, 3}, {}, {1, 1, 1}}, {1, 2, 4}), outside);
  const Obb3 sheared{{0, 0, 0}, {{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}}, {1, 1, 1}};
  EXPECT_EQ(locate(sheared, {2, 1, 1}), boundary);
  EXPECT_EQ(locate(sheared, {1, -0.5, 0}), outside);
  EXPECT_EQ(locate(sheared, {1, 0.5, 0}), inside);
  EXPECT_EQ(locate(Obb2{{0, 0}, {{{1, 1}, {-2, -2}}}, {1, 1}}, {3, 3}), boundary);
  EXPECT_EQ(locate(Obb2{{0, 0}, {{{1, 1}, {-2, -2}}}, {1, 1}}, {3, 2}), outside);
  EXPECT_EQ(locate(Rectangle3{{0, 0, 0}, {{{1, 0, 1}, {0, 1, 0}}}, {2, 1}}, {2, -1, 2}), boundary);
  EXPECT_EQ(locate(Rectangle3{{0, 0, 0}, {{{1, 0, 1}, {0, 1, 0}}}, {2, 1}}, {2, -1, 1}), outside);
}

TEST(ContainsCases, FlatEllipsoids) {
  const Ellipsoid3 disk{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {5, 10, 0}};
  EXPECT_EQ(locate(disk, {3, 8, 0}), boundary);
  EXPECT_EQ(locate(disk, {0, 0, 0}), boundary);
  EXPECT_EQ(locate(disk, {3, 8.5, 0}), outside);
  EXPECT_EQ(locate(disk, {0, 0, 0x1p-1074}), outside);
  const Ellipsoid3 rod{{0, 0, 0}, {{{3, 0, 0}, {4, 0, 0}, {0, 0, 0}}}, {1, 1, 1}};
  EXPECT_EQ(locate(rod, {5, 0, 0}), boundary) << "3 cos + 4 sin is up to 5";
  EXPECT_EQ(locate(rod, {0x1.4000000000001p+2, 0, 0}), outside);
  const Ellipsoid3 solid{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {5, -10, 3}};
  EXPECT_EQ(locate(solid, {3, 8, 0}), boundary);
  EXPECT_EQ(locate(solid, {3, 7.5, 0}), inside);
  EXPECT_EQ(locate(solid, {3, 8, 0x1p-1074}), outside);
}

TEST(ContainsCases, NumbersInBracesAreAPoint) {
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_FALSE(contains(box, {2, 2, 2})) << "and not the start of an empty box";
  EXPECT_TRUE(contains(box, {1, 1, 1}));
  EXPECT_FALSE(contains(Aabb2{{0, 0}, {1, 1}}, {2, 2}));
  EXPECT_FALSE(contains(Sphere3{{0, 0, 0}, 3}, {1, 2, 3}));
  EXPECT_TRUE(contains(Sphere3{{0, 0, 0}, 3}, {1, 2, 2}));
  EXPECT_TRUE(contains(Circle2{{0, 0}, 5}, {3, 4}));
  EXPECT_FALSE(contains(Capsule3{{0, 0, 0}, {1, 0, 0}, 1}, {1, 0, 2}));
}

/// Every number of the shape and the point in turn.
template <class Shape, class Point>
void refuse_non_finite() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for (const double good : {0.0, 1.0}) {
      Numbers<Shape> x;
      x.fill(good);
      const auto p = shape_of<Point>(Numbers<Point>{});
      for (double& t : x) {
        const double was = std::exchange(t, bad);
        EXPECT_THROW(static_cast<void>(locate(shape_of<Shape>(x), p)), NonFinite);
        EXPECT_THROW(static_cast<void>(contains(shape_of<Shape>(x), p)), NonFinite);
        EXPECT_THAT(text_of<Error>([&] { locate(shape_of<Shape>(x), p); }), HasSubstr("contains: "));
        t = was;
      }
      Numbers<Point> q{};
      for (double& t : q) {
        t = bad;
        EXPECT_THROW(static_cast<void>(locate(shape_of<Shape>(x), shape_of<Point>(q))), NonFinite);
        EXPECT_THAT(text_of<Error>([&] { locate(shape_of<Shape>(x), shape_of<Point>(q)); }), HasSubstr("contains: p."));
        t = 0;
      }
    }
  }
}
template <class... Shapes>
void refuse_in_plane() {
  (refuse_non_finite<Shapes, Point2>(), ...);
}
template <class... Shapes>
void refuse_in_space() {
  (refuse_non_finite<Shapes, Point3>(), ...);
}

TEST(ContainsRefuses, WhatIsNoNumber) {
  refuse_in_plane<Line2, Ray2, Segment2, Halfspace2, Slab2, Triangle2, Circle2, Capsule2, Aabb2, Obb2>();
  refuse_in_space<Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Slab3, Triangle3, Tetrahedron3, Sphere3,
                  Capsule3, Lozenge3, Cylinder3, Cone3, Ellipsoid3, Aabb3, AabbWidths3, AabbCenter3, Obb3,
                  Rectangle3>();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point3 p{0, 0, 0};
  EXPECT_EQ(text_of<Error>([&] {
              contains(Sphere3{{0, 0, 0}, nan}, p);
            }),
            "contains: sphere.radius is nan, not a real number; give a finite double");
  EXPECT_THAT(text_of<Error>([&] {
                contains(Obb3{{}, {{{}, {0, nan, 0}, {}}}, {}}, p);
              }),
              HasSubstr("contains: obb.axes[1].y is nan"));
  EXPECT_THAT(text_of<Error>([&] {
                contains(Aabb3{{0, 0, 0}, {1, 1, nan}}, p);
              }),
              HasSubstr("contains: aabb.max.z is nan"));
  HalfspaceIntersection3 wedge{{{{1, 0, 0}, -1}, {{0, 1, 0}, nan}}};
  EXPECT_THAT(text_of<Error>([&] { contains(wedge, p); }),
              HasSubstr("contains: intersection.halfspaces[1].offset is nan"));
  wedge.halfspaces[1] = {{0, nan, 0}, 0};
  EXPECT_THAT(text_of<Error>([&] { contains(wedge, p); }),
              HasSubstr("contains: intersection.halfspaces[1].normal.y is nan"));
  EXPECT_THAT(text_of<Error>([&] { contains(HalfspaceIntersection2{}, {0, nan}); }), HasSubstr("contains: p.y is nan"));
}

TEST(ContainsRefuses, NegativeRadii) {
  const Point3 p{9, 9, 9};
  EXPECT_EQ(text_of<Error>([&] {
              contains(Sphere3{{0, 0, 0}, -1}, p);
            }),
            "contains: sphere.radius is negative; give zero or more");
  EXPECT_THROW(static_cast<void>(locate(Circle2{{0, 0}, -1}, {0, 0})), InvalidShape);
  EXPECT_THROW(static_cast<void>(locate(Sphere3{{0, 0, 0}, -0x1p-1074}, {0, 0, 0})), InvalidShape);
  EXPECT_THROW(static_cast<void>(locate(Capsule2{{0, 0}, {1, 1}, -1}, {0, 0})), InvalidShape);
  EXPECT_THROW(static_cast<void>(locate(Capsule3{{0, 0, 0}, {1, 1, 1}, -1}, p)), InvalidShape);
  EXPECT_THROW(static_cast<void>(locate(Lozenge3{{0, 0, 0}, {}, -1}, p)), InvalidShape);
  EXPECT_THROW(static_cast<void>(locate(Cylinder3{{0, 0, 0}, {1, 0, 0}, -1}, p)), InvalidShape);
  EXPECT_THROW(static_cast<void>(locate(Cone3{{0, 0, 0}, {1, 0, 0}, -1}, p)), InvalidShape);
}

}  // namespace
}  // namespace plumb
