// Is the common set of two figures what rationals say, for random figures of every pair, under the laws?
#include "plumb/query/section/intersection.hpp"

#include <gtest/gtest.h>

#include <map>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "query/body/exact_sets.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;

/// Also of figures that must be convex: the hulls of points.
template <class Figure>
Figure figure_of(Material& m) {
  if constexpr (std::is_same_v<Figure, Polygon2>) {
    const Polygon2 p = m.shape<Polygon2>();
    Polygon2 convex;
    for (const std::uint32_t i : convex_hull(p.vertices, {.all_boundary_points = m.below(2) == 0}).vertices) {
      for (std::size_t times = m.below(6) == 0 ? 2 : 1; times-- > 0;) convex.vertices.push_back(p.vertices[i]);
    }
    while (convex.vertices.size() < 3) convex.vertices.push_back(convex.vertices.back());
    if (m.below(2) == 0) std::ranges::reverse(convex.vertices);
    return convex;
  } else if constexpr (std::is_same_v<Figure, ConvexPolyhedron3>) {
    for (;;) {
      std::vector<Point3> points;
      for (std::size_t n = 4 + m.below(4); n-- > 0;) points.push_back(m.point3());
      if (const Hull3 hull = convex_hull(points); hull.dimension == 3) return convex_polyhedron(hull, points);
      for (const Point3& p : {Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) points.push_back(p);
      if (const Hull3 hull = convex_hull(points); hull.dimension == 3) return convex_polyhedron(hull, points);
    }
  } else {
    return m.shape<Figure>();
  }
}

using Kinds = std::map<IntersectionKind, int>;

template <class A, class B>
Kinds hold_against_rationals(std::uint64_t start, std::uint64_t cases) {
  Kinds kinds;
  on_shapes(start, cases, [&](Material& m) {
    const A a = figure_of<A>(m);
    const B b = figure_of<B>(m);
    const auto told = intersection(a, b);
    ++kinds[told.kind];
    EXPECT_EQ(exact::wrong(told, exact::common(exact::generated(a), exact::generated(b))), "") << m.about(a, b);
    if constexpr (!std::is_same_v<A, B>) {
      EXPECT_TRUE(told == intersection(b, a)) << m.about(a, b);
    } else if (told.kind != IntersectionKind::line && told.kind != IntersectionKind::ray) {
      EXPECT_EQ(told.vertices, intersection(b, a).vertices) << m.about(a, b);
    } else {
      EXPECT_TRUE(told == intersection(b, a)) << m.about(a, b);
    }
  });
  return kinds;
}

/// Each of these kinds is met at least so often; where watched, by a tenth of the cases, they are not counted.
template <class A, class B>
void hold(std::uint64_t start, std::uint64_t cases, std::initializer_list<IntersectionKind> kinds, int least = 5) {
  Kinds count = hold_against_rationals<A, B>(start, battery::sanitized ? 1 + cases / 10 : cases);
  if (!battery::reaches_rare) return;
  for (const IntersectionKind kind : kinds)
    EXPECT_GE(count[kind], least) << static_cast<int>(kind) << " start " << start;
}

constexpr auto nothing = IntersectionKind::nothing, point = IntersectionKind::point,
               segment = IntersectionKind::segment, ray = IntersectionKind::ray, line = IntersectionKind::line,
               polygon = IntersectionKind::polygon;

TEST(Intersection, LinesOfThePlane) {
  hold<Line2, Line2>(1, 300, {nothing, point, line}, 4);
  hold<Line2, Ray2>(2, 300, {nothing, point, ray});
  hold<Line2, Segment2>(3, 300, {nothing, point, segment});
  hold<Ray2, Ray2>(4, 600, {nothing, point, ray}, 4);
  hold<Ray2, Segment2>(5, 400, {nothing, point, segment}, 4);
  hold<Segment2, Segment2>(6, 800, {nothing, point, segment});
}

TEST(Intersection, LinesAndRegionsOfThePlane) {
  hold<Line2, Triangle2>(7, 150, {nothing, point, segment});
  hold<Ray2, Triangle2>(8, 150, {nothing, point, segment});
  hold<Segment2, Triangle2>(9, 300, {nothing, point, segment});
  hold<Line2, Aabb2>(10, 100, {nothing, point, segment});
  hold<Ray2, Aabb2>(11, 100, {nothing, point, segment});
  hold<Segment2, Aabb2>(12, 150, {nothing, point, segment});
  hold<Line2, Polygon2>(13, 60, {nothing, point, segment}, 3);
  hold<Ray2, Polygon2>(14, 60, {nothing, point, segment}, 3);
  hold<Segment2, Polygon2>(15, 100, {nothing, point, segment}, 3);
}

TEST(Intersection, RegionsOfThePlane) {
  hold<Triangle2, Triangle2>(16, 400, {nothing, point, segment, polygon}, 3);
  hold<Triangle2, Aabb2>(17, 150, {nothing, point, segment, polygon}, 2);
  hold<Aabb2, Aabb2>(18, 100, {nothing, point, segment, polygon}, 3);
  hold<Triangle2, Polygon2>(19, 60, {nothing, point, segment, polygon}, 1);
  hold<Polygon2, Polygon2>(20, 60, {nothing, polygon}, 1);
  hold<Polygon2, Aabb2>(21, 40, {nothing, polygon});
}

TEST(Intersection, LinesOfSpace) {
  hold<Line3, Line3>(31, 300, {nothing, point, line});
  hold<Line3, Ray3>(32, 400, {nothing, point, ray}, 3);
  hold<Line3, Segment3>(33, 300, {nothing, point, segment}, 1);
  hold<Ray3, Ray3>(34, 500, {nothing, point}, 5);
  hold<Ray3, Segment3>(35, 400, {nothing, point, segment}, 2);
  hold<Segment3, Segment3>(36, 600, {nothing, point, segment}, 3);
}

TEST(Intersection, LinesAndPlanes) {
  hold<Line3, Plane3>(37, 80, {nothing, point, line}, 1);
  hold<Ray3, Plane3>(38, 80, {nothing, point, ray}, 2);
  hold<Segment3, Plane3>(39, 100, {nothing, point, segment}, 2);
  hold<Line3, ThreePointPlane3>(40, 80, {nothing, point}, 3);
  hold<Ray3, ThreePointPlane3>(41, 80, {nothing, point}, 3);
  hold<Segment3, ThreePointPlane3>(42, 100, {nothing, point, segment}, 3);
  hold<Line3, Halfspace3>(43, 60, {nothing, ray, line}, 2);
  hold<Ray3, Halfspace3>(44, 60, {nothing, point, segment, ray}, 1);
  hold<Segment3, Halfspace3>(45, 60, {nothing, point, segment}, 2);
}

TEST(Intersection, LinesAndTriangles) {
  hold<Line3, Triangle3>(46, 300, {nothing, point, segment});
  hold<Ray3, Triangle3>(47, 300, {nothing, point, segment}, 3);
  hold<Segment3, Triangle3>(48, 500, {nothing, point, segment}, 3);
}

TEST(Intersection, LinesAndSolids) {
  hold<Line3, Tetrahedron3>(49, 50, {nothing, point, segment}, 1);
  hold<Ray3, Tetrahedron3>(50, 50, {nothing, segment}, 1);
  hold<Segment3, Tetrahedron3>(51, 80, {nothing, point, segment}, 1);
  hold<Line3, Aabb3>(52, 20, {nothing, segment}, 2);
  hold<Ray3, Aabb3>(53, 40, {nothing, segment}, 1);
  hold<Segment3, Aabb3>(54, 30, {nothing, segment}, 1);
  hold<Line3, Obb3>(55, 12, {nothing, segment}, 1);
  hold<Ray3, Obb3>(156, 12, {nothing, segment}, 1);
  hold<Segment3, Obb3>(57, 20, {nothing, segment}, 1);
  hold<Line3, ConvexPolyhedron3>(58, 20, {nothing, segment}, 1);
  hold<Ray3, ConvexPolyhedron3>(59, 20, {nothing, segment}, 1);
  hold<Segment3, ConvexPolyhedron3>(60, 24, {nothing, segment}, 1);
}

TEST(Intersection, PlanesAndTriangles) {
  hold<Plane3, Triangle3>(61, 80, {nothing, point, segment, polygon}, 2);
  hold<ThreePointPlane3, Triangle3>(62, 80, {nothing, point, segment, polygon}, 1);
  hold<Halfspace3, Triangle3>(63, 60, {nothing, polygon}, 3);
}

TEST(Intersection, PlanesAndSolids) {
  hold<Plane3, Tetrahedron3>(64, 30, {nothing, polygon}, 2);
  hold<ThreePointPlane3, Tetrahedron3>(65, 30, {nothing, polygon}, 2);
  hold<Plane3, Aabb3>(66, 12, {nothing, polygon}, 1);
  hold<ThreePointPlane3, Aabb3>(67, 12, {nothing, polygon}, 1);
  hold<Plane3, Obb3>(68, 8, {nothing, polygon}, 1);
  hold<ThreePointPlane3, Obb3>(169, 8, {nothing, polygon}, 1);
  hold<Plane3, ConvexPolyhedron3>(70, 10, {nothing, polygon}, 1);
  hold<ThreePointPlane3, ConvexPolyhedron3>(71, 10, {nothing, polygon}, 1);
}

TEST(Intersection, TrianglesOfSpace) { hold<Triangle3, Triangle3>(72, 500, {nothing, point, segment, polygon}, 3); }

/// Random ones, of which nearly none have a corner on an edge or a face: how many meet so?
template <class A, class B, class Draw>
void hold_in_general_position(std::uint64_t start, IntersectionKind kind, int least, const Draw& draw) {
  const int part = battery::sanitized ? 3 : 1;
  int met = 0;
  for (std::uint64_t index = 0; index < 150 * shape_cases::more / part; ++index) {
    Entropy entropy(start, index);
    A a;
    B b;
    a.a = draw(entropy), a.b = draw(entropy);
    if constexpr (requires { a.c; }) a.c = draw(entropy);
    b.a = draw(entropy), b.b = draw(entropy), b.c = draw(entropy);
    const auto told = intersection(a, b);
    met += told.kind == kind ? 1 : 0;
    const auto failure = "start " + std::to_string(start) + " index " + std::to_string(index);
    EXPECT_EQ(exact::wrong(told, exact::common(exact::generated(a), exact::generated(b))), "") << failure;
    if constexpr (std::is_same_v<A, B>) {
      EXPECT_TRUE(told.vertices == intersection(b, a).vertices) << failure;
    }
  }
  EXPECT_GE(met, least * static_cast<int>(shape_cases::more) / part) << "start " << start;
}

TEST(Intersection, TrianglesInGeneralPosition) {
  const auto number = [](Entropy& e) { return static_cast<double>(e.within(1000)) * 0x1p-10; };
  const auto in_plane = [&](Entropy& e) { return Point2{number(e), number(e)}; };
  const auto in_space = [&](Entropy& e) { return Point3{number(e), number(e), number(e)}; };
  const auto slanted = [&](Entropy& e) {
    const double x = number(e), y = number(e);
    return Point3{x, y, x + 2 * y};
  };
  const auto upright = [&](Entropy& e) { return Point3{2, number(e), number(e)}; };
  hold_in_general_position<Triangle2, Triangle2>(171, polygon, 60, in_plane);
  hold_in_general_position<Segment3, Triangle3>(172, point, 10, in_space);
  hold_in_general_position<Triangle3, Triangle3>(173, segment, 30, in_space);
  hold_in_general_position<Triangle3, Triangle3>(174, polygon, 60, slanted);
  hold_in_general_position<Triangle3, Triangle3>(175, polygon, 60, upright);
}

// Of a mesh: what they share is all that they have in common.
TEST(Intersection, NeighborsShareACornerOrAnEdge) {
  const Point3 p{0.1, 0.2, 0.3}, q{0.7, 0.1, 0.9};
  const Triangle3 t{p, q, {0.3, 0.8, 0.5}};
  EXPECT_EQ(intersection(t, Triangle3{{0.9, 0.9, -0.7}, q, p}).vertices, (std::vector<ExactPoint3>{p, q}));
  EXPECT_EQ(intersection(Triangle3{{-0.3, 0.4, -0.5}, {-0.7, 0.1, -0.1}, p}, t).vertices, std::vector<ExactPoint3>{p});
}

TEST(Intersection, TrianglesAndSolids) {
  hold<Triangle3, Tetrahedron3>(73, 60, {nothing, point, segment, polygon}, 1);
  hold<Triangle3, Aabb3>(74, 16, {nothing, polygon}, 1);
  hold<Triangle3, Obb3>(75, 10, {nothing, polygon}, 1);
  hold<Triangle3, ConvexPolyhedron3>(76, 12, {nothing, polygon}, 1);
}

}  // namespace
}  // namespace plumb
