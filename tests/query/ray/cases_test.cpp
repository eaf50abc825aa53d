// Hand-written rays for every figure of section 5.3 and of 5.4.3, the laws, bad input; CGAL's and the quadrilaterals'
// answers on random ones.
#include "query/ray/cases.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "figure/basic/rational_polygon.hpp"
#include "oracle/first_hits.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/ray/parity.hpp"

namespace plumb {
namespace {

using namespace ray_cases;

constexpr Feature vertex(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge(std::uint32_t i) { return {FeatureKind::edge, i}; }
constexpr Feature face(std::uint32_t i) { return {FeatureKind::face, i}; }
constexpr Feature inside{FeatureKind::interior, 0};

void expect_hit(const std::optional<Hit>& hit, double t, Feature feature, const char* what) {
  ASSERT_TRUE(hit) << what;
  EXPECT_EQ(hit->t, t) << what;
  EXPECT_EQ(hit->feature.kind, feature.kind) << what;
  EXPECT_EQ(hit->feature.index, feature.index) << what;
}

bool hits_any(const AnyRay& r, const auto& shape) {
  const bool by_kind = r.kind == AnyRay::Kind::ray       ? hits(Ray3{r.origin, r.direction}, shape)
                       : r.kind == AnyRay::Kind::segment ? hits(Segment3{r.origin, r.end}, shape)
                                                         : hits(Line3{r.origin, r.direction}, shape);
  EXPECT_EQ(hits(r, shape), by_kind);
  return by_kind;
}

TEST(FirstHit, OfABoxBySegmentsThatOnlyAnAxisOfAnEdgeParts) {  // figure 5.23
  const Aabb3 box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_FALSE(hits(Segment3{{-3, 0, 0}, {0, 3, 0}}, box));  // past the edge x = -1, y = 1
  EXPECT_FALSE(first_hit(Segment3{{-3, 0, 0}, {0, 3, 0}}, box));
  expect_hit(first_hit(Segment3{{-3, -1, 0}, {1, 3, 0}}, box), 0.5, edge(8 + 2), "touches that edge");
  expect_hit(first_hit(Segment3{{-3, -1, -1}, {1, 3, 3}}, box), 0.5, vertex(6), "and its vertex");
  EXPECT_FALSE(
      hits(Segment3{{-3, -1, 0}, {std::nextafter(1, 2), 3, 0}}, Aabb3{{-1, -1, -1}, {-1, std::nextafter(1, 0), 1}}));
  // Zeros in the direction, an origin on a face, in the plane of a face.
  expect_hit(first_hit(Ray3{{-1, 0, 0}, {1, 0, 0}}, box), 0, face(0), "from a face inward");
  expect_hit(first_hit(Ray3{{-1, 0, 0}, {-1, 0, 0}}, box), 0, face(0), "from a face outward");
  expect_hit(first_hit(Ray3{{-1, -5, 0}, {0, 2, 0}}, box), 2, edge(8), "along a face");
  expect_hit(first_hit(Ray3{{-1, -5, 1}, {0, 2, 0}}, box), 2, vertex(4), "along an edge");
  EXPECT_FALSE(first_hit(Ray3{{-1, -5, std::nextafter(1, 2)}, {0, 2, 0}}, box));
  expect_hit(first_hit(Ray3{{0, 0, 0}, {1, 2, 3}}, box), 0, inside, "from inside");
  expect_hit(first_hit(Line3{{0, 0, 0}, {1, 0, 0}}, box), -1, face(0), "a line, before its point");
  expect_hit(first_hit(Ray3{{-1, 1, 1}, {0, 0, 0}}, box), 0, vertex(6), "a ray that is a point");
  EXPECT_FALSE(first_hit(Ray3{{-2, 0, 0}, {0, 0, 0}}, box));
  EXPECT_FALSE(first_hit(Ray3{{0, 0, 0}, {1, 0, 0}}, Aabb3{{1, 1, 1}, {-1, 2, 2}}));  // empty
}

TEST(FirstHit, OfATriangleByLinesThroughAllItsFeatures) {  // figures 5.24 and 5.25
  const Triangle3 t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  expect_hit(first_hit(Ray3{{1, 1, 2}, {0, 0, -1}}, t), 2, face(0), "from above");
  expect_hit(first_hit(Ray3{{1, 1, -2}, {0, 0, 1}}, t), 2, face(0), "from below");
  EXPECT_EQ(first_hit(Ray3{{1, 1, -2}, {0, 0, 1}}, t)->normal, (Vector3{0, 0, 16}));
  expect_hit(first_hit(Ray3{{2, 2, 1}, {0, 0, -2}}, t), 0.5, edge(1), "at bc");
  expect_hit(first_hit(Ray3{{0, 4, 1}, {0, 0, -2}}, t), 0.5, vertex(2), "at c");
  EXPECT_FALSE(first_hit(Ray3{{1, 1, 2}, {0, 0, 1}}, t));  // leads away
  expect_hit(first_hit(Line3{{1, 1, 2}, {0, 0, 1}}, t), -2, face(0), "the line");
  EXPECT_FALSE(first_hit(Segment3{{1, 1, 2}, {1, 1, 0x1p-1074}}, t));
  expect_hit(first_hit(Segment3{{1, 1, 2}, {1, 1, 0}}, t), 1, face(0), "ends on it");
  // In the plane: across, along an edge, from inside, past a vertex.
  expect_hit(first_hit(Ray3{{-1, 1, 0}, {2, 0, 0}}, t), 0.5, edge(2), "in the plane");
  expect_hit(first_hit(Ray3{{-1, 0, 0}, {2, 0, 0}}, t), 0.5, vertex(0), "along ab");
  expect_hit(first_hit(Ray3{{9, 0, 0}, {-2, 0, 0}}, t), 2.5, vertex(1), "along ba");
  expect_hit(first_hit(Ray3{{1, 0, 0}, {1, 0, 0}}, t), 0, edge(0), "from ab along it");
  expect_hit(first_hit(Ray3{{1, 1, 0}, {1, 0, 0}}, t), 0, face(0), "from inside");
  expect_hit(first_hit(Ray3{{-1, 5, 0}, {1, -1, 0}}, t), 1, vertex(2), "along cb");
  expect_hit(first_hit(Ray3{{-2, 2, 0}, {1, 1, 0}}, t), 2, vertex(2), "touches c");
  EXPECT_FALSE(first_hit(Ray3{{-1, 1, 0x1p-1074}, {2, 0, 0}}, t));  // beside the plane
  // A segment and a point.
  const Triangle3 segment{{0, 0, 0}, {2, 2, 0}, {4, 4, 0}};
  expect_hit(first_hit(Ray3{{3, 3, 1}, {0, 0, -1}}, segment), 1, edge(1), "a triangle that is a segment");
  EXPECT_EQ(first_hit(Ray3{{3, 3, 1}, {0, 0, -1}}, segment)->normal, (Vector3{0, 0, 0}));
  expect_hit(first_hit(Ray3{{-1, -1, 0}, {1, 1, 0}}, segment), 1, vertex(0), "along it");
  expect_hit(first_hit(Ray3{{1, 1, 4}, {0, 0, -1}}, Triangle3{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), 3, vertex(0),
             "a point");
}

TEST(FirstHit, OfACylinderBySidesEndsAndEdges) {  // figure 5.26
  const Cylinder3 c{{0, 0, 0}, {0, 0, 2}, 1};
  expect_hit(first_hit(Ray3{{-3, 0, 1}, {1, 0, 0}}, c), 2, face(0), "the side");
  EXPECT_EQ(first_hit(Ray3{{-3, 0, 1}, {1, 0, 0}}, c)->normal, (Vector3{-1, 0, 0}));
  expect_hit(first_hit(Ray3{{-3, 1, 1}, {1, 0, 0}}, c), 3, face(0), "touches the side");
  expect_hit(first_hit(Ray3{{0.5, 0, -4}, {0, 0, 2}}, c), 2, face(1), "the end at a, parallel to the axis");
  expect_hit(first_hit(Ray3{{0.5, 0, 4}, {0, 0, -2}}, c), 1, face(2), "the end at b");
  EXPECT_EQ(first_hit(Ray3{{0.5, 0, 4}, {0, 0, -2}}, c)->normal, (Vector3{0, 0, 2}));
  expect_hit(first_hit(Ray3{{1, 0, -4}, {0, 0, 2}}, c), 2, edge(0), "along the side");
  expect_hit(first_hit(Ray3{{-3, 0, 2}, {1, 0, 0}}, c), 2, edge(1), "in the plane of an end");
  expect_hit(first_hit(Ray3{{-2, 0, 3}, {1, 0, -1}}, c), 1, edge(1), "at the circle");
  EXPECT_FALSE(first_hit(Ray3{{-3, 0, std::nextafter(2, 3)}, {1, 0, 0}}, c));
  EXPECT_FALSE(first_hit(Ray3{{2, 0, -4}, {0, 0, 2}}, c));
  expect_hit(first_hit(Ray3{{0, 0, 1}, {1, 0, 0}}, c), 0, inside, "from inside");
  // A ball for equal ends, a segment for no radius.
  expect_hit(first_hit(Ray3{{0, 0, 5}, {0, 0, -1}}, Cylinder3{{0, 0, 0}, {0, 0, 0}, 2}), 3, face(0), "a ball");
  expect_hit(first_hit(Ray3{{-3, 0, 1}, {1, 0, 0}}, Cylinder3{{0, 0, 0}, {0, 0, 2}, 0}), 3, face(0), "a segment");
  EXPECT_FALSE(first_hit(Ray3{{-3, 0x1p-1074, 1}, {1, 0, 0}}, Cylinder3{{0, 0, 0}, {0, 0, 2}, 0}));
}

TEST(FirstHit, OfACapsuleByItsThreeZones) {
  const Capsule3 c{{0, 0, 0}, {0, 0, 4}, 1};
  expect_hit(first_hit(Ray3{{-3, 0, 1}, {1, 0, 0}}, c), 2, face(0), "the side");
  expect_hit(first_hit(Ray3{{-3, 0, 0}, {1, 0, 0}}, c), 2, face(0), "the seam");
  expect_hit(first_hit(Ray3{{0, 0, -3}, {0, 0, 1}}, c), 2, face(1), "about a");
  expect_hit(first_hit(Ray3{{0, 0, 9}, {0, 0, -1}}, c), 4, face(2), "about b");
  EXPECT_EQ(first_hit(Ray3{{0, 0, 9}, {0, 0, -1}}, c)->normal, (Vector3{0, 0, 1}));
  expect_hit(first_hit(Ray3{{0, 0, 2}, {0, 0, 1}}, c), 0, inside, "from inside");
}

TEST(FirstHit, OfAPolyhedronByClippingAgainstAllHalfspaces) {  // figure 5.27
  const ConvexPolyhedron3 wedge = convex_polyhedron(
      TriangleMesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  const Ray3 across{{-4, 1, 1}, {1, 0, 0}};
  expect_hit(first_hit(across, wedge), 4, face(3), "enters by x = 0");
  EXPECT_EQ(first_hit(across, wedge)->normal, (Vector3{-16, 0, 0}));
  expect_hit(first_hit(Ray3{{5, 1, 1}, {-1, 0, 0}}, wedge), 3, face(2), "enters by the slope");
  EXPECT_EQ(first_hit(Ray3{{5, 1, 1}, {-1, 0, 0}}, wedge)->normal, (Vector3{16, 16, 16}));
  EXPECT_FALSE(first_hit(Ray3{{-4, 3, 3}, {1, 0, 0}}, wedge));  // enters one halfspace after it left another
  expect_hit(first_hit(Ray3{{-4, 2, 2}, {1, 0, 0}}, wedge), 4, edge(7), "touches an edge");
  expect_hit(first_hit(Ray3{{-4, 0, 4}, {1, 0, 0}}, wedge), 4, vertex(3), "touches a vertex");
  expect_hit(first_hit(Segment3{{-4, 1, 1}, {0, 1, 1}}, wedge), 1, face(3), "ends on it");
  EXPECT_FALSE(first_hit(Segment3{{-4, 1, 1}, {-0x1p-1074, 1, 1}}, wedge));
  EXPECT_THROW(static_cast<void>(first_hit(across, ConvexPolyhedron3{})), InvalidShape);
}

TEST(FirstHit, OfABallByATangentIsExact) {
  const Sphere3 ball{{0, 0, 0}, 5};
  expect_hit(first_hit(Ray3{{-9, 5, 0}, {1, 0, 0}}, ball), 9, face(0), "touches");
  EXPECT_EQ(first_hit(Ray3{{-9, 5, 0}, {1, 0, 0}}, ball)->normal, (Vector3{0, 5, 0}));
  EXPECT_FALSE(first_hit(Ray3{{-9, std::nextafter(5, 6), 0}, {1, 0, 0}}, ball));
  expect_hit(first_hit(Ray3{{-9, 3, 0}, {1, 0, 0}}, ball), 5, face(0), "a rational root");
  expect_hit(first_hit(Ray3{{-9, 3, 0}, {0x1p-1000, 0, 0}}, ball), std::ldexp(5, 1000), face(0), "a short direction");
  expect_hit(first_hit(Ray3{{3, 4, 0}, {1, 0, 0}}, ball), 0, face(0), "from the surface");
  // sqrt(23) to the last bit: exact roots are compared, not doubles.
  const auto t = first_hit_parameter(Ray3{{-9, 0, std::sqrt(2.0)}, {1, 0, 0}}, ball);
  const auto u = first_hit_parameter(Ray3{{-9, 0, std::nextafter(std::sqrt(2.0), 0)}, {1, 0, 0}}, ball);
  EXPECT_TRUE(*u < *t);
  EXPECT_EQ(t->rounded(), first_hit(Ray3{{-9, 0, std::sqrt(2.0)}, {1, 0, 0}}, ball)->t);
}

TEST(Parity, OfFourPointsShotFromInAHornedSolid) {  // figure 5.29
  // A box with a notch: the ray along x from some points passes vertices, edges and faces that lie along it.
  const TriangleMesh mesh{{{0, 0, 0},
                           {4, 0, 0},
                           {4, 0, 4},
                           {2, 0, 2},
                           {0, 0, 4},  //
                           {0, 4, 0},
                           {4, 4, 0},
                           {4, 4, 4},
                           {2, 4, 2},
                           {0, 4, 4}},
                          {{0, 1, 3},
                           {1, 2, 3},
                           {0, 3, 4},
                           {5, 8, 6},
                           {6, 8, 7},
                           {5, 9, 8},  //
                           {0, 5, 1},
                           {5, 6, 1},
                           {1, 6, 2},
                           {6, 7, 2},
                           {2, 7, 3},
                           {7, 8, 3},  //
                           {3, 8, 4},
                           {8, 9, 4},
                           {4, 9, 0},
                           {9, 5, 0}}};
  ASSERT_TRUE(is_oriented_closed(mesh));
  EXPECT_EQ(locate(mesh, {1, 2, 2}), Location::inside);    // toward the bottom of the notch
  EXPECT_EQ(locate(mesh, {0.5, 2, 3}), Location::inside);  // crosses the notch
  EXPECT_EQ(locate(mesh, {2, 2, 3}), Location::outside);   // in the notch
  EXPECT_EQ(locate(mesh, {-1, 2, 4}), Location::outside);  // past both horns' edges
  EXPECT_EQ(locate(mesh, {-1, 0, 2}), Location::outside);  // along a face
  EXPECT_EQ(locate(mesh, {2, 2, 2}), Location::boundary);
  EXPECT_EQ(winding_number(mesh, {1, 2, 1}), 1);
  EXPECT_EQ(winding_number(mesh, {2, 2, 3}), 0);
}

/// A quadrilateral in a plane of small integers, and the point where a ray from above meets that.
TEST(FirstHit, OfQuadrilateralsIsThatOfTheirChains) {
  std::array<long, 3> told{};
  for (std::uint64_t i = 0; i < 4000 * shape_cases::more; ++i) {
    Entropy e(801, i);
    const auto number = [&](std::int64_t most) { return static_cast<double>(e.within(most)); };
    std::vector<Point2> chain;
    for (int k = 0; k < 4; ++k) chain.push_back({number(3), number(3)});
    const Point2 at{number(6) / 2, number(6) / 2};
    const double u = number(2), v = number(2);  // the plane z = u x + v y
    const auto lift = [&](const Point2& p) { return Point3{p.x, p.y, u * p.x + v * p.y}; };
    const Quadrilateral3 q{lift(chain[0]), lift(chain[1]), lift(chain[2]), lift(chain[3])};
    const Point3 target = lift(at);
    const Vector3 way{number(2), number(2), number(2)};
    if (way.z == u * way.x + v * way.y) continue;
    const auto hit = first_hit(Ray3{{target.x - way.x, target.y - way.y, target.z - way.z}, way}, q);
    const auto winding = plumb_test::winding(chain, at);
    const bool expected = !winding || *winding % 2 != 0;
    ++told[!winding ? 0 : expected ? 1 : 2];
    // All corners on one line in the plane leave no inside, which the chain says as well.
    ASSERT_EQ(hit.has_value(), expected) << "index " << i;
    if (!hit) continue;
    EXPECT_EQ(hit->t, 1) << "index " << i;
    EXPECT_EQ(hit->point, target) << "index " << i;
    EXPECT_EQ(hit->feature == face(0), winding.has_value()) << "index " << i;
    // In the plane: the first of where it begins and of where it crosses edges, so never after them.
    const Point2 from{number(6) / 2, number(6) / 2};
    const Point3 start = lift(from);
    const Segment3 within{start, target};
    const auto there = first_hit(within, q);
    ASSERT_TRUE(there) << "index " << i;  // its end is in the set
    const auto w = plumb_test::winding(chain, from);
    EXPECT_EQ(there->t == 0, !w || *w % 2 != 0 || from == at) << "index " << i;
    EXPECT_TRUE(there->t == 0 || there->feature.kind != FeatureKind::face) << "index " << i;
  }
  for (const long n : told) EXPECT_GT(n, 200);
  const Quadrilateral3 bent{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  EXPECT_THROW(static_cast<void>(first_hit(Ray3{{0, 0, 1}, {0, 0, -1}}, bent)), InvalidShape);
}

template <class Shape>
void check_cgal(std::uint64_t start) {
  long asked = 0, met = 0;
  on_shapes(start, 1500, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const AnyRay ray = ray_of(m);
    const auto expected = oracle::is_hit(ray, shape);
    if (!expected) return;
    ++asked, met += *expected;
    EXPECT_EQ(first_hit(ray, shape).has_value(), *expected) << m.about(shape) << " " << text_of(ray);
  });
  EXPECT_GT(met, 100);
  EXPECT_GT(asked - met, 50);
}
TEST(Cgal, AgreesAboutTriangles) { check_cgal<Triangle3>(811); }
TEST(Cgal, AgreesAboutTetrahedra) { check_cgal<Tetrahedron3>(812); }
TEST(Cgal, AgreesAboutBoxes) { check_cgal<Aabb3>(813); }
TEST(Cgal, AgreesAboutBalls) { check_cgal<Sphere3>(814); }
TEST(Cgal, AgreesAboutPlanes) { check_cgal<Plane3>(815); }

template <class Shape>
void check_yes_or_no(std::uint64_t start) {
  on_shapes(start, 3000, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const AnyRay ray = ray_of(m);
    ASSERT_EQ(hits_any(ray, shape), first_hit(ray, shape).has_value()) << m.about(shape) << " " << text_of(ray);
  });
}
TEST(Hits, SaysWhetherThereIsAFirstHit) {
  check_yes_or_no<Triangle3>(821), check_yes_or_no<Sphere3>(822), check_yes_or_no<Aabb3>(823);
}

/// Powers of two, a permutation of the axes, and the halves of a segment.
TEST(Laws, ScalingPermutingAndCuttingChangeNothing) {
  on_shapes(831, 1500, [&](Material& m) {
    const auto t = m.shape<Triangle3>();
    const Point3 p = m.probe3(), q = m.probe3();
    const Segment3 s{p, q};
    const std::string about = m.about(t, s);
    const auto hit = first_hit(s, t);
    const auto turn = [](const Point3& x) { return Point3{x.y, x.z, x.x}; };
    const auto turned = first_hit(Segment3{turn(p), turn(q)}, Triangle3{turn(t.a), turn(t.b), turn(t.c)});
    ASSERT_EQ(hit.has_value(), turned.has_value()) << about;
    // The other way round it is hit as well; of a set that is convex, the sum of both parameters is at most one.
    const auto back = first_hit(Segment3{q, p}, t);
    ASSERT_EQ(hit.has_value(), back.has_value()) << about;
    if (!hit) return;
    EXPECT_EQ(hit->t, turned->t) << about;
    EXPECT_EQ(hit->feature, turned->feature) << about;
    const auto forth_t = first_hit_parameter(s, t)->base, back_t = first_hit_parameter(Segment3{q, p}, t)->base;
    EXPECT_NE((forth_t + back_t - Rational(1.0)).sign(), Sign::positive) << about;
    // From one corner to another.
    const auto cycled = first_hit(s, Triangle3{t.b, t.c, t.a});
    ASSERT_TRUE(cycled) << about;
    EXPECT_EQ(hit->t, cycled->t) << about;
    EXPECT_EQ(hit->point, cycled->point) << about;
    double most = 0, least = 1;
    for (const Point3& x : {t.a, t.b, t.c, p, q}) {
      for (const double y : {x.x, x.y, x.z}) {
        most = std::fmax(most, std::fabs(y));
        if (y != 0) least = std::fmin(least, std::fabs(y));
      }
    }
    if (most > 0x1p900 || least < 0x1p-900) return;
    const auto scaled = [](const Point3& x) { return Point3{x.x * 0x1p50, x.y * 0x1p50, x.z * 0x1p50}; };
    const auto large = first_hit(Segment3{scaled(p), scaled(q)}, Triangle3{scaled(t.a), scaled(t.b), scaled(t.c)});
    ASSERT_TRUE(large) << about;
    EXPECT_EQ(large->t, hit->t) << about;
    EXPECT_EQ(large->point, scaled(hit->point)) << about;
  });
}

template <class Throws, class Ask>
void expect_text(Ask ask, const char* part) {
  try {
    static_cast<void>(ask());
    FAIL() << part;
  } catch (const Throws& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

TEST(BadInput, IsNamed) {
  const double nan = std::nan(""), inf = INFINITY;
  const Ray3 ray{{0, 0, -1}, {0, 0, 1}};
  const Triangle3 t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  expect_text<NonFinite>([&] { return first_hit(Ray3{{0, nan, 0}, {1, 0, 0}}, t); }, "ray.origin.y");
  expect_text<NonFinite>([&] { return first_hit(Segment3{{0, 0, 0}, {1, 0, inf}}, t); }, "segment.b.z");
  expect_text<NonFinite>([&] { return hits(Line3{{0, 0, 0}, {nan, 0, 0}}, t); }, "line.direction.x");
  expect_text<NonFinite>([&] { return hits(ray, Triangle3{{0, 0, 0}, {1, inf, 0}, {0, 1, 0}}); }, "triangle.b.y");
  expect_text<NonFinite>([&] { return hits(ray, Sphere3{{0, 0, 0}, nan}); }, "sphere.radius");
  expect_text<NonFinite>([&] { return hits(Ray3{{0, 0, 0}, {0, inf, 1}}, Sphere3{{0, 0, 0}, 1}); }, "ray.direction.y");
  expect_text<NonFinite>(
      [&] {
        return hits(Ray3{{inf, 0, 0}, {1, 0, 0}}, Aabb3{{0, 0, 0}, {1, 1, 1}});
      },
      "ray.origin.x");
  expect_text<NonFinite>(
      [&] {
        return hits(Ray3{{nan, 0, 0}, {0, 0, 0}}, Aabb3{{0, 0, 0}, {1, 1, 1}});
      },
      "ray.origin.x");
  expect_text<NonFinite>([&] { return hits(ray, Aabb3{{0, 0, 0}, {1, inf, 1}}); }, "aabb.max.y");
  expect_text<InvalidShape>([&] { return hits(ray, Sphere3{{0, 0, 0}, -1}); }, "sphere.radius");
  expect_text<InvalidShape>([&] { return first_hit(ray, Capsule3{{0, 0, 0}, {1, 0, 0}, -1}); }, "capsule.radius");
  expect_text<InvalidShape>([&] { return first_hit(ray, Cylinder3{{0, 0, 0}, {1, 0, 0}, -1}); }, "cylinder.radius");
}

}  // namespace
}  // namespace plumb
