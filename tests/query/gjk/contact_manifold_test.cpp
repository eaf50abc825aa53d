// Contact manifolds against the exact common part of both bodies, moved together, and of boxes by hand.
#include "plumb/query/gjk/contact_manifold.hpp"

#include <gmock/gmock.h>

#include "certify/sanitized.hpp"
#include "plumb/arith/gmp.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "query/convex/nearest_pair.hpp"
#include "query/gjk/any_body.hpp"
#include "query/section/exact_section.hpp"

namespace plumb {
namespace {

using namespace drawn_body;
using query::operator+;
using query::operator-;

Exact3 exact(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  return {mpq(r.x), mpq(r.y), mpq(r.z)};
}

struct Seen {
  std::array<int, 7> apart{}, touching{};
  int solid = 0;
};

void expect_manifold(const BodyView& va, const BodyView& vb, Seen& seen, const std::string& about) {
  std::optional<std::array<query::Body, 2>> bodies;
  try {
    bodies = query::bodies_of("asked", va, vb);
  } catch (const Error&) {
    EXPECT_THROW((void)query::manifold_of(va, vb), Error) << about;
    return;
  }
  const FlatSet a = core_of((*bodies)[0]), b = core_of((*bodies)[1]);
  const auto pair = *query::nearest_pair(a, b, query::WhichPair::first);
  const Exact3 way = pair.on_b - pair.on_a;
  FlatSet moved = b;
  for (Exact3& p : moved.points) p = p - way;
  const Intersection3 wanted = query::common_part3(a, moved);
  const ContactManifold m = query::manifold_of(va, vb);
  EXPECT_EQ(m.meets, sgn(pair.square) == 0) << about;
  EXPECT_EQ(m.on_a.kind, m.on_b.kind) << about;
  if (m.on_a.kind == IntersectionKind::solid) {
    ++seen.solid;
    EXPECT_EQ(wanted.kind, IntersectionKind::solid) << about;
    EXPECT_TRUE(m.on_a.vertices.empty()) << about;
    return;
  }
  (m.meets ? seen.touching : seen.apart)[static_cast<std::size_t>(m.on_a.kind)] += 1;
  EXPECT_TRUE(m.on_a == wanted) << about;
  ASSERT_EQ(m.on_a.vertices.size(), m.on_b.vertices.size()) << about;
  for (std::size_t i = 0; i < m.on_a.vertices.size(); ++i) {
    EXPECT_EQ(exact(m.on_b.vertices[i]) - exact(m.on_a.vertices[i]), way) << about;
  }
  const ContactManifold other = query::manifold_of(vb, va);
  EXPECT_TRUE(other.on_a == m.on_b && other.on_b == m.on_a) << about;
}

TEST(ContactManifold, IsWhatTheMovedSetsHaveInCommon) {
  Seen seen;
  std::uint64_t start = 33'000;
  for (const Make& first : makers()) {
    for (const Make& second : makers()) {
      if (++start % 4 != 0 && battery::sanitized) continue;
      shape_cases::on_shapes(start, 1, [&](Material& m) {
        const AnyBody a = first(m), b = second(m);
        if (query::is_one_of(a.view.figure.kind, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge})) return;
        if (query::is_one_of(b.view.figure.kind, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge})) return;
        expect_manifold(a.view, b.view, seen, name_of(a.view) + " and " + name_of(b.view) + " " + m.about());
      });
    }
  }
  const auto of = [](const std::array<int, 7>& all, IntersectionKind k) { return all[static_cast<std::size_t>(k)]; };
  for (const auto* all : {&seen.apart, &seen.touching}) {
    std::printf("%d points, %d segments, %d polygons\n", of(*all, IntersectionKind::point),
                of(*all, IntersectionKind::segment), of(*all, IntersectionKind::polygon));
  }
  std::printf("%d solids\n", seen.solid);
  if (battery::sanitized) return;
  EXPECT_GT(of(seen.touching, IntersectionKind::point), 10);
  EXPECT_GT(of(seen.touching, IntersectionKind::segment), 3);
  EXPECT_GT(of(seen.apart, IntersectionKind::point), 10);
}

TEST(ContactManifold, OfBoxesOfAGridIsAsFarAway) {
  Seen seen;
  shape_cases::on_shapes(33'900, battery::sanitized ? 10 : 60, [&](Material& m) {
    const auto box = [&] {
      const auto at = [&] { return static_cast<double>(m.below(4)); };
      const Point3 low{at(), at(), at()};
      return Aabb3{low, {low.x + at(), low.y + at(), low.z + at()}};
    };
    AnyBody a = any(box()), b = any(box());
    if (m.below(3) == 0) a = under(a, pair_cases::whole_pose(m)), b = under(b, *a.pose);
    expect_manifold(a.view, b.view, seen, m.about());
  });
  EXPECT_GT(seen.apart[static_cast<std::size_t>(IntersectionKind::segment)], battery::sanitized ? 0 : 3);
  EXPECT_GT(seen.apart[static_cast<std::size_t>(IntersectionKind::polygon)], battery::sanitized ? 0 : 3);
}

std::vector<Point3> corners(const Intersection3& i) { return approximate(i); }

TEST(ContactManifold, OfBoxesIsAFaceAnEdgeOrACorner) {
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}};
  const auto face = contact_manifold(box, Aabb3{{1, -1, 2}, {5, 1, 3}});
  EXPECT_EQ(face.on_a.kind, IntersectionKind::polygon);
  EXPECT_THAT(corners(face.on_a),
              testing::UnorderedElementsAre(Point3{1, 0, 2}, Point3{2, 0, 2}, Point3{2, 1, 2}, Point3{1, 1, 2}));
  EXPECT_TRUE(face.meets);
  const auto apart = contact_manifold(box, Aabb3{{1, -1, 5}, {5, 1, 6}});
  EXPECT_EQ(corners(apart.on_a), corners(face.on_a));
  EXPECT_EQ(apart.on_b.vertices.size(), 4U);
  EXPECT_EQ(apart.distance, 3);
  EXPECT_EQ(contact_manifold(box, Aabb3{{2, 2, 1}, {5, 4, 6}}).on_a.kind, IntersectionKind::segment);
  EXPECT_EQ(contact_manifold(box, Aabb3{{2, 2, 2}, {5, 4, 6}}).on_a.kind, IntersectionKind::point);
  EXPECT_EQ(contact_manifold(box, Aabb3{{1, 1, 1}, {5, 4, 6}}).on_a.kind, IntersectionKind::solid);
  // An edge on a face, and two edges that cross.
  const Pose turned{{{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}}, {1, 1, 0}};
  const Tetrahedron3 wedge{{0, 0, 2}, {1, 1, 2}, {0, 1, 3}, {1, 0, 3}};
  EXPECT_EQ(contact_manifold(box, wedge).on_a.kind, IntersectionKind::segment);
  EXPECT_EQ(contact_manifold(Posed{box, turned}, Tetrahedron3{{0, 0, 4}, {1, 1, 4}, {0, 1, 5}, {1, 0, 5}}).distance, 2);
}

}  // namespace
}  // namespace plumb
