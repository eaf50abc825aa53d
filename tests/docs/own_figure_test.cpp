// Is the worked example of docs/add_a_figure.md true?  Places and boxes against rationals, and what it says of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "docs/cushion.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::docs {
namespace {

using Exact = std::array<Rational, 3>;
Exact exact(const Point3& p) { return {p.x, p.y, p.z}; }
Exact from(const Exact& a, const Exact& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
Rational inner(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Of p from the segment.
Rational squared_distance(const Exact& a, const Exact& b, const Exact& p) {
  const Exact u = from(a, b), w = from(a, p);
  const Rational whole = inner(u, u);
  Rational t = whole.sign() == Sign::zero ? Rational(0.0) : inner(w, u) / whole;
  t = std::clamp(t, Rational(0.0), Rational(1.0));
  const Exact off{w[0] - t * u[0], w[1] - t * u[1], w[2] - t * u[2]};
  return inner(off, off);
}
/// From the triangle: of its edges, and of the foot where that is within.
Rational squared_distance(const Triangle3& t, const Point3& point) {
  const Exact a = exact(t.a), b = exact(t.b), c = exact(t.c), p = exact(point);
  Rational least = std::min({squared_distance(a, b, p), squared_distance(b, c, p), squared_distance(c, a, p)});
  const Exact u = from(a, b), v = from(a, c), w = from(a, p);
  const Rational uu = inner(u, u), uv = inner(u, v), vv = inner(v, v), whole = uu * vv - uv * uv;
  if (whole.sign() == Sign::zero) return least;
  const Rational s = (inner(w, u) * vv - inner(w, v) * uv) / whole, r = (inner(w, v) * uu - inner(w, u) * uv) / whole;
  if (s.sign() == Sign::negative || r.sign() == Sign::negative || s + r > Rational(1.0)) return least;
  const Exact off{w[0] - s * u[0] - r * v[0], w[1] - s * u[1] - r * v[1], w[2] - s * u[2] - r * v[2]};
  return std::min(least, inner(off, off));
}

TEST(OwnFigure, PlacesAndBoxesAreThoseOfRationals) {
  std::array<int, 3> seen{};
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Entropy e(22, i);
    const auto number = [&e] { return static_cast<double>(e.within(4)); };
    const auto point = [&number] { return Point3{number(), number(), number()}; };
    const mine::Cushion cushion{{point(), point(), point()}, static_cast<double>(e.below(4))};
    Point3 p = point();
    if (e.below(3) == 0) p = {cushion.core.b.x, cushion.core.b.y, cushion.core.b.z + cushion.radius};
    const Rational reach = Rational(cushion.radius) * Rational(cushion.radius);
    const Sign beyond = (squared_distance(cushion.core, p) - reach).sign();
    const auto expected = static_cast<Location>(-static_cast<int>(beyond));
    ASSERT_EQ(locate(cushion, p), expected) << "replay: " << i;
    ASSERT_EQ(contains(cushion, p), expected != Location::outside) << "replay: " << i;
    ++seen[static_cast<std::size_t>(static_cast<int>(expected) + 1)];

    const Triangle3& t = cushion.core;
    const double r = cushion.radius;
    const Aabb3 core = fit_aabb(t);
    ASSERT_EQ(fit_aabb(cushion), (Aabb3{{core.min.x - r, core.min.y - r, core.min.z - r},
                                        {core.max.x + r, core.max.y + r, core.max.z + r}}))
        << "replay: " << i;
  }
  for (const int n : seen) EXPECT_GT(n, 30);
}

// As Fat says it of the triangle, and as the ball or the capsule that it may be.
TEST(OwnFigure, IsAskedWithEveryFigure) {
  std::array<int, 3> seen{};
  int with_kind = 0, timed = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    Entropy e(23, i);
    const auto number = [&e] { return static_cast<double>(e.within(4)); };
    const auto point = [&number] { return Point3{number(), number(), number()}; };
    mine::Cushion cushion{{point(), point(), point()}, static_cast<double>(e.below(4))};
    if (e.below(4) == 0) cushion.core.c = cushion.core.b;
    const Fat fat{cushion.core, cushion.radius};
    const Point3 p = point(), q = point(), r = point();
    const Vector3 by{number(), number(), 9};
    const auto expect = [&](const auto& other) {
      const Relation expected = relate(fat, other);
      ++seen[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
      EXPECT_EQ(relate(cushion, other), expected) << "replay: " << i;
      EXPECT_EQ(relate(other, cushion), expected) << "replay: " << i;
      EXPECT_EQ(relate(cushion, AnyFigure(other)), expected) << "replay: " << i;
      EXPECT_EQ(intersects(other, cushion), expected != Relation::disjoint) << "replay: " << i;
      ExactDistance d = exact_distance(cushion.core, other);
      d.inset = d.inset + Rational(cushion.radius);
      EXPECT_EQ(compare(exact_distance(cushion, other), d), Sign::zero) << "replay: " << i;
      EXPECT_EQ(distance(cushion, other) > 0, expected == Relation::disjoint) << "replay: " << i;
      EXPECT_EQ(compare_distance(cushion, other, other, cushion), Sign::zero) << "replay: " << i;
    };
    expect(p), expect(Segment3{p, q}), expect(Triangle3{p, q, r}), expect(Sphere3{p, 1}), expect(Capsule3{p, q, 1});
    expect(Halfspace3{by, q.x}), expect(Line3{p, by}), expect(Obb3{p, {by, {1, 0, 0}, {0, 1, 0}}, {0.25, 1, 1}});
    const auto as_body = [&](const auto& other) {
      EXPECT_EQ(gjk_intersects(cushion, other), intersects(cushion, other)) << "replay: " << i;
      EXPECT_EQ(gjk_distance(cushion, other), distance(cushion, other)) << "replay: " << i;
      const Closest c = closest_points(cushion, other);
      EXPECT_EQ(c.distance, distance(cushion, other)) << "replay: " << i;
      EXPECT_EQ(swapped(closest_points(other, cushion)), c) << "replay: " << i;
      const auto deep = exact_penetration(cushion, other);
      EXPECT_EQ(deep.has_value(), intersects(cushion, other)) << "replay: " << i;
      const auto touch = contact(cushion, other, {.margin = 99});
      ASSERT_TRUE(touch.has_value()) << "replay: " << i;
      EXPECT_EQ(touch->relation == Relation::disjoint, !intersects(cushion, other)) << "replay: " << i;
      if (!intersects(cushion, other)) {
        EXPECT_EQ(touch->distance, distance(cushion, other)) << "replay: " << i;
      }
    };
    as_body(Segment3{p, q}), as_body(Sphere3{p, 1}), as_body(Tetrahedron3{p, q, r, {0, 0, 0}});
    const mine::Cushion other{{p, q, r}, 1};
    EXPECT_EQ(relate(cushion, other), relate(fat, Fat{other.core, 1})) << "replay: " << i;
    // Which of two that meet has the radius does not matter.
    const auto expect_time = [&](const auto& b, const auto& grown) {
      const auto time = first_contact_time(Translating{cushion, by}, b);
      EXPECT_EQ(time, first_contact_time(Translating{cushion.core, by}, grown)) << "replay: " << i;
      EXPECT_EQ(intersects(Translating{cushion, by}, b), time.has_value()) << "replay: " << i;
      const auto met = first_contact(b, Translating{Posed{cushion, RigidPose{}}, by});
      ASSERT_EQ(met.has_value(), time.has_value()) << "replay: " << i;
      if (met) {
        EXPECT_EQ(met->time, time->rounded(Rounding::down) + 0.0) << "replay: " << i;
      }
      timed += time && time->sign() == Sign::positive;
    };
    expect_time(p, Sphere3{p, cushion.radius}), expect_time(Sphere3{p, 1}, Sphere3{p, 1 + cushion.radius});
    expect_time(Segment3{p, q}, Capsule3{p, q, cushion.radius});
    EXPECT_EQ(contains(Aabb3{{-3, -3, -3}, {3, 3, 3}}, cushion),
              contains(Aabb3{{-3, -3, -3}, {3, 3, 3}}, fit_aabb(cushion)))
        << "replay: " << i;
    if (cushion.core.b != cushion.core.c || cushion.radius == 0) continue;
    ++with_kind;
    const Capsule3 capsule{cushion.core.a, cushion.core.b, cushion.radius};
    const auto deep = penetration(cushion, Obb3{p, {by, {1, 0, 0}, {0, 1, 0}}, {0.25, 1, 1}}),
               of_capsule = penetration(capsule, Obb3{p, {by, {1, 0, 0}, {0, 1, 0}}, {0.25, 1, 1}});
    EXPECT_EQ(deep.has_value(), of_capsule.has_value()) << "replay: " << i;
    if (deep) {
      EXPECT_EQ(deep->depth, of_capsule->depth) << "replay: " << i;
    }
    const Ray3 ray{p, by};
    EXPECT_EQ(first_hit(ray, cushion).has_value(), first_hit(ray, capsule).has_value()) << "replay: " << i;
    EXPECT_EQ(hits(ray, cushion), hits(ray, capsule)) << "replay: " << i;
    EXPECT_EQ(first_hit_parameter(ray, cushion), first_hit_parameter(ray, capsule)) << "replay: " << i;
    EXPECT_EQ(first_contact_time(Translating{cushion, by}, Triangle3{p, q, r}),
              first_contact_time(Translating{capsule, by}, Triangle3{p, q, r}))
        << "replay: " << i;
  }
  for (const int n : seen) EXPECT_GT(n, 20);
  EXPECT_GT(with_kind, 100);
  EXPECT_GT(timed, 100);
  const mine::Cushion cushion{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, 1}, thin{cushion.core, 0};
  EXPECT_THROW(first_hit(Ray3{{1, 1, 9}, {0, 0, -1}}, cushion), Unsupported);
  const Polygon3 roof{{{0, 0, 9}, {4, 0, 9}, {0, 4, 9}}};
  EXPECT_THROW(first_contact(Translating{cushion, {0, 0, 16}}, roof), Unsupported);
  EXPECT_EQ(first_contact(Translating{thin, {0, 0, 18}}, roof)->time, 0.5);
  EXPECT_EQ(first_contact(Translating{cushion, {0, 0, 16}}, Triangle3{{0, 0, 9}, {4, 0, 9}, {0, 4, 9}})->time, 0.5);
  EXPECT_EQ(first_hit(Ray3{{1, 1, 9}, {0, 0, -1}}, thin)->t, 9);
  EXPECT_THROW(relate(mine::Cushion{cushion.core, -1}, cushion), InvalidShape);
}

TEST(OwnFigure, KeepsItsAnswersUnderACommonRigidPose) {
  std::array<int, 3> seen{};
  for (std::uint64_t i = 0; i < 300; ++i) {
    Entropy e(24, i);
    const auto number = [&e] { return static_cast<double>(e.within(4)); };
    const auto point = [&number] { return Point3{number(), number(), number()}; };
    mine::Cushion cushion{{point(), point(), point()}, static_cast<double>(e.below(4))};
    if (e.below(4) == 0) cushion.core.c = cushion.core.b;
    const mine::Cushion other{{point(), point(), point()}, static_cast<double>(e.below(2))};
    const RigidPose turn{{1 + static_cast<double>(e.below(3)), number(), number(), number()}, {number(), 3, 0.1}};
    const RigidChain chain{{turn, {{2, 1, 0, 0}, {1, 0, 0}}}};
    const auto expect = [&](const auto& a, const auto& b, const auto& pose) {
      const Posed p{a, pose};
      const Posed q{b, pose};  // Clang deduces what is declared together as one
      const Relation expected = relate(a, b);
      ++seen[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
      EXPECT_EQ(relate(p, q), expected) << "replay: " << i;
      EXPECT_EQ(relate(q, p), expected) << "replay: " << i;
      EXPECT_EQ(intersects(p, q), expected != Relation::disjoint) << "replay: " << i;
      EXPECT_EQ(distance(p, q), distance(a, b)) << "replay: " << i;
      EXPECT_EQ(compare(exact_distance(p, q), exact_distance(a, b)), Sign::zero) << "replay: " << i;
      EXPECT_EQ(gjk_intersects(p, q), gjk_intersects(a, b)) << "replay: " << i;
      EXPECT_EQ(gjk_distance(p, q), gjk_distance(a, b)) << "replay: " << i;
      EXPECT_EQ(closest_points(p, q).distance, closest_points(a, b).distance) << "replay: " << i;
      const auto deep = penetration(p, q), as_it_stands = penetration(a, b);
      ASSERT_EQ(deep.has_value(), as_it_stands.has_value()) << "replay: " << i;
      EXPECT_TRUE(!deep || deep->depth == as_it_stands->depth) << "replay: " << i;
      const auto touch = contact(p, q, {.margin = 99}), before = contact(a, b, {.margin = 99});
      ASSERT_TRUE(touch && before) << "replay: " << i;
      EXPECT_EQ(touch->distance, before->distance) << "replay: " << i;
    };
    const auto with_all = [&](const auto& pose) {
      expect(cushion, other, pose), expect(cushion, Sphere3{point(), 1}, pose);
      expect(Tetrahedron3{point(), point(), point(), point()}, cushion, pose);
      EXPECT_EQ(relate(AnyFigure(Posed{other.core, pose}), Posed{cushion, pose}), relate(other.core, cushion)) << i;
      const Aabb3 room{{-6, -6, -6}, {6, 6, 6}};
      EXPECT_EQ(contains(Posed{room, pose}, Posed{cushion, pose}), contains(room, cushion)) << "replay: " << i;
    };
    with_all(turn), with_all(chain);
  }
  for (const int n : seen) EXPECT_GT(n, 8);
  // Of a kind it stands under any pose, with a radius that is left under a rigid one alone.
  const Pose sheared{{{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}}, {0, 0, 5}};
  const mine::Cushion cushion{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, 1}, thin{cushion.core, 0};
  EXPECT_EQ(distance(Posed{thin, sheared}, Point3{1, 1, 0}), 5);
  EXPECT_THROW(distance(Posed{cushion, sheared}, Point3{1, 1, 0}), UnevenPose);
  EXPECT_THROW(gjk_distance(Posed{cushion, sheared}, Point3{1, 1, 0}), UnevenPose);
  EXPECT_THROW(relate(Posed{cushion, RigidPose{{0, 0, 0, 0}, {}}}, Point3{1, 1, 0}), InvalidShape);
}

TEST(OwnFigure, SaysItself) {
  mine::Cushion cushion{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, 10};
  EXPECT_EQ(name_of_figure(cushion), "cushion");
  change_members(cushion, [](auto, auto& member) {
    if constexpr (requires { member.a; }) {
      change_members(member, []<part::Role role>(part::RoleIs<role>, Point3& p) {
        static_assert(role == part::Role::place);
        p.x = -p.x;
      });
    } else {
      member *= 2;
    }
  });
  EXPECT_EQ(cushion.core, (Triangle3{{-1, 2, 3}, {-4, 5, 6}, {-7, 8, 9}}));
  EXPECT_EQ(cushion.radius, 20);
}

}  // namespace
}  // namespace plumb::docs
