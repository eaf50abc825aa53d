// Is every point where rationals say, for random shapes of every kind?
#include <gmock/gmock.h>

#include <array>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/containment/exact_locations.hpp"
#include "oracle/shapes.hpp"
#include "plumb/figure/containment/contains.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;

struct Shares {
  std::array<std::uint64_t, 3> count{};
  [[nodiscard]] double of(Location where) const {
    return static_cast<double>(count[static_cast<std::size_t>(static_cast<int>(where) + 1)]) /
           static_cast<double>(count[0] + count[1] + count[2]);
  }
};

/// Of `cases` shapes with four points each.
template <class Shape, class Point>
Shares hold_against_rationals(std::uint64_t cases) {
  Shares shares;
  on_shapes(41, battery::sanitized ? cases / 4 : cases, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    for (int probe = 0; probe < 4; ++probe) {
      const Point p = m.probe<Point>();
      const Location expected = exact::locate(shape, p);
      ++shares.count[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
      EXPECT_EQ(locate(shape, p), expected) << m.about(shape, p) << " probe " << probe;
      EXPECT_EQ(contains(shape, p), expected != Location::outside) << m.about(shape, p) << " probe " << probe;
    }
  });
  return shares;
}

/// Representative: each answer is frequent.
template <class Shape, class Point>
void expect_solid(std::uint64_t cases, double least = 0.05) {
  const Shares s = hold_against_rationals<Shape, Point>(cases);
  for (const Location where : {Location::outside, Location::boundary, Location::inside}) {
    EXPECT_GE(s.of(where), least) << static_cast<int>(where);
  }
}
template <class Shape, class Point>
void expect_flat(std::uint64_t cases, double least = 0.05) {
  const Shares s = hold_against_rationals<Shape, Point>(cases);
  EXPECT_GE(s.of(Location::outside), least);
  EXPECT_GE(s.of(Location::boundary), least);
}

TEST(ContainsRandom, Lines) {
  expect_flat<Line2, Point2>(4000);
  expect_flat<Line3, Point3>(4000);
  expect_flat<Ray2, Point2>(4000);
  expect_flat<Ray3, Point3>(4000);
  expect_flat<Segment2, Point2>(4000);
  expect_flat<Segment3, Point3>(4000);
}

TEST(ContainsRandom, PlanesAndHalfspaces) {
  expect_flat<Plane3, Point3>(4000);
  expect_flat<ThreePointPlane3, Point3>(3000);
  expect_solid<Halfspace2, Point2>(4000);
  expect_solid<Halfspace3, Point3>(4000);
  expect_solid<Slab2, Point2>(4000, 0.03);
  expect_solid<Slab3, Point3>(4000, 0.03);
  expect_solid<HalfspaceIntersection2, Point2>(4000, 0.03);
  expect_solid<HalfspaceIntersection3, Point3>(4000, 0.03);
}

TEST(ContainsRandom, Simplices) {
  expect_solid<Triangle2, Point2>(3000);
  expect_flat<Triangle3, Point3>(2500);
  expect_solid<Tetrahedron3, Point3>(2500, 0.02);
}

TEST(ContainsRandom, RoundShapes) {
  expect_solid<Circle2, Point2>(4000);
  expect_solid<Sphere3, Point3>(4000);
  expect_solid<Capsule2, Point2>(4000);
  expect_solid<Capsule3, Point3>(4000);
  expect_solid<Cylinder3, Point3>(4000);
  expect_solid<Cone3, Point3>(4000, 0.03);
  expect_solid<Lozenge3, Point3>(3000);
  expect_solid<Ellipsoid3, Point3>(3000, 0.03);
}

TEST(ContainsRandom, Boxes) {
  expect_solid<Aabb2, Point2>(4000);
  expect_solid<Aabb3, Point3>(4000, 0.015);
  expect_solid<AabbWidths3, Point3>(4000, 0.015);
  expect_solid<AabbCenter3, Point3>(4000, 0.015);
  expect_solid<Obb2, Point2>(4000);
  expect_solid<Obb3, Point3>(3000);
  expect_flat<Rectangle3, Point3>(2500);
}

/// Of `cases` shapes; CGAL answers for at least this share of them.
template <class Shape, class Point>
void hold_against_cgal(std::uint64_t cases, double share) {
  if (battery::sanitized) cases /= 4;
  std::uint64_t answers = 0;
  on_shapes(42, cases, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const Point p = m.probe<Point>();
    const std::optional<Location> expected = oracle::locate(shape, p);
    if (!expected) return;
    ++answers;
    EXPECT_EQ(locate(shape, p), *expected) << m.about(shape, p);
  });
  EXPECT_GE(static_cast<double>(answers), share * static_cast<double>(cases));
}

TEST(ContainsRandom, AgreesWithCgal) {
  hold_against_cgal<Line2, Point2>(500, 0.7);
  hold_against_cgal<Line3, Point3>(500, 0.7);
  hold_against_cgal<Ray2, Point2>(500, 0.7);
  hold_against_cgal<Ray3, Point3>(500, 0.7);
  hold_against_cgal<Segment2, Point2>(500, 0.7);
  hold_against_cgal<Segment3, Point3>(500, 0.7);
  hold_against_cgal<Plane3, Point3>(500, 0.7);
  hold_against_cgal<ThreePointPlane3, Point3>(500, 0.5);
  hold_against_cgal<Halfspace2, Point2>(500, 0.7);
  hold_against_cgal<Halfspace3, Point3>(500, 0.7);
  hold_against_cgal<Triangle2, Point2>(500, 0.4);
  hold_against_cgal<Triangle3, Point3>(500, 0.5);
  hold_against_cgal<Tetrahedron3, Point3>(500, 0.15);
  hold_against_cgal<Circle2, Point2>(500, 0.5);
  hold_against_cgal<Sphere3, Point3>(500, 0.5);
  hold_against_cgal<Capsule2, Point2>(500, 0.4);
  hold_against_cgal<Capsule3, Point3>(500, 0.4);
  hold_against_cgal<Aabb2, Point2>(500, 0.4);
  hold_against_cgal<Aabb3, Point3>(500, 0.15);
  hold_against_cgal<Obb3, Point3>(500, 0.15);
}

}  // namespace
}  // namespace plumb
