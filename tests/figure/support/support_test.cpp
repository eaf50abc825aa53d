// Do support mappings choose the farthest feature, and round its point once?  Against all corners in rationals, against
// digits by the thousand for round shapes, and by climbing from everywhere.
#include "plumb/figure/support/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "figure/basic/rationals.hpp"
#include "figure/basic/shape_cases.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb {
namespace {

using rationals::dot, rationals::exact, rationals::Vector;
using rationals::operator+, rationals::operator-, rationals::operator*;
using shape_cases::Material, shape_cases::on_shapes;

/// How often there was what is worth trying.
struct Seen {
  int unique = 0, tied = 0, beyond = 0;
};

/// Where there is a value along a direction, the exact one rounded as asked, beyond all doubles infinite.
template <class Shape, class Direction>
void hold_value(const Shape& shape, const mpq_class& exact, const Direction& d) {
  if constexpr (requires { support_value(shape, d); }) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto at_least = [&](double x) { return x == infinity || (x != -infinity && mpq_class(x) >= exact); };
    const double up = support_value(shape, d), down = support_value(shape, d, Rounding::down);
    EXPECT_TRUE(at_least(up) && !at_least(std::nextafter(up, -infinity)));
    EXPECT_TRUE(down == up || std::nextafter(down, infinity) == up);
    EXPECT_EQ(down == up, std::isfinite(up) && mpq_class(up) == exact);
  }
}

/// The corners in the order of their numbers.
template <class Shape, class Direction>
void hold_against(const Shape& shape, const std::vector<Vector>& corners, const Direction& d, Seen& seen) {
  std::vector<mpq_class> height;
  for (const Vector& corner : corners) height.push_back(dot(corner, exact(d)));
  const auto most = std::ranges::max_element(height);
  const auto first = static_cast<std::size_t>(most - height.begin());
  hold_value(shape, *most, d);
  bool unique = true, overflows = false;
  for (std::size_t i = 0; i < corners.size(); ++i)
    unique = unique && (height[i] != *most || corners[i] == corners[first]);
  for (const mpq_class& x : corners[first]) overflows = overflows || rationals::overflows(x);
  try {
    const auto s = support_point(shape, d);
    EXPECT_FALSE(overflows);
    EXPECT_EQ(s.feature, first);
    EXPECT_EQ(s.unique, unique);
    const auto x = coordinates(s.point);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_TRUE(x[i] == corners[first][i] || rationals::is_nearest(x[i], corners[first][i]));
    ++(unique ? seen.unique : seen.tied);
  } catch (const BeyondDoubles&) {
    EXPECT_TRUE(overflows);
    ++seen.beyond;
  }
}

template <class... Points>
std::vector<Vector> all(const Points&... points) {
  return {exact(points)...};
}

/// from + every sum of the steps.
std::vector<Vector> sums(const Vector& from, const std::vector<Vector>& steps) {
  std::vector<Vector> corners{from};
  for (const Vector& step : steps) {
    for (std::size_t i = 0, n = corners.size(); i < n; ++i) corners.push_back(corners[i] + step);
  }
  return corners;
}

template <class Axes>
std::vector<Vector> box(const Vector& center, const Axes& axes, const Vector& half) {
  Vector from = center;
  std::vector<Vector> steps;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Vector reach = abs(half[i]) * exact(axes[i]);
    from = from - reach;
    steps.push_back(mpq_class(2) * reach);
  }
  return sums(from, steps);
}

std::vector<Vector> aligned(const Vector& from, const Vector& widths) {
  std::vector<Vector> steps;
  for (std::size_t i = 0; i < from.size(); ++i) {
    steps.emplace_back(from.size());
    steps.back()[i] = widths[i];
  }
  return sums(from, steps);
}

Vector magnitudes(Vector v) {
  for (mpq_class& x : v) x = abs(x);
  return v;
}

TEST(Support, OfVerticesIsTheFirstOfTheFarthest) {
  Seen seen;
  on_shapes(41, 3000, [&](Material& m) {
    const Vector2 d = m.direction2();
    const Vector3 e = m.direction3();
    const auto t = m.shape<Triangle2>();
    const auto u = m.shape<Triangle3>();
    const auto q = m.shape<Quadrilateral2>();
    const auto r = m.shape<Quadrilateral3>();
    const auto s = m.shape<Segment2>();
    const auto v = m.shape<Segment3>();
    const auto w = m.shape<Tetrahedron3>();
    const auto p = m.shape<Polygon2>();
    const auto o = m.shape<Polygon3>();
    SCOPED_TRACE(m.about(d, e, t, u, q, r, s, v, w));
    hold_against(t, all(t.a, t.b, t.c), d, seen);
    hold_against(u, all(u.a, u.b, u.c), e, seen);
    hold_against(q, all(q.a, q.b, q.c, q.d), d, seen);
    hold_against(r, all(r.a, r.b, r.c, r.d), e, seen);
    hold_against(s, all(s.a, s.b), d, seen);
    hold_against(v, all(v.a, v.b), e, seen);
    hold_against(w, all(w.a, w.b, w.c, w.d), e, seen);
    std::vector<Vector> flat, solid;
    for (const Point2& x : p.vertices) flat.push_back(exact(x));
    for (const Point3& x : o.vertices) solid.push_back(exact(x));
    hold_against(p, flat, d, seen);
    hold_against(std::span<const Point2>(p.vertices), flat, d, seen);
    hold_against(o, solid, e, seen);
    hold_against(std::span<const Point3>(o.vertices), solid, e, seen);
  });
  EXPECT_GT(seen.unique, 3000);
  EXPECT_GT(seen.tied, 3000);
  EXPECT_EQ(seen.beyond, 0);
}

TEST(Support, OfBoxesIsTheFirstOfTheFarthestCorners) {
  Seen seen;
  int empty = 0;
  on_shapes(42, 3000, [&](Material& m) {
    const Vector2 d = m.direction2();
    const Vector3 e = m.direction3();
    const auto a = m.shape<Aabb2>();
    const auto b = m.shape<Aabb3>();
    const auto w = m.shape<AabbWidths3>();
    const auto c = m.shape<AabbCenter3>();
    const auto o = m.shape<Obb2>();
    const auto p = m.shape<Obb3>();
    const auto r = m.shape<Rectangle3>();
    SCOPED_TRACE(m.about(d, e, a, b, w, c, o, p, r));
    if (b.min.x > b.max.x || b.min.y > b.max.y || b.min.z > b.max.z) {
      EXPECT_THROW(support_point(b, e), InvalidShape);
      ++empty;
    } else {
      hold_against(b, aligned(exact(b.min), exact(b.max) - exact(b.min)), e, seen);
    }
    if (a.min.x <= a.max.x && a.min.y <= a.max.y)
      hold_against(a, aligned(exact(a.min), exact(a.max) - exact(a.min)), d, seen);
    hold_against(w, aligned(exact(w.min), magnitudes(exact(w.widths))), e, seen);
    const Vector half = magnitudes(exact(c.half));
    hold_against(c, aligned(exact(c.center) - half, mpq_class(2) * half), e, seen);
    hold_against(o, box(exact(o.center), o.axes, exact(o.half)), d, seen);
    hold_against(p, box(exact(p.center), p.axes, exact(p.half)), e, seen);
    hold_against(r, box(exact(r.center), r.axes, exact(r.half)), e, seen);
  });
  EXPECT_GT(seen.unique, 2000);
  EXPECT_GT(seen.tied, 2000);
  EXPECT_GT(seen.beyond, 20);
  EXPECT_GT(empty, 50);
}

TEST(Support, OfKDopsIsThatOfTheirCorners) {
  const Directions2 diagonals({{1, 1}, {1, -1}});
  const KDop2 square{diagonals, {0, -1}, {2, 1}};
  EXPECT_EQ(support_value(square, {1, 0}), 1.5);
  EXPECT_EQ(support_value(square, {-3, 0}), 1.5);
  const KDop2 third{Directions2({{3, 0}, {0, 1}}), {0, 0}, {1, 1}};
  EXPECT_EQ(support_value(third, {1, 0}, Rounding::nearest), 1.0 / 3);
  EXPECT_EQ(support_value(third, {1, 0}, Rounding::up), std::nextafter(1.0 / 3, 1.0));
  EXPECT_EQ(support_value(third, {1, 0}, Rounding::down), 1.0 / 3);
  const std::vector<Point3> points{{0, 0, 0}, {3, 0, 1}, {0, 4, 2}, {1, 1, 7}};
  EXPECT_EQ(support_value(fit_k_dop(points, 6), {1, 2, 3}), 3.0 + 8 + 21);
  EXPECT_THROW((void)support_value(KDop2{Directions2({{1, 0}}), {0}, {1}}, {0, 1}), InvalidShape);
  EXPECT_THROW((void)support_value(KDop2{diagonals, {3, 0}, {1, 1}}, {0, 1}), InvalidShape);
}

/// Vertices and faces of the hull of what is on its boundary, whole or in triangles: with coplanar faces and vertices
/// amid edges and faces.
ConvexPolyhedron3 polyhedron_of(const std::vector<Point3>& points, bool rough) {
  return convex_polyhedron(convex_hull(points, {.triangulate = rough, .all_boundary_points = rough}), points);
}

TEST(Support, ClimbsFromEveryVertexToTheSame) {
  int solid = 0, tied = 0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(43, " << index << ")");
    Entropy entropy(43, index);
    std::vector<Point3> points = points3(any_family(entropy), Degeneracy::cospherical, 4 + entropy.below(30), entropy);
    if (index % 2 == 0) {
      for (Point3& p : points) p = {double(entropy.within(2)), double(entropy.within(2)), double(entropy.within(2))};
    }
    if (convex_hull(points).dimension < 3) continue;
    ++solid;
    const ConvexPolyhedron3 shape = polyhedron_of(points, entropy.coin());
    const std::vector<Point3>& vertices = shape.mesh.vertices;
    for (int i = 0; i < 6; ++i) {
      Vector3 d{double(entropy.within(1)), double(entropy.within(1)), double(entropy.within(1))};
      if (i >= 3)
        d = {signed_unit_coordinate(entropy), signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)};
      const Support3 whole = support_point(std::span<const Point3>(vertices), d);
      tied += whole.unique ? 0 : 1;
      for (std::uint32_t start = 0; start < vertices.size(); ++start) ASSERT_EQ(support_point(shape, d, start), whole);
    }
  }
  EXPECT_GT(solid, 150);
  EXPECT_GT(tied, 300);
}

// A cube whose faces are cut into triangles about their middles, one corner there twice: from the middle of the bottom,
// every neighbor is as far along z, and the copy of a corner has the corner alone to go to.
TEST(Support, PlateausEndNoClimb) {
  ConvexPolyhedron3 cube;
  for (int i = 0; i < 8; ++i) cube.mesh.vertices.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  const std::vector<std::vector<std::uint32_t>> rims{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::vector<std::vector<std::uint32_t>> near(15);
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    near[a].push_back(b);
    near[b].push_back(a);
  };
  for (const auto& rim : rims) {
    Point3 middle{0, 0, 0};
    for (const std::uint32_t v : rim) {
      const Point3& p = cube.mesh.vertices[v];
      middle = {middle.x + p.x / 4, middle.y + p.y / 4, middle.z + p.z / 4};
    }
    const auto m = static_cast<std::uint32_t>(cube.mesh.vertices.size());
    cube.mesh.vertices.push_back(middle);
    for (std::size_t i = 0; i < 4; ++i) {
      join(m, rim[i]);
      if (rim[i] < rim[(i + 1) % 4]) join(rim[i], rim[(i + 1) % 4]);
    }
  }
  cube.mesh.vertices.push_back({0, 0, 0});
  join(14, 0);
  cube.first_neighbor.assign(1, 0);
  for (const auto& some : near) {
    cube.neighbors.insert(cube.neighbors.end(), some.begin(), some.end());
    cube.first_neighbor.push_back(static_cast<std::uint32_t>(cube.neighbors.size()));
  }
  for (std::uint32_t start = 0; start < 15; ++start) {
    EXPECT_EQ(support_point(cube, {0, 0, 1}, start), (Support3{{0, 0, 1}, 4, false}));
    EXPECT_EQ(support_point(cube, {1, 1, 1e-300}, start), (Support3{{1, 1, 1}, 7, true}));
    EXPECT_EQ(support_point(cube, {-1, -1, -1}, start), (Support3{{0, 0, 0}, 0, true}));
    EXPECT_EQ(support_point(cube, {0, -0.0, 0}, start), (Support3{{0, 0, 0}, 0, false}));
  }
  EXPECT_THROW(support_point(cube, {0, 0, 1}, 15), InvalidShape);
}

// Figure 4.7: after a small turn the farthest vertex is reached along the boundary, from the last one.
TEST(Support, ClimbsAlongTheBoundaryOfATurnedShape) {
  std::vector<Point3> points;
  for (int i = 0; i < 64; ++i) {
    const double a = 0.1 * i;
    points.insert(points.end(), {{std::cos(a), std::sin(a), -1}, {std::cos(a), std::sin(a), 1}});
  }
  const ConvexPolyhedron3 shape = polyhedron_of(points, false);
  std::uint32_t at = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3 d{std::sin(0.05 * i), std::cos(0.05 * i), 0.25};
    const Support3 s = support_point(shape, d, at);
    EXPECT_EQ(s, support_point(std::span<const Point3>(shape.mesh.vertices), d));
    at = s.feature;
  }
}

TEST(Support, RefusesWhatIsNoShape) {
  EXPECT_THROW(support_point(std::span<const Point3>(), Vector3{1, 0, 0}), InvalidShape);
  EXPECT_THROW(support_point(Polygon2{{{0, 0}, {1, 1}}}, Vector2{1, 0}), InvalidShape);
  EXPECT_THROW(support_point(Sphere3{{0, 0, 0}, -1}, Vector3{1, 0, 0}), InvalidShape);
  EXPECT_THROW(support_value(Cone3{{0, 0, 0}, {0, 0, 1}, -1}, Vector3{1, 0, 0}), InvalidShape);
  try {
    support_point(Capsule2{{0, 0}, {1, std::nan("")}, 1}, Vector2{1, 0});
    FAIL();
  } catch (const NonFinite& e) {
    EXPECT_NE(std::string(e.what()).find("support_point: capsule.b.y is nan"), std::string::npos) << e.what();
  }
  EXPECT_THROW(support_point(Triangle3{{0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0}}, Vector3{1, 0, 0}), NonFinite);
}

}  // namespace
}  // namespace plumb
