// Areas, volumes, surfaces and centroids: known ones, and random ones against rationals.
#include "plumb/figure/measures/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>

#include "figure/basic/shape_cases.hpp"
#include "figure/basic/solids.hpp"
#include "figure/basic/thrown.hpp"
#include "figure/measures/rational_measures.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/predicates.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb {
namespace {

using plumb_test::Digits;
using plumb_test::half_gaps_off;
using plumb_test::is_nearest;
using shape_cases::Material;
using shape_cases::on_shapes;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;

TEST(Known, InfiniteBeyondAllDoubles) {
  const double s = 0x1p600;
  const Point3 o{0, 0, 0}, x{s, 0, 0}, y{0, s, 0}, z{0, 0, s};
  const std::array<Vector3, 3> axes{{{s, 0, 0}, {0, s, 0}, {0, 0, s}}};
  const Aabb3 box{o, {s, s, s}};
  const TriangleMesh mesh{{o, x, y, z}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const std::vector<Point3> corners{o, x, y, z};
  const KDop3 k_dop = fit_k_dop(corners, 14);
  const std::vector<double> measures{area(Triangle2{{0, 0}, {s, 0}, {0, s}}),
                                     area(Triangle3{o, x, y}),
                                     area(Quadrilateral2{{0, 0}, {s, 0}, {s, s}, {0, s}}),
                                     area(Quadrilateral3{o, x, {s, s, 0}, y}),
                                     area(Polygon2{{{0, 0}, {s, 0}, {0, s}}}),
                                     area(Polygon3{{o, x, y}}),
                                     area(HoledPolygon2{{{{0, 0}, {s, 0}, {0, s}}}, {}}),
                                     area(HoledPolygon3{{{o, x, y}}, {}}),
                                     area(Circle2{{0, 0}, s}),
                                     area(Capsule2{{0, 0}, {s, 0}, s}),
                                     area(Aabb2{{0, 0}, {s, s}}),
                                     area(Obb2{{0, 0}, {{{s, 0}, {0, s}}}, {1, 1}}),
                                     area(Rectangle3{o, {{{s, 0, 0}, {0, s, 0}}}, {1, 1}}),
                                     volume(Tetrahedron3{o, x, y, z}),
                                     volume(mesh),
                                     volume(convex_polyhedron(mesh)),
                                     volume(box),
                                     volume(Sphere3{o, s}),
                                     volume(Capsule3{o, x, s}),
                                     volume(Lozenge3{o, {axes[0], axes[1]}, s}),
                                     volume(Cylinder3{o, x, s}),
                                     volume(Cone3{o, x, s}),
                                     volume(Ellipsoid3{o, axes, {1, 1, 1}}),
                                     volume(Obb3{o, axes, {1, 1, 1}}),
                                     volume(k_dop),
                                     surface_area(Tetrahedron3{o, x, y, z}),
                                     surface_area(mesh),
                                     surface_area(convex_polyhedron(mesh)),
                                     surface_area(box),
                                     surface_area(Sphere3{o, s}),
                                     surface_area(Capsule3{o, x, s}),
                                     surface_area(Lozenge3{o, {axes[0], axes[1]}, s}),
                                     surface_area(Cylinder3{o, x, s}),
                                     surface_area(Cone3{o, x, s}),
                                     surface_area(Obb3{o, axes, {1, 1, 1}}),
                                     surface_area(k_dop)};
  for (std::size_t i = 0; i < measures.size(); ++i) EXPECT_EQ(measures[i], kInfinity) << i;
  EXPECT_EQ(volume(Obb3{o, {axes[0], axes[1], {0, 0, 0}}, {1, 1, 1}}), 0);
}

TEST(Known, AreasAndCentroids) {
  EXPECT_EQ(signed_area(Triangle2{{0, 0}, {3, 0}, {0, 2}}), 3);
  EXPECT_EQ(signed_area(Triangle2{{0, 0}, {0, 2}, {3, 0}}), -3);
  EXPECT_EQ(signed_area(Quadrilateral2{{0, 0}, {4, 3}, {4, 0}, {0, 3}}), 0);  // both halves of a bowtie
  EXPECT_EQ(centroid(Quadrilateral2{{0, 0}, {4, 3}, {4, 0}, {0, 3}}), (Point2{2, 1.5}));
  const Polygon2 ell{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  EXPECT_EQ(area(ell), 3);
  EXPECT_EQ(centroid(ell), (Point2{5.0 / 6, 5.0 / 6}));
  const HoledPolygon2 frame{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, {{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}}};
  HoledPolygon2 other = frame;
  std::reverse(other.holes[0].vertices.begin(), other.holes[0].vertices.end());
  for (const HoledPolygon2& p : {frame, other}) {
    EXPECT_EQ(area(p), 15);
    EXPECT_EQ(signed_area(p), 15);
    EXPECT_EQ(centroid(p), (Point2{30.5 / 15, 30.5 / 15}));
  }
  std::reverse(other.outer.vertices.begin(), other.outer.vertices.end());
  EXPECT_EQ(signed_area(other), -15);
  EXPECT_EQ(area(other), 15);
  EXPECT_EQ(area(Triangle3{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}), std::sqrt(0.5));
  EXPECT_EQ(area(Polygon3{{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}}}), 16);
  EXPECT_EQ(area(HoledPolygon3{{{{0, 0, 0}, {0, 4, 3}, {4, 4, 3}, {4, 0, 0}}},
                               {{{{1, 0.8, 0.6}, {2, 0.8, 0.6}, {2, 0.8, 0.6}, {1, 0.8, 0.6}}}}}),
            20);
  EXPECT_EQ(area(HoledPolygon3{{{{0, 0, 0}, {0, 4, 4}, {4, 4, 4}, {4, 0, 0}}},
                               {{{{1, 1, 1}, {2, 1, 1}, {2, 2, 2}, {1, 2, 2}}}}}),
            15 * std::sqrt(2.0));
  const HoledPolygon3 sloping{{{{0, 0, 0}, {4, 0, 4}, {4, 4, 4}, {0, 4, 0}}},
                              {{{{1, 1, 1}, {2, 1, 2}, {2, 2, 2}, {1, 2, 1}}}}};
  EXPECT_EQ(centroid(sloping), (Point3{30.5 / 15, 30.5 / 15, 30.5 / 15}));
  EXPECT_EQ(centroid(Polygon3{{{0, 0, 1}, {4, 0, 1}, {4, 4, 5}, {0, 4, 5}}}), (Point3{2, 2, 3}));
  EXPECT_EQ(area(Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 1);
  EXPECT_EQ(centroid(Quadrilateral3{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}), (Point3{1, 1, 0}));
  EXPECT_EQ(centroid(Tetrahedron3{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}), (Point3{1, 1, 1}));
  EXPECT_EQ(centroid(Triangle2{{0, 0}, {3, 0}, {0, 3}}), (Point2{1, 1}));
}

TEST(Known, Solids) {
  EXPECT_EQ(volume(Sphere3{{1, 2, 3}, 1}), 4.1887902047863909846);
  EXPECT_EQ(surface_area(Sphere3{{1, 2, 3}, 0.5}), kPi);
  EXPECT_EQ(area(Circle2{{0, 0}, 2}), 4 * kPi);
  EXPECT_EQ(volume(Cylinder3{{0, 0, 0}, {0, 3, 4}, 1}), 5 * kPi);
  EXPECT_EQ(surface_area(Cylinder3{{0, 0, 0}, {0, 3, 0}, 1}), 8 * kPi);
  EXPECT_EQ(volume(Cone3{{0, 0, 0}, {0, 3, 0}, 1}), kPi);
  EXPECT_EQ(surface_area(Cone3{{0, 0, 0}, {0, 4, 0}, 3}), 24 * kPi);
  EXPECT_EQ(volume(Capsule3{{0, 0, 0}, {0, 3, 0}, 0}), 0);
  EXPECT_EQ(surface_area(Capsule3{{0, 0, 0}, {0, 2, 0}, 1}), 8 * kPi);
  EXPECT_EQ(volume(Ellipsoid3{{0, 0, 0}, {{{2, 0, 0}, {0, 0, 1}, {0, 1, 0}}}, {1, -1, 1}}), volume(Sphere3{{}, 1}) * 2);
  EXPECT_EQ(volume(Aabb3{{0, 0, 0}, {1, 2, 3}}), 6);
  EXPECT_EQ(surface_area(Aabb3{{0, 0, 0}, {1, 2, 3}}), 22);
  EXPECT_EQ(surface_area(Aabb3{{0, 0, 0}, {1, 2, 0}}), 4);  // both sides of a flat box
  EXPECT_EQ(volume(Aabb3{{0, 0, 0}, {1, -2, 3}}), 0);       // empty
  EXPECT_EQ(surface_area(Aabb3{{0, 0, 0}, {1, -2, 3}}), 0);
  EXPECT_EQ(area(Aabb2{{0, 0}, {2, 3}}), 6);
  EXPECT_EQ(area(Aabb2{{0, 0}, {2, -3}}), 0);
  EXPECT_EQ(volume(AabbWidths3{{5, 5, 5}, {1, -2, 3}}), 6);
  EXPECT_EQ(volume(AabbCenter3{{5, 5, 5}, {1, -2, 3}}), 48);
  EXPECT_EQ(surface_area(AabbCenter3{{5, 5, 5}, {0.5, -1, 1.5}}), 22);
  EXPECT_EQ(area(Obb2{{0, 0}, {{{1, 1}, {-1, 1}}}, {2, -3}}), 48);
  EXPECT_EQ(area(Rectangle3{{0, 0, 0}, {{{3, 4, 0}, {0, 0, 1}}}, {1, -1}}), 20);
  EXPECT_EQ(surface_area(Tetrahedron3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 2.3660254037844386468);
  // As thin as can be: a lozenge is a capsule, a capsule a sphere, a cylinder and a cone without axis a ball.
  const Lozenge3 thin{{1, 1, 1}, {{{0, 3, 0}, {0, 0, 0}}}, 2}, folded{{1, 1, 1}, {{{0, 1, 0}, {0, -2, 0}}}, 2};
  for (const Lozenge3& l : {thin, folded}) {
    EXPECT_EQ(volume(l), volume(Capsule3{{0, 0, 0}, {0, 0, 3}, 2}));
    EXPECT_EQ(surface_area(l), surface_area(Capsule3{{0, 0, 0}, {0, 0, 3}, 2}));
  }
  EXPECT_EQ(volume(Capsule3{{7, 7, 7}, {7, 7, 7}, 2}), volume(Sphere3{{}, 2}));
  EXPECT_EQ(volume(Cylinder3{{7, 7, 7}, {7, 7, 7}, 2}), volume(Sphere3{{}, 2}));
  EXPECT_EQ(surface_area(Cone3{{7, 7, 7}, {7, 7, 7}, 2}), surface_area(Sphere3{{}, 2}));
  const Lozenge3 plate{{0, 0, 0}, {{{2, 0, 0}, {0, 3, 0}}}, 1};  // box, four half cylinders, a ball
  EXPECT_DOUBLE_EQ(volume(plate), 12 + 5 * kPi + 4 * kPi / 3);
  EXPECT_DOUBLE_EQ(surface_area(plate), 12 + 10 * kPi + 4 * kPi);
}

TEST(Rounding, OfAreasAndVolumesIsOnce) {
  int doubtful = 0, infinite = 0, zero = 0;
  on_shapes(61, 1500, [&](Material& m) {
    const auto polygon = m.shape<Polygon2>();
    const mpq_class exact = plumb_test::twice_area(polygon.vertices) / 2;
    const double a = signed_area(polygon);
    EXPECT_TRUE(is_nearest(a, exact)) << m.about() << " " << a;
    doubtful += std::isinf(a) || mpq_class(a) != exact;
    infinite += std::isinf(a);
    zero += sgn(exact) == 0;
    EXPECT_EQ(area(polygon), std::fabs(a));
    const auto t = m.shape<Tetrahedron3>();
    const mpq_class six = plumb_test::six_volumes({t.a, t.b, t.c, t.d});
    EXPECT_TRUE(is_nearest(signed_volume(t), six / 6)) << m.about(t);
    EXPECT_EQ(static_cast<int>(orient3d(t.a, t.b, t.c, t.d)), sgn(six));
    const auto triangle = m.shape<Triangle3>();
    const auto n = plumb_test::times(plumb_test::minus(plumb_test::exact3(triangle.c), plumb_test::exact3(triangle.a)),
                                     plumb_test::minus(plumb_test::exact3(triangle.b), plumb_test::exact3(triangle.a)));
    EXPECT_LE(half_gaps_off(area(triangle), Digits(plumb_test::root(plumb_test::inner(n, n)) / 2, plumb_test::kBits)),
              1)
        << m.about(triangle);
    const auto box = m.shape<Aabb3>();
    mpq_class x = mpq_class(box.max.x) - mpq_class(box.min.x), y = mpq_class(box.max.y) - mpq_class(box.min.y),
              z = mpq_class(box.max.z) - mpq_class(box.min.z);
    if (x < 0 || y < 0 || z < 0) x = y = z = 0;
    EXPECT_TRUE(is_nearest(volume(box), x * y * z)) << m.about(box);
    EXPECT_TRUE(is_nearest(surface_area(box), 2 * (x * y + y * z + z * x))) << m.about(box);
    const auto flat = m.shape<Obb2>();
    const mpq_class cross =
        mpq_class(flat.axes[0].x) * mpq_class(flat.axes[1].y) - mpq_class(flat.axes[0].y) * mpq_class(flat.axes[1].x);
    EXPECT_TRUE(is_nearest(area(flat), abs(mpq_class(4 * cross * mpq_class(flat.half.x) * mpq_class(flat.half.y)))))
        << m.about(flat);
  });
  EXPECT_GE(doubtful, 200);
  EXPECT_GE(infinite, 5);
  EXPECT_GE(zero, 20);
}

TEST(Rounding, OfCentroidsIsOnce) {
  int moved = 0, without_area = 0;
  on_shapes(62, 1500, [&](Material& m) {
    const auto polygon = m.shape<Polygon2>();
    // About the origin, edge by edge.
    const auto p = plumb_test::exactly(polygon.vertices);
    mpq_class x = 0, y = 0, whole = 0, mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto &a = p[i], &b = p[(i + 1) % p.size()];
      const mpq_class part = a.x * b.y - b.x * a.y;
      x += (a.x + b.x) * part, y += (a.y + b.y) * part, whole += 3 * part;
      mean_x += a.x, mean_y += a.y;
    }
    const mpq_class n = static_cast<unsigned long>(p.size());
    const bool none = sgn(whole) == 0;
    without_area += none;
    try {
      const Point2 c = centroid(polygon);
      EXPECT_TRUE(is_nearest(c.x, none ? mpq_class(mean_x / n) : mpq_class(x / whole))) << m.about() << c.x;
      EXPECT_TRUE(is_nearest(c.y, none ? mpq_class(mean_y / n) : mpq_class(y / whole))) << m.about() << c.y;
      moved += !none;
    } catch (const BeyondDoubles&) {
      const double most = std::numeric_limits<double>::max();
      ASSERT_FALSE(none);
      EXPECT_TRUE(abs(mpq_class(x / whole)) > most || abs(mpq_class(y / whole)) > most) << m.about();
    }
    // The same in a plane of space.
    if (!none) {
      Polygon3 table;
      for (const Point2& v : polygon.vertices) table.vertices.push_back({v.y, v.x, v.x});
      try {
        const Point3 c = centroid(table);
        EXPECT_TRUE(is_nearest(c.x, mpq_class(y / whole)) && is_nearest(c.y, mpq_class(x / whole))) << m.about();
        EXPECT_EQ(c.y, c.z);
      } catch (const BeyondDoubles&) {
      }
    }
    const Point2 mean = centroid(std::span<const Point2>(polygon.vertices));
    EXPECT_TRUE(is_nearest(mean.x, mpq_class(mean_x / n)) && is_nearest(mean.y, mpq_class(mean_y / n))) << m.about();
  });
  EXPECT_GE(moved, 800);
  EXPECT_GE(without_area, 20);
  const double far = 1e308, more = 1 + 0x1p-30;
  EXPECT_THROW(centroid(Polygon2{{{-far, 1}, {-far, -1}, {far, more}, {far, -more}}}), BeyondDoubles);
}

/// The boundaries of tetrahedra, put together: closed, though faces may meet, overlap and be flat.
struct Heap {
  TriangleMesh mesh;
  std::vector<Tetrahedron3> parts;
};
Heap heap(Material& m) {
  Heap h;
  for (std::size_t n = 1 + m.below(4); n-- > 0;) {
    const auto t = m.shape<Tetrahedron3>();
    h.parts.push_back(t);
    const auto at = static_cast<std::uint32_t>(h.mesh.vertices.size());
    for (const Point3& v : {t.a, t.b, t.c, t.d}) h.mesh.vertices.push_back(v);
    for (const TriangleMesh::Triangle& f : {TriangleMesh::Triangle{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}})
      h.mesh.triangles.push_back({f[0] + at, f[1] + at, f[2] + at});
  }
  return h;
}

TEST(Rounding, OfMeshesIsOnce) {
  int without_volume = 0, rounded = 0;
  on_shapes(63, 600, [&](Material& m) {
    const Heap h = heap(m);
    mpq_class six = 0;
    plumb_test::V3 sum{0, 0, 0};
    for (const Tetrahedron3& t : h.parts) {
      const mpq_class part = plumb_test::six_volumes({t.a, t.b, t.c, t.d});
      six += part;
      for (const Point3& v : {t.a, t.b, t.c, t.d}) {
        const auto x = plumb_test::exact3(v);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += part * x[k] / 4;
      }
    }
    const double v = signed_volume(h.mesh);
    EXPECT_TRUE(is_nearest(v, six / 6)) << m.about() << " " << v;
    EXPECT_EQ(volume(h.mesh), std::fabs(v));
    rounded += std::isinf(v) || mpq_class(v) * 6 != six;
    PolygonMesh polygons{h.mesh.vertices, {}, {0}};
    for (const auto& t : h.mesh.triangles) {
      polygons.corners.insert(polygons.corners.end(), t.rbegin(), t.rend());
      polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
    }
    EXPECT_EQ(signed_volume(polygons), v == 0 ? 0 : -v);
    without_volume += sgn(six) == 0;
    try {
      const Point3 c = centroid(h.mesh);
      const std::array<double, 3> found{c.x, c.y, c.z};
      for (std::size_t k = 0; k < 3 && sgn(six) != 0; ++k)
        EXPECT_TRUE(is_nearest(found[k], mpq_class(sum[k] / six))) << m.about() << " " << found[k];
      if (sgn(six) == 0) {
        EXPECT_EQ(c, centroid(std::span<const Point3>(h.mesh.vertices)));
      }
    } catch (const BeyondDoubles&) {
      EXPECT_TRUE(abs(mpq_class(sum[0] / six)) > 1e308 || abs(mpq_class(sum[1] / six)) > 1e308 ||
                  abs(mpq_class(sum[2] / six)) > 1e308);
    }
    Digits surface(0, plumb_test::kBits);
    for (const auto& t : h.mesh.triangles) {
      const auto a = plumb_test::exact3(h.mesh.vertices[t[0]]);
      const auto n = plumb_test::times(plumb_test::minus(plumb_test::exact3(h.mesh.vertices[t[1]]), a),
                                       plumb_test::minus(plumb_test::exact3(h.mesh.vertices[t[2]]), a));
      surface += plumb_test::root(plumb_test::inner(n, n)) / 2;
    }
    EXPECT_LE(half_gaps_off(surface_area(h.mesh), surface), 1) << m.about();
    EXPECT_EQ(surface_area(polygons), surface_area(h.mesh));
  });
  EXPECT_GE(without_volume, 20);
  EXPECT_GE(rounded, 100);
}

TEST(Rounding, OfWhatHoldsPiIsWithinAnUlp) {
  const Digits pi = plumb_test::machin_pi();
  int cases = 0, nearest = 0, tiny = 0;
  on_shapes(64, 2000, [&](Material& m) {
    const auto check = [&](double x, const Digits& exact, const char* what) {
      const double off = half_gaps_off(x, exact);
      EXPECT_LE(off, 2) << m.about() << " " << what << " " << x;
      ++cases;
      nearest += off <= 1;
      tiny += x != 0 && std::fabs(x) < 1e-280;
    };
    const auto square = [](const Point3& a, const Point3& b) {
      const auto d = plumb_test::minus(plumb_test::exact3(a), plumb_test::exact3(b));
      return plumb_test::inner(d, d);
    };
    const auto sphere = m.shape<Sphere3>();
    Digits r(sphere.radius, plumb_test::kBits);
    check(volume(sphere), Digits(pi * r * r * r * 4 / 3, plumb_test::kBits), "ball");
    check(surface_area(sphere), Digits(pi * r * r * 4, plumb_test::kBits), "sphere");
    check(area(Circle2{{}, sphere.radius}), Digits(pi * r * r, plumb_test::kBits), "disk");
    const auto capsule = m.shape<Capsule3>();
    r = capsule.radius;
    Digits l = plumb_test::root(square(capsule.a, capsule.b));
    check(volume(capsule), Digits(pi * r * r * (l + r * 4 / 3), plumb_test::kBits), "capsule");
    check(surface_area(capsule), Digits(pi * r * 2 * (l + r * 2), plumb_test::kBits), "capsule's surface");
    const auto cylinder = m.shape<Cylinder3>();
    r = cylinder.radius;
    l = plumb_test::root(square(cylinder.a, cylinder.b));
    if (cylinder.a != cylinder.b) {
      check(volume(cylinder), Digits(pi * r * r * l, plumb_test::kBits), "cylinder");
      check(surface_area(cylinder), Digits(pi * r * 2 * (l + r), plumb_test::kBits), "cylinder's surface");
    }
    const auto cone = m.shape<Cone3>();
    r = cone.radius;
    const mpq_class height = square(cone.apex, cone.base);
    if (cone.apex != cone.base) {
      const Digits slant = plumb_test::root(height + mpq_class(cone.radius) * mpq_class(cone.radius));
      check(volume(cone), Digits(pi * r * r * plumb_test::root(height) / 3, plumb_test::kBits), "cone");
      check(surface_area(cone), Digits(pi * r * (r + slant), plumb_test::kBits), "cone's surface");
    }
    const auto e = m.shape<Ellipsoid3>();
    const mpq_class spanned = abs(
        mpq_class(plumb_test::inner(plumb_test::exact3(e.axes[0]),
                                    plumb_test::times(plumb_test::exact3(e.axes[1]), plumb_test::exact3(e.axes[2]))) *
                  mpq_class(e.half.x) * mpq_class(e.half.y) * mpq_class(e.half.z)));
    check(volume(e), Digits(pi * plumb_test::digits(spanned) * 4 / 3, plumb_test::kBits), "ellipsoid");
    const auto cap = m.shape<SphericalCap3>();
    r = cap.sphere.radius;
    const auto normal = plumb_test::exact3(cap.halfspace.normal);
    const mpq_class deep = mpq_class(cap.halfspace.offset) -
                           plumb_test::inner(normal, plumb_test::exact3(cap.sphere.center)),
                    beside =
                        mpq_class(cap.sphere.radius) * mpq_class(cap.sphere.radius) * plumb_test::inner(normal, normal);
    Digits height_of_cap(deep < 0 ? Digits(0) : Digits(2 * r), plumb_test::kBits);
    if (deep * deep < beside)
      height_of_cap = r + plumb_test::digits(deep) / plumb_test::root(plumb_test::inner(normal, normal));
    const Digits& h = height_of_cap;
    const Digits rim = h * (2 * r - h);  // its square
    check(volume(cap), Digits(pi * h * h * (3 * r - h) / 3, plumb_test::kBits), "cap");
    check(surface_area(cap), Digits(pi * (2 * r * h + rim), plumb_test::kBits), "cap's surface");
    const auto z = m.shape<Lozenge3>();
    r = z.radius;
    const auto u = plumb_test::exact3(z.edges[0]), v = plumb_test::exact3(z.edges[1]), n = plumb_test::times(u, v);
    const Digits around = plumb_test::root(plumb_test::inner(u, u)) + plumb_test::root(plumb_test::inner(v, v));
    const Digits flat = plumb_test::root(plumb_test::inner(n, n));
    check(volume(z), Digits(flat * r * 2 + pi * around * r * r + pi * r * r * r * 4 / 3, plumb_test::kBits), "lozenge");
    check(surface_area(z), Digits(flat * 2 + pi * around * r * 2 + pi * r * r * 4, plumb_test::kBits),
          "lozenge's surface");
    const auto stadium = m.shape<Capsule2>();
    r = stadium.radius;
    const mpq_class x = mpq_class(stadium.a.x) - mpq_class(stadium.b.x),
                    y = mpq_class(stadium.a.y) - mpq_class(stadium.b.y);
    check(area(stadium), Digits(pi * r * r + plumb_test::root(x * x + y * y) * r * 2, plumb_test::kBits), "stadium");
  });
  EXPECT_GE(cases, 20000);
  EXPECT_EQ(nearest, cases);
  EXPECT_GE(tiny, 50);
}

TEST(ManyVertices, FarFromTheOriginAndLong) {
  // A staircase of a hundred thousand steps beside 2^52: nothing is lost to the distance.
  Polygon2 stairs{{{0x1p52, 0x1p52}}};
  const int n = 100000;
  for (int k = 0; k < n; ++k) {
    stairs.vertices.push_back({0x1p52 + k + 1, 0x1p52 + k});
    stairs.vertices.push_back({0x1p52 + k + 1, 0x1p52 + k + 1});
  }
  EXPECT_EQ(signed_area(stairs), n / 2.0);
  std::vector<Point2> many(100001, Point2{1e308, -1e308});
  EXPECT_EQ(centroid(many), (Point2{1e308, -1e308}));
  many.assign(3, Point2{5e-324, -5e-324});
  EXPECT_EQ(centroid(many), (Point2{5e-324, -5e-324}));
}

/// Of a closed mesh that is not convex, beside sums in rationals.
void expect_measured(const TriangleMesh& mesh, const std::string& name) {
  mpq_class six = 0;
  long double about = 0;
  for (const auto& t : mesh.triangles) {
    const auto a = plumb_test::exact3(mesh.vertices[t[0]]), b = plumb_test::exact3(mesh.vertices[t[1]]),
               c = plumb_test::exact3(mesh.vertices[t[2]]);
    six += plumb_test::inner(a, plumb_test::times(b, c));
    const auto n = plumb_test::times(plumb_test::minus(b, a), plumb_test::minus(c, a));
    about += std::sqrt(static_cast<long double>(mpq_class(plumb_test::inner(n, n)).get_d())) / 2;
  }
  EXPECT_GT(signed_volume(mesh), 0) << name;
  EXPECT_TRUE(is_nearest(signed_volume(mesh), six / 6)) << name;
  EXPECT_NEAR(surface_area(mesh), static_cast<double>(about), static_cast<double>(about) * 0x1p-45) << name;
  EXPECT_FALSE(is_convex(mesh)) << name;
  const Aabb3 box = fit_aabb(mesh.vertices);
  EXPECT_TRUE(volume(mesh) < volume(box) && contains(box, centroid(mesh))) << name;
}

TEST(Models, GeneratedOnesAreMeasured) {
  const TriangleMesh ring = solids::turned(solids::torus(3, 1, 40, 20));
  expect_measured(ring, "torus");
  expect_measured(solids::turned(solids::hollow_torus(3, 1, 40, 20)), "hollow torus");
  const TriangleMesh stairs = solids::voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}});
  expect_measured(stairs, "stairs");
  EXPECT_EQ(volume(stairs), 4);
  EXPECT_EQ(surface_area(stairs), 18);
  EXPECT_EQ(centroid(stairs), (Point3{1.25, 1, 0.75}));
  EXPECT_THROW(volume(solids::torn(ring, 100)), InvalidShape);
}

TEST(Models, AreMeasured) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::cout << "skipped: there is no folder " << folder << "\n";
    return;
  }
  for (const char* name : {"cow.obj", "fandisk.obj", "spot.obj", "rocker-arm.obj", "cheburashka.obj"})
    expect_measured(read_mesh(folder / name), name);
  for (const char* name : {"teapot.obj", "beetle.obj", "stanford-bunny.obj"})
    EXPECT_THROW(volume(read_mesh(folder / name)), InvalidShape) << name;
}

TEST(BadInput, IsRefusedByName) {
  EXPECT_EQ(text_of<Error>([] {
              volume(Sphere3{{0, 0, 0}, -2});
            }),
            "volume: sphere.radius is negative; give zero or more");
  EXPECT_EQ(text_of<Error>([] {
              surface_area(Cone3{{0, 0, 0}, {1, kInfinity, 0}, 1});
            }),
            "surface_area: cone.base.y is inf, not a real number; give a finite double");
  EXPECT_THROW(volume(Sphere3{{0, 0, 0}, std::nan("")}), NonFinite);
  EXPECT_THROW(area(Capsule2{{0, 0}, {1, 0}, -0x1p-1074}), InvalidShape);
  EXPECT_THROW(volume(Aabb3{{0, 0, 0}, {1, 1, std::nan("")}}), NonFinite);
  EXPECT_EQ(text_of<Error>([] { centroid(std::span<const Point3>{}); }), "centroid: no points; give at least one");
  EXPECT_EQ(text_of<Error>([] {
              area(Polygon3{{{0, 0, 0}}});
            }),
            "area: polygon.vertices has 1 vertex; a polygon has three at least");
  const TriangleMesh open{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}};
  EXPECT_EQ(
      text_of<Error>([&] { volume(open); }),
      "volume: the mesh is open: the edge of vertices 0 and 2 is passed 1 times one way and 0 the other; it must be "
      "equally often");
  EXPECT_EQ(surface_area(open), 1 + std::sqrt(0.75));
  EXPECT_EQ(text_of<Error>([&] {
              centroid(TriangleMesh{{{0, 0, 0}}, {{0, 1, 0}}});
            }),
            "centroid: triangle 0 names vertex 1, but there are 1 vertices");
  // Closed by place: each triangle has corners of its own.
  TriangleMesh soup;
  for (const TriangleMesh::Triangle& t : {TriangleMesh::Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    const auto at = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) soup.vertices.push_back(open.vertices[v]);
    soup.triangles.push_back({at, at + 1, at + 2});
  }
  EXPECT_EQ(signed_volume(soup), 1.0 / 6);
  EXPECT_EQ(volume(TriangleMesh{}), 0);
}

}  // namespace
}  // namespace plumb
