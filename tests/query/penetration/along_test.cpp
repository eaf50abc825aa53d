// Penetration along directions and within cones, against all planes of the difference by brute force.
#include "plumb/query/penetration/along.hpp"

#include <gmock/gmock.h>

#include <cstdio>

#include "certify/sanitized.hpp"
#include "query/penetration/flush_feature.hpp"
#include "query/penetration/told_checks.hpp"

namespace plumb {
namespace {

using namespace penetration_oracle;
using pair_cases::Material;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Seen {
  int none = 0, standing = 0, deep = 0, several = 0, aside = 0;  // aside: not along one of the cone's directions
};

Exact3 exact(const Vector3& v) { return {v.x, v.y, v.z}; }

/// The planes of bodies that overlap; none of those that are parted as they stand, nothing where they are disjoint.
struct Deep {
  std::vector<Plane> planes;
  mpz_class scale = 1;
};
std::optional<Deep> deep(const Round& a, const Round& b) {
  if (query::relate(FlatSet{a.corners, {}, {}}, FlatSet{b.corners, {}, {}}) == Relation::disjoint) return {};
  const Differences d(a, b);
  Deep r{supporting_planes(d.points), d.scale};
  const bool stands = std::ranges::any_of(r.planes, [](const Plane& p) { return p.height == 0; });
  if (stands || is_flat(r.planes, d.points)) r.planes.clear();
  return r;
}
Exact3 inward(const Plane& p) { return {-p.normal[0], -p.normal[1], -p.normal[2]}; }

/// Nothing where the direction does not lead out through the plane.
std::optional<mpq_class> multiple(const Plane& p, const mpz_class& scale, const Exact3& direction) {
  const mpq_class along = dot(inward(p), direction);
  if (sgn(along) <= 0) return {};
  return mpq_class(mpq_class(p.height) / mpq_class(scale) / along);
}
std::optional<mpq_class> least_multiple(const Deep& d, const Exact3& direction) {
  std::optional<mpq_class> least;
  for (const Plane& p : d.planes) {
    const auto t = multiple(p, d.scale, direction);
    if (t && (!least || *t < *least)) least = t;
  }
  return least;
}

/// The shortest translation in the cone through the plane: along the point of the cone that is nearest to its normal.
std::optional<Exact3> translation(const Plane& p, const mpz_class& scale, std::span<const Vector3> cone) {
  FlatSet set{{{0, 0, 0}}, {}, {}};
  for (const Vector3& v : cone) set.directions.push_back(exact(v));
  const Exact3 way = query::nearest_pair(FlatSet{{inward(p)}, {}, {}}, set, query::WhichPair::any)->on_b;
  if (query::is_zero(way)) return {};
  return mpq_class(mpq_class(p.height) / mpq_class(scale) / dot(way, way)) * way;
}

/// It touches after the translation, and overlaps before.
std::string fault_of_way(const Exact3& by, const Round& a, const Round& b) {
  const auto moved = [&](const mpq_class& part) {
    FlatSet s{a.corners, {}, {}};
    for (Exact3& p : s.points) p = p + part * by;
    return query::relate(s, FlatSet{b.corners, {}, {}});
  };
  if (moved(1) != Relation::touching) return "no touching after the way";
  return moved(mpq_class(1048575, 1048576)) == Relation::overlapping ? "" : "no overlapping before the end of the way";
}

std::string fault_of_numbers(const Exact3& by, double depth, const Vector3& rounded) {
  if (!told_checks::is_nearest_to(depth, sqrt(told_checks::big(dot(by, by))))) return "depth";
  const std::array told{rounded.x, rounded.y, rounded.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!told_checks::is_nearest_to(told[k], told_checks::big(by[k]))) return "translation";
  }
  return "";
}

std::vector<Vector3> some_directions(Material& m, std::size_t most) {
  std::vector<Vector3> all;
  while (all.size() < 1 + m.below(most)) {
    const Vector3 v = m.direction3();
    if (v != Vector3{}) all.push_back(v);
    if (m.below(3) == 0) all.push_back({0, 0, m.below(2) == 0 ? 1.0 : -2.0});
  }
  return all;
}

template <class A, class B>
void expect_along(const A& a, const B& b, Material& m, Seen& seen) {
  const Round p = round_of(a), q = round_of(b);
  const auto wanted = deep(p, q);
  const std::vector<Vector3> directions = some_directions(m, 3);
  const auto told = penetration_along(a, b, directions);
  const auto within = penetration_within(a, b, DirectionCone3{directions});
  ASSERT_EQ(told.has_value(), wanted.has_value()) << m.about();
  ASSERT_EQ(within.has_value(), wanted.has_value()) << m.about();
  if (!wanted) {
    ++seen.none;
    return;
  }
  if (wanted->planes.empty()) {
    ++seen.standing;
    const auto least = penetration(a, b);
    EXPECT_EQ(told->depth, 0) << m.about();
    EXPECT_EQ(told->index, 0U) << m.about();
    EXPECT_EQ(told->multiple, Rational(0)) << m.about();
    EXPECT_EQ(within->square, Rational(0)) << m.about();
    EXPECT_EQ(within->depth, 0) << m.about();
    EXPECT_TRUE(within->is_unique) << m.about();
    EXPECT_EQ(told->feature_a, least->feature_a) << m.about();
    EXPECT_EQ(within->feature_b, least->feature_b) << m.about();
    return;
  }
  ++seen.deep;
  std::size_t index = 0;
  mpq_class square = -1;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Exact3 d = exact(directions[i]);
    const mpq_class t = *least_multiple(*wanted, d), length = t * t * dot(d, d);
    if (square < 0 || length < square) index = i, square = length;
    const auto one = penetration_along(a, b, directions[i]);
    EXPECT_EQ(told_checks::gmp(one->multiple), t) << m.about();
    EXPECT_EQ(fault_of_way(t * d, p, q), "") << m.about();
  }
  EXPECT_EQ(told->index, index) << m.about();
  const Exact3 by = told_checks::gmp(told->multiple) * exact(directions[told->index]);
  EXPECT_EQ(dot(by, by), square) << m.about();
  EXPECT_EQ(fault_of_numbers(by, told->depth, told->translation), "") << m.about();

  std::optional<Exact3> least;
  bool is_unique = true;
  for (const Plane& plane : wanted->planes) {
    const auto t = translation(plane, wanted->scale, directions);
    if (!t) continue;
    const int order = least ? cmp(dot(*t, *t), dot(*least, *least)) : -1;
    if (order < 0) is_unique = true;
    if (order == 0 && *t != *least) is_unique = false;
    if (order < 0 || (order == 0 && *t < *least)) least = *t;
  }
  EXPECT_EQ(told_checks::gmp(within->exact_translation), *least) << m.about();
  EXPECT_EQ(told_checks::gmp(within->square), dot(*least, *least)) << m.about();
  EXPECT_EQ(within->is_unique, is_unique) << m.about();
  EXPECT_EQ(fault_of_numbers(*least, within->depth, within->translation), "") << m.about();
  EXPECT_EQ(fault_of_way(*least, p, q), "") << m.about();
  seen.several += is_unique ? 0 : 1;
  seen.aside +=
      std::ranges::none_of(directions, [&](const Vector3& d) { return query::is_zero(cross(exact(d), *least)); });
}

template <class A, class B>
void expect_pairs(std::uint64_t start, std::uint64_t cases, Seen& seen) {
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const A a = pair_cases::figure<A>(m);
    const B b = pair_cases::near_figure<B>(m);
    if constexpr (std::is_same_v<B, Aabb3>) {
      if (is_empty(b)) return;
    }
    expect_along(a, b, m, seen);
  });
}

TEST(PenetrationAlong, IsThatOfBruteForce) {
  const std::uint64_t few = battery::sanitized ? 2 : 20;
  Seen seen;
  expect_pairs<Triangle3, Segment3>(1, few, seen);
  expect_pairs<Triangle3, Triangle3>(2, few, seen);
  expect_pairs<Tetrahedron3, Point3>(3, few, seen);
  expect_pairs<Tetrahedron3, Triangle3>(4, few, seen);
  expect_pairs<Tetrahedron3, Tetrahedron3>(5, few, seen);
  expect_pairs<Tetrahedron3, Aabb3>(6, few / 4 + 1, seen);
  expect_pairs<ConvexPolyhedron3, Segment3>(7, few, seen);
  expect_pairs<ConvexPolyhedron3, Tetrahedron3>(8, few / 2 + 1, seen);
  std::printf("none %d, standing %d, deep %d; several %d, aside %d\n", seen.none, seen.standing, seen.deep,
              seen.several, seen.aside);
  EXPECT_GE(std::min({seen.none, seen.standing, seen.deep, seen.aside}), battery::sanitized ? 0 : 8);
}

struct RoundSeen {
  int none = 0, standing = 0, deep = 0, by_core = 0, rational = 0;
  std::array<int, 3> features{};  // of the first body's core: vertices, edges, faces
};

/// The root, but for 9,000 bits.
mpq_class middle_of(const Root& r) {
  if (const auto x = r.rational()) return told_checks::gmp(*x);
  const mpq_class width = mpq_class(std::clamp(r.rounded(), 0x1p-1074, 0x1p1023)) / mpq_class(mpz_class(1) << 9000);
  const auto [below, above] = r.interval(Rational(BigRational{width}));
  return (told_checks::gmp(below) + told_checks::gmp(above)) / 2;
}

/// The corners that lie furthest along a direction, which may be off a little.
std::vector<std::uint32_t> furthest(const std::vector<Exact3>& corners, const Exact3& out) {
  const Exact3* most = &corners[0];
  for (const Exact3& p : corners) {
    if (dot(out, p - *most) > 0) most = &p;
  }
  std::vector<std::uint32_t> level;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const Exact3 way = *most - corners[i];
    const mpq_class below = dot(out, way), sizes = dot(out, out) * dot(way, way);
    if (below * below * mpq_class(mpz_class(1) << 8000) <= sizes) level.push_back(i);
  }
  return level;
}
template <class Shape>
Feature flush(const Shape& s, const Exact3& out) {
  const query::BodyView view = query::body_view(s);
  const query::CoreCorners c = *query::CoreCorners::of(view);
  std::vector<Exact3> corners;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto p = c.at<mpq_class>(i);
    corners.push_back({p.x, p.y, p.z});
  }
  return query::parting::flush_feature(view, c, furthest(corners, out));
}

/// Against the distance of the cores: less than the radii before the end of the way, more after it, and equal where
/// the end is a rational number.
template <class A, class B>
void expect_round_along(const A& a, const B& b, Material& m, RoundSeen& seen) {
  const Round p = round_of(a), q = round_of(b);
  const mpq_class radii = p.radius + q.radius;
  const std::vector<Vector3> directions = some_directions(m, 3);
  const auto told = penetration_along(a, b, directions);
  const auto apart = [&](const Exact3& by) {
    FlatSet moved{p.corners, {}, {}};
    for (Exact3& x : moved.points) x = x + by;
    const auto pair = query::nearest_pair(moved, FlatSet{q.corners, {}, {}}, query::WhichPair::any);
    return std::pair(pair->square, pair->on_a - pair->on_b);
  };
  if (radii == 0) {
    const auto wanted = deep(p, q);
    ASSERT_EQ(told.has_value(), wanted.has_value()) << m.about();
    if (wanted && !wanted->planes.empty()) {
      EXPECT_EQ(told->multiple, Root(Rational(BigRational{*least_multiple(*wanted, exact(directions[told->index]))})))
          << m.about();
    }
    ++seen.by_core;
    return;
  }
  const mpq_class now = apart({0, 0, 0}).first;
  ASSERT_EQ(told.has_value(), now <= radii * radii) << m.about();
  if (!told) {
    ++seen.none;
    return;
  }
  if (now == radii * radii) {
    ++seen.standing;
    const auto least = penetration(a, b);
    EXPECT_EQ(told->depth, 0) << m.about();
    EXPECT_EQ(told->index, 0U) << m.about();
    EXPECT_EQ(told->multiple, Rational(0)) << m.about();
    EXPECT_EQ(told->translation, Vector3{}) << m.about();
    EXPECT_EQ(told->feature_a, least->feature_a) << m.about();
    EXPECT_EQ(told->feature_b, least->feature_b) << m.about();
    return;
  }
  ++seen.deep;
  const Exact3 d = exact(directions[told->index]);
  const mpq_class t = middle_of(told->multiple), nearly(1, mpz_class(1) << 2500);
  EXPECT_GT(t, 0) << m.about();
  EXPECT_LT(apart(mpq_class(t * (1 - nearly)) * d).first, radii * radii) << m.about();
  EXPECT_GT(apart(mpq_class(t * (1 + nearly)) * d).first, radii * radii) << m.about();
  const auto at_end = apart(t * d);
  if (told->multiple.rational()) {
    ++seen.rational;
    EXPECT_EQ(at_end.first, radii * radii) << m.about();
  }
  EXPECT_EQ(fault_of_numbers(t * d, told->depth, told->translation), "") << m.about();
  EXPECT_EQ(told->feature_a, flush(a, mpq_class(-1) * at_end.second)) << m.about();
  EXPECT_EQ(told->feature_b, flush(b, at_end.second)) << m.about();
  ++seen.features[std::min<std::size_t>(furthest(p.corners, mpq_class(-1) * at_end.second).size() - 1, 2)];
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto one = penetration_along(a, b, directions[i]);
    const Exact3 of_one = exact(directions[i]);
    const mpq_class x = middle_of(one->multiple), length = x * x * dot(of_one, of_one), least = t * t * dot(d, d);
    EXPECT_GE(length * (i < told->index ? mpq_class(1 - nearly) : mpq_class(1 + nearly)), least) << m.about();
  }
}

template <class A, class... B>
void expect_round_pairs(std::uint64_t start, std::uint64_t cases, RoundSeen& seen) {
  const auto expect_with = [&]<class Other>(Other*) {
    shape_cases::on_shapes(start++, cases, [&](Material& m) {
      const A a = pair_cases::figure<A>(m);
      const Other b = pair_cases::near_figure<Other>(m);
      if constexpr (std::is_same_v<Other, Aabb3>) {
        if (is_empty(b)) return;
      }
      expect_round_along(a, b, m, seen);
    });
  };
  (expect_with(static_cast<B*>(nullptr)), ...);
}

TEST(PenetrationAlong, OfRoundBodiesIsWhereTheDistanceIsTheRadius) {
  const std::uint64_t few = battery::sanitized ? 1 : 12;
  RoundSeen seen;
  expect_round_pairs<Sphere3, Point3, Sphere3, Triangle3, Aabb3>(30, few, seen);
  expect_round_pairs<Capsule3, Capsule3, Tetrahedron3, ConvexPolyhedron3>(40, few, seen);
  expect_round_pairs<Lozenge3, Segment3, Lozenge3>(50, few, seen);
  std::printf("none %d, standing %d, deep %d, of radius zero %d, rational %d; vertices %d, edges %d, faces %d\n",
              seen.none, seen.standing, seen.deep, seen.by_core, seen.rational, seen.features[0], seen.features[1],
              seen.features[2]);
  EXPECT_GE(std::min({seen.none, seen.standing, seen.deep, seen.rational, seen.features[0], seen.features[1]}),
            battery::sanitized ? 0 : 3);
}

TEST(PenetrationAlong, OfRoundBodiesByHand) {
  const Sphere3 ball{{0, 0, 0}, 2}, other{{0, 0, 3}, 3};  // 5 apart when they touch
  const auto side = penetration_along(ball, other, Vector3{2, 0, 0});
  EXPECT_EQ(side->multiple, Rational(2));  // 3, 4, 5
  EXPECT_EQ(side->depth, 4);
  EXPECT_EQ(side->translation, (Vector3{4, 0, 0}));
  const std::vector<Vector3> ways{{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {0, 0, -7}};
  const auto best = penetration_along(ball, other, ways);
  EXPECT_EQ(best->index, 2U);
  EXPECT_EQ(best->multiple, Rational(2));

  const Capsule3 rod{{-4, 0, 0}, {4, 0, 0}, 1};
  const Aabb3 box{{-1, -1, -1}, {1, 1, 1}};
  const auto up = penetration_along(rod, box, Vector3{0, 1, 1});
  EXPECT_EQ(up->depth, std::sqrt(2) + 1);  // over an edge of the box
  EXPECT_EQ(up->feature_a, (Feature{FeatureKind::face, 0}));
  EXPECT_EQ(up->feature_b, (Feature{FeatureKind::edge, 3}));
  const auto corner = penetration_along(Sphere3{{0, 0, 0}, 1}, box, Vector3{1, 1, 1});
  EXPECT_EQ(corner->depth, std::sqrt(3) + 1);
  EXPECT_EQ(corner->feature_b, (Feature{FeatureKind::vertex, 7}));
  const auto beside = penetration_along(Sphere3{{0, 0, 0}, 2}, Point3{0, 1, 1}, Vector3{1, 0, 0});
  EXPECT_FALSE(beside->multiple.rational());
  EXPECT_EQ(beside->depth, std::sqrt(2));
  EXPECT_FALSE(penetration_along(rod, Point3{0, 1, 1}, Vector3{0, 0, 1}).has_value());
  EXPECT_EQ(penetration_along(rod, Point3{0, 0, 1}, Vector3{0, 0, 1})->depth, 0);  // it touches, and is parted

  const Pose turned{{Vector3{0, 2, 0}, Vector3{-2, 0, 0}, Vector3{0, 0, 2}}, {0, 0, 0}};
  EXPECT_EQ(penetration_along(Posed{rod, turned}, Point3{0, 0, 0}, Vector3{0, 0, 1})->multiple, Rational(2));
  EXPECT_EQ(penetration_along(Posed{rod, turned}, Point3{0, 0, 0}, Vector3{0, -1, 0})->multiple, Rational(10));
  EXPECT_THAT([&] { (void)penetration_along(rod, box, Vector3{}); },
              ThrowsMessage<InvalidShape>(HasSubstr("penetration_along: direction is zero")));
}

TEST(PenetrationAlong, ConesOfBoxes) {
  const Aabb3 box{{0, 0, 0}, {4, 4, 4}}, other{{1, 1, 1}, {3, 3, 3}};  // the middles are common: 3 along each axis
  const std::vector<Vector3> everywhere{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const auto all = penetration_within(box, other, {everywhere});
  EXPECT_EQ(all->square, Rational(9));
  EXPECT_FALSE(all->is_unique);
  EXPECT_EQ(all->translation, (Vector3{-3, 0, 0}));
  EXPECT_EQ(all->depth, penetration(box, other)->depth);

  const std::vector<Vector3> up{{0, 0, 5}};
  const auto above = penetration_within(box, other, {up});
  EXPECT_EQ(above->translation, (Vector3{0, 0, 3}));
  EXPECT_EQ(above->feature_a, (Feature{FeatureKind::face, 4}));
  EXPECT_EQ(above->feature_b, (Feature{FeatureKind::face, 5}));
  EXPECT_EQ(penetration_along(box, other, up[0])->multiple, Rational(3, 5));

  const std::vector<Vector3> slanted{{1, 1, 0}};  // leaves by two faces at once
  const auto aslant = penetration_along(box, other, slanted[0]);
  EXPECT_EQ(aslant->multiple, Rational(3));
  EXPECT_EQ(aslant->feature_a, (Feature{FeatureKind::face, 2}));  // the direction of y comes before that of x

  const std::vector<Vector3> sector{{1, 1, 0}, {1, -1, 0}};
  const auto inside = penetration_within(box, other, {sector});
  EXPECT_EQ(inside->translation, (Vector3{3, 0, 0}));
  EXPECT_TRUE(inside->is_unique);
}

TEST(PenetrationAlong, WhatIsNoDirectionIsNamed) {
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  const std::vector<Vector3> none, bad{{1, 0, 0}, {0, NAN, 0}}, zero{{1, 0, 0}, {0, 0, 0}};
  EXPECT_THAT([&] { (void)penetration_along(box, box, Vector3{}); },
              ThrowsMessage<InvalidShape>(HasSubstr("penetration_along: direction is zero")));
  EXPECT_THAT([&] { (void)penetration_along(box, box, zero); },
              ThrowsMessage<InvalidShape>(HasSubstr("penetration_along: directions[1] is zero")));
  EXPECT_THAT([&] { (void)penetration_along(box, box, bad); },
              ThrowsMessage<NonFinite>(HasSubstr("penetration_along: directions[1].y")));
  EXPECT_THAT([&] { (void)penetration_within(box, box, {none}); },
              ThrowsMessage<InvalidShape>(HasSubstr("penetration_within: directions is empty")));
  EXPECT_THAT([&] { (void)penetration_within(box, Point3{NAN, 0, 0}, {zero}); }, testing::Throws<InvalidShape>());
  EXPECT_THAT(
      [&] {
        (void)penetration_along(box, Point3{NAN, 0, 0}, bad[0]);
      },
      ThrowsMessage<NonFinite>(HasSubstr("penetration_along: point.x")));
}

static_assert(StraightBody3<VertexHull3> && StraightBody3<Posed<Obb3>> && !StraightBody3<Sphere3> &&
              !StraightBody3<Posed<Capsule3>>);

}  // namespace
}  // namespace plumb
