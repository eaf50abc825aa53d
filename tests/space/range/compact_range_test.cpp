// Are a compact tree's triangles those that intersects says of each one, for every shape that can be asked with?
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

template <class Shape>
class CompactRange : public ::testing::Test {};
using Shapes = ::testing::Types<Aabb3, Obb3, Sphere3, Capsule3, Segment3, Halfspace3, HalfspaceIntersection3>;
TYPED_TEST_SUITE(CompactRange, Shapes);

TYPED_TEST(CompactRange, FindsTheTrianglesThatIntersectsNames) {
  std::size_t met = 0, apart = 0;
  shape_cases::on_shapes(989, battery::fitting(120), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(30), m.below(60));
    const CompactBvh small = build_compact_bvh(mesh, {.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(4))});
    const auto shape = m.template shape<TypeParam>();
    Numbers expected;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      if (intersects(Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, shape)) expected.push_back(i);
    }
    EXPECT_EQ(meeting(small, shape), expected) << m.about(shape);
    met += expected.size(), apart += mesh.triangles.size() - expected.size();
  });
  EXPECT_GT(met, battery::fitting(50u));
  EXPECT_GT(apart, battery::fitting(50u));
}

TYPED_TEST(CompactRange, OfManyIsThatOfTheTreeItIsMadeOf) {
  const Bvh bvh = build_bvh(meshes::ring(8));
  const CompactBvh small = compact(bvh);
  std::vector<TypeParam> shapes;
  shape_cases::on_shapes(990, 30, [&](shape_cases::Material& m) { shapes.push_back(m.template shape<TypeParam>()); });
  const std::span<const TypeParam> all(shapes);
  const std::vector<Numbers> expected = meeting(bvh, all);
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(meeting(small, all), expected);
  }
  EXPECT_THROW((void)meeting(small, all, {.progress = [](double) { return false; }}), Cancelled);
}

TYPED_TEST(CompactRange, OfNothingIsNothing) {
  shape_cases::on_shapes(991, 10, [&](shape_cases::Material& m) {
    EXPECT_EQ(meeting(build_compact_bvh(TriangleMesh{}), m.template shape<TypeParam>()), Numbers{});
  });
}

TEST(CompactRangeOfABox, MeetsWhatTouchesIt) {
  const TriangleMesh mesh = meshes::ring(20);
  const CompactBvh small = build_compact_bvh(mesh);
  for (std::uint32_t i = 0; i < mesh.vertices.size(); i += 37) {
    const Point3& p = mesh.vertices[i];
    Numbers about;  // the triangles of that vertex, and no others: it is regular
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& c = mesh.triangles[t];
      if (c[0] == i || c[1] == i || c[2] == i) about.push_back(t);
    }
    EXPECT_EQ(meeting(small, Aabb3{p, p}), about) << i;
  }
  EXPECT_THROW((void)meeting(small, Sphere3{{0, 0, 0}, -1}), InvalidShape);
}

}  // namespace
}  // namespace plumb
