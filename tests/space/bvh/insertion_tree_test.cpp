// Does a tree that items come to and go from keep its laws, whatever the order?
#include "plumb/space/bvh/insertion_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "figure/basic/thrown.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;

Aabb3 box_of(shape_cases::Material& m) {
  const Point3 a = m.point3(), b = m.point3();
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

TEST(InsertionTree, HasWhatWasInsertedAndNotRemoved) {
  std::size_t removed = 0;
  shape_cases::on_shapes(931, 200, [&](shape_cases::Material& m) {
    InsertionTree tree;
    std::map<std::uint32_t, Aabb3> there;
    for (std::size_t step = m.below(80); step-- > 0;) {
      const auto item = static_cast<std::uint32_t>(m.below(40));
      ASSERT_EQ(tree.contains(item), there.contains(item));
      if (there.contains(item)) {
        tree.remove(item);
        there.erase(item);
        ++removed;
      } else {
        there[item] = box_of(m);
        tree.insert(item, there[item]);
      }
    }
    EXPECT_EQ(tree.size(), there.size());
    // Numbered without gaps, for the laws.
    BoxTree laid_out = tree.laid_out({.most_in_leaf = 3});
    std::vector<Aabb3> boxes;
    std::map<std::uint32_t, std::uint32_t> dense;
    for (const auto& [item, box] : there) {
      dense[item] = static_cast<std::uint32_t>(boxes.size());
      boxes.push_back(box);
    }
    for (std::uint32_t& item : laid_out.items.writable()) {
      ASSERT_TRUE(dense.contains(item));
      item = dense[item];
    }
    EXPECT_EQ(tree_laws::broken(laid_out, boxes, 3), "");
  });
  EXPECT_GT(removed, 1000u);
}

TEST(InsertionTree, TakesAChain) {
  InsertionTree tree;
  std::vector<Aabb3> boxes;
  double x = 1;
  for (std::uint32_t i = 0; i < 300; ++i, x *= 1.5) {
    boxes.push_back({{x, x, x}, {x, x, x}});
    tree.insert(i, boxes.back());
  }
  EXPECT_EQ(tree_laws::broken(tree.laid_out({.most_in_leaf = 1}), boxes, 1), "");
}

TEST(InsertionTree, NamesWhatIsWrong) {
  InsertionTree tree;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Aabb3 unit{{0, 0, 0}, {1, 1, 1}};
  tree.insert(4, unit);
  EXPECT_THAT(text_of<InvalidShape>([&] { tree.insert(4, unit); }), HasSubstr("item 4 is there already"));
  EXPECT_THAT(text_of<InvalidShape>([&] { tree.remove(5); }), HasSubstr("there is no item 5"));
  EXPECT_THAT(text_of<NonFinite>([&] { tree.insert(5, {{0, 0, 0}, {1, nan, 1}}); }), HasSubstr("box.max.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] { tree.insert(5, {{0, 2, 0}, {1, 1, 1}}); }), HasSubstr("box is empty"));
  EXPECT_EQ(tree.size(), 1u);
}

}  // namespace
}  // namespace plumb
