// Does a contact of boxes take memory where doubles decide?  Every allocation of this program is counted, those of GMP as
// well.
#include <gmp.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>

#include "plumb/query/contact/contact.hpp"

namespace {

int taken = 0;

void* counted(std::size_t size) {
  ++taken;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void* counted_again(void* p, std::size_t, std::size_t size) {
  ++taken;
  return std::realloc(p, size);
}
void released(void* p, std::size_t) { std::free(p); }

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace plumb {
namespace {

/// Turned about the upright axis, then down a slope.
std::array<Vector3, 3> axes(double yaw, double slope) {
  const double c = std::cos(yaw), s = std::sin(yaw), d = std::cos(slope), t = std::sin(slope);
  return {Vector3{c * d, c * t, -s}, Vector3{-t, d, 0}, Vector3{s * d, s * t, c}};
}

/// How many of 64 crates on a table or a slope, turned about the upright axis, take memory.
int takers(double slope, double height, bool with_cache) {
  mp_set_memory_functions(counted, counted_again, released);
  int count = 0;
  for (int i = 0; i < 64; ++i) {
    const auto under = axes(0, slope), upon = axes(0.1 * i + 0.05, slope);
    const Vector3 up = under[1];
    const double h = 1 + height;
    const Obb3 crate{{h * up.x, h * up.y, h * up.z}, upon, {0.5, 0.5, 0.5}}, ground{{0, 0, 0}, under, {8, 0.5, 8}};
    ContactCache cache;
    for (int frame = 0; frame < 2; ++frame) {
      const int before = taken;
      const auto m = contact(crate, ground, {.margin = 0.01}, with_cache ? &cache : nullptr);
      count += taken == before ? 0 : 1;
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
  const int before = taken;
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}};
  EXPECT_TRUE(exact_contact(box, box));  // in rational numbers
  EXPECT_GT(taken, before);
}

}  // namespace
}  // namespace plumb
