// Does the wide form have the slots and the boxes of the binary one?
#include "plumb/space/bvh/wide_tree.hpp"

#include <gtest/gtest.h>

#include <map>

#include "certify/sanitized.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using Slots = std::pair<std::uint32_t, std::uint32_t>;  // the first, and one beyond the last

/// Of each node its slots.
std::vector<Slots> slots_of(const BoxTree& tree) {
  std::vector<Slots> slots(tree.nodes.size());
  for (std::size_t i = slots.size(); i-- > 0;) {
    const BoxNode& node = tree.nodes[i];
    slots[i] = node.is_leaf() ? Slots{node.link, node.link + node.count}
                              : Slots{slots[i + 1].first, slots[i + node.link].second};
  }
  return slots;
}

template <std::size_t width>
class Walked {
 public:
  Walked(const BoxTree& tree, std::uint32_t most_in_leaf) : wide_(widen<width>(tree, most_in_leaf)) {
    const std::vector<Slots> slots = slots_of(tree);
    for (std::size_t i = slots.size(); i-- > 0;) boxes_[slots[i]] = tree.nodes[i].box();
    if (tree.nodes.empty()) {
      EXPECT_TRUE(wide_.nodes.empty());
      return;
    }
    EXPECT_EQ(below(0, 0), (Slots{0, static_cast<std::uint32_t>(tree.items.size())}));
    EXPECT_EQ(nodes_, wide_.nodes.size());
  }

 private:
  Slots below(std::uint32_t at, std::uint32_t depth) {
    ++nodes_;
    EXPECT_LE(depth, most_tree_depth);
    const WideNode<width>& node = wide_.nodes[at];
    Slots all{0, 0};
    bool missing = false;
    for (std::size_t i = 0; i < width; ++i) {
      EXPECT_FALSE(missing && node.has(i)) << "a child behind one that is missing";
      missing = missing || !node.has(i);
      if (missing) continue;
      const Slots own =
          node.count[i] != 0 ? Slots{node.link[i], node.link[i] + node.count[i]} : below(node.link[i], depth + 1);
      if (i > 0) {
        EXPECT_EQ(own.first, all.second);
      }
      if (i == 0) all.first = own.first;
      all.second = own.second;
      const auto box = boxes_.find(own);
      if (box == boxes_.end()) {
        ADD_FAILURE() << "no node has the slots " << own.first << " to " << own.second;
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(node.planes[k][i], box->second.min[k]);
        EXPECT_EQ(node.planes[3 + k][i], box->second.max[k]);
      }
    }
    return all;
  }

  WideTree<width> wide_;
  std::map<Slots, FloatBox3> boxes_;  // a parent of one child is not there
  std::size_t nodes_ = 0;
};

TEST(WideTree, HasTheSlotsAndTheBoxesOfTheBinaryOne) {
  on_shapes(971, battery::fitting(400), [&](Material& m) {
    const Bvh bvh = build_bvh(drawn_mesh(m, 90), any_options(m));
    const auto most = static_cast<std::uint32_t>(m.below(20));
    SCOPED_TRACE(m.about());
    Walked<4>(bvh.tree, most);
    Walked<8>(bvh.tree, most);
  });
  Walked<8>(build_bvh(meshes::ring(20)).tree, 8);
  Walked<8>(build_bvh(meshes::repeated(300), {.most_in_leaf = 255}).tree, 8);
}

TEST(WideTree, FollowsWhatMoves) {
  TriangleMesh mesh = meshes::ring(9);
  Bvh bvh = build_bvh(mesh);
  for (Point3& p : mesh.vertices) p = {-3 * p.y, p.x * p.z, p.x + 5};
  refit(bvh, mesh.vertices);
  const Point3& p = mesh.vertices[50];
  const Line3 line{{-5, 0, 5}, {p.x + 5, p.y, p.z - 5}};
  const std::size_t expected = count_hits(build_bvh(mesh), line);
  EXPECT_GT(expected, 0u);
  EXPECT_EQ(count_hits(bvh, line), expected);
  EXPECT_GT(rebuild_parts(bvh, 1.1), 0u);
  EXPECT_EQ(count_hits(bvh, line), expected);
}

}  // namespace
}  // namespace plumb
