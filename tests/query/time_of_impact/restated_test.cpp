// Slabs and boxes by width or center, asked what, where and when: as the figures that say the same.
#include "plumb/query/time_of_impact/restated.hpp"

#include <gmock/gmock.h>

#include "figure/basic/shape_cases.hpp"
#include "plumb/query/overlap/restated.hpp"
#include "plumb/query/ray/restated.hpp"
#include "plumb/query/section/restated.hpp"
#include "plumb/query/separation/restated.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The same box over ends that are doubles, or nothing.
template <class Box>
std::optional<Aabb3> held_by(const Box& box) {
  return query::box_in_doubles("test", box);
}

template <class Box, class Shape>
void expect_same(const Box& box, const Shape& s, const Vector3& by, const std::string& about) {
  const auto held = held_by(box);
  const double d = distance(box, s);
  EXPECT_EQ(distance(s, box), d) << about;
  EXPECT_EQ(closest_points(box, s).distance, d) << about;
  EXPECT_EQ(closest_points(s, box), swapped(closest_points(box, s))) << about;
  const auto time = first_contact_time(Translating{box, by}, s);
  EXPECT_EQ(time.has_value(), first_contact(s, Translating{box, by}).has_value()) << about;
  EXPECT_EQ(time.has_value(), intersects(Translating{box, by}, s)) << about;
  EXPECT_EQ(time.has_value(), intersects(s, Translating{box, by})) << about;
  if (!held) return;
  EXPECT_EQ(closest_points(box, s), closest_points(*held, s)) << about;
  EXPECT_EQ(first_contact(Translating{box, by}, s), first_contact(Translating{*held, by}, s)) << about;
}

template <class Box>
void expect_boxes(std::uint64_t start) {
  int held = 0, hits_seen = 0, cut = 0;
  shape_cases::on_shapes(start, 150, [&](Material& m) {
    Box box = m.shape<Box>();
    const Triangle3 t = m.shape<Triangle3>();
    const Sphere3 ball = m.shape<Sphere3>();
    const Vector3 by = m.shape<Ray3>().direction;
    const std::string about = m.about(box, t);
    held += held_by(box) ? 1 : 0;
    expect_same(box, t, by, about);
    expect_same(box, ball, by, about);
    const Ray3 ray = m.shape<Ray3>();
    const auto parameter = first_hit_parameter(ray, box);
    EXPECT_EQ(hits(ray, box), parameter.has_value()) << about;
    EXPECT_EQ(hits(ray, box), relate(ray, query::box_as_it_is(box)) != Relation::disjoint) << about;
    hits_seen += parameter ? 1 : 0;
    const Intersection3 common = intersection(box, t);
    cut += common.kind == IntersectionKind::nothing ? 0 : 1;
    EXPECT_EQ(common.kind == IntersectionKind::nothing, relate(t, query::box_as_it_is(box)) == Relation::disjoint)
        << about;
    if (const auto b = held_by(box)) {
      EXPECT_EQ(parameter, first_hit_parameter(ray, *b)) << about;
      EXPECT_EQ(common.kind, intersection(*b, t).kind) << about;
      if constexpr (std::is_same_v<Box, AabbCenter3>) {
        EXPECT_EQ(first_hit(ray, box), first_hit(ray, *b)) << about;
      }
    }
  });
  EXPECT_GT(held, 50);
  EXPECT_LT(held, 149);
  EXPECT_GT(hits_seen, 15);
  EXPECT_GT(cut, 15);
}

TEST(Restated, BoxesByWidth) { expect_boxes<AabbWidths3>(5601); }
TEST(Restated, BoxesByCenter) { expect_boxes<AabbCenter3>(5602); }

TEST(Restated, SlabsAsRegions) {
  int apart = 0, seen = 0;
  shape_cases::on_shapes(5603, 150, [&](Material& m) {
    const Slab3 slab = m.shape<Slab3>();
    const Tetrahedron3 s = m.shape<Tetrahedron3>();
    const Ray3 ray = m.shape<Ray3>();
    const HalfspaceIntersection3 region{{query::lower_side(slab), query::upper_side(slab)}};
    const bool hit = relate(ray, region) != Relation::disjoint;
    seen += hit ? 1 : 0;
    EXPECT_EQ(hits(ray, slab), hit) << m.about(slab, s);
    EXPECT_EQ(first_hit(ray, slab).has_value(), hit) << m.about(slab, s);
    EXPECT_EQ(intersection(slab, s).kind == IntersectionKind::nothing, relate(region, s) == Relation::disjoint)
        << m.about(slab, s);
    if (slab.min > slab.max || slab.normal == Vector3{}) return;
    EXPECT_EQ(closest_points(slab, s), closest_points(region, s)) << m.about(slab, s);
    apart += distance(s, slab) > 0 ? 1 : 0;
  });
  EXPECT_GT(apart, 15);
  EXPECT_GT(seen, 15);
}

TEST(Restated, SaysWhatItIs) {
  const Slab3 slab{{0, 0, 2}, 2, 6};
  EXPECT_EQ(closest_points(slab, Point3{1, 2, 5}),
            (Closest{{1, 2, 3}, {1, 2, 5}, 2, {FeatureKind::face, 1}, {FeatureKind::vertex, 0}}));
  EXPECT_EQ(first_hit(Ray3{{0, 0, 0}, {0, 0, 1}}, slab), (Hit{1, {0, 0, 1}, {FeatureKind::face, 0}, {0, 0, -2}}));
  EXPECT_EQ(first_hit(Ray2{{0, 9}, {0, -1}}, Slab2{{0, 1}, 0, 4})->t, 5);
  EXPECT_EQ(first_hit(Line3{{1, 2, 3}, {0, 0, 1}}, Slab3{{0, 0, 0}, -1, 1}),
            (Hit{0, {1, 2, 3}, {FeatureKind::interior, 0}, {0, 0, 0}}));
  EXPECT_FALSE(first_hit(Ray2{{0, 0}, {1, 0}}, Slab2{{0, 0}, 1, 2}));
  EXPECT_EQ(compare_distance(slab, Point3{1, 2, 5}, 2.0), Sign::zero);
  const AabbWidths3 wide{{1, 0, 0}, {0x1p-60, 1, 1}};  // up to 1 + 2^-60
  const Ray3 ray{{2, 0.5, 0.5}, {-1, 0, 0}};
  EXPECT_TRUE(first_hit_parameter(ray, wide) < first_hit_parameter(ray, Aabb3{{1, 0, 0}, {1, 1, 1}}));
  EXPECT_TRUE(first_contact_time(Translating{wide, {1, 0, 0}}, Point3{2, 0, 0}) <
              first_contact_time(Translating{Aabb3{{1, 0, 0}, {1, 1, 1}}, {1, 0, 0}}, Point3{2, 0, 0}));
  EXPECT_THAT(
      [&] {
        (void)first_hit(Ray3{{0, 0, 0}, {0, 0, 1}}, Slab3{{0, 0, 1}, 0, INFINITY});
      },
      ThrowsMessage<NonFinite>(HasSubstr("first_hit: slab.max is inf")));
}

}  // namespace
}  // namespace plumb
