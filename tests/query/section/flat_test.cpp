// Is what polygons and rectangles in space, and oriented boxes of the plane, have in common with others what rationals
// say?
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/query/section/intersection.hpp"
#include "query/body/exact_sets.hpp"

namespace plumb {
namespace {

using exact::Coordinates, exact::Generators;
using shape_cases::Material, shape_cases::on_shapes;

template <class Box>
Generators zonotope(const Box& b, std::initializer_list<double> halves) {
  Generators g{{exact::of(b.center)}, {}};
  std::size_t i = 0;
  for (const double half : halves) {
    std::vector<Coordinates> corners;
    for (const Coordinates& p : g.points) {
      for (const double x : {half, -half})
        corners.push_back(exact::combination(p, exact::Rational(x), exact::of(b.axes[i])));
    }
    g.points = corners;
    ++i;
  }
  return g;
}
template <class Figure>
Generators generators_of(const Figure& s) {
  if constexpr (std::is_same_v<Figure, Obb2> || std::is_same_v<Figure, Rectangle3>) {
    return zonotope(s, {s.half.x, s.half.y});
  } else if constexpr (std::is_same_v<Figure, Polygon3>) {
    Generators g;
    for (const Point3& v : s.vertices) g.points.push_back(exact::of(v));
    return g;
  } else {
    return exact::generated(s);
  }
}

template <class Figure>
Figure figure_of(Material& m) {
  if constexpr (std::is_same_v<Figure, Polygon3>) {
    // A triangle, or one with its corners cut at the middles of edges, where doubles hold those.
    const Triangle3 t = m.shape<Triangle3>();
    const auto middle = [](const Point3& p, const Point3& q) {
      return Point3{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
    };
    Polygon3 p{{t.a, middle(t.a, t.b), middle(t.b, t.c), t.c}};
    return m.below(2) == 0 && is_planar(p) && is_convex(p) ? p : Polygon3{{t.a, t.b, t.c}};
  } else if constexpr (std::is_same_v<Figure, Polygon2>) {
    const Triangle2 t = m.shape<Triangle2>();
    return {{t.a, t.b, t.c}};
  } else {
    return m.shape<Figure>();
  }
}

struct Drawn {
  query::FigureView view;
  std::shared_ptr<const void> held;
  Generators set;
  std::string about;
};
template <class Figure>
Drawn drawn(Material& m) {
  const auto s = std::make_shared<const Figure>(figure_of<Figure>(m));
  return {query::view_of(*s), s, generators_of(*s),
          std::string(name_of(figure_kind<Figure>)) + " " + m.about(*s) + " "};
}

using Draw = Drawn (*)(Material&);
constexpr std::array<Draw, 11> of_space{drawn<Rectangle3>, drawn<Polygon3>,     drawn<Line3>,
                                        drawn<Ray3>,       drawn<Segment3>,     drawn<Plane3>,
                                        drawn<Triangle3>,  drawn<Tetrahedron3>, drawn<ThreePointPlane3>,
                                        drawn<Halfspace3>, drawn<Aabb3>};
constexpr std::array<Draw, 7> of_plane{drawn<Obb2>,      drawn<Line2>,    drawn<Ray2>, drawn<Segment2>,
                                       drawn<Triangle2>, drawn<Polygon2>, drawn<Aabb2>};

template <std::size_t N, class Common>
void hold(const std::array<Draw, N>& draws, std::size_t first, Common common, std::uint64_t start,
          std::uint64_t cases) {
  std::map<IntersectionKind, int> count;
  for (std::size_t i = 0; i < first; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      on_shapes(start + i * N + j, battery::sanitized ? 1 + cases / 10 : cases, [&](Material& m) {
        const Drawn a = draws[i](m), b = draws[j](m);
        const auto told = common(a.view, b.view);
        ++count[told.kind];
        EXPECT_EQ(exact::wrong(told, exact::common(a.set, b.set)), "") << a.about << b.about;
        EXPECT_TRUE(told == common(b.view, a.view)) << a.about << b.about;
      });
    }
  }
  if (!battery::reaches_rare) return;
  for (const auto kind :
       {IntersectionKind::nothing, IntersectionKind::point, IntersectionKind::segment, IntersectionKind::polygon}) {
    EXPECT_GE(count[kind], 3) << static_cast<int>(kind);
  }
}

TEST(Flat, OfSpace) { hold(of_space, 2, query::common_set3, 301, 6); }
TEST(Flat, OrientedBoxesOfThePlane) { hold(of_plane, 1, query::common_set2, 401, 30); }

TEST(Flat, InEitherOrder) {
  const Polygon3 square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
  const Rectangle3 upright{{1, 1, 0}, {Vector3{1, 0, 0}, Vector3{0, 0, 1}}, {4, 1}};
  EXPECT_EQ(approximate(intersection(square, upright)), (std::vector<Point3>{{0, 1, 0}, {2, 1, 0}}));
  EXPECT_TRUE(intersection(upright, square) == intersection(square, upright));
  EXPECT_EQ(intersection(Plane3{{0, 0, 1}, 0}, square).kind, IntersectionKind::polygon);
  EXPECT_EQ(intersection(square, Ray3{{1, 1, 1}, {0, 0, -1}}).kind, IntersectionKind::point);
  EXPECT_EQ(intersection(Aabb3{{1, 1, 0}, {3, 3, 3}}, square).vertices.size(), 4u);
  const Obb2 turned{{0, 0}, {Vector2{1, 1}, Vector2{-1, 1}}, {1, 1}};
  EXPECT_EQ(approximate(intersection(turned, Aabb2{{-1, 0}, {3, 3}})),
            (std::vector<Point2>{{-1, 0}, {2, 0}, {0, 2}, {-1, 1}}));
  EXPECT_EQ(approximate(intersection(Segment2{{-5, 0}, {5, 0}}, turned)), (std::vector<Point2>{{-2, 0}, {2, 0}}));
  EXPECT_EQ(intersection(turned, turned).vertices.size(), 4u);
}

TEST(Flat, BadInputIsNamed) {
  const Segment3 s{{0, 0, -1}, {0, 0, 1}};
  EXPECT_EQ(text_of<Error>([&] {
              (void)intersection(s, Polygon3{{{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}});
            }),
            "intersection: polygon is not planar; triangulate it or intersect its triangles");
  EXPECT_EQ(text_of<Error>([&] {
              (void)intersection(s, Polygon3{{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}});
            }),
            "intersection: polygon is not convex; triangulate it or intersect its convex pieces");
  EXPECT_EQ(text_of<Error>([&] {
              (void)intersection(Obb2{{0, 0}, {Vector2{NAN, 0}, Vector2{}}, {1, 1}}, Aabb2{});
            }),
            "intersection: obb.axes[0].x is nan, not a real number; give a finite double");
}

}  // namespace
}  // namespace plumb
