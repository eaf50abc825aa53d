// The nearest point of every shape against the least of all of its features in rationals: features, coordinates,
// distances, exact squares, and all of it the other way round.
#include "plumb/query/closest/closest.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "figure/basic/shape_cases.hpp"
#include "plumb/arith/big.hpp"
#include "query/closest/oracle.hpp"

namespace plumb {

std::ostream& operator<<(std::ostream& out, const Feature& f) {
  return out << std::array{"vertex", "edge", "face", "interior"}[static_cast<std::size_t>(f.kind)] << ' ' << f.index;
}

namespace {

using namespace closest_oracle;
using rationals::is_nearest, rationals::overflows;
using shape_cases::Material, shape_cases::on_shapes;

/// Is x the nearest double to sqrt(square) - less?  By roots rounded down and up, of more and more digits.
bool is_nearest_root(double x, const mpq_class& square, const mpq_class& less = 0, const mpq_class& times = 1) {
  const mpz_class& n = square.get_num();
  const mpz_class& d = square.get_den();
  if (mpz_perfect_square_p(n.get_mpz_t()) != 0 && mpz_perfect_square_p(d.get_mpz_t()) != 0) {
    const mpq_class exactly = times * mpq_class(sqrt(n), sqrt(d)) - less;
    return std::isinf(x) ? overflows(exactly) : is_nearest(x, exactly);
  }
  for (unsigned digits = 256; digits < 20000; digits *= 2) {
    const mpz_class below = sqrt(mpz_class((n * d) << 2 * digits));
    const mpz_class scale = d << digits;
    const auto at = [&](const mpz_class& root) {
      mpq_class r(root, scale);
      r.canonicalize();
      return mpq_class(times * r - less);
    };
    const mpq_class low = at(below), high = at(below + 1);
    if (std::isinf(x)) return overflows(low);
    const bool one = is_nearest(x, low), other = is_nearest(x, high);
    if (one && other) return true;
    if (!one && !other && (low < x) == (high < x)) return false;
  }
  return false;
}

template <class Point>
bool is_nearest_point(const Point& p, const Vector& q) {
  const auto x = coordinates(p);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isinf(x[i]) ? !overflows(q[i]) : !is_nearest(x[i], q[i])) return false;
  }
  return true;
}

mpq_class value(const Rational& x) { return x.value().value; }

struct Seen {
  std::array<int, 4> kind{};
  void add(const Feature& f) { ++kind[static_cast<std::size_t>(f.kind)]; }
};

/// All that is asked of a flat shape.
template <class Shape, class Point>
void expect_nearest(const Shape& shape, const Point& p, const Nearest& expected) {
  const auto c = closest_points(p, shape);
  EXPECT_EQ(c.feature_b, expected.feature);
  EXPECT_EQ(c.feature_a, vertex(0));
  EXPECT_EQ(c.on_a, p);
  EXPECT_TRUE(is_nearest_point(c.on_b, expected.point));
  EXPECT_TRUE(is_nearest_root(c.distance, expected.square)) << c.distance;
  EXPECT_EQ(closest_point(shape, p), c.on_b);
  EXPECT_EQ(distance(p, shape), c.distance);
  EXPECT_EQ(value(squared_distance_exact(p, shape)), expected.square);
  EXPECT_EQ(value(exact_distance(p, shape).square), expected.square);
  if constexpr (!std::is_same_v<Shape, Point>) {
    EXPECT_EQ(closest_points(shape, p), swapped(c));
    EXPECT_EQ(distance(shape, p), c.distance);
    EXPECT_EQ(squared_distance_exact(shape, p), squared_distance_exact(p, shape));
  }
}

template <class Box>
bool is_empty(const Box& box) {
  const auto min = coordinates(box.min), max = coordinates(box.max);
  for (std::size_t i = 0; i < min.size(); ++i) {
    if (min[i] > max[i]) return true;
  }
  return false;
}

template <class Shape, class Point>
Seen check(std::uint64_t start, std::uint64_t cases) {
  Seen seen;
  on_shapes(start, cases, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const Point p = m.probe<Point>();
    SCOPED_TRACE(m.about(shape, p));
    if constexpr (requires { shape.min; }) {
      if (is_empty(shape)) {
        EXPECT_THROW(closest_points(p, shape), InvalidShape);
        return;
      }
    }
    const Nearest expected = nearest_of(shape_of(shape), exact(p));
    seen.add(expected.feature);
    expect_nearest(shape, p, expected);
  });
  return seen;
}

TEST(ClosestTest, OfSegments) {
  for (const Seen& s : {check<Segment2, Point2>(1, 400), check<Segment3, Point3>(2, 400)}) {
    EXPECT_GT(s.kind[0], 100);
    EXPECT_GT(s.kind[1], 50);
  }
}
TEST(ClosestTest, OfTriangles) {
  for (const Seen& s : {check<Triangle2, Point2>(3, 500), check<Triangle3, Point3>(4, 500)}) {
    EXPECT_GT(s.kind[0], 100);
    EXPECT_GT(s.kind[1], 50);
    EXPECT_GT(s.kind[2], 10);
  }
}
TEST(ClosestTest, OfTetrahedra) {
  const Seen s = check<Tetrahedron3, Point3>(5, 500);
  EXPECT_GT(s.kind[0], 100);
  EXPECT_GT(s.kind[1], 50);
  EXPECT_GT(s.kind[2], 20);
  EXPECT_GT(s.kind[3], 0);
}
TEST(ClosestTest, OfAxisAlignedBoxes) {
  const Seen plane = check<Aabb2, Point2>(6, 300), space = check<Aabb3, Point3>(7, 200);
  EXPECT_GT(plane.kind[0], 30);
  EXPECT_GT(plane.kind[1], 20);
  EXPECT_GT(plane.kind[2], 8);
  EXPECT_GT(space.kind[0], 20);
  EXPECT_GT(space.kind[1], 10);
  EXPECT_GT(space.kind[2], 4);
}
TEST(ClosestTest, OfOrientedBoxes) {
  const Seen plane = check<Obb2, Point2>(8, 300), flat = check<Rectangle3, Point3>(9, 300),
             space = check<Obb3, Point3>(10, 120);
  EXPECT_GT(plane.kind[0], 30);
  EXPECT_GT(plane.kind[1], 20);
  EXPECT_GT(plane.kind[2], 8);
  EXPECT_GT(flat.kind[0], 30);
  EXPECT_GT(flat.kind[1], 20);
  EXPECT_GT(flat.kind[2], 8);
  EXPECT_GT(space.kind[0], 10);
  EXPECT_GT(space.kind[1], 10);
  EXPECT_GT(space.kind[2], 3);
}

/// Nothing special about them: pairs of doubles tell nearly all.
TEST(ClosestTest, OfUniformPoints) {
  std::array<Seen, 4> seen;
  for (std::uint64_t index = 0; index < 120 * shape_cases::more; ++index) {
    SCOPED_TRACE(testing::Message() << "start 21 index " << index);
    Entropy e(21, index);
    const auto number = [&] { return signed_unit_coordinate(e); };
    const auto point = [&] {
      const double x = number(), y = number(), z = number();
      return Point3{x, y, z};
    };
    const auto vector = [&] {
      const Point3 a = point();
      return Vector3{a.x, a.y, a.z};
    };
    const auto expect = [&](std::size_t i, const auto& shape, const Point3& p) {
      const Nearest expected = nearest_of(shape_of(shape), exact(p));
      seen[i].add(expected.feature);
      expect_nearest(shape, p, expected);
    };
    const Point3 a = point(), b = point(), c = point(), p = point();
    expect(0, Segment3{a, b}, p);
    expect(1, Triangle3{a, b, c}, p);
    expect(2, Aabb3{{-0.5, -0.4, -0.3}, {0.5, 0.4 + std::fabs(a.x), 0.3}}, p);
    if (index % 2 == 0) expect(3, Obb3{a, {vector(), vector(), vector()}, {0.7, 0.5 * number(), 0.9}}, p);
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t kind = 0; kind < (i < 2 ? i + 2 : 3); ++kind) EXPECT_GT(seen[i].kind[kind], 2) << i << kind;
  }
}

/// At all distances from the line, and from the origin.
TEST(ClosestTest, NearToSegmentsAndTriangles) {
  Seen seen;
  for (std::uint64_t index = 0; index < 400 * shape_cases::more; ++index) {
    SCOPED_TRACE(testing::Message() << "start 22 index " << index);
    Entropy e(22, index);
    const auto power = [&](std::uint64_t most) { return std::ldexp(1.0, -static_cast<int>(e.below(most))); };
    const double far = e.coin() ? 0 : 1 / power(40), size = power(3), off = power(70);
    const auto point = [&](double scale) {
      const double x = signed_unit_coordinate(e), y = signed_unit_coordinate(e), z = signed_unit_coordinate(e);
      return Point3{scale * x, scale * y, scale * z};
    };
    const auto sum = [](const Point3& p, const Point3& q, double t) {
      return Point3{p.x + t * q.x, p.y + t * q.y, p.z + t * q.z};
    };
    const Point3 a = sum(point(size), {1, -1, 1}, far), way = point(1), b = sum(a, way, 1), c = sum(a, point(1), 1);
    const Point3 p = sum(sum(a, way, 1.5 * unit_coordinate(e) - 0.25), point(1), off);
    const auto expect = [&](const auto& shape) {
      const Nearest expected = nearest_of(shape_of(shape), exact(p));
      seen.add(expected.feature);
      expect_nearest(shape, p, expected);
    };
    expect(Segment3{a, b});
    expect(Triangle3{a, b, c});
  }
  for (std::size_t kind = 0; kind < 3; ++kind) EXPECT_GT(seen.kind[kind], 20) << kind;
}

TEST(ClosestTest, OfPoints) {
  on_shapes(11, 200, [](Material& m) {
    const Point2 a = m.point2(), b = m.probe2();
    const Point3 c = m.point3(), d = m.probe3();
    SCOPED_TRACE(m.about(a, b, c, d));
    expect_nearest(a, b, {exact(a), square_of(exact(a) - exact(b))});
    expect_nearest(c, d, {exact(c), square_of(exact(c) - exact(d))});
  });
}

/// The point of origin + all combinations of the directions that is nearest to p.
Nearest nearest_of_span(const Vector& origin, const std::vector<Vector>& directions, const Vector& p,
                        const Feature& feature) {
  std::vector<Vector> rows;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    rows.emplace_back();
    for (const Vector& d : directions) rows[i].push_back(dot(directions[i], d));
    rows[i].push_back(dot(directions[i], p - origin));
  }
  const Vector weights = *rationals::only_solution(rows);
  Vector q = origin;
  for (std::size_t i = 0; i < directions.size(); ++i) q = q + weights[i] * directions[i];
  return {q, square_of(q - p), feature};
}

bool is_zero(const Vector& v) { return square_of(v) == 0; }

template <class Line, class Ray, class Point>
void check_lines(std::uint64_t start) {
  Seen seen;
  on_shapes(start, 300, [&](Material& m) {
    const Line line = m.shape<Line>();
    const Ray ray{line.point, line.direction};
    const Point p = m.probe<Point>();
    SCOPED_TRACE(m.about(line, p));
    const Vector a = exact(line.point), d = exact(line.direction), q = exact(p);
    const Nearest end{a, square_of(a - q), vertex(0)};
    const Nearest foot = is_zero(d) ? end : nearest_of_span(a, {d}, q, edge(0));
    const Nearest on_ray = dot(d, q - a) > 0 ? foot : end;
    expect_nearest(line, p, foot);
    expect_nearest(ray, p, on_ray);
    seen.add(on_ray.feature);
    const auto expect_parameter = [&](double t, const Vector& at) {
      const mpq_class exactly = is_zero(d) ? mpq_class(0) : mpq_class(dot(at - a, d) / dot(d, d));
      EXPECT_TRUE(std::isinf(t) ? overflows(exactly) : is_nearest(t, exactly));
    };
    expect_parameter(closest_parameter(line, p), foot.point);
    expect_parameter(closest_parameter(ray, p), on_ray.point);
  });
  EXPECT_GT(seen.kind[0], 50);
  EXPECT_GT(seen.kind[1], 50);
}
TEST(ClosestTest, OfLinesAndRays) {
  check_lines<Line2, Ray2, Point2>(12);
  check_lines<Line3, Ray3, Point3>(13);
}

/// Where normal . x = offset, p's foot.
Nearest nearest_of_normal(const Vector& n, const mpq_class& offset, const Vector& p, const Feature& feature) {
  const mpq_class t = (offset - dot(n, p)) / dot(n, n);
  const Vector q = p + t * n;
  return {q, square_of(q - p), feature};
}

template <class Halfspace, class Point>
void check_halfspaces(std::uint64_t start) {
  Seen seen;
  on_shapes(start, 300, [&](Material& m) {
    const Halfspace s = m.shape<Halfspace>();
    const Point p = m.probe<Point>();
    SCOPED_TRACE(m.about(s, p));
    const Vector n = exact(s.normal), q = exact(p);
    constexpr bool plane = std::is_same_v<Point, Point2>;
    const Feature inside = plane ? face(0) : Feature{FeatureKind::interior, 0};
    if constexpr (!plane) {
      const Plane3 boundary{s.normal, s.offset};
      if (is_zero(n) && s.offset != 0) {
        EXPECT_THROW(closest_points(p, boundary), InvalidShape);
      } else {
        expect_nearest(boundary, p, is_zero(n) ? Nearest{q, 0, inside} : nearest_of_normal(n, s.offset, q, face(0)));
      }
    }
    if (is_zero(n) && s.offset < 0) {
      EXPECT_THROW(closest_points(p, s), InvalidShape);
      return;
    }
    const bool within = is_zero(n) || dot(n, q) < s.offset;
    const Nearest expected =
        within ? Nearest{q, 0, inside} : nearest_of_normal(n, s.offset, q, plane ? edge(0) : face(0));
    seen.add(expected.feature);
    expect_nearest(s, p, expected);
  });
  EXPECT_GT(seen.kind[1] + seen.kind[2], 100);
  EXPECT_GT(seen.kind[2] + seen.kind[3], 60);
}
TEST(ClosestTest, OfPlanesAndHalfspaces) {
  check_halfspaces<Halfspace2, Point2>(14);
  check_halfspaces<Halfspace3, Point3>(15);
}

TEST(ClosestTest, OfPlanesOfThreePoints) {
  Seen seen;
  on_shapes(16, 300, [&](Material& m) {
    const auto s = m.shape<ThreePointPlane3>();
    const Point3 p = m.probe3();
    SCOPED_TRACE(m.about(s, p));
    const Vector a = exact(s.a), ab = exact(s.b) - a, ac = exact(s.c) - a, q = exact(p);
    const mpq_class gram = dot(ab, ab) * dot(ac, ac) - dot(ab, ac) * dot(ab, ac);
    const Nearest expected = gram != 0                      ? nearest_of_span(a, {ab, ac}, q, face(0))
                             : !is_zero(ab) || !is_zero(ac) ? nearest_of_span(a, {is_zero(ab) ? ac : ab}, q, edge(0))
                                                            : Nearest{a, square_of(a - q), vertex(0)};
    seen.add(expected.feature);
    expect_nearest(s, p, expected);
  });
  EXPECT_GT(seen.kind[0], 0);
  EXPECT_GT(seen.kind[1], 20);
  EXPECT_GT(seen.kind[2], 100);
}

/// Of what is within the radius of a core.
template <class Shape, class Point>
void expect_round(const Shape& s, const Point& p, const Nearest& core, const Feature& surface, const Feature& inside) {
  const Vector q = exact(p);
  const mpq_class r(s.radius);
  const auto c = closest_points(p, s);
  EXPECT_EQ(closest_points(s, p), swapped(c));
  EXPECT_EQ(closest_point(s, p), c.on_b);
  EXPECT_EQ(distance(s, p), c.distance);
  if (core.square < r * r) {
    EXPECT_EQ(c.feature_b, inside);
    EXPECT_TRUE(is_nearest_point(c.on_b, q));
    EXPECT_EQ(c.distance, 0);
    EXPECT_EQ(compare(exact_distance(s, p), 0.0), Sign::zero);
    return;
  }
  EXPECT_EQ(c.feature_b, surface);
  EXPECT_TRUE(is_nearest_root(c.distance, core.square, r)) << c.distance;
  const auto on = coordinates(c.on_b);
  for (std::size_t i = 0; i < on.size(); ++i) {  // core + (q - core) r / sqrt(square)
    const mpq_class at = core.point[i], way = (q[i] - at) * r;
    if (way == 0) {
      EXPECT_TRUE(is_nearest(on[i], at));
    } else {
      EXPECT_TRUE(is_nearest_root(on[i], 1 / core.square, -at, way)) << i;
    }
  }
}

template <class Ball, class Capsule, class Point>
void check_round(std::uint64_t start) {
  constexpr bool plane = std::is_same_v<Point, Point2>;
  const Feature inside = plane ? face(0) : Feature{FeatureKind::interior, 0};
  const auto surface = [](std::size_t i) { return plane ? edge(i) : face(i); };
  Seen balls, capsules;
  on_shapes(start, 300, [&](Material& m) {
    const Ball ball = m.shape<Ball>();
    const Capsule capsule = m.shape<Capsule>();
    const Point p = m.probe<Point>();
    SCOPED_TRACE(m.about(ball, capsule, p));
    const Vector c = exact(ball.center), q = exact(p);
    expect_round(ball, p, {c, square_of(c - q)}, surface(0), inside);
    const Nearest core = nearest_of(shape_of(std::conditional_t<plane, Segment2, Segment3>{capsule.a, capsule.b}), q);
    const std::size_t part = core.feature.kind == FeatureKind::vertex ? 1 + core.feature.index : 0;
    expect_round(capsule, p, core, surface(part), inside);
    balls.add(closest_points(p, ball).feature_b);
    capsules.add(closest_points(p, capsule).feature_b);
  });
  const std::size_t out = plane ? 1 : 2, in = plane ? 2 : 3;
  for (const Seen& s : {balls, capsules}) {
    EXPECT_GT(s.kind[out], 100);
    EXPECT_GT(s.kind[in], 20);
  }
}
TEST(ClosestTest, OfBallsAndCapsules) {
  check_round<Circle2, Capsule2, Point2>(17);
  check_round<Sphere3, Capsule3, Point3>(18);
}

TEST(ClosestTest, OfLozenges) {
  std::array<int, 3> parts{};
  int inside = 0;
  on_shapes(23, 300, [&](Material& m) {
    const Lozenge3 lozenge = m.shape<Lozenge3>();
    const Point3 p = m.probe3();
    SCOPED_TRACE(m.about(lozenge, p));
    const Nearest core =
        nearest_of(box_of(exact(lozenge.corner), {exact(lozenge.edges[0]), exact(lozenge.edges[1])}), exact(p));
    const std::size_t kind = static_cast<std::size_t>(core.feature.kind);
    constexpr std::array<std::size_t, 3> first{5, 1, 0};
    expect_round(lozenge, p, core, face(first[kind] + core.feature.index), {FeatureKind::interior, 0});
    (closest_points(p, lozenge).feature_b.kind == FeatureKind::interior ? inside : parts[kind]) += 1;
  });
  EXPECT_GT(inside, 10);
  for (const int n : parts) EXPECT_GT(n, 2);
}

TEST(ClosestTest, OfConvexPolyhedra) {
  const ConvexPolyhedron3 polyhedron = convex_polyhedron(
      PolygonMesh{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 2}},
                  {0, 3, 2, 1, 4, 8, 5, 6, 7, 0, 1, 8, 4, 1, 5, 8, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7},
                  {0, 4, 9, 13, 16, 20, 24, 28}});
  const closest_oracle::Shape exactly = shape_of(polyhedron);
  Seen seen;
  for (std::uint64_t index = 0; index < 80; ++index) {
    Entropy entropy(19, index);
    const auto part = [&] { return 1 + static_cast<double>(entropy.within(3)) / 2; };
    const double x = part(), y = part(), z = part();
    const Point3 p{x, y, z};
    SCOPED_TRACE(testing::Message() << "start 19 index " << index);
    const Nearest expected = nearest_of(exactly, exact(p));
    seen.add(expected.feature);
    expect_nearest(polyhedron, p, expected);
  }
  for (const int n : seen.kind) EXPECT_GT(n, 2);
}

TEST(ClosestTest, WeightsOfTheNearestPoint) {
  on_shapes(20, 200, [](Material& m) {
    const auto t = m.shape<Triangle3>();
    const Point3 p = m.probe3();
    SCOPED_TRACE(m.about(t, p));
    const std::array corner{t.a, t.b, t.c};
    const Nearest expected = nearest_of(shape_of(t), exact(p));
    const auto w = closest_weights(t, p);
    std::vector<Vector> chosen;
    std::vector<std::size_t> who;
    const Feature f = expected.feature;
    for (std::size_t i = 0; i < 3; ++i) {
      if (f.kind == FeatureKind::vertex ? i != f.index : f.kind == FeatureKind::edge && i == (f.index + 2) % 3) {
        EXPECT_EQ(w[i], 0);
        continue;
      }
      chosen.push_back(exact(corner[i]));
      who.push_back(i);
    }
    const Vector weights = chosen.size() == 1 ? Vector{1} : *rationals::weights_of(chosen, exact(p));
    for (std::size_t i = 0; i < who.size(); ++i) EXPECT_TRUE(is_nearest(w[who[i]], weights[i]));
  });
}

}  // namespace
}  // namespace plumb
