// Does the Hausdorff distance lie between the two numbers, and are they as near to one another as was asked for?
#include "plumb/space/closest/hausdorff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;

Triangle3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Is the exact distance of a point from the mesh at most, at least this?
bool is_at_most(const Point3& p, const TriangleMesh& mesh, double d) {
  if (d == std::numeric_limits<double>::infinity()) return true;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (compare_distance(p, at(mesh, i), d) != Sign::positive) return true;
  }
  return false;
}
bool is_at_least(const Point3& p, const TriangleMesh& mesh, double d) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (compare_distance(p, at(mesh, i), d) == Sign::negative) return false;
  }
  return true;
}

/// At least the distance of every point of a from b, by one triangle of b for each of a, without pieces.
double bound_by_brute_force(const TriangleMesh& a, const TriangleMesh& b) {
  double all = 0;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < b.triangles.size(); ++k) {
      double most = 0;
      for (const Point3& p : {at(a, i).a, at(a, i).b, at(a, i).c}) most = std::max(most, distance(p, at(b, k)));
      best = std::min(best, most);
    }
    all = std::max(all, best);
  }
  return all;
}

/// Points that are on the triangle: sums of corners whose numbers are exact on a lattice.
std::vector<Point3> lattice_samples(const Triangle3& t, int n) {
  std::vector<Point3> samples;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; i + k <= n; ++k) {
      const double u = 1.0 * i / n, v = 1.0 * k / n, w = 1 - u - v;
      samples.push_back(
          {w * t.a.x + u * t.b.x + v * t.c.x, w * t.a.y + u * t.b.y + v * t.c.y, w * t.a.z + u * t.b.z + v * t.c.z});
    }
  }
  return samples;
}

void expect_true(const HausdorffDistance& h, const TriangleMesh& a, const TriangleMesh& b, const std::string& about) {
  EXPECT_LE(h.least, h.most) << about;
  EXPECT_GE(h.least, 0) << about;
  EXPECT_LE(h.least, bound_by_brute_force(a, b)) << about;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (const Point3& p : {at(a, i).a, at(a, i).b, at(a, i).c}) EXPECT_TRUE(is_at_most(p, b, h.most)) << about;
  }
  const Triangle3 from = at(a, h.from);
  if (h.point == from.a || h.point == from.b || h.point == from.c) {
    EXPECT_TRUE(is_at_least(h.point, b, h.least)) << about;
  }
  EXPECT_EQ(h.to, closest_on_mesh(build_bvh(b), h.point)->triangle) << about;
}

TriangleMesh box(double low, double high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back({(i & 1) != 0 ? high : low, (i & 2) != 0 ? high : low, (i & 4) != 0 ? high : low});
  }
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh square(double from, double to, double z) {
  return {{{from, 0, z}, {to, 0, z}, {to, 4, z}, {from, 4, z}}, {{0, 1, 2}, {0, 2, 3}}};
}

void expect_within(const HausdorffDistance& h, const Rational& square) {
  EXPECT_TRUE(h.is_within);
  EXPECT_LE(Rational(h.least) * Rational(h.least), square);
  EXPECT_GE(Rational(h.most) * Rational(h.most), square);
  EXPECT_LE(h.most - h.least, 0x1p-10 * h.most);
}

TEST(Hausdorff, OfKnownMeshes) {
  const Bvh small = build_bvh(box(0, 4)), large = build_bvh(box(-1, 5));
  expect_within(hausdorff_from(small, large), 1);
  expect_within(hausdorff_from(large, small), 3);
  expect_within(hausdorff_distance(small, large), 3);
  EXPECT_TRUE(hausdorff_distance(small, large).of_b);
  EXPECT_FALSE(hausdorff_distance(large, small).of_b);

  const Bvh plane = build_bvh(square(0, 4, 0));
  expect_within(hausdorff_distance(plane, build_bvh(square(0, 4, 3))), 9);
  expect_within(hausdorff_distance(plane, build_bvh(square(1, 5, 0))), 1);

  const Bvh tent = build_bvh(TriangleMesh{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 2}},
                                          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
  expect_within(hausdorff_from(tent, plane), 4);
  expect_within(hausdorff_from(plane, tent), 2);  // the middle, from four faces
  const auto h = hausdorff_from(tent, plane);
  EXPECT_EQ(h.point, (Point3{2, 2, 2}));
  EXPECT_EQ(h.least, 2);
}

TEST(Hausdorff, OfAMeshAndItselfIsZero) {
  shape_cases::on_shapes(971, battery::fitting(60), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const HausdorffDistance h = hausdorff_distance(build_bvh(mesh), build_bvh(mesh));
    EXPECT_EQ(h.least, 0) << m.about();
    EXPECT_EQ(h.most, 0) << m.about();
    EXPECT_TRUE(h.is_within);
  });
  const Bvh ring = build_bvh(meshes::ring(20));
  EXPECT_EQ(hausdorff_distance(ring, ring).most, 0);
}

TEST(Hausdorff, LiesBetweenForMeshesOfAnyKind) {
  std::size_t within = 0, all = 0;
  shape_cases::on_shapes(972, battery::fitting(250), [&](shape_cases::Material& m) {
    const TriangleMesh a = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const TriangleMesh b = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const auto h = hausdorff_from(build_bvh(a), build_bvh(b), {.relative = 0.125, .of_size = 0, .most_pieces = 200});
    expect_true(h, a, b, m.about());
    EXPECT_TRUE(!h.is_within || h.most - h.least <= 0.125 * h.most) << m.about();
    within += h.is_within ? 1 : 0, ++all;
  });
  EXPECT_GT(within * 10, all * 8);
}

/// Triangles with corners on a lattice, some of them segments.
TriangleMesh drawn_on_lattice(Entropy& entropy, std::uint32_t n, std::int64_t most, double unit) {
  TriangleMesh mesh;
  for (std::uint32_t k = 0; k < n; ++k) {
    const auto number = [&] { return static_cast<double>(entropy.within(most)) * unit; };
    for (int c = 0; c < 3; ++c) mesh.vertices.push_back({number(), number(), number()});
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + (entropy.below(5) == 0 ? 1 : 2)});
  }
  return mesh;
}

/// On the lattice of 1 / 64, where samples are exact.
TEST(Hausdorff, LiesAboveEverySample) {
  for (std::uint64_t i = 0; i < battery::fitting(60u); ++i) {
    Entropy entropy(973, i);
    const TriangleMesh a = drawn_on_lattice(entropy, 4, 256, 0x1p-6), b = drawn_on_lattice(entropy, 6, 256, 0x1p-6);
    const auto h = hausdorff_from(build_bvh(a), build_bvh(b), {.relative = 0x1p-6});
    EXPECT_TRUE(h.is_within) << i;
    expect_true(h, a, b, "start 973 index " + std::to_string(i));
    double farthest = 0;
    for (std::size_t k = 0; k < a.triangles.size(); ++k) {
      for (const Point3& p : lattice_samples(at(a, k), 16)) {
        EXPECT_TRUE(is_at_most(p, b, h.most)) << i;
        farthest = std::max(farthest, closest_on_mesh(build_bvh(b), p)->distance);
      }
    }
    EXPECT_GE(farthest * 1.25, h.least) << i;  // samples are dense
    EXPECT_LT(distance(h.point, at(a, h.from)), 1e-12) << i;
  }
}

/// Far from the origin no middle of an edge is a double; the distance is the same.
TEST(Hausdorff, CountsHowFarOffCutsAre) {
  for (std::uint64_t i = 0; i < battery::fitting(60u); ++i) {
    Entropy entropy(974, i);
    TriangleMesh a = drawn_on_lattice(entropy, 3, 16, 1), b = drawn_on_lattice(entropy, 3, 16, 1);
    const auto here = hausdorff_from(build_bvh(a), build_bvh(b), {.relative = 0x1p-12});
    for (TriangleMesh* mesh : {&a, &b}) {
      for (Point3& p : mesh->vertices) p = {p.x + 0x1p52, p.y - 0x1p52 - 64, p.z + 0x1p52};
    }
    const auto there = hausdorff_from(build_bvh(a), build_bvh(b), {.relative = 0x1p-12, .most_pieces = 500});
    EXPECT_TRUE(here.is_within) << "start 974 index " << i;
    EXPECT_LE(there.least, here.most) << "start 974 index " << i;
    EXPECT_GE(there.most, here.least) << "start 974 index " << i;
  }
}

TEST(Hausdorff, OfNumbersOfAnySizeAndTreesInOtherFrames) {
  for (const int exponent : {-1070, -600, 0, 500, 1018}) {
    TriangleMesh a = box(0, 4), b = box(-1, 5);
    for (TriangleMesh* mesh : {&a, &b}) {
      for (Point3& p : mesh->vertices) {
        p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
      }
    }
    const auto h =
        hausdorff_from(build_bvh(b), build_bvh(a), {.absolute = std::ldexp(1.0, exponent), .most_pieces = 99});
    expect_true(h, b, a, std::to_string(exponent));
    EXPECT_TRUE(h.is_within) << exponent;
    EXPECT_GE(h.most, std::ldexp(1.73, exponent));
    EXPECT_LE(h.least, std::ldexp(1.74, exponent));
  }
  const double most = std::numeric_limits<double>::max();
  const Bvh left = build_bvh(TriangleMesh{{{-most, 0, 0}}, {{0, 0, 0}}});
  const Bvh right = build_bvh(TriangleMesh{{{most, 0, 0}, {most, 1, 0}, {most, 0, 1}}, {{0, 1, 2}}});
  const HausdorffDistance h = hausdorff_distance(left, right);
  EXPECT_EQ(h.least, most);
  EXPECT_EQ(h.most, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(h.is_within);
}

/// A square of 2 n^2 triangles.
TriangleMesh tiles(std::uint32_t n, bool turned) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) mesh.vertices.push_back({4.0 * k / n, 4.0 * i / n, 0});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, turned ? c : d}, {d, c, turned ? b : a}});
    }
  }
  return mesh;
}

/// The same surface in other triangles: no piece but a small one is in a triangle, unless it is cut where that ends.
TEST(Hausdorff, OfOneSurfaceInOtherTrianglesIsAsGoodAsZero) {
  const Bvh one = build_bvh(tiles(1, false)), turned = build_bvh(tiles(1, true));
  const HausdorffDistance exact = hausdorff_distance(one, turned, {.of_size = 0});
  EXPECT_EQ(exact.most, 0);
  for (const auto& [n, m] : {std::pair{7u, 5u}, {6u, 6u}, {3u, 8u}}) {
    const HausdorffDistance h = hausdorff_distance(build_bvh(tiles(n, false)), build_bvh(tiles(m, true)));
    EXPECT_TRUE(h.is_within) << n;
    EXPECT_LE(h.most, 4e-12) << n;
  }
}

TEST(Hausdorff, SaysThatItIsNotWithin) {
  const TriangleMesh a = tiles(7, false), b = tiles(5, true);
  const HausdorffDistance few = hausdorff_distance(build_bvh(a), build_bvh(b), {.most_pieces = 10});
  EXPECT_FALSE(few.is_within);
  EXPECT_EQ(few.least, 0);
  EXPECT_GT(few.most, 0.125);
  const HausdorffDistance more = hausdorff_distance(build_bvh(a), build_bvh(b), {.absolute = 0.125});
  EXPECT_TRUE(more.is_within);
  EXPECT_LE(more.most, 0.125);
}

TEST(Hausdorff, DependsOnNoTreeNorThreads) {
  TriangleMesh moved = meshes::ring(8);
  for (Point3& p : moved.vertices) p = {p.x + 0.1 * p.y, p.y, p.z - 0.05};
  const Bvh a = build_bvh(meshes::ring(9)), b = build_bvh(moved);
  const auto expected = hausdorff_distance(a, b, {.most_pieces = 2000, .execution = Execution::serial});
  expect_true(hausdorff_from(a, b, {.most_pieces = 2000}), meshes::ring(9), moved, "rings");
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    double last = 0;
    const auto watched = hausdorff_distance(a, b, {.most_pieces = 2000, .progress = [&](double share) {
                                                     EXPECT_GE(share, last);
                                                     last = share;
                                                     return true;
                                                   }});
    EXPECT_EQ(watched, expected);
    EXPECT_EQ(last, 1);
    EXPECT_EQ(hausdorff_distance(build_bvh(meshes::ring(9), {.method = BvhMethod::linear}), b, {.most_pieces = 2000}),
              expected);
  }
  const auto stopped = [&] { (void)hausdorff_from(a, b, {.progress = [](double) { return false; }}); };
  EXPECT_THAT(text_of<Cancelled>(stopped), HasSubstr("hausdorff_from: cancelled"));
}

TEST(Hausdorff, NamesWhatIsWrong) {
  const Bvh none = build_bvh(TriangleMesh{{{0, 0, 0}}, {}}), some = build_bvh(meshes::ring(3));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)hausdorff_from(none, some); }),
              HasSubstr("hausdorff_from: a is empty"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)hausdorff_distance(some, none); }),
              HasSubstr("hausdorff_distance: b is empty"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)hausdorff_from(some, some, {.relative = -1}); }),
              HasSubstr("options.relative is -1"));
}

}  // namespace
}  // namespace plumb
