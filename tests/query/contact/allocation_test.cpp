// Does a contact of boxes take memory where doubles decide?  Every allocation of this program is counted, those of GMP as
// well.
#include <gtest/gtest.h>

#include <cmath>

#include "counted_allocations.hpp"
#include "plumb/query/contact/contact.hpp"

namespace plumb {
namespace {

/// Turned about the upright axis, then down a slope.
std::array<Vector3, 3> axes(double yaw, double slope) {
  const double c = std::cos(yaw), s = std::sin(yaw), d = std::cos(slope), t = std::sin(slope);
  return {Vector3{c * d, c * t, -s}, Vector3{-t, d, 0}, Vector3{s * d, s * t, c}};
}

/// How many of 64 crates on a table or a slope, turned about the upright axis, take memory in one of three frames, of
/// which the last is the one before; a cache takes it once.
int takers(double slope, double height, bool with_cache) {
  int count = 0;
  for (int i = 0; i < 64; ++i) {
    const auto under = axes(0, slope), upon = axes(0.1 * i + 0.05, slope);
    const Vector3 up = under[1];
    const Obb3 ground{{0, 0, 0}, under, {8, 0.5, 8}};
    ContactCache cache;
    for (int frame = 0; frame < 3; ++frame) {
      const double h = 1 + height + (frame == 0 ? 0x1p-12 : 0);
      const Obb3 crate{{h * up.x, h * up.y, h * up.z}, upon, {0.5, 0.5, 0.5}};
      const int before = allocations, most = with_cache && frame == 0 ? 1 : 0;
      const auto m = contact(crate, ground, {.margin = 0.01}, with_cache ? &cache : nullptr);
      count += allocations - before <= most ? 0 : 1;
      EXPECT_EQ(m->corners.size(), 4U);
    }
  }
  return count;
}

TEST(ContactAllocations, NoneOfCratesThatRestOrNearlyDo) {
  for (const double slope : {0.0, 0.3}) {
    for (const double height : {1e-3, 0.0, -1e-3}) {
      for (const bool with_cache : {false, true}) EXPECT_EQ(takers(slope, height, with_cache), 0) << slope << height;
    }
  }
}

TEST(ContactAllocations, AreCounted) {
  const int before = allocations;
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}};
  EXPECT_TRUE(exact_contact(box, box));  // in rational numbers
  EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace plumb
