// Are the hits of balls, cylinders and capsules those of real arithmetic, and those of unbounded and many-faced shapes?
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "plumb/arith/big.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/ray/cases.hpp"
#include "query/ray/oracle.hpp"

namespace plumb {
namespace {

using namespace ray_cases;
namespace oracle = ray_oracle;
using oracle::Coordinates, oracle::Corners, oracle::Path, oracle::Rational;

/// a t^2 + 2 b t + c, from the definition: |v(t)|^2 - r^2 |scale|^2 for a vector v(t) = w + t u.
struct Curve {
  Rational a, b, c;
  Curve(const Coordinates& w, const Coordinates& u, const Rational& square)
      : a(exact::square(u)), b(exact::dot(w, u)), c(exact::square(w) - square) {}
  [[nodiscard]] Rational at(const Rational& t) const { return a * t * t + 2 * b * t + c; }
  [[nodiscard]] Rational slope(const Rational& t) const { return a * t + b; }
};

/// The sign of t - x for the lesser root t of a curve that has one.
int root_against(const Curve& q, const Rational& x) {
  const int value = sgn(q.at(x)), slope = sgn(q.slope(x));
  if (value == 0) return slope <= 0 ? 0 : -1;
  return value > 0 && slope < 0 ? 1 : -1;
}

/// Is x the nearest double to a number that compares so?
template <class Against>
bool is_nearest_to(double x, Against against) {
  if (std::isnan(x)) return false;
  const Rational beyond = Rational(std::numeric_limits<double>::max()) + Rational(0x1p970);
  if (std::isinf(x)) return x > 0 ? against(beyond) >= 0 : against(Rational(-beyond)) <= 0;
  const double above = std::nextafter(x, INFINITY), below = std::nextafter(x, -INFINITY);
  if (!std::isfinite(above) || !std::isfinite(below)) return true;
  const int high = against((Rational(x) + Rational(above)) / 2), low = against((Rational(x) + Rational(below)) / 2);
  return high <= 0 && low >= 0;
}

Curve ball_curve(const Path& path, const Point3& center, double radius) {
  return {exact::difference(path.origin, exact::of(center)), path.direction, exact::squared(radius)};
}
Curve tube_curve(const Path& path, const Point3& a, const Point3& b, double radius) {
  const Coordinates e = exact::difference(exact::of(b), exact::of(a));
  return {oracle::cross(exact::difference(path.origin, exact::of(a)), e), oracle::cross(path.direction, e),
          exact::squared(radius) * exact::square(e)};
}
bool holds_origin(const auto& shape, const AnyRay& ray) {
  return exact::locate(shape, ray.origin) != Location::outside;
}

/// The point is on the ray, exactly rounded: of the coordinate along which the ray runs fastest only what t allows.
void check_root(const std::string& about, const Path& path, const Curve& q, const Hit& hit, const RayParameter& t) {
  EXPECT_TRUE(is_nearest_to(hit.t, [&](const Rational& x) { return root_against(q, x); })) << about;
  const Rational base = t.base.value().value, square = t.square.value().value;
  EXPECT_EQ(base, Rational(-q.b / q.a)) << about;
  EXPECT_EQ(square, Rational((q.b * q.b - q.a * q.c) / (q.a * q.a))) << about;
  const double at[] = {hit.point.x, hit.point.y, hit.point.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational &o = path.origin[i], &d = path.direction[i];
    if (d == 0) {
      EXPECT_EQ(Rational(at[i]), o) << about;
      continue;
    }
    EXPECT_TRUE(
        is_nearest_to(at[i], [&](const Rational& x) { return sgn(d) * root_against(q, Rational((x - o) / d)); }))
        << about << " axis " << i;
  }
}

/// By the definition: a ray hits a ball where its nearest point is in it.
TEST(FirstHit, OfBallsIsThatOfTheirEquation) {
  Tally tally;
  long touching = 0;
  on_shapes(701, 3000, [&](Material& m) {
    const auto ball = m.shape<Sphere3>();
    const AnyRay ray = ray_of(m);
    const std::string about = m.about(ball) + " " + text_of(ray);
    const auto hit = first_hit(ray, ball);
    tally.count(hit);
    const Path path(ray);
    std::optional<Rational> from, to;
    if (path.begins) from = 0;
    if (path.ends) to = 1;
    const auto foot = exact::foot(path.origin, path.direction, exact::of(ball.center), from, to);
    const Rational gap = foot.squared_distance - exact::squared(ball.radius);
    ASSERT_EQ(hit.has_value(), gap <= 0) << about;
    if (!hit) return;
    touching += gap == 0;
    const Curve q = ball_curve(path, ball.center, ball.radius);
    const auto t = first_hit_parameter(ray, ball);
    if (path.is_point() || (path.begins && q.c <= 0)) {
      EXPECT_EQ(hit->t, 0) << about;
      EXPECT_TRUE(oracle::is_nearest(hit->point, path.origin)) << about;
      EXPECT_EQ(hit->feature.kind, q.c == 0 ? FeatureKind::face : FeatureKind::interior) << about;
      if (q.c != 0) return;
      EXPECT_TRUE(oracle::is_nearest(hit->normal, exact::difference(path.origin, exact::of(ball.center)))) << about;
      return;
    }
    EXPECT_EQ(hit->feature, (Feature{FeatureKind::face, 0})) << about;
    check_root(about, path, q, *hit, *t);
  });
  std::printf("%ld misses, %ld on the surface, %ld inside, %ld touching\n", tally.misses, tally.faces, tally.interiors,
              touching);
  EXPECT_GT(touching, 30);
  for (const long n : {tally.misses, tally.faces, tally.interiors}) EXPECT_GT(n, 100);
}

/// The set along the line is what is left of [0, 1] by the ends and the quadratic: all of its ends are tried.
TEST(FirstHit, OfCylindersIsTheFirstOfAllCandidates) {
  Tally tally;
  on_shapes(702, 2500, [&](Material& m) {
    const auto cylinder = m.shape<Cylinder3>();
    if (cylinder.a == cylinder.b) return;
    const AnyRay ray = ray_of(m);
    const std::string about = m.about(cylinder) + " " + text_of(ray);
    const auto hit = first_hit(ray, cylinder);
    tally.count(hit);
    const Path path(ray);
    const Curve q = tube_curve(path, cylinder.a, cylinder.b, cylinder.radius);
    const Coordinates a = exact::of(cylinder.a), e = exact::difference(exact::of(cylinder.b), a);
    const auto along = [&](const Rational& t) {  // 0 at a, 1 at b
      return Rational(exact::dot(exact::difference(path.at(t), a), e) / exact::square(e));
    };
    const auto holds = [&](const Rational& t) { return path.has(t) && q.at(t) <= 0 && along(t) >= 0 && along(t) <= 1; };
    std::optional<Rational> best;
    const auto take = [&](const Rational& t) {
      if (holds(t) && (!best || t < *best)) best = t;
    };
    if (path.begins || path.is_point()) take(0);
    const Rational speed = along(1) - along(0);
    if (speed != 0) take(-along(0) / speed), take((1 - along(0)) / speed);
    // The lesser root, where it is between the ends and in the ray's range.
    bool root = q.a > 0 && q.b * q.b >= q.a * q.c && (!path.begins || root_against(q, 0) >= 0) &&
                (!path.ends || root_against(q, 1) <= 0);
    if (root && speed != 0) {
      const int first = root_against(q, Rational(-along(0) / speed)),
                second = root_against(q, Rational((1 - along(0)) / speed));
      root = first * second <= 0;
    } else if (root) {
      root = along(0) >= 0 && along(0) <= 1;
    }
    const bool by_root = root && (!best || root_against(q, *best) < 0);
    ASSERT_EQ(hit.has_value(), by_root || best.has_value()) << about;
    if (!hit) return;
    if (by_root) {
      const bool on_a = speed == 0 && along(0) == 0, on_b = speed == 0 && along(0) == 1;
      EXPECT_EQ(hit->feature.kind, on_a || on_b ? FeatureKind::edge : FeatureKind::face) << about;
      EXPECT_EQ(hit->feature.index, on_b ? 1u : 0u) << about;
      check_root(about, path, q, *hit, *first_hit_parameter(ray, cylinder));
      return;
    }
    EXPECT_TRUE(oracle::is_nearest(hit->t, *best)) << about;
    EXPECT_TRUE(oracle::is_nearest(hit->point, path.at(*best))) << about;
    const bool side = q.at(*best) == 0, at_a = along(*best) == 0, at_b = along(*best) == 1;
    const Feature expected = side && (at_a || at_b) ? Feature{FeatureKind::edge, at_a ? 0u : 1u}
                             : side                 ? Feature{FeatureKind::face, 0}
                             : at_a                 ? Feature{FeatureKind::face, 1}
                             : at_b                 ? Feature{FeatureKind::face, 2}
                                                    : Feature{FeatureKind::interior, 0};
    EXPECT_EQ(hit->feature.kind, expected.kind) << about;
    EXPECT_EQ(hit->feature.index, expected.index) << about;
  });
  std::printf("%ld misses, %ld edges, %ld faces, %ld inside\n", tally.misses, tally.edges, tally.faces,
              tally.interiors);
  for (const long n : {tally.misses, tally.edges, tally.faces, tally.interiors}) EXPECT_GT(n, 30);
}

/// A capsule is the union of a cylinder and two balls.
TEST(FirstHit, OfCapsulesIsTheFirstOfTheirParts) {
  std::array<long, 3> zones{};
  on_shapes(703, 2500, [&](Material& m) {
    const auto capsule = m.shape<Capsule3>();
    const AnyRay ray = ray_of(m);
    const std::string about = m.about(capsule) + " " + text_of(ray);
    const auto hit = first_hit(ray, capsule);
    std::optional<RayParameter> least;
    const auto take = [&](const std::optional<RayParameter>& t) {
      if (t && (!least || *t < *least)) least = t;
    };
    take(first_hit_parameter(ray, Sphere3{capsule.a, capsule.radius}));
    take(first_hit_parameter(ray, Sphere3{capsule.b, capsule.radius}));
    if (capsule.a != capsule.b) take(first_hit_parameter(ray, Cylinder3{capsule.a, capsule.b, capsule.radius}));
    ASSERT_EQ(hit.has_value(), least.has_value()) << about;
    if (!hit) return;
    EXPECT_EQ(*first_hit_parameter(ray, capsule), *least) << about;
    EXPECT_EQ(hit->t, least->rounded()) << about;
    if (hit->t == 0 && least->sign() == Sign::zero && ray.kind != AnyRay::Kind::line) {
      const Location where = exact::locate(capsule, ray.origin);
      EXPECT_EQ(hit->feature.kind, where == Location::inside ? FeatureKind::interior : FeatureKind::face) << about;
    } else if (capsule.a != capsule.b) {
      ++zones[hit->feature.index];
    }
  });
  std::printf("side %ld, about a %ld, about b %ld\n", zones[0], zones[1], zones[2]);
  for (const long n : zones) EXPECT_GT(n, 30);
}

/// Of halfspaces: the first of all crossings, and of zero, that all of them hold.
std::optional<Rational> first_of(const Path& path, const std::vector<std::pair<Coordinates, Rational>>& halfspaces) {
  std::vector<Rational> candidates{0};
  for (const auto& [n, offset] : halfspaces) {
    const Rational speed = exact::dot(n, path.direction);
    if (speed != 0) candidates.push_back(Rational((offset - exact::dot(n, path.origin)) / speed));
  }
  const auto holds = [&](const Rational& t) {
    return path.has(t) &&
           std::ranges::all_of(halfspaces, [&](const auto& h) { return exact::dot(h.first, path.at(t)) <= h.second; });
  };
  // A line that has no least parameter in the set: nearest to zero; there is one where far before all crossings it is
  // in.
  Rational before = 0;
  for (const Rational& t : candidates) before = std::min(before, t);
  before -= 1;
  const bool from_ever = !path.begins && holds(before);
  std::optional<Rational> best;
  for (const Rational& t : candidates) {
    if (holds(t) && (!best || (from_ever ? abs(t) < abs(*best) : t < *best))) best = t;
  }
  return best;
}

template <class Shape>
void check_halfspaces(const std::string& about, const AnyRay& ray, const Shape& shape,
                      const std::vector<std::pair<Coordinates, Rational>>& halfspaces, Tally& tally) {
  const auto hit = first_hit(ray, shape);
  tally.count(hit);
  const Path path(ray);
  const auto t = first_of(path, halfspaces);
  ASSERT_EQ(hit.has_value(), t.has_value()) << about;
  if (!hit) return;
  EXPECT_TRUE(oracle::is_nearest(hit->t, *t)) << about;
  EXPECT_TRUE(oracle::is_nearest(hit->point, path.at(*t))) << about;
  EXPECT_EQ(first_hit_parameter(ray, shape)->base.value().value, *t) << about;
  const bool on =
      std::ranges::any_of(halfspaces, [&](const auto& h) { return exact::dot(h.first, path.at(*t)) == h.second; });
  EXPECT_EQ(hit->feature.kind == FeatureKind::interior, !on) << about;
}

std::pair<Coordinates, Rational> halfspace(const Vector3& n, double offset, bool opposite) {
  if (!opposite) return {exact::of(n), Rational(offset)};
  return {exact::of(Vector3{-n.x, -n.y, -n.z}), Rational(-offset)};
}

TEST(FirstHit, OfPlanesHalfspacesAndKDopsIsThatOfTheirInequalities) {
  Tally planes, spaces, dops;
  on_shapes(704, 1500, [&](Material& m) {
    const auto plane = m.shape<Plane3>();
    const auto space = m.shape<Halfspace3>();
    const AnyRay ray = ray_of(m);
    check_halfspaces(m.about(plane) + " " + text_of(ray), ray, plane,
                     {halfspace(plane.normal, plane.offset, false), halfspace(plane.normal, plane.offset, true)},
                     planes);
    check_halfspaces(m.about(space) + " " + text_of(ray), ray, space, {halfspace(space.normal, space.offset, false)},
                     spaces);
    std::vector<Vector3> directions;
    for (std::size_t n = 1 + m.below(5); directions.size() < n;) {
      const Vector3 d = m.direction3();
      if (d != Vector3{0, 0, 0}) directions.push_back(d);
    }
    KDop3 k_dop{Directions3(directions), {}, {}};
    std::vector<std::pair<Coordinates, Rational>> all;
    for (const Vector3& d : directions) {
      const double a = m.number(), b = m.number();
      k_dop.min.push_back(std::min(a, b)), k_dop.max.push_back(std::max(a, b));
      all.push_back(halfspace(d, std::min(a, b), true)), all.push_back(halfspace(d, std::max(a, b), false));
    }
    check_halfspaces(m.about() + " " + text_of(ray), ray, k_dop, all, dops);
  });
  for (const Tally& tally : {planes, spaces, dops}) {
    EXPECT_GT(tally.misses, 50);
    EXPECT_GT(tally.faces, 50);
  }
  EXPECT_GT(spaces.interiors, 100);
}

/// Equations of the plane, line or place that three points are.
std::vector<std::pair<Coordinates, Rational>> equations(const ThreePointPlane3& p) {
  const Coordinates a = exact::of(p.a), u = exact::difference(exact::of(p.b), a),
                    v = exact::difference(exact::of(p.c), a), n = oracle::cross(u, v);
  std::vector<Coordinates> rows;
  if (exact::square(n) != 0) {
    rows = {n};
  } else {
    const Coordinates e = exact::square(u) != 0 ? u : v;
    const std::array<Coordinates, 3> units{exact::of(Vector3{1, 0, 0}), exact::of(Vector3{0, 1, 0}),
                                           exact::of(Vector3{0, 0, 1})};
    for (const Coordinates& unit : units) rows.push_back(exact::square(e) != 0 ? oracle::cross(e, unit) : unit);
  }
  std::vector<std::pair<Coordinates, Rational>> all;
  for (const Coordinates& row : rows) {
    const Coordinates back = exact::difference(exact::of(Vector3{0, 0, 0}), row);
    all.emplace_back(row, exact::dot(row, a)), all.emplace_back(back, exact::dot(back, a));
  }
  return all;
}

TEST(FirstHit, OfPlanesOfThreePointsIsThatOfTheirEquations) {
  Tally tally;
  on_shapes(706, 1500, [&](Material& m) {
    auto plane = m.shape<ThreePointPlane3>();
    if (m.below(4) == 0) plane.c = m.below(2) == 0 ? plane.a : plane.b;
    if (m.below(16) == 0) plane.b = plane.c = plane.a;
    const AnyRay ray = ray_of(m);
    check_halfspaces(m.about(plane) + " " + text_of(ray), ray, plane, equations(plane), tally);
  });
  for (const long n : {tally.misses, tally.faces, tally.edges, tally.vertices}) EXPECT_GT(n, 20);
}

TEST(FirstHit, OfConvexPolyhedraIsThatOfRationals) {
  Tally tally;
  for (std::uint64_t i = 0; i < 150 * shape_cases::more; ++i) {
    Material m(705, i);
    std::vector<Point3> points;
    for (int k = 0; k < 7; ++k) points.push_back(m.point3());
    const Hull3 hull = convex_hull(points, {.triangulate = m.below(2) == 0});
    if (hull.dimension < 3) continue;
    const ConvexPolyhedron3 solid = convex_polyhedron(hull, points);
    const PolygonMesh& mesh = solid.mesh;
    std::vector<oracle::Part> parts;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) parts.push_back({{FeatureKind::vertex, v}, {v}});
    for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
      for (std::uint32_t c = mesh.first[f]; c < mesh.first[f + 1]; ++c) {
        const std::uint32_t next = c + 1 < mesh.first[f + 1] ? c + 1 : mesh.first[f];
        parts.push_back({{FeatureKind::edge, c}, {mesh.corners[c], mesh.corners[next]}});
      }
    }
    for (std::uint32_t f = 0; f + 1 < mesh.first.size(); ++f)
      parts.push_back(
          {{FeatureKind::face, f}, {mesh.corners.begin() + mesh.first[f], mesh.corners.begin() + mesh.first[f + 1]}});
    Corners corners;
    for (const Point3& p : mesh.vertices) corners.push_back(exact::of(p));
    for (int k = 0; k < 3; ++k) {
      const AnyRay ray = ray_of(m);
      const auto hit = first_hit(ray, solid);
      tally.count(hit);
      const Path path(ray);
      const auto t = oracle::first(path, corners);
      ASSERT_EQ(hit.has_value(), t.has_value()) << m.about() << text_of(ray);
      if (!hit) continue;
      EXPECT_TRUE(oracle::is_nearest(hit->t, *t)) << m.about();
      EXPECT_TRUE(oracle::is_nearest(hit->point, path.at(*t))) << m.about();
      EXPECT_EQ(hit->feature, oracle::holder(corners, parts, path.at(*t))) << m.about() << text_of(ray);
    }
  }
  for (const long n : {tally.misses, tally.vertices, tally.edges, tally.faces}) EXPECT_GT(n, 5);
}

}  // namespace
}  // namespace plumb
