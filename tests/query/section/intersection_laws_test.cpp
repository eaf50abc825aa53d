// Do common sets keep their laws, agree with CGAL, and show what the figures of RTCD show?
#include <gtest/gtest.h>

#include <cmath>

#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "oracle/intersections.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/planes.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;

std::vector<std::vector<std::string>> texts(const Intersection2& set) {
  std::vector<std::vector<std::string>> all;
  for (const ExactPoint2& v : set.vertices) {
    const RationalPoint2 p = rational_point(v);
    all.push_back({p.x.text(), p.y.text()});
  }
  std::ranges::sort(all);
  return all;
}
std::vector<std::vector<std::string>> texts(const Intersection3& set) {
  std::vector<std::vector<std::string>> all;
  for (const ExactPoint3& v : set.vertices) {
    const RationalPoint3 p = rational_point(v);
    all.push_back({p.x.text(), p.y.text(), p.z.text()});
  }
  std::ranges::sort(all);
  return all;
}

template <class A, class B>
void hold_against_cgal(std::uint64_t start, std::uint64_t cases, double least_met) {
  std::uint64_t answered = 0, met = 0;
  on_shapes(start, cases, [&](Material& m) {
    const auto a = m.shape<A>();
    const auto b = m.shape<B>();
    const oracle::CommonVertices expected = oracle::common_vertices(a, b);
    if (!expected) return;
    const auto told = intersection(a, b);
    ++answered;
    met += told.empty() ? 0 : 1;
    EXPECT_EQ(texts(told), *expected) << m.about(a, b);
  });
  EXPECT_GE(static_cast<double>(met), least_met * static_cast<double>(answered));
  EXPECT_GE(answered * 3, cases);
}

TEST(IntersectionLaws, AgreesWithCgalInThePlane) {
  hold_against_cgal<Segment2, Segment2>(101, 1600, 0.1);
  hold_against_cgal<Line2, Triangle2>(102, 800, 0.3);
  hold_against_cgal<Segment2, Triangle2>(103, 800, 0.2);
  hold_against_cgal<Triangle2, Triangle2>(104, 800, 0.2);
  hold_against_cgal<Segment2, Aabb2>(106, 800, 0.2);
}

TEST(IntersectionLaws, AgreesWithCgalInSpace) {
  hold_against_cgal<Segment3, Segment3>(111, 1200, 0.05);
  hold_against_cgal<Line3, Plane3>(112, 600, 0.3);
  hold_against_cgal<Segment3, Triangle3>(113, 1200, 0.05);
  hold_against_cgal<Line3, Triangle3>(114, 800, 0.1);
  hold_against_cgal<Segment3, Aabb3>(115, 600, 0.1);
  hold_against_cgal<Plane3, Triangle3>(116, 600, 0.3);
  hold_against_cgal<Plane3, Tetrahedron3>(117, 600, 0.3);
  hold_against_cgal<Plane3, Aabb3>(118, 400, 0.3);
  hold_against_cgal<Triangle3, Triangle3>(119, 1200, 0.05);
  hold_against_cgal<Triangle3, Aabb3>(120, 600, 0.1);
  hold_against_cgal<Triangle3, Tetrahedron3>(121, 600, 0.05);
}

// Common moves of the figures of one case, all of small integers: exact.
struct Move {
  int exponent = 0;
  Vector3 by{0, 0, 0};
  bool cycled = false;  // x y z become y z x

  [[nodiscard]] Point3 operator()(const Point3& p) const {
    const Point3 q{std::ldexp(p.x, exponent) + by.x, std::ldexp(p.y, exponent) + by.y,
                   std::ldexp(p.z, exponent) + by.z};
    return cycled ? Point3{q.y, q.z, q.x} : q;
  }
  [[nodiscard]] Triangle3 operator()(const Triangle3& t) const { return {(*this)(t.a), (*this)(t.b), (*this)(t.c)}; }
  [[nodiscard]] Segment3 operator()(const Segment3& s) const { return {(*this)(s.a), (*this)(s.b)}; }
  [[nodiscard]] RationalPoint3 operator()(const ExactPoint3& v) const {
    const RationalPoint3 p = rational_point(v);
    const Rational factor(std::ldexp(1, exponent));
    const RationalPoint3 q{p.x * factor + by.x, p.y * factor + by.y, p.z * factor + by.z};
    return cycled ? RationalPoint3{q.y, q.z, q.x} : q;
  }
};

Point3 small_point(Entropy& e, bool flat) {
  const auto x = static_cast<double>(e.within(3)), y = static_cast<double>(e.within(3));
  return {x, y, flat ? 0 : static_cast<double>(e.within(2))};
}

template <class A, class B>
void hold_moves(const A& a, const B& b, std::uint64_t index) {
  const auto expected = intersection(a, b);
  for (const Move& move : {Move{.exponent = 40}, Move{.exponent = -1000}, Move{.by = {1024, -512, 4096}},
                           Move{.cycled = true}, Move{.exponent = 3, .by = {7, 0, -9}, .cycled = true}}) {
    const auto told = intersection(move(a), move(b));
    Intersection3 moved{expected.kind, {}};
    for (const ExactPoint3& v : expected.vertices) moved.vertices.emplace_back(move(v));
    EXPECT_EQ(told.kind, expected.kind) << "start 131 index " << index;
    EXPECT_EQ(texts(told), texts(moved)) << "start 131 index " << index;
  }
}

TEST(IntersectionLaws, MovesMoveTheSetAndOrdersChangeNothing) {
  std::array<int, 7> kinds{};
  for (std::uint64_t index = 0; index < 300 * shape_cases::more; ++index) {
    Entropy e(131, index);
    const bool flat = e.below(4) == 0;
    const auto corner = [&] { return small_point(e, flat); };
    const Triangle3 t{corner(), corner(), corner()}, u{corner(), corner(), corner()};
    const Segment3 s{corner(), corner()};
    const auto common = intersection(t, u);
    ++kinds[static_cast<std::size_t>(common.kind)];
    for (const Triangle3& v : {Triangle3{u.b, u.c, u.a}, Triangle3{u.a, u.c, u.b}, Triangle3{u.c, u.b, u.a}}) {
      EXPECT_EQ(common.vertices, intersection(t, v).vertices) << "start 131 index " << index;
      EXPECT_EQ(common.vertices, intersection(v, t).vertices) << "start 131 index " << index;
    }
    EXPECT_EQ(intersection(s, t).vertices, intersection(Segment3{s.b, s.a}, t).vertices);
    hold_moves(t, u, index);
    hold_moves(s, t, index);
  }
  for (const IntersectionKind kind :
       {IntersectionKind::nothing, IntersectionKind::point, IntersectionKind::segment, IntersectionKind::polygon})
    EXPECT_GE(kinds[static_cast<std::size_t>(kind)], 5) << static_cast<int>(kind);
}

TEST(IntersectionLaws, NearestDoublesAreRoundedOnce) {
  // Between the neighbors of the nearest double's halves, by rationals.
  int inexact = 0;
  on_shapes(132, 200, [&](Material& m) {
    const auto a = m.shape<Segment2>();
    const auto b = m.shape<Line2>();
    for (const ExactPoint2& v : intersection(a, b).vertices) {
      const RationalPoint2 exact = rational_point(v);
      const Point2 p = approximate(v);  // a point of a segment is within doubles
      const auto gap = [](const Rational& x, double y) { return x < Rational(y) ? Rational(y) - x : x - Rational(y); };
      for (const auto& [x, y] : {std::pair{exact.x, p.x}, {exact.y, p.y}}) {
        for (const double to : {-INFINITY, INFINITY}) {
          const double other = std::nextafter(y, to);
          if (!std::isfinite(other)) continue;
          EXPECT_LE(gap(x, y), gap(x, other)) << m.about(a, b);
        }
        inexact += x == Rational(y) ? 0 : 1;
      }
    }
  });
  EXPECT_GE(inexact, 20);
}

TEST(IntersectionLaws, CornersArePredicatesInput) {
  // The corners of a common polygon lie on both planes, exactly, which their nearest doubles need not.
  const Triangle3 t{{0, 0, 0.1}, {1, 0.3, 0.7}, {0.2, 1, 0.3}}, u{{0.3, 0.1, -1}, {0.35, 0.4, 2}, {0.6, 0.2, 0.4}};
  const Intersection3 common = intersection(t, u);
  ASSERT_EQ(common.kind, IntersectionKind::segment);
  for (const ExactPoint3& v : common.vertices) {
    EXPECT_EQ(orient3d(t.a, t.b, t.c, v), Sign::zero);
    EXPECT_EQ(orient3d(u.a, u.b, u.c, v), Sign::zero);
    const auto* crossing = std::get_if<LinePlanePoint3>(&v.as());
    ASSERT_NE(crossing, nullptr);
    EXPECT_EQ(orient3d(t.a, t.b, t.c, *crossing), Sign::zero);
  }
}

using Corners = std::vector<Point3>;

TEST(IntersectionLaws, Figure519TrianglesInGeneral) {
  const Triangle3 t{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  // (a) two edges of one pierce the inside of the other; (b) one edge of each does.
  EXPECT_EQ(approximate(intersection(t, Triangle3{{1, 1, -1}, {3, 1, -1}, {2, 2, 1}})),
            (Corners{{1.5, 1.5, 0}, {2.5, 1.5, 0}}));
  EXPECT_EQ(approximate(intersection(t, Triangle3{{2, 2, -1}, {2, 2, 1}, {-2, 2, -1}})),
            (Corners{{0, 2, 0}, {2, 2, 0}}));
  // In one plane: the star of six corners.
  EXPECT_EQ(approximate(intersection(t, Triangle3{{6, 6, 0}, {-2, 6, 0}, {6, -2, 0}})),
            (Corners{{0, 4, 0}, {4, 0, 0}, {6, 0, 0}, {6, 2, 0}, {2, 6, 0}, {0, 6, 0}}));
  // Touching at corners, along an edge, a corner inside; flat ones.
  EXPECT_EQ(approximate(intersection(t, Triangle3{{8, 0, 0}, {9, 0, 0}, {9, 1, 5}})), (Corners{{8, 0, 0}}));
  EXPECT_EQ(approximate(intersection(t, Triangle3{{1, 0, 0}, {5, 0, 0}, {1, 0, 5}})), (Corners{{1, 0, 0}, {5, 0, 0}}));
  EXPECT_EQ(approximate(intersection(t, Triangle3{{2, 3, 0}, {5, 0, 4}, {1, 0, 5}})), (Corners{{2, 3, 0}}));
  EXPECT_EQ(approximate(intersection(t, Triangle3{{-1, 2, 0}, {3, 2, 0}, {1, 2, 0}})), (Corners{{0, 2, 0}, {3, 2, 0}}));
  EXPECT_TRUE(intersection(t, Triangle3{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).empty());
}

TEST(IntersectionLaws, Figure520SegmentAndPlane) {
  const Plane3 plane{{0, 0, 2}, 1};  // z = 1/2
  EXPECT_EQ(approximate(intersection(Segment3{{0, 0, 0}, {1, 2, 1}}, plane)), (Corners{{0.5, 1, 0.5}}));
  EXPECT_TRUE(intersection(Segment3{{0, 0, 0}, {1, 2, 0.4}}, plane).empty());
  EXPECT_EQ(approximate(intersection(plane, Segment3{{0, 0, 0.5}, {1, 2, 7}})), (Corners{{0, 0, 0.5}}));
  EXPECT_EQ(intersection(plane, Segment3{{0, 0, 0.5}, {1, 2, 0.5}}).kind, IntersectionKind::segment);
  EXPECT_EQ(intersection(Plane3{{0, 0, 0}, 0}, Segment3{{0, 0, 0.5}, {1, 2, 3}}).kind, IntersectionKind::segment);
  EXPECT_TRUE(intersection(Plane3{{0, 0, 0}, 1}, Segment3{{0, 0, 0.5}, {1, 2, 3}}).empty());
  // The largest doubles there are.
  EXPECT_EQ(approximate(intersection(Segment3{{0, 0, -1e308}, {1e308, 0, 1.5e308}}, Plane3{{0, 0, 1}, 0})),
            (Corners{{4e307, 0, 0}}));
}

TEST(IntersectionLaws, Figure522RayAndBox) {
  const Aabb3 box{{0, 0, 0}, {2, 1, 1}};
  // The first ray leaves one slab before it enters the other, the second does not.
  EXPECT_TRUE(intersection(Ray3{{-1, 0, 0.5}, {1, 2, 0}}, box).empty());
  EXPECT_EQ(approximate(intersection(Ray3{{-1, 0, 0.5}, {4, 1, 0}}, box)), (Corners{{0, 0.25, 0.5}, {2, 0.75, 0.5}}));
  // Direction zero across two slabs: along an edge, inside a face, beyond.
  EXPECT_EQ(approximate(intersection(Ray3{{-1, 1, 1}, {1, 0, 0}}, box)), (Corners{{0, 1, 1}, {2, 1, 1}}));
  EXPECT_EQ(approximate(intersection(Ray3{{1, 0.5, 1}, {1, 0, 0}}, box)), (Corners{{1, 0.5, 1}, {2, 0.5, 1}}));
  EXPECT_TRUE(intersection(Ray3{{-1, 1.25, 1}, {1, 0, 0}}, box).empty());
  EXPECT_TRUE(intersection(Ray3{{3, 0.5, 1}, {1, 0, 0}}, box).empty());
  EXPECT_EQ(approximate(intersection(Ray3{{2, 1, 1}, {1, 1, 1}}, box)), (Corners{{2, 1, 1}}));
  EXPECT_TRUE(intersection(Line3{{0, 0, 0}, {1, 1, 1}}, Aabb3{{1, 0, 0}, {0, 1, 1}}).empty());
}

TEST(IntersectionLaws, BadInputIsNamed) {
  const Triangle3 t{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  EXPECT_EQ(text_of<Error>([&] {
              (void)intersection(Ray3{{0, 0, 0}, {0, NAN, 0}}, t);
            }),
            "intersection: ray.direction.y is nan, not a real number; give a finite double");
  EXPECT_EQ(text_of<Error>([&] {
              (void)intersection(t, Aabb3{{0, 0, 0}, {0, 0, INFINITY}});
            }),
            "intersection: aabb.max.z is inf, not a real number; give a finite double");
  EXPECT_EQ(text_of<Error>([&] {
              (void)intersection(Segment2{{0, 0}, {1, 1}}, Polygon2{{{0, 0}, {1, 0}}});
            }),
            "intersection: polygon.vertices has 2 vertices; a polygon has three at least");
  EXPECT_EQ(text_of<Error>([&] {
              (void)intersection(Segment2{{0, 0}, {1, 1}}, Polygon2{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}});
            }),
            "intersection: polygon is not convex; triangulate it or intersect its convex pieces");
  EXPECT_EQ(text_of<Error>([&] {
              (void)approximate(intersection(Line2{{0, 0}, {1e300, 1}}, Line2{{0, 1e300}, {1, 0}}));
            }),
            "approximate: a.x is beyond the largest double");
}

}  // namespace
}  // namespace plumb
