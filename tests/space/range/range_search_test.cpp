// Are the triangles those that intersects says of each one, for every shape that can be asked with?
#include "plumb/space/range/range_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

template <class Shape>
Numbers by_brute_force(const TriangleMesh& mesh, const Shape& shape) {
  Numbers numbers;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (intersects(Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, shape)) numbers.push_back(i);
  }
  return numbers;
}

template <class Shape>
class RangeSearch : public ::testing::Test {};
using Shapes = ::testing::Types<Aabb3, Obb3, Sphere3, Capsule3, Segment3, Halfspace3, HalfspaceIntersection3>;
TYPED_TEST_SUITE(RangeSearch, Shapes);

TYPED_TEST(RangeSearch, FindsTheTrianglesThatIntersectsNames) {
  std::size_t met = 0, apart = 0;
  shape_cases::on_shapes(971, battery::fitting(150), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(20), m.below(40));
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(4))});
    const auto shape = m.template shape<TypeParam>();
    const Numbers expected = by_brute_force(mesh, shape);
    EXPECT_EQ(meeting(bvh, shape), expected) << m.about(shape);
    met += expected.size(), apart += mesh.triangles.size() - expected.size();
  });
  EXPECT_GT(met, battery::fitting(50u));
  EXPECT_GT(apart, battery::fitting(50u));
}

TYPED_TEST(RangeSearch, OfManyIsThatOfEach) {
  const TriangleMesh mesh = meshes::ring(battery::sanitized ? 3 : 6);
  const Bvh bvh = build_bvh(mesh);
  std::vector<TypeParam> shapes;
  std::vector<Numbers> expected;
  shape_cases::on_shapes(972, 20, [&](shape_cases::Material& m) {
    shapes.push_back(m.template shape<TypeParam>());
    expected.push_back(by_brute_force(mesh, shapes.back()));
  });
  const std::span<const TypeParam> all(shapes);
  EXPECT_EQ(meeting(bvh, all, {.execution = Execution::serial}), expected);
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(meeting(bvh, all), expected);
  }
  const auto stopped = [&] { (void)meeting(bvh, all, {.progress = [](double) { return false; }}); };
  EXPECT_THAT(text_of<Cancelled>(stopped), ::testing::HasSubstr("meeting: cancelled"));
}

TYPED_TEST(RangeSearch, OfNothingIsNothing) {
  shape_cases::on_shapes(973, 10, [&](shape_cases::Material& m) {
    EXPECT_EQ(meeting(build_bvh(TriangleMesh{}), m.template shape<TypeParam>()), Numbers{});
  });
}

// A camera's frustum: the near and far planes, and four sides through its eye.
TEST(RangeSearchOfAFrustum, CullsWhatIsOutside) {
  const TriangleMesh mesh = meshes::ring(20);
  const Bvh bvh = build_bvh(mesh);
  std::size_t met = 0;
  for (int i = 0; i < 12; ++i) {
    const double x = 0.25 * i - 1.5, slope = 0.25;
    const HalfspaceIntersection3 frustum{{{{1, 0, -slope}, x},
                                          {{-1, 0, -slope}, -x},
                                          {{0, 1, -slope}, 0.5},
                                          {{0, -1, -slope}, -0.5},
                                          {{0, 0, -1}, 0.125},
                                          {{0, 0, 1}, 3}}};
    const Numbers expected = by_brute_force(mesh, frustum);
    EXPECT_EQ(meeting(bvh, frustum), expected) << i;
    met += expected.size();
  }
  EXPECT_GT(met, 50u);
}

TEST(RangeSearchOfAFrustum, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Bvh none = build_bvh(TriangleMesh{});
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)meeting(none, Sphere3{{0, nan, 0}, 1});
              }),
              ::testing::HasSubstr("sphere.center.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)meeting(none, Sphere3{{0, 0, 0}, -1});
              }),
              ::testing::HasSubstr("intersects: "));
  EXPECT_EQ(meeting(build_bvh(meshes::ring(3)), Aabb3{{1, 1, 1}, {-1, -1, -1}}), Numbers{});
}

}  // namespace
}  // namespace plumb
