// Is what is nearest of moved meshes what is nearest of the exactly moved triangles?
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/gmp.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "query/closest/posed_triangle.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;

/// No point of the triangle is nearer than q in the direction toward p, nor is q beside the triangle.
void expect_nearest(const Posed<Triangle3>& t, const Point3& p, const std::string& about) {
  const auto& [s, pose] = t;
  const std::array corner{image(s.a, pose), image(s.b, pose), image(s.c, pose)};
  const RationalPoint at{mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
  const mpq_class square = mpq(query::squared_distance_exact(t, p));
  // The least over the corners and over the feet on the edges and the plane that are within.
  const auto less = [](const RationalPoint& a, const RationalPoint& b) {
    return RationalPoint{mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1]), mpq_class(a[2] - b[2])};
  };
  const auto dot = [](const RationalPoint& a, const RationalPoint& b) -> mpq_class {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  std::optional<mpq_class> least;
  const auto take = [&](const mpq_class& x) { least = least ? std::min(*least, x) : x; };
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint w = less(at, corner[i]), e = less(corner[(i + 1) % 3], corner[i]);
    const RationalPoint f = less(corner[(i + 2) % 3], corner[i]);
    take(dot(w, w));
    const mpq_class ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), we = dot(w, e), wf = dot(w, f);
    if (we > 0 && we < ee) take(dot(w, w) - we * we / ee);
    const mpq_class whole = ee * ff - ef * ef;
    if (whole == 0) continue;
    const mpq_class x = (we * ff - wf * ef) / whole, y = (wf * ee - we * ef) / whole;
    if (x < 0 || y < 0 || x + y > 1) continue;
    RationalPoint rest = w;
    for (std::size_t k = 0; k < 3; ++k) rest[k] -= x * e[k] + y * f[k];
    take(dot(rest, rest));
  }
  ASSERT_EQ(square, *least) << about;
  ASSERT_EQ(query::distance(t, p), rounded_root(Rounding::nearest, rational(square))) << about;
  ASSERT_EQ(query::closest_on(t, p).distance, query::distance(t, p)) << about;
}

TEST(PosedClosest, IsWhatRationalsSay) {
  shape_cases::on_shapes(1721, battery::fitting(1000), [&](Material& m) {
    const Posed<Triangle3> t{m.shape<Triangle3>(), any_pose(m)};
    expect_nearest(t, m.probe3(), m.about(t));
  });
}

TEST(PosedClosest, IsThatOfTheExactlyPosedTriangles) {
  long compared = 0;
  shape_cases::on_shapes(1722, battery::fitting(1500), [&](Material& m) {
    const Posed<Triangle3> a{m.shape<Triangle3>(), integer_pose(m)};
    const Posed<Triangle3> b{m.shape<Triangle3>(), pose_like(m, a.pose)};
    const auto exact = [](const Posed<Triangle3>& t) {
      return exact_mesh({{t.shape.a, t.shape.b, t.shape.c}, {{0, 1, 2}}}, t.pose);
    };
    const auto p = exact(a), q = exact(b);
    if (!p || !q) return;
    const auto triangle = [](const TriangleMesh& t) { return Triangle3{t.vertices[0], t.vertices[1], t.vertices[2]}; };
    const Triangle3 s = triangle(*p), t = triangle(*q);
    ASSERT_EQ(query::closest_points(a, b), closest_points(s, t)) << m.about(a, b);
    ASSERT_EQ(query::distance(a, b), distance(s, t)) << m.about(a, b);
    ASSERT_EQ(query::squared_distance_exact(a, b), squared_distance_exact(s, t)) << m.about(a, b);
    const Point3 at = m.probe3();
    const Closest near = closest_points(at, s);
    const query::ClosestOnPosed found = query::closest_on(a, at);
    ASSERT_EQ(found.point, near.on_b) << m.about(a, at);
    ASSERT_EQ(found.distance, near.distance) << m.about(a, at);
    ASSERT_EQ(found.feature, near.feature_b) << m.about(a, at);
    ++compared;
  });
  EXPECT_GT(compared, battery::fitting(500));
}

TEST(PosedClosest, IsThatOfTheExactlyPosedMesh) {
  long compared = 0;
  shape_cases::on_shapes(1723, battery::fitting(250), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(20), m.below(20));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(12), m.below(8));
    const Pose pose_a = integer_pose(m), pose_b = pose_like(m, pose_a);
    const auto posed_a = exact_mesh(mesh_a, pose_a), posed_b = exact_mesh(mesh_b, pose_b);
    if (!posed_a || !posed_b) return;
    const Bvh a = build_bvh(mesh_a, {.most_in_leaf = 2}), b = build_bvh(mesh_b);
    const Bvh there_a = build_bvh(*posed_a), there_b = build_bvh(*posed_b);
    const PosedMesh asked_a{a, pose_a}, asked_b{b, pose_b};
    const Point3 p = m.probe3();
    ASSERT_EQ(closest_on_mesh(asked_a, p), closest_on_mesh(there_a, p)) << m.about(p);
    ASSERT_EQ(nearest_triangles(asked_a, p, 5), nearest_triangles(there_a, p, 5)) << m.about(p);
    if (const auto closest = closest_on_mesh(there_a, p)) {
      for (const double within : {closest->distance / 2, closest->distance, 2 * closest->distance})
        ASSERT_EQ(closest_on_mesh(asked_a, p, within), closest_on_mesh(there_a, p, within)) << m.about(p);
    }
    const auto nearest = nearest_triangles(there_a, p, 3);
    if (!nearest.empty() && std::isfinite(nearest.back().distance)) {
      const double reach = nearest.back().distance;
      ASSERT_EQ(triangles_within(asked_a, p, reach), triangles_within(there_a, p, reach)) << m.about(p);
    }
    const auto near = closest_triangles(there_a, there_b, {.first = true});
    ASSERT_EQ(closest_triangles(asked_a, asked_b, {.first = true}), near) << m.about();
    ASSERT_EQ(closest_triangles(asked_a, asked_b).has_value(), near.has_value()) << m.about();
    if (near) {
      const double d = near->closest.distance;
      ASSERT_EQ(closest_triangles(asked_a, asked_b)->closest.distance, d) << m.about();
      ASSERT_EQ(distance(asked_a, asked_b), d) << m.about();
      for (const double reach : {d / 2, d, 2 * d})
        ASSERT_EQ(within(asked_a, asked_b, reach), within(there_a, there_b, reach)) << m.about();
    }
    ++compared;
  });
  EXPECT_GT(compared, battery::fitting(100));
}

TEST(PosedClosest, OfATurnedMeshIsThatOfEachTriangle) {
  const TriangleMesh mesh = meshes::ring(5);
  const Bvh bvh = build_bvh(mesh);
  shape_cases::on_shapes(1724, battery::fitting(10), [&](Material& m) {
    Pose pose = turn(m);
    pose.translation = {0.1, 0.2, 0.3};
    std::vector<Point3> points;
    for (int i = 0; i < 20; ++i) {
      const Point3& v = mesh.vertices[m.below(mesh.vertices.size())];
      const Point3 at = approximate(Posed<Point3>{v, pose});
      points.push_back(i % 2 == 0 ? at : Point3{2 * at.x, at.y + 0.25, at.z});
    }
    std::vector<ClosestOnMesh> found(points.size());
    closest_on_mesh({bvh, pose}, points, found);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::optional<std::pair<Rational, std::uint32_t>> least;
      for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) {
        Rational square = query::squared_distance_exact(posed_triangle(mesh, k, pose), points[i]);
        if (!least || square < least->first) least = {std::move(square), k};
      }
      EXPECT_EQ(found[i].triangle, least->second) << m.about() << " point " << i;
      EXPECT_EQ(found[i].distance, rounded_root(Rounding::nearest, least->first)) << m.about() << " point " << i;
      EXPECT_EQ(closest_on_mesh({bvh, pose}, points[i]), found[i]);
    }
    Pose away = turn(m);
    away.translation = {4, 1, 2};
    const auto near = closest_triangles({bvh, pose}, {bvh, away});
    ASSERT_TRUE(near);
    EXPECT_EQ(near->closest.distance,
              query::distance(posed_triangle(mesh, near->a, pose), posed_triangle(mesh, near->b, away)));
  });
}

/// Lattices face to face, in any order of the numbers: many pairs are equally near, and the first is told.  Now and then
/// a tip or a ridge is nearer, or slopes rise between them.
TEST(PosedClosest, OfManyEquallyNearIsTheFirst) {
  const auto lattice = [](Entropy& entropy, double z) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < 9; ++i) mesh.vertices.push_back({1.0 * (i % 3), 1.0 * (i / 3), z});
    for (const std::uint32_t i : {0u, 1u, 3u, 4u})
      mesh.triangles.insert(mesh.triangles.end(), {{i, i + 1, i + 4}, {i, i + 4, i + 3}});
    const std::uint64_t kind = entropy.below(4);
    if (kind == 1) mesh.vertices[entropy.below(9)].z += 0.25 - 0.5 * z;
    if (kind == 2) mesh.vertices[3].z = mesh.vertices[4].z = 0.5;
    for (std::size_t i = 8; i > 1; --i) std::swap(mesh.triangles[i - 1], mesh.triangles[entropy.below(i)]);
    return mesh;
  };
  const auto cases = static_cast<std::uint64_t>(battery::fitting(60));
  for (std::uint64_t index = 0; index < cases; ++index) {
    Entropy entropy(1724, index);
    const TriangleMesh mesh_a = lattice(entropy, 0), mesh_b = lattice(entropy, 1);
    const auto part = [&] { return 0.25 * static_cast<double>(entropy.within(12)); };
    const double x = part(), y = part();
    TriangleMesh there = mesh_b;
    for (Point3& p : there.vertices) p = {p.x + x, p.y + y, p.z};
    const Pose turned{{{{0.8, 0.6, 0}, {-0.36, 0.48, 0.8}, {0.48, -0.64, 0.6}}}, {0.1, 0.2, 0.3}};
    const Pose pose_a = entropy.coin() ? turned : identity_pose;
    Pose pose_b = pose_a;  // beside the image, not quite along the plane where it is turned
    pose_b.translation.x += part();
    const Bvh a = build_bvh(mesh_a, {.most_in_leaf = 1}), b = build_bvh(there);
    std::optional<Rational> least;
    std::uint32_t first_a = 0, first_b = 0;
    for (std::uint32_t i = 0; i < 8; ++i) {
      for (std::uint32_t k = 0; k < 8; ++k) {
        auto square =
            query::squared_distance_exact(posed_triangle(mesh_a, i, pose_a), posed_triangle(there, k, pose_b));
        if (least && !(square < *least)) continue;
        least = std::move(square), first_a = i, first_b = k;
      }
    }
    EXPECT_EQ(distance(PosedMesh{a, pose_a}, PosedMesh{b, pose_b}), rounded_root(Rounding::nearest, *least));
    const auto near = closest_triangles({a, pose_a}, {b, pose_b}, {.first = true});
    ASSERT_TRUE(near.has_value());
    EXPECT_EQ(std::pair(near->a, near->b), std::pair(first_a, first_b)) << "case " << index;
    EXPECT_EQ(near->closest.distance, rounded_root(Rounding::nearest, *least)) << "case " << index;
  }
}

TEST(PosedClosest, ReachesBeyondTheDoubles) {
  const double most = std::numeric_limits<double>::max();
  const Bvh unit = build_bvh(TriangleMesh{{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {{0, 1, 2}}});
  Pose right = identity_pose;
  right.columns[0].x = right.translation.x = most;
  Pose above = right, left = right;
  above.translation.y = 4;
  left.columns[0].x = left.translation.x = -most;
  const auto near = closest_triangles({unit, right}, {unit, above});  // the images are beyond the doubles
  ASSERT_TRUE(near);
  EXPECT_EQ(near->closest.distance, 3);
  EXPECT_EQ(distance({unit, right}, {unit, above}), 3);
  EXPECT_TRUE(within({unit, right}, {unit, above}, 3));
  EXPECT_FALSE(within({unit, right}, {unit, above}, std::nextafter(3, 0)));
  EXPECT_EQ(distance({unit, right}, {unit, left}), INFINITY);  // four times the largest double
  EXPECT_EQ(closest_on_mesh({unit, right}, Point3{0, 0, 0})->distance, INFINITY);
}

TEST(PosedClosest, RefusesWhatIsNone) {
  const Bvh bvh = build_bvh(meshes::repeated(2)), nothing = build_bvh(TriangleMesh{});
  Pose pose = identity_pose;
  pose.translation.z = INFINITY;
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)closest_on_mesh({bvh, pose}, Point3{0, 0, 0});
            }),
            "closest_on_mesh: mesh.pose.translation.z is inf, not a real number; give a finite double");
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)closest_triangles(bvh, {bvh, pose});
            }),
            "closest_triangles: b.pose.translation.z is inf, not a real number; give a finite double");
  EXPECT_THROW((void)nearest_triangles(PosedMesh(bvh), {0, NAN, 0}, 2), NonFinite);
  EXPECT_THROW((void)triangles_within(PosedMesh(bvh), {0, 0, 0}, NAN), NonFinite);
  EXPECT_FALSE(closest_on_mesh(PosedMesh(nothing), {0, 0, 0}));
  EXPECT_FALSE(closest_triangles(PosedMesh(nothing), PosedMesh(bvh)));
  std::vector<ClosestOnMesh> out(1);
  EXPECT_THROW(closest_on_mesh(PosedMesh(nothing), std::vector<Point3>(1), out), InvalidShape);
  EXPECT_THROW(closest_on_mesh(PosedMesh(bvh), std::vector<Point3>(2), out), UnequalLengths);
}

}  // namespace
}  // namespace plumb
