// Both figures moved alike: distances, first hits and contact times are those of before, exactly.
//
// The maps are those of query/body/pair_moves.hpp: axes permuted and mirrored, powers of two, whole shifts, turns by the
// triangle of sides 3, 4 and 5; and shears, where no length and no right angle counts.
#include <gtest/gtest.h>

#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/time_of_impact/continuous_contact.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "query/body/pair_moves.hpp"
#include "query/body/pair_types.hpp"
#include "query/ray/cases.hpp"

namespace plumb::pair_cases {
namespace {

/// How many cases were moved, and how many of these had an answer that could change: a hit, a contact, some distance.
struct Moved {
  int all = 0, answered = 0;
  ~Moved() {
    std::printf("%d moved, %d with an answer\n", all, answered);
    EXPECT_GT(answered * 5, all);
    EXPECT_GT(all, 300);
  }
};

/// Lengths keep their ratios: no shears.
template <class A, class B>
MapKind rigid_kind(Material& m) {
  const MapKind kind = map_kind<A, B>(m);
  return kind == MapKind::sheared ? MapKind::turned : kind;
}

template <class A, class B>
void expect_distance_grows(Moved& moved, std::uint64_t start, std::uint64_t cases) {
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const B b = near_figure<B>(m);
    const A a = near_figure<A>(m);
    const Rational unit = squared_distance_exact(Point3{0, 0, 0}, Point3{1, 0, 0});
    Map map(m, figure_dimension<A>, rigid_kind<A, B>(m), m.below(2) == 0);
    const A c = mapped(a, map);
    const B d = mapped(b, map);
    const Point3 from = map.point(Point3{0, 0, 0}), to = map.point(Point3{1, 0, 0});
    if (!map.exact()) return;
    const Rational growth = squared_distance_exact(from, to) / unit;
    ExactDistance before, after;
    try {
      before = exact_distance(a, b), after = exact_distance(c, d);
    } catch (const InvalidShape&) {  // an empty box is nowhere
      EXPECT_THROW(exact_distance(a, b), InvalidShape);
      EXPECT_THROW(exact_distance(c, d), InvalidShape);
      return;
    }
    ++moved.all;
    moved.answered += before.square.sign() != Sign::zero;
    EXPECT_TRUE(after.square == before.square * growth) << pair_name<A, B>() << m.about(a, b) << " to" << m.about(c, d);
    EXPECT_TRUE(after.inset * after.inset == before.inset * before.inset * growth)
        << pair_name<A, B>() << m.about(a, b);
  });
}
template <class A, class... Bs>
void expect_distances_grow(Types<Bs...>, Moved& moved, std::uint64_t start, std::uint64_t cases) {
  (expect_distance_grows<A, Bs>(moved, start++, cases), ...);
}

TEST(PosedPairs, DistancesOfPointsGrowAsLengthsDo) {
  Moved moved;
  expect_distances_grow<Point2>(Types<Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Quadrilateral2, Polygon2,
                                      HoledPolygon2, Circle2, Aabb2, Obb2, Capsule2>{},
                                moved, 4001, 40);
  expect_distances_grow<Point3>(
      Types<Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3, Polygon3,
            HoledPolygon3, Rectangle3, Tetrahedron3, Sphere3, Aabb3, Obb3, Capsule3, ConvexPolyhedron3>{},
      moved, 4101, 40);
}

TEST(PosedPairs, DistancesOfStraightFiguresGrowAsLengthsDo) {
  Moved moved;
  using Straight2 = Types<Line2, Ray2, Segment2, Triangle2>;
  using Straight3 = Types<Line3, Ray3, Segment3, Triangle3>;
  expect_distances_grow<Line2>(Straight2{}, moved, 4201, 40);
  expect_distances_grow<Ray2>(Straight2{}, moved, 4211, 40);
  expect_distances_grow<Segment2>(Straight2{}, moved, 4221, 40);
  expect_distances_grow<Triangle2>(Straight2{}, moved, 4231, 40);
  expect_distances_grow<Line3>(Straight3{}, moved, 4241, 40);
  expect_distances_grow<Ray3>(Straight3{}, moved, 4251, 40);
  expect_distances_grow<Segment3>(Straight3{}, moved, 4261, 40);
  expect_distances_grow<Triangle3>(Straight3{}, moved, 4271, 40);
}

AnyRay mapped_ray(const AnyRay& ray, Map& map) {
  if (ray.kind == AnyRay::Kind::segment) return Segment3{map.point(ray.origin), map.point(ray.end)};
  if (ray.kind == AnyRay::Kind::line) return Line3{map.point(ray.origin), map.vector(ray.direction)};
  return Ray3{map.point(ray.origin), map.vector(ray.direction)};
}

/// Whose features keep their names when the axes are others.
template <class Shape>
inline constexpr bool keeps_names =
    !query::is_one_of(figure_kind<Shape>, {FigureKind::aabb, FigureKind::convex_polyhedron});

template <class Shape>
void expect_same_hits(Moved& moved, std::uint64_t start, std::uint64_t cases) {
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const Shape shape = near_figure<Shape>(m);
    const AnyRay ray = ray_cases::ray_of(m);
    Map map(m, 3, map_kind<Shape, Shape>(m), m.below(2) == 0);
    const Shape other = mapped(shape, map);
    const AnyRay other_ray = mapped_ray(ray, map);
    if (!map.exact()) return;
    const std::string about = std::string(name_of(figure_kind<Shape>)) + m.about(shape) + " " + ray_cases::text_of(ray);
    const auto before = first_hit_parameter(ray, shape), after = first_hit_parameter(other_ray, other);
    ++moved.all;
    ASSERT_EQ(before.has_value(), after.has_value()) << about;
    const auto hit = first_hit(ray, shape), other_hit = first_hit(other_ray, other);
    ASSERT_EQ(hit.has_value(), before.has_value()) << about;
    ASSERT_EQ(other_hit.has_value(), before.has_value()) << about;
    if (!before) return;
    ++moved.answered;
    EXPECT_TRUE(*before == *after) << about;
    EXPECT_EQ(hit->t, other_hit->t) << about;
    EXPECT_EQ(hit->feature.kind, other_hit->feature.kind) << about;
    EXPECT_TRUE(!keeps_names<Shape> || hit->feature.index == other_hit->feature.index) << about;
  });
}
template <class... Shapes>
void expect_same_hits_of(Types<Shapes...>, Moved& moved, std::uint64_t start, std::uint64_t cases) {
  (expect_same_hits<Shapes>(moved, start++, cases), ...);
}

TEST(PosedPairs, FirstHitsAreTheSame) {
  Moved moved;
  expect_same_hits_of(Types<Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3, Rectangle3, Tetrahedron3,
                            Sphere3, Capsule3, Cylinder3, Aabb3, Obb3, KDop3, ConvexPolyhedron3>{},
                      moved, 4301, 150);
}

/// Toward the other figure, or anywhere.
template <class A, class B>
void expect_same_time(Moved& moved, std::uint64_t start, std::uint64_t cases) {
  if constexpr (!std::is_same_v<A, Plane3> || !std::is_same_v<B, Plane3>) {
    shape_cases::on_shapes(start, cases, [&](Material& m) {
      const A shape = figure<A>(m);
      const B other = near_figure<B>(m);
      const Translating<A> a{shape, m.vector3()};
      const Translating<B> b{other, m.vector3()};
      Map map(m, 3, map_kind<A, B>(m), m.below(2) == 0);
      const Translating<A> c{mapped(shape, map), map.vector(a.by)};
      const Translating<B> d{mapped(other, map), map.vector(b.by)};
      if (!map.exact()) return;
      const std::string about = pair_name<A, B>() + m.about(shape, a.by, other, b.by);
      const auto before = first_contact_time(a, b), after = first_contact_time(c, d);
      ++moved.all;
      ASSERT_EQ(before.has_value(), after.has_value()) << about;
      EXPECT_EQ(intersects(c, d), before.has_value()) << about;
      if (!before) return;
      ++moved.answered;
      EXPECT_TRUE(*before == *after) << about;
      EXPECT_EQ(first_contact(a, b)->time, first_contact(d, c)->time) << about;
    });
  }
}

template <class F, class A, class... Bs>
void on_all_pairs(Types<A, Bs...>, F f) {
  f(static_cast<const A*>(nullptr), static_cast<const A*>(nullptr));
  (f(static_cast<const A*>(nullptr), static_cast<const Bs*>(nullptr)), ...);
  if constexpr (sizeof...(Bs) > 0) on_all_pairs(Types<Bs...>{}, f);
}

TEST(PosedPairs, FirstContactsAreAtTheSameTime) {
  Moved moved;
  std::uint64_t start = 4401;
  on_all_pairs(Types<Point3, Segment3, Triangle3, Plane3, Sphere3, Aabb3, Obb3, Capsule3, ConvexPolyhedron3>{},
               [&]<class A, class B>(const A*, const B*) { expect_same_time<A, B>(moved, start++, 30); });
}

template <class A, class B>
void expect_same_moving_time(Moved& moved, std::uint64_t start, std::uint64_t cases) {
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const Moving<A> a{figure<A>(m), near_figure<A>(m)};
    const Moving<B> b{near_figure<B>(m), near_figure<B>(m)};
    Map map(m, 3, map_kind<A, B>(m), m.below(2) == 0);
    const Moving<A> c{mapped(a.from, map), mapped(a.to, map)};
    const Moving<B> d{mapped(b.from, map), mapped(b.to, map)};
    if (!map.exact()) return;
    const std::string about = pair_name<A, B>() + m.about(a.from, a.to, b.from, b.to);
    const auto before = first_contact_time(a, b), after = first_contact_time(c, d);
    ++moved.all;
    ASSERT_EQ(before.has_value(), after.has_value()) << about;
    if (!before) return;
    ++moved.answered;
    EXPECT_TRUE(*before == *after) << about;
    const Contact first = *first_contact(a, b), other = *first_contact(c, d);
    EXPECT_EQ(first, other) << about;
  });
}
TEST(PosedPairs, CornersAndEdgesInMotionMeetAtTheSameTime) {
  Moved moved;
  expect_same_moving_time<Point3, Triangle3>(moved, 4501, 400);
  expect_same_moving_time<Segment3, Segment3>(moved, 4502, 400);
}

}  // namespace
}  // namespace plumb::pair_cases
