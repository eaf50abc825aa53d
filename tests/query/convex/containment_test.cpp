// Does one figure hold another where rationals say so, and under the laws?
#include "plumb/query/convex/containment.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "query/body/exact_sets.hpp"

namespace plumb {
namespace {

using exact::Coordinates;
using shape_cases::Material, shape_cases::on_shapes;

/// With diagonals, or with the axes alone where a sum of coordinates is beyond all doubles.
template <class Point, class Directions>
auto k_dop_of(const std::vector<Point>& points, const Directions& directions, const Directions& axes) {
  try {
    return fit_k_dop(points, directions);
  } catch (const BeyondDoubles&) {
    return fit_k_dop(points, axes);
  }
}

template <class Figure>
Figure any_figure(Material& m) {
  if constexpr (std::is_same_v<Figure, ConvexPolyhedron3>) {
    std::vector<Point3> points;
    for (std::size_t n = 4 + m.below(3); n-- > 0;) points.push_back(m.point3());
    for (const Point3& p : {Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      if (const Hull3 hull = convex_hull(points); hull.dimension == 3) return convex_polyhedron(hull, points);
      points.push_back(p);
    }
    return convex_polyhedron(convex_hull(points), points);
  } else if constexpr (std::is_same_v<Figure, Polygon2>) {
    const Polygon2 p = m.shape<Polygon2>();
    Polygon2 convex;
    for (const std::uint32_t i : convex_hull(p.vertices).vertices) convex.vertices.push_back(p.vertices[i]);
    while (convex.vertices.size() < 3) convex.vertices.push_back(convex.vertices.back());
    return convex;
  } else if constexpr (std::is_same_v<Figure, Polygon3>) {
    const Triangle3 t = m.shape<Triangle3>();
    return {{t.a, t.b, t.c}};
  } else if constexpr (std::is_same_v<Figure, KDop3>) {
    return k_dop_of(std::vector{m.point3(), m.point3()}, k_dop_directions(m.below(2) == 0 ? 6 : 14),
                    k_dop_directions(6));
  } else if constexpr (std::is_same_v<Figure, KDop2>) {
    return k_dop_of(std::vector{m.point2(), m.point2()}, k_dop_directions2(m.below(2) == 0 ? 4 : 8),
                    k_dop_directions2(4));
  } else {
    return m.shape<Figure>();
  }
}

/// A figure whose type was forgotten; its corners, where it is the hull of them; does it hold a point?
struct Drawn {
  query::FigureView view;
  std::shared_ptr<const void> held;
  std::optional<std::vector<Coordinates>> corners;
  std::function<bool(const Point3&)> has;
  std::string about;
};
template <class Figure>
Drawn drawn(Material& m) {
  const auto s = std::make_shared<const Figure>(any_figure<Figure>(m));
  Drawn d{query::view_of(*s), s, {}, {}, std::string(name_of(figure_kind<Figure>)) + " " + m.about(*s) + " "};
  if constexpr (requires { exact::generated(*s); }) {
    if (auto g = exact::generated(*s); g.rays.empty()) d.corners = std::move(g.points);
  }
  d.has = [s](const Point3& p) {
    if constexpr (figure_dimension<Figure> == 2) {
      return contains(*s, Point2{p.x, p.y});
    } else {
      return contains(*s, p);
    }
  };
  return d;
}

using Draw = Drawn (*)(Material&);
constexpr std::array<Draw, 15> of_space{
    drawn<Halfspace3>, drawn<Triangle3>, drawn<Rectangle3>, drawn<Tetrahedron3>, drawn<Sphere3>,
    drawn<Aabb3>,      drawn<Obb3>,      drawn<Capsule3>,   drawn<Lozenge3>,     drawn<Cylinder3>,
    drawn<Polygon3>,   drawn<KDop3>,     drawn<Segment3>,   drawn<Cone3>,        drawn<ConvexPolyhedron3>};
constexpr std::array<Draw, 10> of_plane{drawn<Halfspace2>, drawn<Triangle2>, drawn<Polygon2>, drawn<Circle2>,
                                        drawn<Aabb2>,      drawn<Obb2>,      drawn<Capsule2>, drawn<KDop2>,
                                        drawn<Segment2>,   drawn<Ray2>};

/// Every ordered pair: against the corners, by points of both, and by what holds the outer one.
template <std::size_t N>
void hold_pairs(const std::array<Draw, N>& draws, std::uint64_t start, std::uint64_t cases) {
  int held = 0, not_held = 0;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      on_shapes(start + i * N + j, cases, [&](Material& m) {
        const Drawn a = draws[i](m), b = draws[j](m), c = draws[m.below(N)](m);
        if (!query::answers_containment(a.view.kind, b.view.kind)) return;
        const bool holds = query::holds(a.view, b.view);
        const std::string about = a.about + b.about;
        if (a.corners && b.corners) {
          bool expected = true;
          for (const Coordinates& p : *b.corners) expected = expected && exact::in_hull(*a.corners, p);
          EXPECT_EQ(holds, expected) << about;
        }
        (holds ? held : not_held) += 1;
        for (int probes = 0; probes < 8; ++probes) {
          const Point3 p = b.view.dimension == 3 ? m.probe3() : Point3{m.probe2().x, m.probe2().y, 0};
          EXPECT_FALSE(holds && b.has(p) && !a.has(p)) << about;
        }
        if (query::answers_containment(a.view.kind, a.view.kind)) {
          EXPECT_TRUE(query::holds(a.view, a.view)) << a.about;
        }
        if (holds && query::answers_containment(c.view.kind, a.view.kind) &&
            query::answers_containment(c.view.kind, b.view.kind) && query::holds(c.view, a.view)) {
          EXPECT_TRUE(query::holds(c.view, b.view)) << c.about << about;
        }
      });
    }
  }
  const int least = battery::reaches_rare ? static_cast<int>(N) : 1;
  EXPECT_GE(held, least);
  EXPECT_GE(not_held, least);
}

const std::uint64_t some = battery::sanitized ? 1 : 15;

TEST(Containment, OfSpace) { hold_pairs(of_space, 1, some); }
TEST(Containment, OfThePlane) { hold_pairs(of_plane, 501, 2 * some); }

/// The special functions of a kind say the same.
template <class Shape>
void agrees_with_own(std::uint64_t start, std::uint64_t cases) {
  int held = 0;
  on_shapes(start, cases, [&](Material& m) {
    const auto a = any_figure<Shape>(m);
    auto b = any_figure<Shape>(m);
    if constexpr (requires { b.radius; }) {
      if (m.below(2) == 0) b = a, b.radius /= 2;
    }
    const bool expected = contains(a, b);
    held += expected ? 1 : 0;
    EXPECT_EQ(query::holds(query::view_of(a), query::view_of(b)), expected) << m.about(a, b);
  });
  EXPECT_GE(held, 1) << start;
}

TEST(Containment, AgreesWithThoseOfOneKind) {
  agrees_with_own<Circle2>(701, 60);
  agrees_with_own<Sphere3>(702, 60);
  agrees_with_own<Aabb2>(703, 60);
  agrees_with_own<Aabb3>(704, 100);
  agrees_with_own<Capsule3>(705, 40);
  agrees_with_own<Lozenge3>(706, 30);
  agrees_with_own<KDop3>(707, 20);
}

/// Held while the radius is at most this, which touches from inside.
template <class Outer, class Round>
void holds_up_to(const Outer& outer, Round round, double radius) {
  round.radius = radius;
  EXPECT_TRUE(contains(outer, round)) << radius;
  round.radius = moved_by_ulps(radius, 1);
  EXPECT_FALSE(contains(outer, round)) << radius;
}

TEST(Containment, TouchesFromInside) {
  const Obb3 slanted{
      {0, 0, 0}, {Vector3{3, 4, 0}, Vector3{-4, 3, 0}, Vector3{0, 0, 1}}, {2, 2, 10}};  // 10 to all sides
  holds_up_to(slanted, Sphere3{{0, 0, 0}, 0}, 10);
  holds_up_to(slanted, Capsule3{{0, 0, -2}, {0, 0, 2}, 0}, 8);
  holds_up_to(slanted, Lozenge3{{3, 4, 0}, {Vector3{-6, -8, 0}, Vector3{0, 0, 1}}, 0}, 5);
  holds_up_to(slanted, Cylinder3{{3, 4, 0}, {-3, -4, 0}, 0}, 10);
  holds_up_to(slanted, Cone3{{0, 0, 10}, {0, 0, -10}, 0}, 10);
  holds_up_to(Halfspace3{{3, 0, 4}, 0}, Sphere3{{-3, 9, -4}, 0}, 5);
  holds_up_to(Halfspace3{{3, 0, 4}, 25}, Cylinder3{{0, 0, 0}, {0, 0, 4}, 0}, 3);  // 3 x + 4 * 4 <= 25
  const Sphere3 ball{{0, 0, 0}, 13};
  holds_up_to(ball, Cylinder3{{0, 0, -5}, {0, 0, 5}, 0}, 12);
  holds_up_to(ball, Cylinder3{{3, 0, -12}, {3, 0, 0}, 0}, 2);  // the farthest point: (5, 0, -12)
  holds_up_to(ball, Cone3{{0, 13, 0}, {0, -5, 0}, 0}, 12);
  holds_up_to(ball, Capsule3{{3, 4, 0}, {-3, 0, 4}, 0}, 8);
  const Cylinder3 pipe{{0, 0, 0}, {0, 0, 20}, 10};
  holds_up_to(pipe, Sphere3{{3, 4, 10}, 0}, 5);
  holds_up_to(pipe, Sphere3{{0, 0, 3}, 0}, 3);
  holds_up_to(pipe, Capsule3{{3, 4, 10}, {-6, 0, 10}, 0}, 4);
  EXPECT_TRUE(contains(pipe, Aabb3{{-6, -8, 0}, {6, 8, 20}}));
  EXPECT_FALSE(contains(pipe, Aabb3{{-6, -8, 0}, {6, moved_by_ulps(8.0, 1), 20}}));
  const Lozenge3 pad{{0, 0, 0}, {Vector3{8, 0, 0}, Vector3{0, 8, 0}}, 5};
  holds_up_to(pad, Sphere3{{4, 4, 3}, 0}, 2);
  holds_up_to(pad, Sphere3{{11, 4, 0}, 0}, 2);
  EXPECT_TRUE(contains(pad, Aabb3{{-3, 0, -4}, {8, 8, 4}}));
  holds_up_to(Capsule2{{0, 0}, {8, 0}, 5}, Circle2{{11, 0}, 0}, 2);
  holds_up_to(Obb2{{0, 0}, {Vector2{3, 4}, Vector2{-4, 3}}, {1, 2}}, Capsule2{{0, 0}, {-4, 3}, 0}, 5);
}

TEST(Containment, NothingAndForever) {
  const Aabb3 empty{{1, 0, 0}, {0, 1, 1}};
  EXPECT_TRUE(contains(Sphere3{{5, 5, 5}, 0}, empty));
  EXPECT_FALSE(contains(empty, Sphere3{{0.5, 0.5, 0.5}, 0}));
  EXPECT_TRUE(contains(empty, HalfspaceIntersection3{{{{0, 0, 0}, -1}}}));
  EXPECT_TRUE(contains(HalfspaceIntersection3{}, Line3{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_TRUE(contains(Halfspace3{{0, 0, 1}, 2}, Halfspace3{{0, 0, 4}, 8}));
  EXPECT_FALSE(contains(Halfspace3{{0, 0, 1}, 2}, Halfspace3{{0, 0, 4}, moved_by_ulps(8.0, 1)}));
  EXPECT_TRUE(contains(Halfspace2{{0, 1}, 2}, Ray2{{0, 2}, {5, -1}}));
  EXPECT_FALSE(contains(Halfspace2{{0, 1}, 2}, Ray2{{0, 2}, {5, 0x1p-1074}}));
  EXPECT_FALSE(contains(Sphere3{{0, 0, 0}, 1e300}, Ray3{{0, 0, 0}, {0, 0, 0x1p-1074}}));
  // Quadrilaterals and what winds are held where their corners are.
  EXPECT_TRUE(contains(Circle2{{0, 0}, 5}, Polygon2{{{3, 4}, {-3, -4}, {-3, 4}, {3, -4}}}));
}

TEST(Containment, BadInputIsNamed) {
  EXPECT_EQ(text_of<Error>([] {
              (void)contains(Aabb3{{0, 0, 0}, {1, 1, NAN}}, Sphere3{});
            }),
            "contains: aabb.max.z is nan, not a real number; give a finite double");
  EXPECT_EQ(text_of<Error>([] {
              (void)contains(Sphere3{{0, 0, 0}, -1}, Obb3{});
            }),
            "contains: sphere.radius is negative; give zero or more");
  EXPECT_EQ(text_of<Error>([] {
              (void)contains(Polygon2{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, Circle2{});
            }),
            "contains: the outer polygon is not convex; ask its convex pieces, or locate points in it");
  EXPECT_EQ(text_of<Error>([] {
              (void)contains(Polygon3{{{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}}, Segment3{});
            }),
            "contains: the outer polygon is not planar");
}

}  // namespace
}  // namespace plumb
