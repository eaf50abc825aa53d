// Does the compact form hold the boxes of the tree that it is made of, in real arithmetic, and every triangle once?
#include "plumb/space/bvh/compact_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using ::testing::HasSubstr;

/// x 2^exponent, exactly.
Rational scaled(double x, int exponent) {
  Rational two(2), power(1);
  for (int i = 0; i < std::abs(exponent); ++i) power = exponent < 0 ? power / two : power * two;
  return Rational(x) * power;
}

/// Is what the node says of a child, in rationals, what box() gives as floats, and does it hold the child's box, which
/// is met to less than a step?
void expect_exact(const CompactNode& node, std::size_t child, const FloatBox3& held) {
  const FloatBox3 box = node.box(child);
  for (std::size_t k = 0; k < 3; ++k) {
    const int exponent = node.step[k] + CompactNode::least_exponent;
    const Rational step = scaled(1, exponent), origin(static_cast<double>(node.origin[k]));
    const Rational low = origin + scaled(node.planes[k][child], exponent),
                   high = origin + scaled(node.planes[3 + k][child], exponent);
    EXPECT_TRUE(low == Rational(static_cast<double>(box.min[k])));
    EXPECT_TRUE(high == Rational(static_cast<double>(box.max[k])));
    const Rational held_low(static_cast<double>(held.min[k])), held_high(static_cast<double>(held.max[k]));
    EXPECT_TRUE(low <= held_low && held_low < low + step);
    EXPECT_TRUE(held_high <= high && high < held_high + step);
  }
}

/// Below a node: its slots, and the box that holds their triangles' boxes in the tree's frame.
class Checked {
 public:
  Checked(const Bvh& bvh, const CompactBvh& small) : small_(small) {
    EXPECT_EQ(small.slots(), bvh.triangles.size());
    EXPECT_EQ(small.tree.frame, bvh.tree.frame);
    if (small.tree.nodes.empty()) {
      EXPECT_EQ(small.slots(), 0u);
      return;
    }
    EXPECT_EQ(small.tree.box(), bvh.tree.box());
    slots_.resize(small.slots());
    below(0, 0);
    EXPECT_EQ(nodes_, small.tree.nodes.size());
    for (const int seen : slots_) EXPECT_EQ(seen, 1);
    for (std::size_t slot = 0; slot < small.slots(); ++slot) triangles_[small.numbers[slot]] = small.triangle(slot);
    EXPECT_EQ(triangles_.size(), small.slots());
    for (std::size_t slot = 0; slot < bvh.triangles.size(); ++slot) {
      EXPECT_EQ(triangles_[bvh.tree.items[slot]], bvh.triangle(slot));
    }
  }

 private:
  static FloatBox3 together(const FloatBox3& a, const FloatBox3& b) {
    FloatBox3 all = a;
    for (std::size_t k = 0; k < 3; ++k) {
      all.min[k] = std::min(a.min[k], b.min[k]);
      all.max[k] = std::max(a.max[k], b.max[k]);
    }
    return all;
  }
  static bool holds(const FloatBox3& a, const FloatBox3& b) { return together(a, b) == a; }

  /// The least box around the triangles.
  FloatBox3 below(std::uint32_t at, std::uint32_t depth) {
    ++nodes_;
    EXPECT_LT(depth, most_tree_depth + 9);
    const CompactNode& node = small_.tree.nodes[at];
    const WideNode<8> wide = node.widened();
    std::optional<FloatBox3> all;
    for (std::size_t i = 0; i < CompactNode::width; ++i) {
      EXPECT_EQ(wide.has(i), node.has(i));
      if (!node.has(i)) continue;
      EXPECT_EQ(wide.link[i], node.link(i));
      EXPECT_EQ(wide.count[i], node.count[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(wide.planes[k][i], node.box(i).min[k]);
        EXPECT_EQ(wide.planes[3 + k][i], node.box(i).max[k]);
      }
      FloatBox3 own{};
      if (i < node.inner) {
        EXPECT_GT(node.link(i), at);
        own = below(node.link(i), depth + 1);
      } else {
        EXPECT_LE(node.count[i], CompactNode::most_in_leaf);
        for (std::uint32_t k = 0; k < node.count[i]; ++k) {
          const std::uint32_t slot = node.link(i) + k;
          ++slots_.at(slot);
          const Triangle3 t = small_.triangle(slot);
          const FloatBox3 box = small_.tree.frame.around(space::box_around(t.a, t.b, t.c));
          own = k == 0 ? box : together(own, box);
        }
      }
      expect_exact(node, i, own);
      EXPECT_TRUE(holds(node.box(i), own));
      all = all ? together(*all, own) : own;
    }
    EXPECT_TRUE(all.has_value());
    return *all;
  }

  const CompactBvh& small_;
  std::vector<int> slots_;
  std::map<std::uint32_t, Triangle3> triangles_;
  std::size_t nodes_ = 0;
};

TEST(CompactTree, HoldsTheBoxesAndEveryTriangleOnce) {
  on_shapes(981, battery::fitting(400), [&](Material& m) {
    const Bvh bvh = build_bvh(drawn_mesh(m, 90), any_options(m));
    SCOPED_TRACE(m.about());
    Checked(bvh, compact(bvh));
  });
  on_shapes(982, battery::fitting(200), [&](Material& m) {
    const Bvh bvh = build_bvh(meshes::soup(m, 1 + m.below(60), m.below(200)));
    SCOPED_TRACE(m.about());
    Checked(bvh, compact(bvh));
  });
  const Bvh ring = build_bvh(meshes::ring(20));
  Checked(ring, compact(ring));
}

// Exponents from those of subnormal doubles to those of the largest, in one mesh.
TEST(CompactTree, HoldsThemAtExtremeExponents) {
  for (const int first : {-1074, -1000, -149, -30, 0, 500}) {
    for (const int step : {1, 17, 25}) {
      const Bvh bvh = build_bvh(meshes::doubling(21, first, step));
      SCOPED_TRACE(testing::Message() << first << " " << step);
      Checked(bvh, compact(bvh));
    }
  }
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const TriangleMesh apart{{{most, -most, 1e300}, {-most, most, 1e-300}, {least, -least, 0}, {1, 0, -1e300}},
                           {{0, 1, 2}, {2, 2, 2}, {1, 2, 3}, {3, 3, 3}, {0, 0, 1}}};
  const Bvh bvh = build_bvh(apart, {.most_in_leaf = 1});
  Checked(bvh, compact(bvh));
}

// Boxes on the finest grid of floats: nothing is lost where there is nothing to be gained.
TEST(CompactTree, KeepsSmallBoxesAsTheyAre) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const double x = 1 + std::ldexp(3.0 * i, -23);
    mesh.vertices.push_back({x, -x, 2 - x});
    mesh.triangles.push_back({i, i, i});
  }
  const CompactBvh small = build_compact_bvh(mesh);
  std::size_t leaves = 0;
  for (const CompactNode& node : small.tree.nodes) {
    for (std::size_t i = node.inner; i < CompactNode::width && node.has(i); ++i, ++leaves) {
      Aabb3 box{small.triangle(node.link(i)).a, small.triangle(node.link(i)).a};
      for (std::uint32_t k = 1; k < node.count[i]; ++k) {
        const Point3 p = small.triangle(node.link(i) + k).a;
        box = {{std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)},
               {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)}};
      }
      EXPECT_EQ(node.box(i), small.tree.frame.around(box));
    }
  }
  EXPECT_GT(leaves, 5u);
}

TEST(CompactTree, DividesLeavesThatAreTooLarge) {
  for (const std::size_t n : {31u, 32u, 300u, 20000u}) {
    const Bvh bvh = build_bvh(meshes::repeated(n), {.most_in_leaf = 255});
    Checked(bvh, compact(bvh));
  }
  Bvh one = build_bvh(meshes::repeated(5000));  // by hand: a single leaf
  one.tree.nodes = std::vector<BoxNode>{{one.tree.nodes[0].min, 0, one.tree.nodes[0].max, 5000}};
  widen(one);
  Checked(one, compact(one));
}

TEST(CompactTree, DescendsToWhatEnters) {
  const CompactBvh small = compact(build_bvh(meshes::ring(24)));
  const auto meets = [](const BoxNode& n) { return n.min[0] <= 0.5F && n.max[0] >= 0.25F && n.min[2] <= 0; };
  std::vector<char> entered(small.slots());
  descend(small.tree, meets, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) EXPECT_EQ(entered[slot]++, 0);
  });
  std::size_t expected = 0;
  for (std::uint32_t slot = 0; slot < small.slots(); ++slot) {
    const Triangle3 t = small.triangle(slot);
    const Aabb3 box = space::box_around(t.a, t.b, t.c);
    const bool meeting = box.min.x <= 0.5 && box.max.x >= 0.25 && box.min.z <= 0;
    if (meeting) {
      EXPECT_EQ(entered[slot], 1);
    }
    expected += meeting;
  }
  EXPECT_GT(expected, 50u);
  EXPECT_LT(static_cast<std::size_t>(std::count(entered.begin(), entered.end(), 1)), 2 * expected);
  std::size_t visits = 0;
  const Descent stopped = descend(
      small.tree, meets, [&](std::uint32_t, std::uint32_t) { return ++visits == 3 ? Descent::stop : Descent::go_on; });
  EXPECT_EQ(stopped, Descent::stop);
  EXPECT_EQ(visits, 3u);
}

TEST(CompactTree, OfNothingIsNothing) {
  const CompactBvh none = build_compact_bvh(TriangleMesh{});
  EXPECT_EQ(memory_of(none), 0u);
  EXPECT_EQ(none.slots(), 0u);
  EXPECT_TRUE(build_compact_bvh(TriangleMesh{{{1, 2, 3}}, {}}).tree.nodes.empty());
}

TEST(CompactTree, NamesWhatIsWrong) {
  const auto index = [] { (void)build_compact_bvh(TriangleMesh{{{0, 0, 0}}, {{0, 1, 0}}}); };
  EXPECT_THAT(text_of<InvalidShape>(index), HasSubstr("triangles[0][1] is 1"));
  Bvh beyond = build_bvh(meshes::ring(3));
  beyond.wide.nodes.writable()[0].planes[4][0] = std::numeric_limits<float>::infinity();
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)compact(beyond); }), HasSubstr("compact: a box of the tree reaches"));
}

TEST(PackedNumbers, AreThoseGiven) {
  for (const std::uint32_t most : {0u, 1u, 255u, 256u, 65535u, 65536u, 0xffffffu, 0x1000000u, 0xffffffffu}) {
    std::vector<std::uint32_t> numbers{most};
    for (std::uint64_t i = 0; i < 50; ++i) {
      numbers.push_back(static_cast<std::uint32_t>(Entropy(983, i).below(std::uint64_t{most} + 1)));
    }
    const PackedNumbers packed(numbers);
    ASSERT_EQ(packed.size(), numbers.size());
    EXPECT_EQ(packed.width(), most < 256 ? 1u : most < 65536 ? 2u : most < 0x1000000 ? 3u : 4u);
    EXPECT_LE(packed.bytes(), numbers.size() * packed.width() + 3);
    const PackedView words{std::span<const std::uint32_t>(numbers)};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_EQ(packed[i], numbers[i]);
      EXPECT_EQ(words[i], numbers[i]);
    }
  }
  EXPECT_EQ(PackedNumbers().bytes(), 0u);
}

double bytes_a_triangle(std::size_t bytes, const TriangleMesh& mesh) {
  return static_cast<double>(bytes) / static_cast<double>(mesh.triangles.size());
}

TEST(CompactTree, TakesAtMost32BytesATriangleOfAClosedMesh) {
  for (const std::uint32_t n : {20u, 100u}) {
    const TriangleMesh mesh = meshes::ring(n);
    const CompactBvh small = build_compact_bvh(mesh);
    EXPECT_LE(memory_of(small), 32 * mesh.triangles.size());
    EXPECT_LE(memory_of(small.tree), 5 * mesh.triangles.size());
  }
}

TEST(CompactTree, HoldsTheModels) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models";
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() == ".md") continue;
    const TriangleMesh mesh = read_mesh(file.path());
    const Bvh bvh = build_bvh(mesh);
    const CompactBvh small = compact(bvh);
    SCOPED_TRACE(file.path().filename());
    if (mesh.triangles.size() < battery::fitting(20000u)) Checked(bvh, small);
    const double share = static_cast<double>(mesh.vertices.size()) / static_cast<double>(mesh.triangles.size());
    if (share < 0.75) {
      EXPECT_LE(memory_of(small), 32 * mesh.triangles.size());
    }
    std::printf("%s: %zu triangles, %.2f vertices each; %.1f bytes each, of which nodes %.1f; default %.1f\n",
                file.path().filename().c_str(), mesh.triangles.size(), share, bytes_a_triangle(memory_of(small), mesh),
                bytes_a_triangle(memory_of(small.tree), mesh), bytes_a_triangle(memory_of(bvh), mesh));
  }
}

}  // namespace
}  // namespace plumb
