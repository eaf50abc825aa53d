// Is what comes from a file what went into it, and is every file that is no tree refused before anything is asked?
#include "plumb/space/bvh/tree_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

#include "space/bvh/meshes.hpp"
#include "space/bvh/sealed_file.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class TreeFile : public ::testing::Test {
 protected:
  const fs::path folder_ = fs::temp_directory_path() / ("plumb_tree_file_" + std::to_string(::getpid()));
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
      (void)map_bvh(path_);
    } catch (const BvhFileError& e) {
      by_map = e;
    }
    try {
      (void)read_bvh(path_);
    } catch (const BvhFileError& e) {
      by_read = e;
    }
    EXPECT_EQ(by_map.has_value(), by_read.has_value());
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

void expect_equal(const Bvh& a, const Bvh& b) {
  EXPECT_TRUE(std::ranges::equal(a.tree.nodes, b.tree.nodes));
  EXPECT_TRUE(std::ranges::equal(a.tree.items, b.tree.items));
  EXPECT_TRUE(std::ranges::equal(a.triangles, b.triangles));
  EXPECT_TRUE(std::ranges::equal(a.vertices, b.vertices));
  EXPECT_EQ(a.tree.frame, b.tree.frame);
}

TEST_F(TreeFile, GivesBackWhatWasWritten) {
  shape_cases::on_shapes(951, 60, [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(50), m.below(100));
    const Bvh bvh = build_bvh(mesh);
    write_bvh(path_, bvh);
    EXPECT_EQ(bvh_bytes(bvh), bytes());
    expect_equal(read_bvh(path_), bvh);
    const Bvh mapped = map_bvh(path_);
    expect_equal(mapped, bvh);
    const Bvh copy = mapped;
    fs::remove(path_);  // the mapping stays
    EXPECT_EQ(tree_laws::broken(copy.tree, tree_laws::boxes_of(mesh), BvhOptions{}.most_in_leaf), "");
  });
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(TreeFile, CanBeWrittenToAfterItIsMapped) {
  const Bvh bvh = build_bvh(meshes::ring(3));
  write_bvh(path_, bvh);
  Bvh mapped = map_bvh(path_);
  mapped.vertices.writable()[0] = {7, 7, 7};
  EXPECT_EQ(mapped.vertices[0], (Point3{7, 7, 7}));
  expect_equal(map_bvh(path_), bvh);
}

TEST_F(TreeFile, NamesWhatIsNoTree) {
  using enum BvhFileProblem;
  write_bvh(path_, build_bvh(meshes::ring(3)));
  const std::string good = bytes();
  ASSERT_FALSE(refused(good));
  expect_refused("", not_a_tree, "does not begin");
  expect_refused("solid part", not_a_tree, "does not begin");
  expect_refused(good.substr(0, 60), truncated, "ends after 60 bytes");
  expect_refused(good.substr(0, good.size() - 1), truncated, "its head promises " + std::to_string(good.size()));
  expect_refused(good + "x", truncated, "its head promises");
  expect_refused(good.substr(0, good.size() - 1) + "x", damaged, "another checksum");
  expect_refused(with(good, 8, std::uint32_t{1}), version,
                 "is of version 1, and this library reads 2; write it again with write_bvh(path, build_bvh(mesh))");
  expect_refused(with(good, 12, std::uint32_t{0x04030201}), version, "byte order");
  expect_refused(with(good, 16, std::int32_t{5000}), broken_law, "exponent 5000");
  expect_refused(with(good, 24, std::uint64_t{1} << 59), broken_law, "more than 2^32");
  expect_refused(with(good, 24, std::uint64_t{1}), truncated, "its head promises");
  fs::remove(path_);
  const auto problem = [](const auto& call) -> std::optional<BvhFileProblem> {
    try {
      call();
    } catch (const BvhFileError& e) {
      return e.problem;
    }
    return {};
  };
  EXPECT_EQ(problem([&] { (void)map_bvh(path_); }), missing);
  EXPECT_EQ(problem([&] { (void)map_bvh(folder_.string()); }), unreadable);
  EXPECT_EQ(problem([&] { write_bvh((folder_ / "no" / "tree").string(), Bvh{}); }), unwritable);
}

TEST_F(TreeFile, NamesBrokenLaws) {
  using enum BvhFileProblem;
  const TriangleMesh mesh = meshes::ring(3);
  const Bvh bvh = build_bvh(mesh);
  write_bvh(path_, bvh);
  const std::string good = bytes();
  const std::size_t nodes = 128, vertices = nodes + 32 * bvh.tree.nodes.size(),
                    triangles = vertices + 24 * bvh.vertices.size(), items = triangles + 12 * bvh.triangles.size();
  ASSERT_EQ(items + 4 * bvh.tree.items.size(), good.size());
  ASSERT_FALSE(bvh.tree.nodes[0].is_leaf());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_refused(with(good, nodes + 12, 1u), broken_law, "node 0 has a child out of bounds");
  expect_refused(with(good, nodes + 12, 0xffffffffu), broken_law, "node 0 has a child out of bounds");
  expect_refused(with(good, nodes + 12, bvh.tree.nodes[0].link + 1), broken_law, "is not where its parent says");
  expect_refused(with(good, nodes + 28, 5u), broken_law, "node 0 has slots that are not its own");
  expect_refused(with(good, nodes, nan), broken_law, "box");
  expect_refused(with(good, nodes, 0.0F), broken_law, "is not in its parent's box");
  expect_refused(with(good, vertices + 8, std::numeric_limits<double>::infinity()), broken_law,
                 "vertex 0 is not finite");
  expect_refused(with(good, vertices, 1e5), broken_law, "is not in the box of node");
  expect_refused(with(good, triangles + 4, 4000u), broken_law, "the triangle in slot 0 names vertex 4000");
  expect_refused(with(good, items, bvh.tree.items[1]), broken_law, "triangle ");
  expect_refused(with(good, items, 0xffffffffu), broken_law, "has a number beyond the slots");
}

// A builder makes no such leaf, but a file may hold one.
TEST_F(TreeFile, MayHoldALeafOfAnySize) {
  const std::uint32_t many = 700;
  const TriangleMesh mesh = meshes::repeated(many);
  Bvh bvh = build_bvh(mesh);
  BoxNode leaf = bvh.tree.nodes[0];
  leaf.link = 0;
  leaf.count = many;
  bvh.tree.nodes = std::vector{leaf};
  write_bvh(path_, bvh);
  const Bvh mapped = map_bvh(path_);
  EXPECT_EQ(intersecting_pairs(mapped).size(), many * (many - 1) / 2);
  EXPECT_EQ(intersecting_pairs(mapped, build_bvh(meshes::repeated(3))).size(), 3 * many);
  EXPECT_EQ(count_hits(mapped, Ray3{{0.25, 0.25, 1}, {0, 0, -1}}), many);
  EXPECT_EQ(nearest_triangles(mapped, Point3{0, 0, 1}, 5).size(), 5u);
  EXPECT_EQ(locate(mapped, Point3{0, 0, 1}), Location::outside);
}

// Whatever one byte of it becomes, and if the checksum is made to fit, it is refused or a tree that keeps the laws.
TEST_F(TreeFile, TakesNoHarmFromAnyByte) {
  const TriangleMesh mesh = meshes::ring(2);
  write_bvh(path_, build_bvh(mesh));
  const std::string good = bytes();
  std::size_t taken = 0, refusals = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ flip);
      if (refused(tree_files::sealed(bad))) {
        ++refusals;
        continue;
      }
      ++taken;
      const Bvh bvh = read_bvh(path_);
      TriangleMesh own{{bvh.vertices.begin(), bvh.vertices.end()},
                       std::vector<TriangleMesh::Triangle>(bvh.triangles.size())};
      for (std::size_t slot = 0; slot < bvh.triangles.size(); ++slot)
        own.triangles[bvh.tree.items[slot]] = bvh.triangles[slot];
      ASSERT_EQ(tree_laws::broken(bvh.tree, tree_laws::boxes_of(own), 255), "") << at;
    }
  }
  EXPECT_GT(taken, 100u);
  EXPECT_GT(refusals, 500u);
}

}  // namespace
}  // namespace plumb
