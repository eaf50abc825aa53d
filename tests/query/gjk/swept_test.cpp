// Swept bodies against the exact hulls of their corners before and after, and against bodies that stand.
#include "plumb/query/gjk/swept.hpp"

#include <gmock/gmock.h>

#include "certify/sanitized.hpp"
#include "query/convex/nearest_pair.hpp"
#include "query/gjk/any_body.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb {
namespace {

using namespace drawn_body;
using query::operator+;
using query::operator-;

TEST(SweptBodies, AreTheHullsOfWhereTheyGo) {
  int cases = 0, meet = 0, on_the_way = 0;
  std::uint64_t start = 34'000;
  for (const Make& first : makers()) {
    for (const Make& second : makers()) {
      if (++start % 4 != 0 && battery::sanitized) continue;
      shape_cases::on_shapes(start, 1, [&](Material& m) {
        AnyBody a = first(m);
        const AnyBody b = second(m);
        if (m.below(4) == 0) a = under(a, pair_cases::whole_pose(m));
        const Vector3 by_a = m.vector3(), by_b = m.below(2) == 0 ? m.vector3() : Vector3{0, 0, 0};
        const std::string about = name_of(a.view) + " and " + name_of(b.view) + " " + m.about();
        std::optional<std::array<query::Body, 2>> bodies;
        try {
          bodies = query::bodies_of("asked", a.view, b.view);
        } catch (const Error&) {
          EXPECT_THROW((void)query::moving_meet({a.view, by_a}, {b.view, by_b}), Error) << about;
          return;
        }
        const auto& [p, q] = *bodies;
        FlatSet swept = core_of(p);
        const Exact3 way = Exact3{by_a.x, by_a.y, by_a.z} - Exact3{by_b.x, by_b.y, by_b.z};
        for (std::size_t i = 0, n = swept.points.size(); i < n; ++i) swept.points.push_back(swept.points[i] + way);
        const mpq_class radii = p.radius + q.radius,
                        square = query::nearest_pair(swept, core_of(q), query::WhichPair::any)->square;
        const bool do_meet = square <= radii * radii;
        EXPECT_EQ(query::moving_meet({a.view, by_a}, {b.view, by_b}), do_meet) << about;
        EXPECT_EQ(query::moving_meet({b.view, by_b}, {a.view, by_a}), do_meet) << about;
        EXPECT_EQ(query::moving_apart_by({a.view, by_a}, {b.view, by_b}), query::rounded_distance(square, radii))
            << about;
        const bool stand = query::gjk_meets(a.view, b.view, {});
        EXPECT_EQ(query::moving_meet({a.view, by_a}, {b.view, by_a}), stand) << about;
        ++cases, meet += do_meet, on_the_way += do_meet && !stand;
      });
    }
  }
  std::printf("%d cases, %d meet, %d on the way\n", cases, meet, on_the_way);
  EXPECT_GT(meet * 5, cases);
  EXPECT_GT(on_the_way, battery::sanitized ? 0 : 8);
}

TEST(SweptBodies, NameTheWayThatIsNone) {
  const Segment3 s{{0, 0, 0}, {1, 1, 1}};
  EXPECT_THAT(
      [&] {
        (void)gjk_intersects_moving(s, {0, NAN, 0}, s);
      },
      testing::ThrowsMessage<NonFinite>(testing::HasSubstr("gjk_intersects_moving: by_a.y")));
  EXPECT_TRUE(gjk_intersects_moving(Sphere3{{0, 0, 0}, 1}, {10, 0, 0}, Point3{5, 1, 0}));
  EXPECT_FALSE(gjk_intersects_moving(Sphere3{{0, 0, 0}, 1}, {10, 0, 0}, Point3{5, 0x1.0000000000001p0, 0}));
  EXPECT_EQ(gjk_distance_moving(Point3{0, 0, 0}, {10, 0, 0}, Point3{5, 2, 0}), 2);
}

}  // namespace
}  // namespace plumb
