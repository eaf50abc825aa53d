// Balls, capsules and lozenges against what is flat and convex, and one another: against brute force over rationals.
#include "plumb/query/overlap_round.hpp"

#include <gtest/gtest.h>

#include "plumb/figure/hull3.hpp"
#include "plumb/query/overlap.hpp"
#include "query/round_oracle.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using shape_cases::on_shapes;

template <class Flat>
Flat flat_shape(Material& m) {
  if constexpr (std::is_same_v<Flat, ConvexPolyhedron3>) {
    std::array<Point3, 6> points{m.point3(), m.point3(), m.point3(), m.point3(), m.point3(), m.point3()};
    if (convex_hull(points).dimension < 3)
      points = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    return convex_polyhedron(convex_hull(points), points);
  } else if constexpr (std::is_same_v<Flat, KDop3>) {
    const std::array<int, 3> kinds{6, 8, 14};
    const std::array<Point3, 3> points{m.point3(), m.point3(), m.point3()};
    KDop3 k_dop = fit_k_dop(points, kinds[m.below(3)]);
    if (m.below(3) == 0) k_dop.max[m.below(k_dop.max.size())] = m.number();
    return k_dop;
  } else {
    return near_drawn<Flat>(m);
  }
}

/// On random shapes, and with the radius that makes them touch, where a double is it.
template <class Flat, class Round>
void expect_as_brute_force(std::uint64_t start, std::uint64_t cases) {
  Counts counts;
  int just_touching = 0;
  on_shapes(start, cases, [&](Material& m) {
    const Flat flat = flat_shape<Flat>(m);
    Round round = m.shape<Round>();
    const oracle::Spanned core = oracle::core(round), other = oracle::spanned(flat);
    const auto square = oracle::squared_distance(core, other);
    if (square && m.below(3) != 0) {
      if (const auto root = oracle::exact_root(*square)) round.radius = *root;
    }
    const Relation expected =
        round.radius == 0 ? oracle::relation(core, other) : oracle::relation_of_gap(square, mpq_class(round.radius));
    counts.add(expected);
    if (round.radius > 0 && expected == Relation::touching) ++just_touching;
    const std::string about = m.about(flat, round);
    ASSERT_EQ(relate(flat, round), expected) << about;
    ASSERT_EQ(relate(round, flat), expected) << about;
    ASSERT_EQ(intersects(round, flat), expected != Relation::disjoint) << about;
  });
  std::printf("disjoint %d, touching %d (%d round), overlapping %d\n", counts.of[0], counts.of[1], just_touching,
              counts.of[2]);
  expect_all_answers(counts, cases * shape_cases::more);
}

TEST(OverlapRound, LineSphere) { expect_as_brute_force<Line3, Sphere3>(500, 600); }
TEST(OverlapRound, RaySphere) { expect_as_brute_force<Ray3, Sphere3>(501, 600); }
TEST(OverlapRound, SegmentSphere) { expect_as_brute_force<Segment3, Sphere3>(502, 600); }
TEST(OverlapRound, PlaneSphere) { expect_as_brute_force<Plane3, Sphere3>(503, 300); }
TEST(OverlapRound, ThreePointPlaneSphere) { expect_as_brute_force<ThreePointPlane3, Sphere3>(504, 300); }
TEST(OverlapRound, HalfspaceSphere) { expect_as_brute_force<Halfspace3, Sphere3>(505, 300); }
TEST(OverlapRound, TriangleSphere) { expect_as_brute_force<Triangle3, Sphere3>(506, 800); }
TEST(OverlapRound, RectangleSphere) { expect_as_brute_force<Rectangle3, Sphere3>(507, 300); }
TEST(OverlapRound, TetrahedronSphere) { expect_as_brute_force<Tetrahedron3, Sphere3>(508, 400); }
TEST(OverlapRound, AabbSphere) { expect_as_brute_force<Aabb3, Sphere3>(509, 600); }
TEST(OverlapRound, ObbSphere) { expect_as_brute_force<Obb3, Sphere3>(510, 300); }
TEST(OverlapRound, KDopSphere) { expect_as_brute_force<KDop3, Sphere3>(511, 100); }
TEST(OverlapRound, PolyhedronSphere) { expect_as_brute_force<ConvexPolyhedron3, Sphere3>(512, 200); }

TEST(OverlapRound, LineCapsule) { expect_as_brute_force<Line3, Capsule3>(520, 400); }
TEST(OverlapRound, RayCapsule) { expect_as_brute_force<Ray3, Capsule3>(521, 400); }
TEST(OverlapRound, SegmentCapsule) { expect_as_brute_force<Segment3, Capsule3>(522, 400); }
TEST(OverlapRound, PlaneCapsule) { expect_as_brute_force<Plane3, Capsule3>(523, 200); }
TEST(OverlapRound, ThreePointPlaneCapsule) { expect_as_brute_force<ThreePointPlane3, Capsule3>(524, 200); }
TEST(OverlapRound, HalfspaceCapsule) { expect_as_brute_force<Halfspace3, Capsule3>(525, 200); }
TEST(OverlapRound, TriangleCapsule) { expect_as_brute_force<Triangle3, Capsule3>(526, 400); }
TEST(OverlapRound, RectangleCapsule) { expect_as_brute_force<Rectangle3, Capsule3>(527, 150); }
TEST(OverlapRound, TetrahedronCapsule) { expect_as_brute_force<Tetrahedron3, Capsule3>(528, 150); }
TEST(OverlapRound, AabbCapsule) { expect_as_brute_force<Aabb3, Capsule3>(529, 150); }
TEST(OverlapRound, ObbCapsule) { expect_as_brute_force<Obb3, Capsule3>(530, 100); }
TEST(OverlapRound, KDopCapsule) { expect_as_brute_force<KDop3, Capsule3>(531, 60); }
TEST(OverlapRound, PolyhedronCapsule) { expect_as_brute_force<ConvexPolyhedron3, Capsule3>(532, 80); }

}  // namespace
}  // namespace plumb
