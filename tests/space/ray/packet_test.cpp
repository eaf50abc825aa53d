// Do rays that descend together find what each of them finds alone?  Batches that lie close together, that do not, and
// of both, at meshes whose vertices, edges and planes they meet exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "space/ray/ray_order.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

enum class Batch : int { camera, parallel, in_planes, any, mixed };
constexpr std::uint64_t batches = 5;

double whole(Entropy& e, std::int64_t most) { return static_cast<double>(e.within(most)); }

/// Squares of whole corners, at few heights: many triangles lie in one plane.
TriangleMesh steps(Entropy& e, std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
    const double height = e.below(4) == 0 ? whole(e, 2) : 0;
    mesh.vertices.push_back({1.0 * (i % (n + 1)), 1.0 * (i / (n + 1)), height});
  }
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const std::uint32_t a = (n + 1) * (i / n) + i % n;
    mesh.triangles.push_back({a, a + 1, a + n + 2});
    mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    if (e.below(20) == 0) mesh.triangles.push_back({a, a, a + n + 2});
  }
  return mesh;
}

AnyRay any_ray(Entropy& e) {
  const Point3 a{whole(e, 8), whole(e, 8), whole(e, 4)}, b{whole(e, 8), whole(e, 8), whole(e, 4)};
  const Vector3 d{b.x - a.x, b.y - a.y, b.z - a.z};  // which may be zero
  switch (e.below(3)) {
    case 0:
      return Segment3{a, b};
    case 1:
      return Line3{a, d};
    default:
      return Ray3{a, d};
  }
}

/// From places to places, all of one kind.
std::vector<AnyRay> rays_of(Entropy& e, Batch batch, std::size_t n) {
  const double step = e.below(2) == 0 ? 0.5 : 0.3;
  const Point3 eye{whole(e, 12), whole(e, 12), 3 + whole(e, 2)}, at{whole(e, 6), whole(e, 6), 0};
  const Vector3 way{whole(e, 1), whole(e, 1), -1 + whole(e, 1)};
  const std::uint64_t kind = e.below(3);
  std::vector<AnyRay> rays;
  for (std::size_t i = 0; i < n; ++i) {
    if (batch == Batch::any || (batch == Batch::mixed && e.below(12) == 0)) {
      rays.push_back(any_ray(e));
      continue;
    }
    const double u = step * static_cast<double>(i % 8), v = step * static_cast<double>(i / 8);
    Point3 a = eye, b{at.x + u, at.y + v, at.z};
    if (batch == Batch::parallel) {
      a = {b.x - 4 * way.x, b.y - 4 * way.y, b.z - 4 * way.z};
    } else if (batch == Batch::in_planes) {
      a = {-1, v, 0}, b = {9, v + u, 0};
    }
    const Vector3 d{b.x - a.x, b.y - a.y, b.z - a.z};
    if (kind == 0) {
      rays.emplace_back(Segment3{a, b});
    } else if (kind == 1) {
      rays.emplace_back(Line3{a, d});
    } else {
      rays.emplace_back(Ray3{a, d});
    }
  }
  return rays;
}

void scale(TriangleMesh& mesh, std::vector<AnyRay>& rays, int exponent) {
  const auto scaled = [&](auto& p) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = std::ldexp(*x, exponent);
  };
  for (Point3& p : mesh.vertices) scaled(p);
  for (AnyRay& r : rays) {
    scaled(r.origin);
    scaled(r.end);
  }
}

/// How many are hit?
template <class Mesh>
std::size_t check(const std::vector<AnyRay>& rays, const Mesh& mesh, const ManyRays& options) {
  std::vector<std::optional<NumberedHit>> first(rays.size());
  std::vector<std::uint32_t> triangle(rays.size());
  std::vector<std::uint8_t> any(rays.size());
  std::vector<std::size_t> count(rays.size());
  std::vector<std::vector<NumberedHit>> ordered(rays.size());
  first_hit(mesh, rays, first, options);
  first_triangle(mesh, rays, triangle, options);
  any_hit(mesh, rays, any, options);
  count_hits(mesh, rays, count, options);
  hits(mesh, rays, ordered, options);
  std::size_t hit = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto alone = first_hit(mesh, rays[i], options.rule);
    const std::string about = "ray " + std::to_string(i) + " " + mesh_rays::text_of(rays[i]);
    EXPECT_EQ(first[i], alone) << about;
    EXPECT_EQ(triangle[i], alone ? alone->index : no_triangle) << about;
    EXPECT_EQ(any[i], alone ? 1 : 0) << about;
    EXPECT_EQ(count[i], count_hits(mesh, rays[i], options.rule)) << about;
    EXPECT_EQ(ordered[i], hits(mesh, rays[i], options.rule)) << about;
    hit += alone.has_value();
  }
  return hit;
}

TEST(RayPacket, FindsWhatEachRayFinds) {
  const auto sets = batch_instruction_sets();
  std::array<std::size_t, batches> hit{}, asked{};
  for (int n = 0; n < battery::fitting(100); ++n) {
    const auto i = static_cast<std::uint64_t>(n);
    Entropy e(965, i);
    const std::string_view set = sets[i % sets.size()];
    SCOPED_TRACE("index " + std::to_string(i) + ", " + std::string(set));
    certify::batch::take_instruction_set(set);
    const std::size_t batch = e.below(batches);
    TriangleMesh mesh = steps(e, 2 + static_cast<std::uint32_t>(e.below(8)));
    std::vector<AnyRay> rays = rays_of(e, static_cast<Batch>(batch), 1 + e.below(70));
    constexpr std::array exponents{0, 0, 0, -900, 300, 900};
    scale(mesh, rays, exponents[e.below(exponents.size())]);
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(12))});
    const ManyRays options{.rule = e.below(2) == 0 ? HitRule::closed : HitRule::half_open,
                           .execution = e.below(2) == 0 ? Execution::serial : Execution::parallel};
    hit[batch] += e.below(3) == 0 ? check(rays, compact(bvh), options) : check(rays, bvh, options);
    asked[batch] += rays.size();
    for (std::size_t k = 0; k < rays.size(); k += 7) {  // one by one is as every triangle says
      const auto expected = mesh_rays::true_hits(rays[k], mesh, options.rule);
      const auto first = first_triangle(bvh, rays[k], options.rule);
      EXPECT_EQ(first.value_or(no_triangle), expected.empty() ? no_triangle : expected[0].index) << "ray " << k;
    }
    if (HasFailure()) break;
  }
  certify::batch::take_instruction_set({});
  for (std::size_t k = 0; k < batches; ++k) {
    if (battery::reaches_rare) {
      EXPECT_GT(hit[k], asked[k] / 20) << k;
    }
    EXPECT_GT(asked[k], static_cast<std::size_t>(battery::fitting(40))) << k;
  }
}

// Long batches at a closed surface, in rows and in no order: some of each packet end before the others, and some go on
// alone.
TEST(RayPacket, OfACameraFindsWhatEachRayFinds) {
  const Bvh bvh = build_bvh(meshes::ring(24));
  constexpr int side = 50, all = side * side;
  for (const int step : {1, 1237}) {
    std::vector<AnyRay> rays;
    for (int n = 0; n < all; ++n) {
      const int i = n * step % all;
      const double u = 1.0 * (i % side) / side - 0.5, v = 1.0 * (i / side) / side - 0.5;
      rays.emplace_back(Ray3{{2.5, 1.5, 1.8}, {1.6 * u - 0.5 * v - 2.5, -2.6 * u - 1.5, 2 * v - 1.8}});
    }
    const std::size_t hit = check(rays, bvh, {.execution = step == 1 ? Execution::parallel : Execution::serial});
    EXPECT_GT(hit, std::size_t{all / 3});
    EXPECT_LT(hit, std::size_t{8 * all / 9});
  }
}

// A camera that turns about its way: the answer does not depend on how its rows lie.
TEST(RayPacket, AreOfRaysBetweenWhichFewTrianglesLie) {
  const Aabb3 box{{-1, -1, -1}, {1, 1, 1}};
  for (const double angle : {0.0, 0.5, 1.5}) {
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<AnyRay> rays;
    for (int n = 0; n < 2048; ++n) {  // a strip of an image
      const double u = (n % 256) / 128.0 - 1, v = (n / 256) / 128.0;
      rays.emplace_back(Ray3{{0, 0, 4}, {c * u - s * v, s * u + c * v, -4}});
    }
    for (const auto& [triangles, are_near] :
         {std::pair{std::size_t{10'000}, true}, {std::size_t{100'000'000}, false}}) {
      auto [order, near] = space::order_of(rays, box, triangles);
      EXPECT_EQ(near, are_near) << angle;
      std::ranges::sort(order);
      ASSERT_EQ(order.size(), rays.size());
      for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
    }
  }
  EXPECT_TRUE(space::order_of({}, box, 0).order.empty());
}

}  // namespace
}  // namespace plumb
