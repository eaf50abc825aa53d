// Do the trees of meshes say of points what the meshes say, triangle by triangle?
#include "plumb/space/ray/inside.hpp"

#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/ray/parity.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;

void check(const TriangleMesh& mesh, const Bvh& bvh, const Point3& p, const std::string& about,
           std::array<long, 3>& told) {
  const Location expected = locate(mesh, p);
  ++told[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
  ASSERT_EQ(locate(bvh, p), expected) << about;
  ASSERT_EQ(contains(bvh, p), expected != Location::outside) << about;
  ASSERT_EQ(winding_number(bvh, p), winding_number(mesh, p)) << about;
}

TEST(Inside, IsWhatEveryTriangleSays) {
  std::array<long, 3> told{};
  on_shapes(981, battery::fitting(600), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 30);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    for (int k = 0; k < 5; ++k) check(mesh, bvh, m.probe3(), m.about(), told);
  });
  for (const long n : told) EXPECT_GT(n, battery::fitting(50));
}

TEST(Inside, OfClosedMeshes) {
  std::array<long, 3> told{};
  for (const TriangleMesh& mesh : {meshes::ring(8), solids::turned(solids::hollow_torus(3, 1, 16, 8))}) {
    const Bvh bvh = build_bvh(mesh);
    std::vector<Point3> points;
    for (std::uint64_t i = 0; i < 300; ++i) {
      Entropy e(982, i);
      const Point3& p = mesh.vertices[e.below(mesh.vertices.size())];
      const auto part = static_cast<double>(e.within(8)) / 8;
      points.push_back(i % 3 == 0   ? p
                       : i % 3 == 1 ? Point3{p.x, p.y * part, p.z}
                                    : Point3{p.x * 0.9, p.y * 0.9, p.z * part});
      check(mesh, bvh, points.back(), "index " + std::to_string(i), told);
    }
    for (const Execution execution : {Execution::serial, Execution::parallel}) {
      std::vector<Location> where(points.size());
      std::vector<std::optional<std::int64_t>> winding(points.size());
      locate(bvh, points, where, execution);
      winding_number(bvh, points, winding, execution);
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(where[i], locate(bvh, points[i]));
        EXPECT_EQ(winding[i], winding_number(bvh, points[i]));
      }
    }
  }
  for (const long n : told) EXPECT_GT(n, 40);
}

TEST(Inside, OfNothingIsOutside) {
  const Bvh nothing = build_bvh(TriangleMesh{});
  EXPECT_EQ(locate(nothing, Point3{0, 0, 0}), Location::outside);
  EXPECT_EQ(winding_number(nothing, Point3{0, 0, 0}), 0);
}

TEST(Inside, RefusesWhatIsNoPoint) {
  const Bvh bvh = build_bvh(meshes::ring(4));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(text_of<NonFinite>([&] { (void)locate(bvh, Point3{nan, 0, 0}); }).starts_with("locate: p.x is nan"));
  std::vector<Location> out(1);
  EXPECT_EQ(text_of<UnequalLengths>([&] { locate(bvh, std::vector<Point3>(2), out); }),
            "locate: out has 1 items, points has 2");
}

}  // namespace
}  // namespace plumb
