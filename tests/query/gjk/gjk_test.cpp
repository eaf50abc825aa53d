// GJK against the exact sets, the questions that have answers of their own, and itself: with caches of any content and with
// its history.
#include "plumb/query/gjk/gjk.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "certify/sanitized.hpp"
#include "plumb/arith/gmp.hpp"
#include "plumb/query/separation/separation.hpp"
#include "query/convex/nearest_pair.hpp"
#include "query/gjk/any_body.hpp"
#include "query/gjk/body_pair.hpp"
#include "query/overlap/polygon_relation.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb {
namespace {

using namespace drawn_body;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Seen {
  int cases = 0, meet = 0, touch = 0, several = 0, none = 0;
};

GjkCache garbage(Material& m) {
  GjkCache c;
  c.simplex.size = static_cast<std::uint32_t>(m.below(7));
  for (auto& ends : c.simplex.corners) {
    for (auto& i : ends) i = static_cast<std::uint32_t>(m.below(3) == 0 ? m.below(1000) : m.below(8));
  }
  if (m.below(4) != 0) c.direction = m.vector3();
  if (m.below(10) == 0) c.direction.x = std::nan("");
  return c;
}

/// Squares of the history, exactly; each simplex independent, each weight above zero.
void expect_history(const query::Body& a, const query::Body& b, const std::vector<GjkStep>& history,
                    const std::string& about) {
  ASSERT_FALSE(history.empty()) << about;
  std::optional<mpq_class> last;
  for (const GjkStep& step : history) {
    query::DifferenceCorners corners;
    for (std::uint32_t i = 0; i < step.simplex.size; ++i) {
      corners.add(step.simplex.corners[i]);
      EXPECT_GE(step.weight[i], 0) << about;  // exactly above zero: is_within
    }
    CertainSigns ask;
    const auto n = query::nearest_of<BigDyadic>(a.corners, b.corners, corners, ask);
    EXPECT_TRUE(corners.size == 1 || n.is_independent) << about;
    EXPECT_TRUE(query::is_within(n, corners.size, ask)) << about;
    const mpq_class square = big_rational(n.square).value / big_rational(n.square_whole).value;
    EXPECT_TRUE(rationals::overflows(square) || rationals::is_nearest(step.square, square)) << about;
    EXPECT_TRUE(!last || square < *last) << about;
    last = square;
  }
}

/// Both points are in their bodies, but for their rounding; where they are not told to be others, they are the first ones.
void expect_any_pair(const BodyView& a, const BodyView& b, const GjkAnswer& any, const GjkAnswer& first,
                     const std::string& about) {
  EXPECT_EQ(any.meets, first.meets) << about;
  EXPECT_EQ(any.closest.distance, first.closest.distance) << about;
  constexpr Feature interior{FeatureKind::interior, 0};
  if (any.meets) {
    EXPECT_EQ(any.closest.on_a, any.closest.on_b) << about;
    EXPECT_EQ(any.closest.feature_a, interior) << about;
    EXPECT_EQ(any.closest.feature_b, interior) << about;
  }
  const auto expect_in = [&](const Point3& p, const BodyView& body) {
    const double size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    if (std::isfinite(size)) {
      EXPECT_LE(query::gjk_apart_by(query::body_view(p), body, {}), size * 0x1p-52 + 0x1p-1073) << about;
    }
  };
  expect_in(any.closest.on_a, a), expect_in(any.closest.on_b, b);
}

void expect_answer(const AnyBody& first, const AnyBody& second, Material& m, Seen& seen, const std::string& about) {
  const BodyView &va = first.view, &vb = second.view;
  std::optional<std::array<query::Body, 2>> bodies;
  try {
    bodies = query::bodies_of("asked", va, vb);
  } catch (const Error&) {
    ++seen.none;
    EXPECT_THROW((void)query::gjk_answer(va, vb, {}), Error) << about;
    EXPECT_THROW((void)query::gjk_meets(va, vb, {}), Error) << about;
    EXPECT_THROW((void)query::gjk_apart_by(va, vb, {}), Error) << about;
    return;
  }
  const auto& [a, b] = *bodies;
  const auto pair = *query::nearest_pair(core_of(a), core_of(b), query::WhichPair::first);
  const mpq_class radii = a.radius + b.radius;
  const bool meet = pair.square <= radii * radii;
  ++seen.cases, seen.meet += meet, seen.touch += meet && pair.square == radii * radii;

  const GjkAnswer answer = query::gjk_answer(va, vb, {.pair = WhichPair::first});
  EXPECT_EQ(answer.meets, meet) << about;
  EXPECT_GT(answer.steps, 0U) << about;
  EXPECT_EQ(query::gjk_meets(va, vb, {}), meet) << about;
  const double d = query::rounded_distance(pair.square, radii);
  EXPECT_EQ(answer.closest.distance, d) << about;
  EXPECT_EQ(query::gjk_apart_by(va, vb, {}), d) << about;
  EXPECT_EQ(swapped(query::gjk_answer(vb, va, {.pair = WhichPair::first}).closest), answer.closest) << about;
  if (!va.is_hull() && !vb.is_hull() && va.pose.stands() && vb.pose.stands()) {
    EXPECT_EQ(answer.closest, query::closest_points_of(va.figure, vb.figure)) << about;
  }

  GjkCache cache = garbage(m);
  std::vector<GjkStep> history;
  const GjkAnswer watched = query::gjk_answer(va, vb, {.history = &history, .pair = WhichPair::first});
  EXPECT_EQ(watched.closest, answer.closest) << about;
  EXPECT_EQ(watched.steps, history.size()) << about;
  expect_history(a, b, history, about);
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(query::gjk_meets(va, vb, {.cache = &cache}), meet) << about;
  }
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(query::gjk_answer(va, vb, {.cache = &cache, .pair = WhichPair::first}).closest, answer.closest) << about;
    expect_any_pair(va, vb, query::gjk_answer(va, vb, {.cache = &cache}), answer, about);
    EXPECT_EQ(query::gjk_apart_by(va, vb, {.cache = &cache}), d) << about;
  }
  cache = garbage(m);
  history.clear();
  const GjkOptions all_of_them{.cache = &cache, .history = &history, .pair = WhichPair::first};
  EXPECT_EQ(query::gjk_answer(va, vb, all_of_them).closest, answer.closest) << about;
  expect_history(a, b, history, about);
}

TEST(Gjk, IsAsTheExactSetsAre) {
  Seen seen;
  std::uint64_t start = 31'000;
  for (const Make& first : makers()) {
    for (const Make& second : makers()) {
      if (++start % 2 == 0 && battery::sanitized) continue;
      shape_cases::on_shapes(start, battery::sanitized ? 1 : 2, [&](Material& m) {
        const AnyBody a = first(m), b = second(m);
        expect_answer(a, b, m, seen, name_of(a.view) + " and " + name_of(b.view) + " " + m.about());
      });
    }
  }
  std::printf("%d cases, %d meet, %d touch, %d are none\n", seen.cases, seen.meet, seen.touch, seen.none);
  EXPECT_GT(seen.meet * 5, seen.cases);
  EXPECT_GT(seen.touch * 20, seen.cases);
  EXPECT_LT(seen.meet * 5, seen.cases * 4);
}

TEST(Gjk, IsAsTheExactImagesAreUnderPoses) {
  Seen seen;
  std::uint64_t start = 32'000;
  for (const Make& first : makers()) {
    for (const Make& second : makers()) {
      if (start++ % (battery::sanitized ? 8 : 2) != 0) continue;
      shape_cases::on_shapes(start, 1, [&](Material& m) {
        AnyBody a = first(m), b = second(m);
        a = under(a, m.below(2) == 0 ? pair_cases::whole_pose(m) : pair_cases::regular_pose(m));
        if (m.below(2) == 0) b = under(b, *a.pose);
        expect_answer(a, b, m, seen, name_of(a.view) + " and " + name_of(b.view) + " " + m.about());
      });
    }
  }
  std::printf("%d cases, %d meet, %d touch, %d are none\n", seen.cases, seen.meet, seen.touch, seen.none);
  EXPECT_GT(seen.meet * 10, seen.cases);
  EXPECT_GT(seen.cases, battery::sanitized ? 5 : 30);
}

TEST(Gjk, RefusesWhatIsNoBody) {
  const Segment3 s{{0, 0, 0}, {1, 1, 1}};
  const std::vector<Point3> none, with_nan{{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}, {0, 0, 1}, {5, 5, 5}};
  EXPECT_THAT([&] { (void)gjk_intersects(VertexHull3{none}, s); }, ThrowsMessage<InvalidShape>(HasSubstr("is empty")));
  EXPECT_THAT([&] { (void)gjk_intersects(VertexHull3{with_nan}, s); },
              ThrowsMessage<NonFinite>(HasSubstr("gjk_intersects: hull.vertices[2].y")));
  EXPECT_THAT([&] { (void)gjk(s, VertexHull3{with_nan}); },
              ThrowsMessage<NonFinite>(HasSubstr("gjk: hull.vertices[2]")));
  EXPECT_THAT([&] { (void)gjk_distance(Sphere3{{0, 0, 0}, -1}, s); }, ThrowsMessage<InvalidShape>(HasSubstr("radius")));
  EXPECT_THAT(
      [&] {
        (void)gjk_intersects(Sphere3{{0, 0, 0}, -1}, s);
      },
      ThrowsMessage<InvalidShape>(HasSubstr("radius")));
  EXPECT_THROW((void)gjk(Polygon3{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}}}, s), InvalidShape);
}

TEST(Gjk, NamesFeaturesOfHulls) {
  const std::vector<Point3> cube{{1, 1, 1}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0},
                                 {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {2, 2, 2}};
  const VertexHull3 hull{cube};
  const auto feature = [&](const Point3& p) { return gjk(hull, p, {.pair = WhichPair::first}).closest.feature_a; };
  EXPECT_EQ(feature({3, 3, 3}), (Feature{FeatureKind::vertex, 7}));
  EXPECT_EQ(feature({3, 3, 1}), (Feature{FeatureKind::edge, 3}));
  EXPECT_EQ(feature({1, 1, 3}), (Feature{FeatureKind::face, 5}));
  EXPECT_EQ(feature({1, 1, 1}), (Feature{FeatureKind::interior, 0}));
  EXPECT_EQ(feature({0, 1, 0}), (Feature{FeatureKind::edge, 1}));
}

}  // namespace
}  // namespace plumb
