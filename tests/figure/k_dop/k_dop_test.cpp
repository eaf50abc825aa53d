// k-DOPs: tight fits, exact relations against an elimination of variables, moves and measures.
#include "plumb/figure/k_dop/k_dop.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "figure/sphere/bound_oracle.hpp"

namespace plumb {
namespace {

using namespace bound_oracle;
using bound_oracle::Rational;  // there is also plumb::Rational
using shape_cases::Material;
using shape_cases::on_shapes;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::vector<Rational> numbers(const Vector2& v) { return {Rational(v.x), Rational(v.y)}; }
std::vector<Rational> numbers(const Vector3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

template <class Vector>
std::vector<Half> halves(const KDop<Vector>& k_dop) {
  std::vector<Half> all;
  for (std::size_t i = 0; i < k_dop.min.size(); ++i) {
    std::vector<Rational> normal = numbers(k_dop.directions.all()[i]);
    all.push_back({normal, Rational(k_dop.max[i]), false});
    for (Rational& x : normal) x = -x;
    all.push_back({normal, Rational(-k_dop.min[i]), false});
  }
  return all;
}

// A halfspace that no point of the set meets with slack is part of its affine hull; the others are open in the
// relative interior.
std::vector<Half> relative_interior(const std::vector<Half>& set, std::size_t dimension) {
  std::vector<Half> open = set;
  for (std::size_t i = 0; i < set.size(); ++i) {
    std::vector<Half> one = set;
    one[i].open = true;
    open[i].open = have_point(one, dimension);
  }
  return open;
}

template <class Vector>
Relation expected_relation(const KDop<Vector>& a, const KDop<Vector>& b) {
  const std::size_t dimension = sizeof(Vector) / sizeof(double);
  std::vector<Half> both = halves(a), of_b = halves(b);
  both.insert(both.end(), of_b.begin(), of_b.end());
  if (!have_point(both, dimension)) return Relation::disjoint;
  both = relative_interior(halves(a), dimension);
  of_b = relative_interior(of_b, dimension);
  both.insert(both.end(), of_b.begin(), of_b.end());
  return have_point(both, dimension) ? Relation::overlapping : Relation::touching;
}

template <class Vector>
KDop<Vector> any_k_dop(Material& m, const Directions<Vector>& directions) {
  KDop<Vector> k_dop{directions, {}, {}};
  const bool ordered = m.below(8) != 0, flat = m.below(6) == 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double a = m.number(), b = flat && m.below(2) == 0 ? a : m.number();
    k_dop.min.push_back(ordered ? std::min(a, b) : a);
    k_dop.max.push_back(ordered ? std::max(a, b) : b);
  }
  return k_dop;
}

std::vector<Point3> any_points(Material& m, std::size_t most) {
  std::vector<Point3> points;
  for (std::size_t i = m.below(most) + 1; i-- > 0;) points.push_back(m.point3());
  return points;
}

Directions2 any_directions2(Material& m) {
  if (m.below(2) == 0) return k_dop_directions2(m.below(2) == 0 ? 4 : 8);
  std::vector<Vector2> own;
  for (std::size_t i = m.below(4) + 1; i-- > 0;) {
    const auto number = [&] { return static_cast<double>(m.below(7)) - 3; };
    own.push_back({number(), number()});
    if (own.back() == Vector2{0, 0}) own.back() = {1, 2};
  }
  return Directions2(own);
}

TEST(KDop, RelationsInThePlaneAreExact) {
  std::map<Relation, int> count;
  int conservative = 0;
  on_shapes(501, 2500, [&](Material& m) {
    const Directions2 directions = any_directions2(m);
    const KDop2 a = any_k_dop(m, directions), b = any_k_dop(m, directions);
    const Relation expected = expected_relation(a, b);
    ++count[expected];
    ASSERT_EQ(relate(a, b), expected) << m.about();
    ASSERT_EQ(relate(b, a), expected) << m.about();
    ASSERT_EQ(intersects(a, b), expected != Relation::disjoint) << m.about();
    ASSERT_EQ(is_empty(a), !have_point(halves(a), 2)) << m.about();
    conservative += intervals_overlap(a, b) && expected == Relation::disjoint;
    if (!intervals_overlap(a, b)) {
      ASSERT_EQ(expected, Relation::disjoint) << m.about();
    }
  });
  EXPECT_GT(count[Relation::disjoint], 500);
  EXPECT_GT(count[Relation::touching], 100);
  EXPECT_GT(count[Relation::overlapping], 300);
  EXPECT_GT(conservative, 50);
}

TEST(KDop, RelationsInSpaceAreExact) {
  std::map<Relation, int> count;
  on_shapes(502, 160, [&](Material& m) {
    const Directions3 directions = k_dop_directions(m.below(2) == 0 ? 8 : 14);
    const auto made = [&]() -> KDop3 {
      if (m.below(3) == 0) return any_k_dop(m, directions);
      const std::vector<Point3> points = any_points(m, 4);
      try {
        return fit_k_dop(points, directions);
      } catch (const BeyondDoubles&) {  // near the largest doubles sums of coordinates are none
        return any_k_dop(m, directions);
      }
    };
    const KDop3 a = made(), b = made();
    const Relation expected = expected_relation(a, b);
    ++count[expected];
    ASSERT_EQ(relate(a, b), expected) << m.about();
    ASSERT_EQ(relate(b, a), expected) << m.about();
    ASSERT_EQ(intersects(a, b), expected != Relation::disjoint) << m.about();
  });
  EXPECT_GT(count[Relation::disjoint], 20);
  EXPECT_GT(count[Relation::touching], 5);
  EXPECT_GT(count[Relation::overlapping], 20);
}

// Intervals overlap in all directions, but one's corner is in the other's slanted side, or beyond it.
TEST(KDop, OverlappingIntervalsMayBeDisjoint) {
  const Directions2 d({{1, 0}, {0, 1}, {1, 2}});
  const KDop2 a{d, {0, 0, 0}, {4, 4, 3}}, b{d, {1, 1, 2}, {4, 4, 12}};
  EXPECT_TRUE(intervals_overlap(a, b));
  EXPECT_EQ(relate(a, b), Relation::touching);
  const KDop2 c{d, {1, 1 + 0x1p-50, 2}, {4, 4, 12}};
  EXPECT_TRUE(intervals_overlap(a, c));
  EXPECT_EQ(relate(a, c), Relation::disjoint);
}

// RTCD figure 4.13: the 8-DOP of a triangle.
TEST(KDop, OfATriangle) {
  const std::array triangle{Point2{3, 1}, Point2{5, 4}, Point2{1, 5}};
  const KDop2 k_dop = fit_k_dop(triangle, k_dop_directions2(8));
  EXPECT_THAT(k_dop.min, ElementsAre(1, 1, 4, -4));
  EXPECT_THAT(k_dop.max, ElementsAre(5, 5, 9, 2));
  EXPECT_EQ(area(k_dop), 16 - 2 - 0.5 - 2);
  EXPECT_EQ(locate(k_dop, Point2{3, 1}), Location::boundary);
  EXPECT_EQ(locate(k_dop, Point2{3, 3}), Location::inside);
  EXPECT_EQ(locate(k_dop, Point2{1, 1}), Location::outside);
}

TEST(KDop, FitsAreTightAndHoldTheirPoints) {
  on_shapes(503, 500, [](Material& m) {
    const std::array ks{6, 8, 14, 18, 26};
    const int k = ks[m.below(5)];
    const Directions3 directions = k_dop_directions(k);
    ASSERT_EQ(2 * directions.size(), static_cast<std::size_t>(k));
    const std::vector<Point3> points = any_points(m, 10);
    KDop3 k_dop{directions, {}, {}};
    try {
      k_dop = fit_k_dop(points, k);
    } catch (const BeyondDoubles&) {
      return;
    }
    for (const Point3& p : points) ASSERT_TRUE(contains(k_dop, p)) << m.about(p);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Rational3 d = rational(directions.all()[i]);
      Range r{dot(d, rational(points[0])), dot(d, rational(points[0]))};
      for (const Point3& p : points) r.add(dot(d, rational(p)));
      ASSERT_TRUE(is_rounded_down(k_dop.min[i], r.min) && is_rounded_up(k_dop.max[i], r.max)) << m.about() << " " << i;
    }
    const Pose pose{{m.direction3(), m.direction3(), m.direction3()}, m.vector3()};
    KDop3 moved{directions, {}, {}};
    try {
      moved = fit_k_dop(points, directions, pose);
    } catch (const BeyondDoubles&) {
      return;
    }
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Rational3 d = rational(directions.all()[i]);
      const Rational first = dot(d, image(rational(points[0]), pose));
      Range r{first, first};
      for (const Point3& p : points) r.add(dot(d, image(rational(p), pose)));
      ASSERT_TRUE(is_rounded_down(moved.min[i], r.min) && is_rounded_up(moved.max[i], r.max)) << m.about(pose) << i;
    }
  });
}

TEST(KDop, MergedAndMovedOnesHoldWhatTheyAreMadeOf) {
  int moved_ones = 0;
  on_shapes(504, 60, [&](Material& m) {
    const Directions3 directions = k_dop_directions(m.below(2) == 0 ? 14 : 26);
    const std::vector<Point3> p = any_points(m, 5), q = any_points(m, 5);
    const Pose pose{{m.direction3(), m.direction3(), m.direction3()}, m.vector3()};
    try {
      const KDop3 a = fit_k_dop(p, directions), b = fit_k_dop(q, directions), both = merge(a, b);
      ASSERT_EQ(both, merge(b, a));
      ASSERT_TRUE(contains(both, a) && contains(both, b)) << m.about();
      const KDop3 tight = tighten(a);
      for (std::size_t i = 0; i < a.min.size(); ++i)
        ASSERT_TRUE(tight.min[i] == a.min[i] && tight.max[i] == a.max[i]) << m.about() << " direction " << i;
      const KDop3 moved = transform(a, pose);
      const KDop3 least = fit_k_dop(p, directions, pose);
      for (std::size_t i = 0; i < a.min.size(); ++i)
        ASSERT_TRUE(moved.min[i] <= least.min[i] && least.max[i] <= moved.max[i]) << m.about() << " direction " << i;
      ++moved_ones;
    } catch (const BeyondDoubles&) {
    }
  });
  EXPECT_GT(moved_ones, 40);
}

// Slack planes close up; a set that is empty, though no interval is, is found to be.
TEST(KDop, TightenedAndEmpty) {
  const Directions2 d = k_dop_directions2(8);
  const KDop2 slack{d, {0, 0, 1, -10}, {4, 4, 100, 10}};
  const KDop2 tight = tighten(slack);
  EXPECT_THAT(tight.min, ElementsAre(0, 0, 1, -4));
  EXPECT_THAT(tight.max, ElementsAre(4, 4, 8, 4));
  const KDop2 empty{d, {0, 0, 9, -1}, {4, 4, 10, 1}};
  EXPECT_TRUE(is_empty(empty));
  EXPECT_THAT(tighten(empty).min, ElementsAre(1, 1, 1, 1));
  EXPECT_EQ(area(empty), 0);
  EXPECT_EQ(relate(empty, empty), Relation::disjoint);
  EXPECT_TRUE(contains(slack, empty));
  EXPECT_FALSE(contains(empty, slack));
  EXPECT_TRUE(contains(slack, tight) && contains(tight, slack));
}

TEST(KDop, VolumesAndSurfaces) {
  std::vector<Point3> cube;
  for (const double x : {0.0, 2.0}) {
    for (const double y : {0.0, 2.0}) {
      for (const double z : {0.0, 2.0}) cube.push_back({x, y, z});
    }
  }
  for (const int k : {6, 14, 18, 26}) {
    EXPECT_EQ(volume(fit_k_dop(cube, k)), 8) << k;
    EXPECT_EQ(surface_area(fit_k_dop(cube, k)), 24) << k;
  }
  const std::array octahedron{Point3{1, 0, 0},  Point3{-1, 0, 0}, Point3{0, 1, 0},
                              Point3{0, -1, 0}, Point3{0, 0, 1},  Point3{0, 0, -1}};
  EXPECT_EQ(volume(fit_k_dop(octahedron, 8)), 4 / 3.0);
  EXPECT_EQ(volume(fit_k_dop(octahedron, 26)), 4 / 3.0);
  EXPECT_DOUBLE_EQ(surface_area(fit_k_dop(octahedron, 14)), 4 * std::sqrt(3.0));
  const std::array flat{Point3{0, 0, 1}, Point3{2, 0, 1}, Point3{2, 3, 1}, Point3{0, 3, 1}};
  EXPECT_EQ(volume(fit_k_dop(flat, 26)), 0);
  EXPECT_EQ(surface_area(fit_k_dop(flat, 26)), 12);
  const KDop3 twice{Directions3({{1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}}), {0, 0, 0, 0}, {1, 2, 1, 1}};
  EXPECT_EQ(fit_aabb(twice), (Aabb3{{0, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(fit_aabb(fit_k_dop(octahedron, 8)), (Aabb3{{-1, -1, -1}, {1, 1, 1}}));
  EXPECT_EQ(volume(twice), 1);
  EXPECT_EQ(surface_area(twice), 6);
}

TEST(KDop, BadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Directions2 d = k_dop_directions2(8);
  const KDop2 good{d, {0, 0, 0, 0}, {1, 1, 1, 1}};
  KDop2 bad = good;
  bad.max[2] = nan;
  const auto shape = [](const char* text) { return ThrowsMessage<InvalidShape>(HasSubstr(text)); };
  const auto number = [](const char* text) { return ThrowsMessage<NonFinite>(HasSubstr(text)); };
  EXPECT_THAT([&] { static_cast<void>(intervals_overlap(good, bad)); }, number("intervals_overlap: b.max[2] is nan"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(relate(bad, KDop2{d, {9, 9, 9, 9}, {9, 9, 9, 9}}));
      },
      number("relate: a.max[2] is nan"));
  EXPECT_THAT([&] { static_cast<void>(contains(good, Point2{nan, 0})); }, number("contains: p.x is nan"));
  bad.max.pop_back();
  EXPECT_THAT([&] { static_cast<void>(relate(bad, good)); },
              shape("relate: a has 4 entries in min and 3 in max for 4 directions"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(relate(good, KDop2{k_dop_directions2(4), {0, 0}, {1, 1}}));
      },
      shape("relate: a and b have different directions"));
  EXPECT_THAT([] { static_cast<void>(fit_k_dop(std::span<const Point3>(), 14)); }, shape("no points"));
  EXPECT_THAT([] { static_cast<void>(k_dop_directions(10)); }, shape("k is 10; give 6, 8, 14, 18 or 26"));
  EXPECT_THAT([] { static_cast<void>(Directions2({{1, 0}, {0, -0.0}})); }, shape("directions[1] is zero"));
  const KDop3 prism{Directions3({{1, 0, 0}, {0, 1, 0}}), {0, 0}, {1, 1}};
  EXPECT_THAT([&] { static_cast<void>(volume(prism)); }, shape("volume: the k-DOP is unbounded"));
  EXPECT_EQ(relate(prism, prism), Relation::overlapping);
}

TEST(KDop, SurfaceAreaWithDirectionsOfAnyLength) {
  for (const double t : {1.0, 0x1p-500, 0x1p300}) {
    const Directions3 directions({{t, 0, 0}, {0, t, 0}, {0, 0, t}, {t, t, 0}});
    EXPECT_EQ(surface_area(KDop3{directions, {-t, -t, -t, -t}, {t, t, t, t}}), 19.656854249492380) << t;
  }
}

}  // namespace
}  // namespace plumb
