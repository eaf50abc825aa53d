// How much stack do questions take?  As much as docs/environment.md says, on a thread whose stack is read afterwards.
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "certify/sanitized.hpp"
#include "plumb/plumb.hpp"

namespace plumb {
namespace {

constexpr std::size_t all_of_stack = std::size_t{1} << 20, kib = 1024;

/// The bytes of stack that were written below where the thread began.
std::size_t stack_of(const std::function<void()>& work) {
  auto* const stack = static_cast<unsigned char*>(
      ::mmap(nullptr, all_of_stack, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  if (stack == MAP_FAILED) return all_of_stack;
  std::memset(stack, 0xa5, all_of_stack);
  pthread_attr_t attributes;
  ::pthread_attr_init(&attributes);
  ::pthread_attr_setstack(&attributes, stack, all_of_stack);
  pthread_t thread{};
  const auto begin = [](void* given) -> void* {
    (*static_cast<const std::function<void()>*>(given))();
    return nullptr;
  };
  EXPECT_EQ(::pthread_create(&thread, &attributes, begin, const_cast<std::function<void()>*>(&work)), 0);
  ::pthread_join(thread, nullptr);
  ::pthread_attr_destroy(&attributes);
  const auto* const lowest = std::find_if(stack, stack + all_of_stack, [](unsigned char b) { return b != 0xa5; });
  const auto used = static_cast<std::size_t>(stack + all_of_stack - lowest);
  ::munmap(stack, all_of_stack);
  return used;
}

TriangleMesh ring(double at) {
  constexpr std::uint32_t n = 40;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const double u = 6.283185307179586 * i / n, v = 6.283185307179586 * k / n, r = 2 + 0.7 * std::cos(v);
      mesh.vertices.push_back({at + r * std::cos(u), r * std::sin(u), 0.7 * std::sin(v)});
    }
  }
  const auto number = [](std::uint32_t i, std::uint32_t k) { return i % n * n + k % n; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
      mesh.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
    }
  }
  return mesh;
}

void expect_at_most(std::size_t most, const std::string& name, const std::function<void()>& work) {
  const std::size_t used = stack_of(work);
  std::printf("%6.1f KiB  %s\n", static_cast<double>(used) / kib, name.c_str());
  if (!battery::sanitized) {
    EXPECT_LE(used, most) << name;
  }
}

const TriangleMesh a = ring(0), b = ring(0.4), c = ring(9);
const Triangle3 t{{0, 0, 0}, {1, 0.1, 0}, {0.2, 1, 0.3}}, touching{{0.5, 0.05, 0}, {3, 1, 1}, {2, -1, 2}};
const double tiny = 0x1p-900, huge = 0x1p900;

// Ordinary input: on a stack of 64 KiB, of which the C library takes some.
TEST(SmallStack, QuestionsAboutTwoFiguresTake48KiB) {
  const std::size_t most = 48 * kib;
  expect_at_most(8 * kib, "nothing", [] {});
  expect_at_most(most, "the four classics, decided at once", [] {
    orient2d({0, 0}, {1, 2}, {3, 4});
    orient3d({0, 0, 0}, {1, 2, 3}, {3, 4, 7}, {1, 9, 3});
    incircle({0, 0}, {1, 2}, {3, 4}, {5, 3});
    insphere({0, 0, 0}, {1, 2, 3}, {3, 4, 7}, {1, 9, 3}, {2, 2, 1});
  });
  expect_at_most(most, "the four classics, by integers", [] {
    orient2d({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3});
    orient3d({0.1, 0.1, 0.1}, {0.2, 0.2, 0.7}, {0.3, 0.3, 0.3}, {0.4, 0.4, 0.9});
    incircle({0.1, 0.1}, {0.1, 0.7}, {0.7, 0.1}, {0.7, 0.7});
    insphere({0.1, 0.1, 0.1}, {0.7, 0.1, 0.1}, {0.1, 0.7, 0.1}, {0.1, 0.1, 0.7}, {0.7, 0.7, 0.7});
  });
  expect_at_most(most, "the four classics, exponents far apart", [] {
    orient3d({tiny, huge, 1}, {huge, tiny, 1}, {1, huge, tiny}, {huge, huge, huge});
    insphere({tiny, huge, 1}, {huge, tiny, 1}, {1, huge, tiny}, {huge, huge, huge}, {1, 1, 1});
  });
  expect_at_most(most, "triangles: relate, distance, intersection", [] {
    relate(t, touching);
    distance(t, touching);
    intersection(t, touching);
  });
  expect_at_most(most, "closest points of segments", [] {
    closest_points(Segment3{{0, 0, 0}, {1, 1, 0.1}}, Segment3{{0.1, 0, 3}, {1, -1, 2}});
  });
  expect_at_most(most, "a ray at a triangle, a box, a ball", [] {
    const Ray3 ray{{-3, 0.1, 0.1}, {1, 0.1, 0.03}};
    first_hit(ray, t);
    first_hit(ray, Aabb3{{0, 0, 0}, {1, 1, 1}});
    first_hit(ray, Sphere3{{0, 0, 0}, 1});
  });
  expect_at_most(most, "boxes and balls in motion", [] {
    first_contact(Translating<Sphere3>{{{0, 0, 0}, 1}, {9, 1, 0}}, Translating<Sphere3>{{{5, 1, 1}, 1}, {0, 0, 0}});
    first_contact(Translating<Aabb3>{{{0, 0, 0}, {1, 1, 1}}, {9, 1, 0}},
                  Translating<Aabb3>{{{5, 1, 1}, {6, 2, 2}}, {0, 0, 0}});
  });
}

TEST(SmallStack, QuestionsAboutManyFiguresTake48KiB) {
  const std::size_t most = 48 * kib;
  const ThreadLimit one(1);
  expect_at_most(most, "a batch of signs", [] {
    const std::vector<Point2> p(10000, {0.1, 0.1}), q(10000, {0.2, 0.3}), r(10000, {0.3, 0.3});
    std::vector<Sign> signs(10000);
    orient2d(p, q, r, signs, Execution::parallel);
  });
  std::vector<Point3> points = a.vertices;
  expect_at_most(most, "a tree of points, nearest", [&] {
    const KdTree3 tree = build_kd_tree(std::span<const Point3>(points));
    nearest(tree, Point3{1, 1, 1}, 8);
  });
  expect_at_most(most, "pairs of boxes", [] {
    std::vector<Aabb3> boxes;
    for (const Point3& p : a.vertices) boxes.push_back({p, {p.x + 0.1, p.y + 0.1, p.z + 0.1}});
    overlapping_pairs(boxes);
  });
  expect_at_most(most, "a mesh's tree", [] { build_bvh(a); });
  const Bvh of_a = build_bvh(a), of_b = build_bvh(b), of_c = build_bvh(c);
  expect_at_most(most, "the nearest triangle", [&] { closest_on_mesh(of_a, {5, 5, 5}); });
  expect_at_most(most, "pairs of triangles", [&] { intersecting_pairs(of_a, of_b); });
}

// A ray keeps the boxes that it may still enter.
TEST(SmallStack, RaysAtMeshesTake128KiB) {
  const ThreadLimit one(1);
  const Bvh of_a = build_bvh(a);
  expect_at_most(128 * kib, "a ray at a mesh", [&] { first_hit(of_a, Ray3{{-9, 0.1, 0.1}, {1, 0, 0}}); });
  expect_at_most(128 * kib, "all hits of a ray", [&] { hits(of_a, Ray3{{-9, 0.1, 0.1}, {1, 0, 0}}); });
  expect_at_most(128 * kib, "is a point inside", [&] { locate(of_a, Point3{2, 0, 0}); });
}

}  // namespace
}  // namespace plumb
