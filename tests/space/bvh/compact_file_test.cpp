// Is the compact tree that comes from a file what went into it, and is every file that is none refused before anything
// is asked?
#include "plumb/space/bvh/compact_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

#include "certify/sanitized.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/sealed_file.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class CompactFile : public ::testing::Test {
 protected:
  const fs::path folder_ = fs::temp_directory_path() / ("plumb_compact_file_" + std::to_string(::getpid()));
  const std::string path_ = (folder_ / "tree.bvh").string();

  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string bytes() const {
    std::ifstream in(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

  /// What both ways of reading say of these bytes; nothing where they take them.
  [[nodiscard]] std::optional<BvhFileError> refused(const std::string& bytes) const {
    put(bytes);
    std::optional<BvhFileError> by_map, by_read;
    try {
      (void)map_compact_bvh(path_);
    } catch (const BvhFileError& e) {
      by_map = e;
    }
    try {
      (void)read_compact_bvh(path_);
    } catch (const BvhFileError& e) {
      by_read = e;
    }
    EXPECT_EQ(std::string(by_map ? by_map->what() : ""), by_read ? by_read->what() : "");
    return by_map;
  }
  void expect_refused(const std::string& bytes, BvhFileProblem problem, const std::string& text) const {
    const auto error = refused(bytes);
    ASSERT_TRUE(error) << text;
    EXPECT_EQ(error->problem, problem) << error->what();
    EXPECT_EQ(error->file, path_);
    EXPECT_THAT(error->what(), HasSubstr(path_));
    EXPECT_THAT(error->what(), HasSubstr(text));
  }
};

/// With a value changed, and a checksum that fits: as a program would write it that writes another tree.
template <class T>
std::string with(std::string bytes, std::size_t at, T value) {
  std::memcpy(&bytes[at], &value, sizeof value);
  return tree_files::sealed(bytes);
}

void expect_equal(const CompactBvh& a, const CompactBvh& b) {
  EXPECT_TRUE(std::ranges::equal(a.tree.nodes, b.tree.nodes));
  EXPECT_TRUE(std::ranges::equal(a.corners.memory(), b.corners.memory()));
  EXPECT_TRUE(std::ranges::equal(a.numbers.memory(), b.numbers.memory()));
  EXPECT_TRUE(std::ranges::equal(a.vertices, b.vertices));
  EXPECT_EQ(a.corners.width(), b.corners.width());
  EXPECT_EQ(a.numbers.width(), b.numbers.width());
  EXPECT_EQ(a.slots(), b.slots());
  EXPECT_EQ(a.tree.frame, b.tree.frame);
  EXPECT_EQ(a.tree.root, b.tree.root);
}

TEST_F(CompactFile, GivesBackWhatWasWritten) {
  std::vector<TriangleMesh> meshes{{}, {{{1, 2, 3}}, {}}, meshes::repeated(300), meshes::ring(24)};
  for (const int first : {-1074, -149, 0, 500}) meshes.push_back(meshes::doubling(21, first, 25));
  shape_cases::on_shapes(
      971, 15, [&](shape_cases::Material& m) { meshes.push_back(meshes::soup(m, 1 + m.below(50), m.below(100))); });
  for (const TriangleMesh& mesh : meshes) {
    for (const float share : {0.0F, 1.0F}) {
      const CompactBvh small = build_compact_bvh(mesh, {.split_share = share});
      write_compact_bvh(path_, small);
      EXPECT_EQ(fs::file_size(path_), 128 + memory_of(small));
      expect_equal(read_compact_bvh(path_), small);
      const CompactBvh mapped = map_compact_bvh(path_), copy = mapped;
      fs::remove(path_);  // the mapping stays
      expect_equal(copy, small);
      if (small.slots() == 0) continue;
      EXPECT_EQ(intersecting_pairs(copy), intersecting_pairs(small));
      const Point3& p = mesh.vertices[0];
      EXPECT_EQ(closest_on_mesh(copy, p), closest_on_mesh(small, p));
      const Line3 line{p, {1, 0.5, 0.25}};
      EXPECT_EQ(hits(copy, line), hits(small, line));
    }
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(CompactFile, IsNoOtherKindOfFile) {
  const TriangleMesh mesh = meshes::ring(4);
  write_bvh(path_, build_bvh(mesh));
  expect_refused(bytes(), BvhFileProblem::not_a_tree, "does not begin with \"plumbcmp\", so it is no compact tree");
  write_compact_bvh(path_, build_compact_bvh(mesh));
  EXPECT_THROW((void)map_bvh(path_), BvhFileError);
  const std::string good = bytes();
  expect_refused("", BvhFileProblem::not_a_tree, "no compact tree");
  expect_refused(with(good, 8, 1u), BvhFileProblem::version,
                 "is of version 1, and this library reads 2; write it again with write_compact_bvh(path, ");
  expect_refused(with(good, 12, 0x04030201u), BvhFileProblem::version, "another byte order");
  fs::remove(path_);
  try {
    (void)map_compact_bvh(path_);
    ADD_FAILURE() << "a file that is not there";
  } catch (const BvhFileError& e) {
    EXPECT_EQ(e.problem, BvhFileProblem::missing);
  }
  const std::string nowhere = (folder_ / "no" / "tree.bvh").string();
  try {
    write_compact_bvh(nowhere, CompactBvh{});
    ADD_FAILURE() << "a folder that is not there";
  } catch (const BvhFileError& e) {
    EXPECT_EQ(e.problem, BvhFileProblem::unwritable);
  }
}

TEST_F(CompactFile, IsRefusedWhereItIsCutOrExtended) {
  write_compact_bvh(path_, build_compact_bvh(meshes::ring(2)));
  const std::string good = bytes();
  for (std::size_t n = 8; n < good.size(); n += n < 140 ? 1 : 7) {
    const auto error = refused(good.substr(0, n));
    ASSERT_TRUE(error) << n;
    EXPECT_EQ(error->problem, BvhFileProblem::truncated) << n;
  }
  expect_refused(good + "x", BvhFileProblem::truncated, "its head promises " + std::to_string(good.size()));
}

// Where each thing lies: a head of 128, nodes of 80 (origin 0, step 12, inner 15, first_node 16, first_slot 20, count 24,
// planes 32), vertices, corners, numbers.
TEST_F(CompactFile, NamesTheLawThatIsBroken) {
  using enum BvhFileProblem;
  const CompactBvh small = build_compact_bvh(meshes::ring(16));
  write_compact_bvh(path_, small);
  const std::string good = bytes();
  const std::size_t nodes = 128, vertices = nodes + 80 * small.tree.nodes.size(),
                    corners = vertices + 24 * small.vertices.size(), numbers = corners + small.corners.bytes();
  ASSERT_EQ(good.size(), numbers + small.numbers.bytes());
  ASSERT_EQ(small.corners.width(), 2u);
  ASSERT_EQ(small.numbers.width(), 2u);
  ASSERT_GE(small.tree.nodes[0].inner, 2);
  const CompactNode& root = small.tree.nodes[0];
  const auto node_count = static_cast<std::uint32_t>(small.tree.nodes.size());
  const float nan = std::numeric_limits<float>::quiet_NaN(), far = std::numeric_limits<float>::infinity();
  const auto law = [&](const std::string& bad, const std::string& text) { expect_refused(bad, broken_law, text); };
  // The head.
  law(with(good, 16, 4000), "has a frame of exponent 4000");
  law(with(good, 20, 0u), "has numbers of 0 bytes");
  law(with(good, 24, 5u), "has numbers of 5 bytes");
  law(with(good, 32, ~std::uint64_t{0}), "promises more than 2^32 nodes");
  expect_refused(with(good, 20, 3u), truncated, "its head promises");
  law(with(good, 64, 2.0F), "is not in the boxes on the way to its leaf");  // the root's box
  law(with(good, 64, nan), "is not in the boxes on the way to its leaf");
  // Nodes: children out of bounds, of two, of none, in a circle.
  law(with(good, nodes + 16, node_count), "node 0 has a child out of bounds");
  law(with(good, nodes + 16, 0u), "node 0 has a child out of bounds");
  law(with(good, nodes + 16, 0xffffffffu), "node 0 has a child out of bounds");
  law(with(good, nodes + 16, root.first_node + 1), "is nobody's child");
  law(with(good, nodes + 15, std::uint8_t{9}), "node 0 has more than eight children");
  law(with(good, nodes + 24, std::uint8_t{1}), "node 0 has a child that is a leaf as well");
  const auto inner = [](const CompactNode& node) { return node.inner != 0; };
  const auto below = small.tree.nodes.view().subspan(1);
  ASSERT_TRUE(std::ranges::any_of(below, inner));
  const auto deep = static_cast<std::size_t>(1 + (std::ranges::find_if(below, inner) - below.begin()));
  law(with(good, nodes + 80 * deep + 16, root.first_node), "child");
  law(with(good, nodes + 80 * deep + 16, static_cast<std::uint32_t>(deep)), "has a child out of bounds");
  law(with(good, nodes + 80 * deep + 16, small.tree.nodes[deep].first_node - 1), "child");
  std::size_t flat = 1;
  while (small.tree.nodes[flat].inner != 0) ++flat;
  const std::size_t leaves = nodes + 80 * flat;
  const auto slots = static_cast<std::uint32_t>(small.slots());
  law(with(good, leaves + 20, slots), "has slots out of bounds");
  law(with(good, leaves + 20, 0xfffffffeu), "has slots out of bounds");
  law(with(good, leaves + 20, small.tree.nodes[flat].first_slot + 1), "slot");
  law(with(good, leaves + 24, std::uint8_t{32}), "has too large a leaf");
  law(with(good, leaves + 24, std::uint64_t{0}), "has no children");
  // Boxes.
  for (const float origin : {nan, far, -far, 0x1p127F, 0.1F}) law(with(good, nodes, origin), "box");
  law(with(good, nodes + 12, std::uint8_t{255}), "node 0 has a box that is no floats");
  law(with(good, nodes + 12, std::uint8_t{0}), "node 0 has a box that is no floats");
  for (std::size_t plane = 0; plane < 6; ++plane) {
    law(with(good, leaves + 32 + 8 * plane, plane < 3 ? std::uint8_t{255} : std::uint8_t{0}),
        "is not in the boxes on the way to its leaf");
    law(with(good, nodes + 32 + 8 * plane, plane < 3 ? std::uint8_t{255} : std::uint8_t{0}),
        "is not in the boxes on the way to its leaf");
  }
  // The mesh.
  law(with(good, vertices + 8, std::numeric_limits<double>::infinity()), "vertex 0 is not finite");
  law(with(good, vertices, 1e5), "is not in the boxes on the way to its leaf");
  law(with(good, corners + 2, static_cast<std::uint16_t>(small.vertices.size())),
      "the triangle in slot 0 names vertex");
  law(with(good, numbers, static_cast<std::uint16_t>(small.numbers[1])), "triangle ");
}

TEST_F(CompactFile, MayBeAsDeepAsAStackHasRoom) {
  CompactBvh small = build_compact_bvh(meshes::repeated(4));
  const CompactNode leaf = small.tree.nodes[0];
  ASSERT_EQ(leaf.inner, 0);
  const auto chain = [&](std::size_t levels) {
    std::vector<CompactNode> nodes;
    for (std::uint32_t i = 0; i + 1 < levels; ++i) {
      CompactNode node = leaf;
      node.count = {};
      node.inner = 1;
      node.first_node = i + 1;
      for (std::size_t k = 0; k < 6; ++k) node.planes[k][0] = k < 3 ? 0 : 255;
      nodes.push_back(node);
    }
    nodes.push_back(leaf);
    small.tree.nodes = nodes;
    write_compact_bvh(path_, small);
    return bytes();
  };
  EXPECT_FALSE(refused(chain(CompactTree::most_levels)));
  const CompactBvh deep = map_compact_bvh(path_);
  EXPECT_EQ(count_hits(deep, Ray3{{0.25, 0.25, 1}, {0, 0, -1}}), 4u);
  EXPECT_EQ(intersecting_pairs(deep).size(), 6u);
  EXPECT_EQ(intersecting_pairs(deep, deep).size(), 16u);
  const Pose turn{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {1, 0, 0}};
  EXPECT_EQ(intersecting_pairs({deep, turn}, deep).size(), 16u);
  expect_refused(chain(CompactTree::most_levels + 1), BvhFileProblem::broken_law, "lies deeper than a tree may be");
}

// Whatever one byte of it becomes, and if the checksum is made to fit, it is refused or answers as asking each of its
// triangles does.
TEST_F(CompactFile, TakesNoHarmFromAnyByte) {
  write_compact_bvh(path_, build_compact_bvh(meshes::ring(2), {.most_in_leaf = 2}));
  const std::string good = bytes();
  std::size_t taken = 0, refusals = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int flip : {at % 2 == 0 ? 0xff : 1 << at / 2 % 8}) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ flip);
      if (refused(tree_files::sealed(bad))) {
        ++refusals;
        continue;
      }
      ++taken;
      const CompactBvh small = read_compact_bvh(path_);
      TriangleMesh own{{small.vertices.begin(), small.vertices.end()}, {}};
      own.triangles.resize(small.slots());
      for (std::size_t slot = 0; slot < small.slots(); ++slot)
        own.triangles[small.number(slot)] = small.corners_of(slot);
      const Bvh whole = build_bvh(own, {.execution = Execution::serial});
      const Line3 line{{0.1, 0.2, 0.05}, {1, 0.25, 0.125}};
      ASSERT_EQ(hits(small, line), hits(whole, line)) << at << " " << flip;
      ASSERT_EQ(nearest_triangles(small, {2, 1, 0.5}, 4), nearest_triangles(whole, {2, 1, 0.5}, 4)) << at;
      ASSERT_EQ(intersecting_pairs(small, {.execution = Execution::serial}),
                intersecting_pairs(whole, {.execution = Execution::serial}))
          << at;
    }
  }
  EXPECT_GT(taken, 80u);
  EXPECT_GT(refusals, 150u);
}

}  // namespace
}  // namespace plumb
