// Does nothing slip through a closed mesh, by either rule, and do batches say what single questions say?
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "query/ray/cases.hpp"
#include "query/ray/oracle.hpp"
#include "query/ray/triangle_hit.hpp"

namespace plumb {
namespace {

using namespace ray_cases;
namespace oracle = ray_oracle;
using oracle::Coordinates, oracle::Rational;

bool hits_any(const AnyRay& r, const Triangle3& t, HitRule rule) {
  const bool by_kind = r.kind == AnyRay::Kind::ray       ? hits(Ray3{r.origin, r.direction}, t, rule)
                       : r.kind == AnyRay::Kind::segment ? hits(Segment3{r.origin, r.end}, t, rule)
                                                         : hits(Line3{r.origin, r.direction}, t, rule);
  EXPECT_EQ(hits(r, t, rule), by_kind);
  return by_kind;
}

/// By a vector that is small beside all coordinates of a small grid, moved in rationals.
bool moved_ray_hits(const AnyRay& ray, const Triangle3& t) {
  oracle::Path path(ray);
  Rational step(1);
  for (Rational& x : path.origin) {
    step >>= 200;
    x += step;
  }
  if (path.is_point()) return false;
  const auto at = oracle::meets(path, oracle::corners_of(t));
  return at && path.has(*at);
}

Point3 grid_point(Entropy& e, std::int64_t most) {
  const auto x = static_cast<double>(e.within(most)), y = static_cast<double>(e.within(most));
  return {x, y, static_cast<double>(e.within(most))};
}
Vector3 between_points(const Point3& a, const Point3& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }

TEST(HalfOpen, IsTheRayMovedByOneVector) {
  long hit = 0;
  for (std::uint64_t i = 0; i < 6000 * shape_cases::more; ++i) {
    Entropy e(601, i);
    const std::int64_t most = 1 + static_cast<std::int64_t>(e.below(3));
    const Triangle3 t{grid_point(e, most), grid_point(e, most), grid_point(e, most)};
    const Point3 a = grid_point(e, most), b = grid_point(e, most);
    const std::uint64_t kind = e.below(3);
    const AnyRay ray = kind == 0   ? AnyRay(Ray3{a, between_points(a, b)})
                       : kind == 1 ? AnyRay(Segment3{a, b})
                                   : AnyRay(Line3{a, between_points(a, b)});
    const bool expected = moved_ray_hits(ray, t);
    ASSERT_EQ(hits_any(ray, t, HitRule::half_open), expected) << "index " << i << " " << text_of(ray);
    const auto first = first_hit(ray, t, HitRule::half_open);
    ASSERT_EQ(first.has_value(), expected) << "index " << i;
    if (!expected) continue;
    ++hit;
    // What is hit by this rule is hit as a set, at the same place.
    const auto closed = first_hit(ray, t);
    ASSERT_TRUE(closed) << "index " << i;
    EXPECT_EQ(*closed, *first) << "index " << i;
  }
  EXPECT_GT(hit, 400);
}

/// On which side of the plane through the ray and the edge from a to b?  By the rational determinant.
Sign line_side(const Ray3& ray, const Point3& a, const Point3& b, const Point3& p) {
  const Coordinates d = exact::of(ray.direction), e = exact::difference(exact::of(b), exact::of(a));
  return static_cast<Sign>(sgn(exact::dot(oracle::cross(d, e), exact::difference(exact::of(p), exact::of(a)))));
}

/// Rays from a grid through points of the edge that two triangles share, and through its ends.
TEST(HalfOpen, OfTwoTrianglesWithACommonEdgeExactlyOneIsHit) {
  long between = 0, beside = 0;
  for (std::uint64_t i = 0; i < 4000 * shape_cases::more; ++i) {
    Entropy e(602, i);
    const Point3 a = grid_point(e, 8), b = grid_point(e, 8), c = grid_point(e, 8), d = grid_point(e, 8);
    const auto part = static_cast<double>(e.below(7) + 1) / 8;  // strictly between the ends, exact
    const Point3 on{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)};
    const Vector3 way = between_points({0, 0, 0}, grid_point(e, 8));
    const Ray3 ray{{on.x - way.x, on.y - way.y, on.z - way.z}, way};
    const Sign left = line_side(ray, a, b, c), right = line_side(ray, a, b, d);
    if (left == Sign::zero || right == Sign::zero) continue;
    const Triangle3 one{a, b, c}, other{e.coin() ? b : a, e.coin() ? a : b, d};
    if (other.a == other.b) continue;
    EXPECT_TRUE(hits(ray, one) && hits(ray, other)) << "index " << i;
    const int count = hits(ray, one, HitRule::half_open) + hits(ray, other, HitRule::half_open);
    if (left != right) {
      ++between;
      EXPECT_EQ(count, 1) << "index " << i;
    } else {
      ++beside;
      EXPECT_NE(count, 1) << "index " << i;
    }
  }
  EXPECT_GT(between, 500);
  EXPECT_GT(beside, 500);
}

/// Whole numbers times powers of two, of few digits and of many, from a small grid: what integers of the least width
/// decide is what is decided without them.
TEST(DecidedHit, IsThatOfNumbersOfAllSizes) {
  long hit = 0, missed = 0;
  for (std::uint64_t i = 0; i < 3000 * shape_cases::more; ++i) {
    Entropy e(603, i);
    const auto any_unit = [&] {
      const auto odd = static_cast<double>(2 * e.below(std::uint64_t{1} << e.below(48)) + 1);
      return std::ldexp(odd, e.coin() ? 0 : static_cast<int>(e.within(900)));
    };
    const double unit = any_unit(), way_unit = any_unit();
    const auto point = [&] {
      const Point3 p = grid_point(e, 2);
      return Point3{unit * p.x, unit * p.y, unit * p.z};
    };
    const Triangle3 t{point(), point(), point()};
    const Point3 a = point(), b = point(), way = grid_point(e, 2);
    const Vector3 d{way_unit * way.x, way_unit * way.y, way_unit * way.z};
    const std::uint64_t kind = e.below(3);
    const AnyRay ray = kind == 0 ? AnyRay(Ray3{a, d}) : kind == 1 ? AnyRay(Segment3{a, b}) : AnyRay(Line3{a, d});
    for (const HitRule rule : {HitRule::closed, HitRule::half_open}) {
      const auto decided = query::decide_hit(ray, t, rule);
      ASSERT_EQ(decided.has_value(), hits_any(ray, t, rule)) << "index " << i;
      (decided ? hit : missed) += 1;
      if (!decided) continue;
      const auto numbers = first_hit(ray, t, rule);
      ASSERT_TRUE(numbers && query::hit_of(ray, t, *decided) == *numbers) << "index " << i;
      const auto [least, most] = query::range_of(ray, t, *decided);
      EXPECT_TRUE(least <= numbers->t && numbers->t <= most) << "index " << i;
    }
  }
  EXPECT_GT(hit, 500);
  EXPECT_GT(missed, 1000);
}

TriangleMesh hull_mesh(std::span<const Point3> points) {
  const Hull3 hull = convex_hull(points, {.triangulate = true});
  TriangleMesh mesh;
  mesh.vertices.assign(points.begin(), points.end());
  for (std::size_t f = 0; f < hull.face_count(); ++f)
    mesh.triangles.push_back({hull.face(f)[0], hull.face(f)[1], hull.face(f)[2]});
  return mesh;
}

int crossings(const AnyRay& ray, const TriangleMesh& mesh) {
  int count = 0;
  for (const auto& t : mesh.triangles)
    count += hits_any(ray, {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, HitRule::half_open);
  return count;
}

TEST(Parity, OfConvexMeshesIsThatOfTheirHalfspaces) {
  std::array<long, 3> told{};
  for (std::uint64_t i = 0; i < 150 * shape_cases::more; ++i) {
    Entropy e(603, i);
    std::vector<Point3> points;
    for (int k = 0; k < 12; ++k) points.push_back(grid_point(e, 3));
    const Hull3 hull = convex_hull(points);
    if (hull.dimension < 3) continue;
    const ConvexPolyhedron3 solid = convex_polyhedron(hull, points);
    TriangleMesh mesh = hull_mesh(points);
    ASSERT_TRUE(is_closed(mesh) && is_oriented_closed(mesh)) << "index " << i;
    for (int k = 0; k < 12; ++k) {
      const Point3 p = grid_point(e, 4);
      const Location expected = locate(solid, p);
      ++told[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
      ASSERT_EQ(locate(mesh, p), expected) << "index " << i;
      const auto winding = winding_number(mesh, p);
      if (expected == Location::boundary) {
        EXPECT_FALSE(winding) << "index " << i;
        continue;
      }
      EXPECT_EQ(winding, expected == Location::inside ? 1 : 0) << "index " << i;
      // Any ray tells the same, above all those at vertices.
      for (int way = 0; way < 4; ++way) {
        const Ray3 ray{p, between_points(p, way == 0 ? grid_point(e, 4) : points[e.below(points.size())])};
        if (ray.direction == Vector3{0, 0, 0}) continue;
        EXPECT_EQ(crossings(ray, mesh) % 2 == 1, expected == Location::inside) << "index " << i << " way " << way;
      }
      // Two segments end to end cross what the whole crosses, each crossing once.
      const Point3 q = points[e.below(points.size())], r = {2 * q.x - p.x, 2 * q.y - p.y, 2 * q.z - p.z};
      EXPECT_EQ(crossings(Segment3{p, q}, mesh) + crossings(Segment3{q, r}, mesh), crossings(Segment3{p, r}, mesh))
          << "index " << i;
    }
    // Turned inside out, and twice over.
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
    const Point3 p = grid_point(e, 2);
    if (locate(solid, p) != Location::inside) continue;
    EXPECT_EQ(winding_number(mesh, p), -1);
    const auto once = mesh.triangles;
    mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
    EXPECT_EQ(winding_number(mesh, p), -2);
    EXPECT_EQ(locate(mesh, p), Location::outside);
  }
  for (const long n : told) EXPECT_GT(n, 40);
}

TEST(Parity, OpenMeshesAreToldFromClosedOnes) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_TRUE(is_closed(mesh) && is_oriented_closed(mesh));
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_FALSE(is_oriented_closed(mesh));
  mesh.triangles.pop_back();
  EXPECT_FALSE(is_closed(mesh));
  mesh.triangles.push_back({0, 1, 9});
  EXPECT_TRUE(text_of<InvalidShape>([&] { (void)is_closed(mesh); }).starts_with("is_closed: "));
  EXPECT_TRUE(text_of<InvalidShape>([&] { (void)is_oriented_closed(mesh); }).starts_with("is_oriented_closed: "));
  EXPECT_THROW(static_cast<void>(locate(mesh, Point3{0, 0, 0})), InvalidShape);
}

/// Is the answer of one the answers of all, and the first the least?
void check_batch(const AnyRay& ray, std::span<const Triangle3> triangles, HitRule rule, const std::string& about) {
  const TriangleBatch batch(triangles);
  std::vector<std::uint8_t> out(triangles.size(), 7);
  hits(ray, batch, out, rule);
  std::optional<std::uint32_t> best;
  std::optional<RayParameter> least;
  std::vector<std::uint32_t> all;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto parameter = first_hit_parameter(ray, triangles[i], rule);
    ASSERT_EQ(out[i], parameter ? 1 : 0) << about << " triangle " << i;
    if (!parameter) continue;
    all.push_back(static_cast<std::uint32_t>(i));
    if (!least || *parameter < *least) least = parameter, best = static_cast<std::uint32_t>(i);
  }
  EXPECT_EQ(all_hits(ray, batch, rule), all) << about;
  const auto first = first_hit(ray, batch, rule);
  ASSERT_EQ(first.has_value(), best.has_value()) << about;
  if (!first) return;
  EXPECT_EQ(first->index, *best) << about;
  EXPECT_EQ(first->hit, *first_hit(ray, triangles[*best], rule)) << about;
}

TEST(Batch, SaysWhatSingleQuestionsSay) {
  long hit = 0;
  on_shapes(604, 500, [&](Material& m) {
    std::vector<Triangle3> triangles;
    for (std::size_t n = 1 + m.below(40); n-- > 0;) triangles.push_back(m.shape<Triangle3>());
    const AnyRay ray = ray_of(m);
    const HitRule rule = m.below(2) == 0 ? HitRule::closed : HitRule::half_open;
    check_batch(ray, triangles, rule, m.about() + " " + text_of(ray));
    hit += first_hit(ray, TriangleBatch(triangles), rule).has_value();
  });
  EXPECT_GT(hit, 100);
}

TEST(Batch, OfBoxesSaysWhatSingleQuestionsSay) {
  std::array<long, 2> told{};
  on_shapes(607, 400, [&](Material& m) {
    std::vector<Aabb3> boxes;
    for (std::size_t n = 1 + m.below(40); n-- > 0;) boxes.push_back(m.shape<Aabb3>());
    const AnyRay ray = ray_of(m);
    std::vector<std::uint8_t> out(boxes.size(), 7);
    hits(ray, BoxBatch(boxes), out);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      ASSERT_EQ(out[i], first_hit(ray, boxes[i]) ? 1 : 0) << m.about(boxes[i]) << " " << text_of(ray);
      ++told[out[i]];
    }
  });
  for (const long n : told) EXPECT_GT(n, 500);
}

TEST(Batch, OrdersWhatIsNearlyTheSame) {
  // Planes across the ray by ulps apart, and equal ones, in any order.
  for (std::uint64_t i = 0; i < 60; ++i) {
    Entropy e(605, i);
    std::vector<Triangle3> triangles;
    for (int k = 0; k < 40; ++k) {
      const double z = moved_by_ulps(1.0, e.within(2)), tilt = static_cast<double>(e.within(1)) * 0x1p-52;
      triangles.push_back({{-5, -5, z + tilt}, {7, -3, z - tilt}, {-2, 9, z}});
    }
    check_batch(Ray3{{0.125, 0.25, -3}, {0x1p-30, 0, 1}}, triangles, HitRule::closed, "index " + std::to_string(i));
    check_batch(Segment3{{0.1, 0.2, -3}, {0.3, 0.1, 5}}, triangles, HitRule::closed, "index " + std::to_string(i));
  }
}

TEST(Batch, NamesWhatIsWrong) {
  const double nan = std::nan("");
  const std::vector<Triangle3> bad{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}};
  try {
    const TriangleBatch batch(bad);
    FAIL();
  } catch (const NonFinite& e) {
    EXPECT_NE(std::string(e.what()).find("items[1].b.y"), std::string::npos) << e.what();
  }
  const TriangleBatch one(std::span<const Triangle3>(bad.data(), 1));
  std::vector<std::uint8_t> out(2);
  EXPECT_THROW(hits(Ray3{{0, 0, 0}, {1, 0, 0}}, one, out), UnequalLengths);
  EXPECT_THROW(static_cast<void>(all_hits(Ray3{{0, 0, 0}, {nan, 0, 0}}, one)), NonFinite);
}

/// Rays aimed exactly at vertices and edge points of a closed mesh: an even number of crossings in all of a line.
void expect_watertight(const TriangleMesh& mesh, const std::string& name) {
  const TriangleBatch batch = triangle_batch(mesh);
  for (std::uint64_t i = 0; i < battery::fitting(12 * shape_cases::more); ++i) {
    Entropy e(606, i);
    const auto unit = [&] { return static_cast<double>(e.within(1024)) / 1024; };
    const TriangleMesh::Triangle& t = mesh.triangles[e.below(mesh.triangles.size())];
    const Point3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]];
    const Point3 from{a.x + unit(), a.y + unit(), a.z + unit()};
    // Through a vertex, exactly, and along an edge and beyond.
    const AnyRay rays[] = {Line3{a, between_points(a, from)}, Line3{a, between_points(a, b)}};
    for (const AnyRay& ray : rays) {
      EXPECT_EQ(all_hits(ray, batch, HitRule::half_open).size() % 2, 0u) << name << " index " << i;
      EXPECT_FALSE(all_hits(ray, batch).empty()) << name << " index " << i;  // closed: never missed
    }
    const Location where = locate(mesh, from);
    ASSERT_NE(where, Location::boundary);
    const std::size_t out = all_hits(Ray3{from, between_points(from, a)}, batch, HitRule::half_open).size();
    EXPECT_EQ(out % 2 == 1, where == Location::inside) << name << " index " << i;
    EXPECT_EQ(*winding_number(mesh, from) % 2 != 0, where == Location::inside) << name << " index " << i;
    EXPECT_EQ(locate(mesh, a), Location::boundary);
  }
}

TEST(Watertight, GeneratedMeshesAreCrossedAsOftenInAsOut) {
  expect_watertight(solids::torus(3, 1, 32, 16), "torus");
  expect_watertight(solids::turned(solids::torus(2, 1.5, 24, 24)), "thick torus");
  expect_watertight(solids::turned(solids::hollow_torus(3, 1, 24, 12)), "hollow torus");
}

TEST(Watertight, RealMeshesAreCrossedAsOftenInAsOut) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::printf("skipped: there is no %s\n", folder.c_str());
    return;
  }
  int closed = 0;
  for (const char* name : {"spot.obj", "cow.obj", "rocker-arm.obj", "horse.ply", "fandisk.obj", "suzanne.obj"}) {
    const TriangleMesh mesh = read_mesh(folder / name);
    if (!is_closed(mesh)) {
      std::printf("%s is open\n", name);
      continue;
    }
    ++closed;
    expect_watertight(mesh, name);
  }
  EXPECT_GT(closed, 1);
}

}  // namespace
}  // namespace plumb
