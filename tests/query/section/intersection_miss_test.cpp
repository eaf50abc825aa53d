// What does it cost that two figures have nothing in common?  A few signs, and not one allocation.
#include <gtest/gtest.h>

#include "counted_allocations.hpp"
#include "figure/basic/shape_cases.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;

class Random {
 public:
  explicit Random(std::uint64_t index) : entropy_(50, index) {}

  double unit() { return static_cast<double>(entropy_.within(1ll << 52)) * 0x1p-52; }
  Vector3 vector() { return {unit(), unit(), unit()}; }
  Point3 point() { return {unit() + at_.x, unit() + at_.y, unit() + at_.z}; }

  /// Corners within 1 of a center of its own, so that most figures miss each other.
  template <class Figure>
  Figure figure() {
    at_ = vector();
    if constexpr (std::is_same_v<Figure, Plane3> || std::is_same_v<Figure, Halfspace3>) {
      return {vector(), 3 * unit()};
    } else if constexpr (std::is_same_v<Figure, Obb3>) {
      return {point(), {Vector3{1, unit(), 0}, {unit(), 1, 0}, {0, unit(), 1}}, {0.25, 0.5, 0.125}};
    } else if constexpr (std::is_same_v<Figure, Aabb3>) {
      const Point3 min = point();
      return {min, {min.x + 0.25, min.y + 0.5, min.z + 0.75}};
    } else if constexpr (std::is_same_v<Figure, Segment3>) {
      return {point(), point()};
    } else if constexpr (std::is_same_v<Figure, Tetrahedron3>) {
      return {point(), point(), point(), point()};
    } else {
      return {point(), point(), point()};
    }
  }

 private:
  Entropy entropy_;
  Vector3 at_{};
};

template <class A, class B>
void hold_misses() {
  SCOPED_TRACE(__PRETTY_FUNCTION__);
  int misses = 0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    Random random(index);
    const A a = random.figure<A>();
    const B b = random.figure<B>();
    const bool missed = !intersects(a, b);
    const int before = allocations;
    const bool empty = intersection(a, b).empty();
    const int made = allocations - before;
    EXPECT_EQ(empty, missed) << index;
    if (!missed) continue;
    ++misses;
    EXPECT_EQ(made, 0u) << index;
  }
  EXPECT_GE(misses, 50);
  EXPECT_LE(misses, 398);
  on_shapes(51, 400, [](Material& m) {  // degenerate ones, too, if not for nothing
    const A a = m.shape<A>();
    const B b = m.shape<B>();
    EXPECT_EQ(intersection(a, b).empty(), !intersects(a, b)) << m.about(a, b);
  });
}

TEST(IntersectionMiss, OfPlanesAllocatesNothing) {
  hold_misses<Plane3, Triangle3>();
  hold_misses<Plane3, Tetrahedron3>();
  hold_misses<Plane3, Aabb3>();
  hold_misses<Plane3, Obb3>();
  hold_misses<ThreePointPlane3, Triangle3>();
  hold_misses<ThreePointPlane3, Tetrahedron3>();
  hold_misses<ThreePointPlane3, Aabb3>();
  hold_misses<ThreePointPlane3, Obb3>();
  hold_misses<Halfspace3, Triangle3>();
}

TEST(IntersectionMiss, OfOthersWithSignsOfTheirOwnAllocatesNothing) {
  hold_misses<Segment3, Plane3>();
  hold_misses<Segment3, ThreePointPlane3>();
  hold_misses<Segment3, Triangle3>();
  hold_misses<Segment3, Tetrahedron3>();
  hold_misses<Segment3, Aabb3>();
  hold_misses<Triangle3, Triangle3>();
  hold_misses<Triangle3, Tetrahedron3>();
  hold_misses<Triangle3, Aabb3>();
}

}  // namespace
}  // namespace plumb
