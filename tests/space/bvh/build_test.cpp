// Does every builder make a tree that keeps the laws, of whatever there is, and the same one for any number of threads?
#include "plumb/space/bvh/build.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using tree_laws::boxes_of;
using tree_laws::broken;

class Build : public ::testing::TestWithParam<BvhMethod> {
 protected:
  // Ten times as many as one thread grows a tree of, but by what is quadratic, and where each is watched.
  const std::size_t many_ = GetParam() == BvhMethod::nearest_pairs ? 1'000 : battery::fitting(160'000);

  [[nodiscard]] BvhOptions options() const { return {.method = GetParam()}; }
  [[nodiscard]] std::string broken_for(const TriangleMesh& mesh, BvhOptions options) const {
    const std::vector<Aabb3> boxes = boxes_of(mesh);
    return broken(build_box_tree(boxes, options), boxes, options.most_in_leaf);
  }
  [[nodiscard]] std::string broken_for(const TriangleMesh& mesh) const { return broken_for(mesh, options()); }
};

TEST_P(Build, KeepsTheLawsOfHardItems) {
  std::size_t scaled = 0;
  shape_cases::on_shapes(901, 300, [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(60), m.below(120));
    BvhOptions o = options();
    o.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(10));
    o.item_cost = static_cast<float>(1 + m.below(8)) / 4;
    EXPECT_EQ(broken_for(mesh, o), "");
    scaled += build_box_tree(boxes_of(mesh), o).frame.exponent() != 0 ? 1 : 0;
  });
  EXPECT_GT(scaled, 30u);
}

TEST_P(Build, KeepsTheLawsOfAMesh) {
  for (const std::uint32_t n : {1u, 2u, 9u, 30u}) EXPECT_EQ(broken_for(meshes::ring(n)), "") << n;
}

TEST_P(Build, TakesEqualItemsAndChains) {
  EXPECT_EQ(broken_for(meshes::repeated(1)), "");
  EXPECT_EQ(broken_for(meshes::repeated(many_)), "");
  EXPECT_EQ(broken_for(meshes::doubling(2000, -1000, 1)), "");
  EXPECT_EQ(broken_for(meshes::doubling(400, -1074, 5)), "");
  BvhOptions one = options();
  one.most_in_leaf = 1;
  EXPECT_EQ(broken_for(meshes::repeated(1000), one), "");
  EXPECT_EQ(broken_for(meshes::doubling(160, -20, 1), one), "");
}

TEST_P(Build, TakesTheEndsOfTheDoubles) {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  for (const double x : {most, 1e300, 1e40, 1e-40, 1e-300, least}) {
    const TriangleMesh mesh{{{-x, x, 0}, {x, -x, x}, {x / 2, 0, -x}, {0, 0, 0}, {1, least, -0.0}},
                            {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 3, 3}, {4, 4, 4}, {0, 0, 1}}};
    EXPECT_EQ(broken_for(mesh), "") << x;
  }
}

TEST_P(Build, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Aabb3> boxes = boxes_of(meshes::ring(GetParam() == BvhMethod::nearest_pairs ? 30 : 100));
  BvhOptions o = options();
  o.execution = Execution::serial;
  const BoxTree serial = build_box_tree(boxes, o);
  o.execution = Execution::parallel;
  for (const std::size_t threads : {1u, 2u, 5u}) {
    const ThreadLimit control(threads);
    const BoxTree parallel = build_box_tree(boxes, o);
    EXPECT_TRUE(std::ranges::equal(serial.nodes, parallel.nodes)) << threads;
    EXPECT_TRUE(std::ranges::equal(serial.items, parallel.items)) << threads;
  }
  EXPECT_EQ(broken(serial, boxes, o.most_in_leaf), "");
}

TEST_P(Build, MakesNothingOfNothing) {
  const BoxTree tree = build_box_tree({}, options());
  EXPECT_TRUE(tree.nodes.empty());
  EXPECT_TRUE(tree.items.empty());
}

INSTANTIATE_TEST_SUITE_P(All, Build, ::testing::ValuesIn(bvh_methods), [](const auto& each) {
  std::string name(name_of(each.param));
  std::ranges::replace(name, ' ', '_');
  return name;
});

TEST(BuildErrors, NameWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Aabb3 unit{{0, 0, 0}, {1, 1, 1}};
  const auto refused = [](const auto& kind, std::vector<Aabb3> boxes, BvhOptions options = {}) {
    return text_of<std::decay_t<decltype(kind)>>([&] { (void)build_box_tree(boxes, options); });
  };
  EXPECT_THAT(refused(NonFinite(""), {unit, {{0, nan, 0}, {1, 1, 1}}}), HasSubstr("boxes[1].min.y is nan"));
  EXPECT_THAT(refused(NonFinite(""), {unit, unit, {{0, 0, 0}, {1, 1, infinity}}}), HasSubstr("boxes[2].max.z is inf"));
  EXPECT_THAT(refused(InvalidShape(""), {{{0, 2, 0}, {1, 1, 1}}}), HasSubstr("boxes[0] is empty"));
  EXPECT_THAT(refused(InvalidShape(""), {unit}, {.most_in_leaf = 0}), HasSubstr("options.most_in_leaf is 0"));
  EXPECT_THAT(refused(InvalidShape(""), {unit}, {.most_in_leaf = 256}), HasSubstr("from 1 to 255"));
  EXPECT_THAT(refused(InvalidShape(""), {unit}, {.item_cost = 0}), HasSubstr("options.item_cost is 0"));
}

}  // namespace
}  // namespace plumb
