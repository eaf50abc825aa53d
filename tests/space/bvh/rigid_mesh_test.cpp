// Is a mesh under a rigid pose asked about exactly?  Turns by quaternions of small integers have matrices of integers
// over a weight: so many times as large, all is a question of integers under a Pose.  Turns of other numbers leave what
// meshes under one pose have in common.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using shape_cases::Material;

double small(Material& m, int most) { return static_cast<double>(m.entropy().within(most)); }
Point3 lattice_point(Material& m, int most = 4) { return {small(m, most), small(m, most), small(m, most)}; }
Vector3 lattice_vector(Material& m, int most = 3) { return {small(m, most), small(m, most), small(m, most)}; }

TriangleMesh lattice_mesh(Material& m) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < 4 + m.below(5); ++i) mesh.vertices.push_back(lattice_point(m));
  const auto any = [&] { return static_cast<std::uint32_t>(m.below(mesh.vertices.size())); };
  for (std::size_t i = 0; i < 1 + m.below(12); ++i) mesh.triangles.push_back({any(), any(), any()});
  return mesh;
}

/// A pose and the weight of its numbers.
struct Turned {
  MeshPose pose;
  Pose weighted;  // where everything is so many times as large
  double weight;
};
RigidPose lattice_turn(Material& m) {
  RigidPose r{{small(m, 2), small(m, 2), small(m, 2), small(m, 2)}, lattice_vector(m)};
  if (r.turn == Rotation{0, 0, 0, 0}) r.turn = {1, 0, 0, 1};
  return r;
}
Vector3 times(const Vector3& v, double by) { return {v.x * by, v.y * by, v.z * by}; }
Point3 times(const Point3& p, double by) { return {p.x * by, p.y * by, p.z * by}; }
Vector3 mapped(const std::array<Vector3, 3>& c, const Vector3& v) {
  return {c[0].x * v.x + c[1].x * v.y + c[2].x * v.z, c[0].y * v.x + c[1].y * v.y + c[2].y * v.z,
          c[0].z * v.x + c[1].z * v.y + c[2].z * v.z};
}
Turned turned(const RigidPose& r) {
  const auto& [w, x, y, z] = r.turn;  // small integers, whose products are doubles
  const double weight = w * w + x * x + y * y + z * z;
  const std::array<Vector3, 3> columns{{{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
                                        {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
                                        {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}}};
  return {r, {columns, times(r.translation, weight)}, weight};
}
Turned turned(Material& m) {
  if (m.below(3) != 0) return turned(lattice_turn(m));
  const RigidPose r = lattice_turn(m), s = lattice_turn(m);
  const Turned a = turned(r), b = turned(s);
  const auto& c = a.weighted.columns;
  const Vector3 shift = mapped(c, b.weighted.translation), by_a = times(a.weighted.translation, b.weight);
  return {RigidChain{{r, s}},
          {{mapped(c, b.weighted.columns[0]), mapped(c, b.weighted.columns[1]), mapped(c, b.weighted.columns[2])},
           {shift.x + by_a.x, shift.y + by_a.y, shift.z + by_a.z}},
          a.weight * b.weight};
}
/// The weighted pose, larger again.
Pose larger(const Turned& t, double by) {
  const auto& c = t.weighted.columns;
  return {{times(c[0], by), times(c[1], by), times(c[2], by)}, times(t.weighted.translation, by)};
}

/// Of what is so many times as large, rounded twice.
void expect_near(double large, double weight, double given) {
  EXPECT_NEAR(large / weight, given, 1e-14 * (1 + std::abs(given)));
}

TEST(RigidMesh, IsHitByRaysWhereTheWeightedMeshIs) {
  long hit = 0;
  shape_cases::on_shapes(4401, battery::fitting(2000), [&](Material& m) {
    const Bvh bvh = build_bvh(lattice_mesh(m));
    const CompactBvh small_bvh = compact(bvh);
    const Turned t = turned(m);
    const std::array ends{lattice_point(m, 9), lattice_point(m, 9)};
    const std::uint64_t kind = m.below(3);
    const auto ray_times = [&](double by) -> AnyRay {
      const Point3 a = times(ends[0], by), b = times(ends[1], by);
      const Vector3 along{b.x - a.x, b.y - a.y, b.z - a.z};
      return kind == 0 ? AnyRay(Segment3{a, b}) : kind == 1 ? AnyRay(Ray3{a, along}) : AnyRay(Line3{a, along});
    };
    const AnyRay ray = ray_times(1), large = ray_times(t.weight);
    for (const HitRule rule : {HitRule::closed, HitRule::half_open}) {
      const std::vector<NumberedHit> expected = hits(PosedMesh{bvh, t.weighted}, large, rule);
      const std::vector<NumberedHit> found = hits(PosedMesh{bvh, t.pose}, ray, rule);
      ASSERT_EQ(found.size(), expected.size()) << m.about();
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].index, expected[i].index) << m.about();
        ASSERT_EQ(found[i].hit.t, expected[i].hit.t) << m.about();
        ASSERT_EQ(found[i].hit.feature, expected[i].hit.feature) << m.about();
        expect_near(expected[i].hit.point.x, t.weight, found[i].hit.point.x);
        expect_near(expected[i].hit.normal.z, t.weight * t.weight, found[i].hit.normal.z);
      }
      ASSERT_EQ(hits(PosedCompactMesh{small_bvh, t.pose}, ray, rule), found) << m.about();
      ASSERT_EQ(first_hit(PosedMesh{bvh, t.pose}, ray, rule), found.empty() ? std::nullopt : std::optional(found[0]))
          << m.about();
      ASSERT_EQ(any_hit(PosedMesh{bvh, t.pose}, ray, rule), !found.empty()) << m.about();
      ASSERT_EQ(count_hits(PosedMesh{bvh, t.pose}, ray, rule), found.size()) << m.about();
      std::vector<std::optional<NumberedHit>> out(1);
      first_hit(PosedMesh{bvh, t.pose}, {&ray, 1}, out, {.rule = rule});
      ASSERT_EQ(out[0], found.empty() ? std::nullopt : std::optional(found[0])) << m.about();
    }
    hit += any_hit(PosedMesh{bvh, t.pose}, ray) ? 1 : 0;
  });
  EXPECT_GT(hit, battery::fitting(30));
}

TEST(RigidMesh, HoldsThePointsThatTheWeightedMeshHolds) {
  std::array<long, 3> told{};
  shape_cases::on_shapes(4402, battery::fitting(6000), [&](Material& m) {
    const Point3 a = lattice_point(m), b = lattice_point(m), c = lattice_point(m), d = lattice_point(m);
    const Bvh bvh = build_bvh(TriangleMesh{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
    const Turned t = turned(m);
    const Point3 p = lattice_point(m, 5), large = times(p, t.weight);
    const Location expected = locate({bvh, t.weighted}, large);
    ++told[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
    ASSERT_EQ(locate({bvh, t.pose}, p), expected) << m.about();
    ASSERT_EQ(winding_number({bvh, t.pose}, p), winding_number({bvh, t.weighted}, large)) << m.about();
  });
  for (const long n : told) EXPECT_GT(n, battery::fitting(2));
}

TEST(RigidMesh, MeetsTheFiguresThatTheWeightedMeshMeets) {
  long met = 0;
  shape_cases::on_shapes(4403, battery::fitting(200), [&](Material& m) {
    const Bvh bvh = build_bvh(lattice_mesh(m));
    const Turned t = turned(m);
    const double w = t.weight;
    const auto same = [&](const auto& shape, const auto& large) {
      const auto found = meeting(PosedMesh{bvh, t.pose}, shape);
      ASSERT_EQ(found, meeting(PosedMesh{bvh, t.weighted}, large)) << m.about();
      met += static_cast<long>(found.size());
    };
    const Point3 p = lattice_point(m, 5), q = lattice_point(m, 5);
    const Vector3 half{std::abs(small(m, 3)), std::abs(small(m, 3)), std::abs(small(m, 3))}, n = lattice_vector(m);
    const double radius = std::abs(small(m, 4)), offset = small(m, 9);
    const Point3 high{p.x + half.x, p.y + half.y, p.z + half.z};
    same(Aabb3{p, high}, Aabb3{times(p, w), times(high, w)});
    same(Obb3{p, {{{1, 0, 0}, {0, 3, 4}, {0, -4, 3}}}, half},
         Obb3{times(p, w), {{{1, 0, 0}, {0, 3, 4}, {0, -4, 3}}}, times(half, w)});
    same(Sphere3{p, radius}, Sphere3{times(p, w), radius * w});
    same(Capsule3{p, q, radius}, Capsule3{times(p, w), times(q, w), radius * w});
    same(Segment3{p, q}, Segment3{times(p, w), times(q, w)});
    same(Halfspace3{n, offset}, Halfspace3{n, offset * w});
    const Vector3 other = lattice_vector(m);
    same(HalfspaceIntersection3{{{n, offset}, {other, 3}}}, HalfspaceIntersection3{{{n, offset * w}, {other, 3 * w}}});
  });
  EXPECT_GT(met, battery::fitting(200));
}

TEST(RigidMesh, MeetsTheTrianglesThatTheWeightedMeshMeets) {
  long met = 0;
  shape_cases::on_shapes(4404, battery::fitting(1500), [&](Material& m) {
    const Bvh a = build_bvh(lattice_mesh(m)), b = build_bvh(lattice_mesh(m));
    const Turned s = turned(m), t = turned(m);
    const PosedMesh large_a{a, larger(s, t.weight)}, large_b{b, larger(t, s.weight)};
    const auto pairs = intersecting_pairs({a, s.pose}, {b, t.pose});
    ASSERT_EQ(pairs, intersecting_pairs(large_a, large_b)) << m.about();
    ASSERT_EQ(any_intersecting_pair({a, s.pose}, {b, t.pose}).has_value(), !pairs.empty()) << m.about();
    ASSERT_EQ(intersecting_pairs({a, s.pose}), intersecting_pairs(a)) << m.about();
    met += static_cast<long>(pairs.size());
    const auto common = intersections({a, s.pose}, {b, t.pose}, pairs);
    const auto large = intersections(large_a, large_b, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ASSERT_EQ(common[i].kind, large[i].kind) << m.about();
      ASSERT_EQ(common[i].vertices.size(), large[i].vertices.size()) << m.about();
    }
  });
  EXPECT_GT(met, battery::fitting(200));
}

TEST(RigidMesh, IsAsNearAsTheWeightedMesh) {
  shape_cases::on_shapes(4405, battery::fitting(150), [&](Material& m) {
    const Bvh a = build_bvh(lattice_mesh(m)), b = build_bvh(lattice_mesh(m));
    const Turned s = turned(m), t = turned(m);
    const Point3 p = lattice_point(m, 9);
    const auto near = closest_on_mesh({a, s.pose}, p), large = closest_on_mesh({a, s.weighted}, times(p, s.weight));
    ASSERT_EQ(near->triangle, large->triangle) << m.about();
    ASSERT_EQ(near->feature, large->feature) << m.about();
    expect_near(large->distance, s.weight, near->distance);
    for (const auto x : {&Point3::x, &Point3::y, &Point3::z}) expect_near(large->point.*x, s.weight, near->point.*x);
    const double reach = std::abs(small(m, 6));
    std::vector<std::uint32_t> within, expected;
    for (const NearTriangle& n : triangles_within({a, s.pose}, p, reach)) within.push_back(n.triangle);
    for (const NearTriangle& n : triangles_within({a, s.weighted}, times(p, s.weight), reach * s.weight))
      expected.push_back(n.triangle);
    ASSERT_EQ(within, expected) << m.about();
    const auto pair = closest_triangles({a, s.pose}, {b, t.pose}, {.first = true});
    const auto large_pair = closest_triangles({a, larger(s, t.weight)}, {b, larger(t, s.weight)}, {.first = true});
    ASSERT_EQ(pair->a, large_pair->a) << m.about();
    ASSERT_EQ(pair->b, large_pair->b) << m.about();
    expect_near(large_pair->closest.distance, s.weight * t.weight, pair->closest.distance);
    const HausdorffDistance far = hausdorff_distance({a, s.pose}, {b, t.pose});
    const HausdorffDistance as_far = hausdorff_distance({a, larger(s, t.weight)}, {b, larger(t, s.weight)});
    EXPECT_LE(far.least * (1 - 1e-14), as_far.most / (s.weight * t.weight)) << m.about();
    EXPECT_LE(as_far.least / (s.weight * t.weight) * (1 - 1e-14), far.most) << m.about();
  });
}

TEST(RigidMesh, MeetsFirstWhatTheWeightedMeshMeetsFirst) {
  long met = 0;
  shape_cases::on_shapes(4406, battery::fitting(100), [&](Material& m) {
    const Bvh a = build_bvh(lattice_mesh(m)), b = build_bvh(lattice_mesh(m));
    const Turned s = turned(m), t = turned(m);
    const Vector3 by = lattice_vector(m, 9);
    const double w = s.weight * t.weight;
    const PosedMesh large_a{a, larger(s, t.weight)}, large_b{b, larger(t, s.weight)};
    const auto contact = first_contact({a, s.pose}, by, {b, t.pose});
    ASSERT_EQ(contact, first_contact(large_a, times(by, w), large_b)) << m.about();
    const auto time = first_contact_time({a, s.pose}, by, {b, t.pose});
    ASSERT_EQ(time.has_value(), contact.has_value());
    ASSERT_TRUE(!time || *time == *first_contact_time(large_a, times(by, w), large_b)) << m.about();
    met += contact ? 1 : 0;
    // Along a's own turn: as its columns map the vector.
    const auto own = first_contact({a, s.pose}, by, {b, t.pose}, MotionAlong::mesh_a);
    const Vector3 way = times(mapped(s.weighted.columns, by), t.weight);
    ASSERT_EQ(own, first_contact(large_a, way, large_b)) << m.about();
  });
  EXPECT_GT(met, battery::fitting(20));
}

TEST(RigidMesh, MeetsItselfInMotionWhereTheWeightedMeshDoes) {
  long met = 0;
  shape_cases::on_shapes(4407, battery::fitting(40), [&](Material& m) {
    const TriangleMesh now = lattice_mesh(m);
    std::vector<Point3> next = now.vertices;
    for (Point3& p : next) p = lattice_point(m);
    const MovingMesh cloth = build_moving_mesh(now.vertices, next, now.triangles);
    const Turned s = turned(m), t = turned(m);
    const auto contacts = contacts_in_motion({cloth, s.pose, t.pose});
    ASSERT_EQ(contacts, contacts_in_motion({cloth, larger(s, t.weight), larger(t, s.weight)})) << m.about();
    ASSERT_EQ(contacts_in_motion({cloth, s.pose, s.pose}), contacts_in_motion(cloth)) << m.about();
    met += static_cast<long>(contacts.size());
  });
  EXPECT_GT(met, battery::reaches_rare ? 20 : 0);
}

// A turn that no matrix of doubles is: as one link of a chain it is another pose to the search, and the same.
TEST(RigidMesh, HasUnderOnePoseWhatItHasWithoutOne) {
  long met = 0;
  shape_cases::on_shapes(4408, battery::fitting(100), [&](Material& m) {
    const Bvh a = build_bvh(lattice_mesh(m)), b = build_bvh(lattice_mesh(m));
    const auto number = [&] { return small(m, 1000) / 7; };
    const RigidPose turn{{number(), number(), number(), 1 + number() * number()}, {number(), number(), number()}};
    const RigidChain chain{{turn}};
    const auto pairs = intersecting_pairs({a, turn}, {b, chain});
    ASSERT_EQ(pairs, intersecting_pairs(a, b)) << m.about();
    const auto near = closest_triangles({a, turn}, {b, chain}, {.first = true}),
               stands = closest_triangles(a, b, {.first = true});
    ASSERT_EQ(near->a, stands->a) << m.about();
    ASSERT_EQ(near->b, stands->b) << m.about();
    ASSERT_EQ(near->closest.distance, stands->closest.distance) << m.about();
    met += static_cast<long>(pairs.size());
  });
  EXPECT_GT(met, battery::fitting(100));
}

TEST(RigidMesh, UnderVolumesOfAnyKindMeetsWhatItMeetsWithoutThem) {
  shape_cases::on_shapes(4409, battery::fitting(40), [&](Material& m) {
    const Bvh a = build_bvh(lattice_mesh(m)), b = build_bvh(lattice_mesh(m));
    const Turned t = turned(m);
    const PosedMesh moved{a, t.pose};
    const auto expected = intersecting_pairs(moved, b);
    const auto same = [&]<class Volume>(const VolumeTree<Volume>& in_a, const VolumeTree<Volume>& in_b) {
      const auto around = posed_volume_tree(moved, in_a);
      ASSERT_EQ(intersecting_pairs(VolumeMesh(moved, around), VolumeMesh(b, in_b)), expected) << m.about();
    };
    same(build_volume_tree<Sphere3>(a), build_volume_tree<Sphere3>(b));
    same(build_volume_tree<Aabb3>(a), build_volume_tree<Aabb3>(b));
    same(build_volume_tree<Obb3>(a), build_volume_tree<Obb3>(b));
    same(build_volume_tree<KDop3>(a, {.k = 14}), build_volume_tree<KDop3>(b, {.k = 14}));
  });
}

TEST(RigidMesh, RefusesWhatIsNoPose) {
  const Bvh unit = build_bvh(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const RigidPose no_turn{{0, 0, 0, 0}, {0, 0, 0}}, nan{{1, 0, 0, 0}, {0, std::nan(""), 0}};
  EXPECT_THROW((void)first_hit({unit, no_turn}, Ray3{{0, 0, 9}, {0, 0, -1}}), InvalidShape);
  EXPECT_THROW((void)intersecting_pairs({unit, RigidChain{{no_turn}}}, unit), InvalidShape);
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)closest_on_mesh({unit, nan}, Point3{0, 0, 0});
            }),
            "closest_on_mesh: mesh.pose.translation.y is nan, not a real number; give a finite double");
  EXPECT_THROW((void)first_contact({unit, RigidPose{}}, {0, 0, 1},
                                   {unit, Pose{{{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 5}}}, MotionAlong::mesh_a),
               InvalidShape);
}

}  // namespace
}  // namespace plumb
