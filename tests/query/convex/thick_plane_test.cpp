// On which side of a thick plane does a figure lie, by the corners and by balls that touch?
#include "plumb/query/convex/thick_plane.hpp"

#include <gtest/gtest.h>

#include "figure/basic/shape_cases.hpp"
#include "query/body/exact_sets.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;

ThickSide side_of_corners(const ThickPlane3& plane, const std::vector<exact::Coordinates>& corners) {
  const exact::Coordinates n = exact::of(plane.normal);
  const exact::Rational least = exact::square(n) * exact::squared(plane.radius);
  bool front = false, behind = false;
  for (const exact::Coordinates& p : corners) {
    const exact::Rational height = exact::dot(n, p) - exact::Rational(plane.offset);
    if (height * height > least) (height > 0 ? front : behind) = true;
  }
  return front && behind ? ThickSide::straddling
         : front         ? ThickSide::in_front
         : behind        ? ThickSide::behind
                         : ThickSide::coplanar;
}

template <class Shape>
void hold(std::uint64_t start, std::array<int, 4>& count) {
  on_shapes(start, 100, [&](Material& m) {
    const auto s = m.shape<Shape>();
    const ThickPlane3 plane{m.direction3(), m.number(), m.below(3) == 0 ? 0 : m.radius() / 2};
    const ThickSide told = side_of(plane, s);
    EXPECT_EQ(told, side_of_corners(plane, exact::generated(s).points)) << m.about(s, plane);
    const Vector3& n = plane.normal;
    const ThickSide turned = side_of(ThickPlane3{{-n.x, -n.y, -n.z}, -plane.offset, plane.radius}, s);
    EXPECT_EQ(static_cast<int>(turned), told == ThickSide::straddling ? 2 : -static_cast<int>(told))
        << m.about(s, plane);
    ++count[static_cast<std::size_t>(static_cast<int>(told) + 1)];
  });
}

TEST(ThickPlane, BySigns) {
  std::array<int, 4> count{};
  hold<Triangle3>(801, count);
  hold<Aabb3>(802, count);
  hold<Obb3>(803, count);
  hold<Segment3>(804, count);
  for (const int n : count) EXPECT_GE(n, 10);
}

TEST(ThickPlane, TouchesIsWithin) {
  const ThickPlane3 slanted{{3, 0, 4}, 25, 2};  // from 3 to 7 from the origin
  const Point3 near{9, 1, 2};                   // at distance 7
  EXPECT_EQ(side_of(slanted, near), ThickSide::coplanar);
  EXPECT_EQ(side_of(slanted, Point3{moved_by_ulps(9.0, 1), 1, 2}), ThickSide::in_front);
  EXPECT_EQ(side_of(slanted, Point3{moved_by_ulps(5.0, -1), 8, 0}), ThickSide::behind);
  EXPECT_EQ(side_of(slanted, Point3{5, 8, 0}), ThickSide::coplanar);
  EXPECT_EQ(side_of(slanted, Sphere3{{3, 0, 4}, 2}), ThickSide::coplanar);
  EXPECT_EQ(side_of(slanted, Sphere3{{3, 0, 4}, moved_by_ulps(2.0, 1)}), ThickSide::straddling);
  EXPECT_EQ(side_of(slanted, Capsule3{{3, 0, 4}, {6, 0, 8}, 2}), ThickSide::in_front);
  EXPECT_EQ(side_of(slanted, Sphere3{{0, 0, 0}, 1}), ThickSide::behind);
  EXPECT_EQ(side_of(slanted, Sphere3{{0, 0, 0}, 7}), ThickSide::behind);
  EXPECT_EQ(side_of(slanted, Sphere3{{0, 0, 0}, 7.5}), ThickSide::straddling);
  EXPECT_EQ(side_of(slanted, Line3{{3, 0, 4}, {4, 7, -3}}), ThickSide::coplanar);
  EXPECT_EQ(side_of(slanted, Ray3{{3, 0, 4}, {4, 7, moved_by_ulps(-3.0, 1)}}), ThickSide::in_front);
  EXPECT_EQ(side_of(slanted, Aabb3{{1, 0, 0}, {0, 0, 0}}), ThickSide::coplanar);
  EXPECT_EQ(side_of(ThickPlane3{{0, 0, 0}, -1, 5}, near), ThickSide::in_front);
  EXPECT_THROW((void)side_of(ThickPlane3{{0, 0, 1}, 0, -1}, near), InvalidShape);
  EXPECT_THROW((void)side_of(ThickPlane3{{0, 0, 1}, NAN, 1}, near), NonFinite);
  EXPECT_THROW((void)side_of(ThickPlane3{{0, 0, 1}, 0, 1}, Point3{0, 0, NAN}), NonFinite);
}

}  // namespace
}  // namespace plumb
