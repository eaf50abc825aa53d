// Does what a cache holds change an answer?  Of boxes and polyhedra, whatever frames it is of, and whatever is in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/contact/contact.hpp"
#include "query/contact/turned_box.hpp"

namespace plumb {
namespace {

/// Boxes, as they stand and under a rigid pose, that tremble, jump, touch and part.
TEST(ContactCache, OfOtherFramesChangesNothing) {
  std::array<int, 3> seen{};
  for (std::uint64_t i = 0; i < (battery::sanitized ? 10U : 400U); ++i) {
    Entropy entropy(46, i);
    const auto noise = [&](double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
    const double tremor = std::ldexp(1.0, -static_cast<int>(entropy.bits(6))), turn = noise(3);
    const Vector3 half{0.5, 0.25 + 0.25 * static_cast<double>(entropy.bits(1)), 0.5};
    const Obb3 under = turned_box({0, 0, 0}, noise(3), i % 3 == 0 ? noise(1) : 0, {1 + noise(0.5), 0.5, 1});
    const Vector3 up = under.axes[1];
    ContactCache cache;
    for (int frame = 0; frame < 6; ++frame) {
      const double height = 0.5 + half.y + (frame == 3 ? noise(1) : noise(tremor));
      Obb3 box = i % 2 == 0 ? turned_box({0, 0, 0}, turn + noise(tremor), noise(tremor), half) : under;
      if (i % 2 != 0) box.half = half;  // its edges are parallel to those of the other
      box.center = {up.x * height + noise(tremor), up.y * height, up.z * height + noise(tremor)};
      const ContactManifoldOptions options{.margin = 0.5};
      const auto m = contact(box, under, options, &cache);
      EXPECT_EQ(m, contact(box, under, options)) << i << " frame " << frame;
      if (m) ++seen[static_cast<std::size_t>(static_cast<int>(m->relation) + 1)];
      const RigidPose pose{{1, noise(tremor), 0.25, 0}, {0.1, 0, 0}};
      if (i % 5 == 0) {
        const Posed posed{box, pose};
        EXPECT_EQ(contact(posed, under, options, &cache), contact(posed, under, options)) << i << " frame " << frame;
      }
    }
  }
  std::printf("apart %d, touching %d, overlapping %d\n", seen[0], seen[1], seen[2]);
  EXPECT_GT(std::min(seen[0], seen[2]), 0);
}

/// Polyhedra that move by little, jump, touch and part; the cache is that of the frame before, of another question, or
/// filled with anything.
TEST(ContactCache, OfPolyhedraChangesNoDepthAndNoContact) {
  std::array<int, 4> seen{};
  for (std::uint64_t i = 0; i < (battery::sanitized ? 4U : 150U); ++i) {
    Entropy entropy(47, i);
    const auto noise = [&](double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
    const bool is_on_grid = i % 3 == 0;
    const auto number = [&] { return is_on_grid ? static_cast<double>(entropy.bits(2)) - 1.5 : noise(1); };
    const auto points = [&] {
      std::vector<Point3> p{{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, {-0.5, -0.5, 0.5}};
      const std::size_t size = 5 + entropy.bits(4);
      while (p.size() < size) p.push_back({number(), number(), number()});
      return p;
    };
    const auto of_a = points(), of_b = points();
    const auto b = convex_polyhedron(convex_hull(of_b), of_b);
    ContactCache cache, of_depth;
    for (int frame = 0; frame < 6; ++frame) {
      const double jump = frame == 3 ? 2 : 1, tremor = is_on_grid ? 0 : 0x1p-6;
      std::vector<Point3> moved;
      const Vector3 by{jump + noise(tremor), noise(tremor), frame == 4 ? noise(1) : 0};
      for (const Point3& p : of_a) moved.push_back({p.x + by.x, p.y + by.y, p.z + by.z});
      const auto a = convex_polyhedron(convex_hull(moved), moved);
      if (frame == 5) {
        for (auto& e : cache.corners)
          e = {static_cast<std::uint32_t>(entropy.bits(4)), static_cast<std::uint32_t>(entropy.bits(3))};
        cache.size = 4, of_depth = cache;
      }
      const auto m = contact(a, b, {.margin = 0.5});
      EXPECT_EQ(m, contact(a, b, {.margin = 0.5}, &cache)) << i << " frame " << frame;
      const auto p = penetration(a, b);
      EXPECT_EQ(p, penetration(a, b, &of_depth)) << i << " frame " << frame;
      EXPECT_EQ(p, penetration(a, b, &cache)) << i << " frame " << frame;
      ++seen[m ? static_cast<std::size_t>(static_cast<int>(m->relation) + 1) : 3];
    }
  }
  std::printf("apart %d, touching %d, overlapping %d, no contact %d\n", seen[0], seen[1], seen[2], seen[3]);
  EXPECT_GT(std::ranges::min(seen), 0);
}

}  // namespace
}  // namespace plumb
