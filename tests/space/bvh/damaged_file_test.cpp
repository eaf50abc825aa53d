// Is a tree file with any other bytes refused, read and mapped?  Bits, blocks, ends: what disks and networks do to files.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "arith/splitmix.hpp"
#include "plumb/space/bvh/compact_file.hpp"
#include "space/bvh/kept_file.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// A way to write and to take back trees of one kind.
struct Kind {
  std::string name;
  void (*write)(const std::string& path);
  void (*map)(const std::string& path);
  void (*read)(const std::string& path);

  friend std::ostream& operator<<(std::ostream& out, const Kind& kind) { return out << kind.name; }
};

const std::array<Kind, 2> kinds{{
    {"tree", [](const std::string& path) { write_bvh(path, build_bvh(meshes::ring(7))); },
     [](const std::string& path) { (void)map_bvh(path); }, [](const std::string& path) { (void)read_bvh(path); }},
    {"compact tree", [](const std::string& path) { write_compact_bvh(path, build_compact_bvh(meshes::ring(7))); },
     [](const std::string& path) { (void)map_compact_bvh(path); },
     [](const std::string& path) { (void)read_compact_bvh(path); }},
}};

struct Mutant {
  std::string how, bytes;
};

/// One change of a file; the same number, the same change.
class Damage {
 public:
  Damage(const std::string& good, std::uint64_t number) : bytes_(good), number_(number), state_(number) {}

  Mutant mutant() {
    switch (number_ % 8) {
      case 0:
      case 1:
        return flipped_bits(1);
      case 2:
        return flipped_bits(2 + below(6));
      case 3:
        return overwritten_block();
      case 4:
        return swapped_blocks();
      case 5:
        return {"cut off", bytes_.substr(0, below(bytes_.size()))};
      case 6:
        return {"continued", bytes_ + std::string(1 + below(300), static_cast<char>(below(256)))};
      default:
        return shifted_block();
    }
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(splitmix64(state_) % n); }

  Mutant flipped_bits(std::size_t many) {
    std::string bad = bytes_;
    for (std::size_t k = 0; k < many; ++k) {
      const std::size_t at = below(bad.size());
      bad[at] = static_cast<char>(bad[at] ^ (1 << below(8)));
    }
    return {many == 1 ? "a flipped bit" : "flipped bits", bad};
  }
  Mutant overwritten_block() {
    const std::size_t size = std::size_t{1} << below(10), at = below(bytes_.size() - size);
    std::string bad = bytes_;
    std::fill_n(bad.begin() + static_cast<std::ptrdiff_t>(at), size, below(2) == 0 ? '\0' : '\xff');
    return {"an overwritten block", bad};
  }
  Mutant swapped_blocks() {
    const std::size_t size = std::size_t{8} << below(6), blocks = bytes_.size() / size;
    const std::size_t a = below(blocks) * size, b = below(blocks) * size;
    std::string bad = bytes_;
    std::swap_ranges(&bad[a], &bad[a] + size, &bad[b]);
    return {"swapped blocks", bad};
  }
  /// A piece is missing, and the end is filled up.
  Mutant shifted_block() {
    const std::size_t size = 1 + below(64), at = below(bytes_.size() - size);
    std::string bad = bytes_;
    bad.erase(at, size).append(size, '\0');
    return {"a missing piece", bad};
  }

  const std::string& bytes_;
  std::uint64_t number_, state_;
};

class DamagedFile : public ::testing::TestWithParam<Kind> {
 protected:
  const fs::path folder_ = fs::temp_directory_path() / ("plumb_damaged_file_" + std::to_string(::getpid()));
  const std::string path_ = (folder_ / "tree").string();

  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string written() const {
    GetParam().write(path_);
    std::ifstream in(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// By both ways to take it back, for the same reason.
  [[nodiscard]] bool refused(const std::string& bytes) const {
    fs::remove(path_);  // a new file, as some file systems wait for the disk where an old one is cut to nothing
    std::ofstream(path_, std::ios::binary) << bytes;
    std::array<std::string, 2> reasons;
    for (std::size_t i = 0; i < 2; ++i) {
      try {
        (i == 0 ? GetParam().map : GetParam().read)(path_);
      } catch (const BvhFileError& e) {
        reasons[i] = e.what();
      }
    }
    EXPECT_EQ(reasons[0], reasons[1]);
    return !reasons[0].empty();
  }
};

TEST_P(DamagedFile, IsRefusedWhicheverBitOfTheHeadIsAnother) {
  const std::string good = written();
  ASSERT_FALSE(refused(good));
  for (std::size_t bit = 0; bit < 8 * std::size_t{128}; ++bit) {
    std::string bad = good;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << bit % 8));
    EXPECT_TRUE(refused(bad)) << "bit " << bit;
  }
}

TEST_P(DamagedFile, IsRefusedTenThousandTimes) {
  const std::string good = written();
  std::map<std::string, int> refusals;
  int same = 0;
  for (std::uint64_t i = 0; i < 11'000; ++i) {
    const auto [how, bytes] = Damage(good, i).mutant();
    if (bytes == good) {
      ++same;
    } else {
      EXPECT_TRUE(refused(bytes)) << GetParam().name << ", mutant " << i << ": " << how;
      ++refusals[how];
    }
  }
  int all = 0;
  for (const auto& [how, count] : refusals) {
    std::printf("%6d %s\n", count, how.c_str());
    all += count;
  }
  std::printf("%6d mutants of a %s, and %d that are no mutants\n", all, GetParam().name.c_str(), same);
  EXPECT_GE(all, 10'000);
  EXPECT_EQ(refusals.size(), 7U);
}

INSTANTIATE_TEST_SUITE_P(OfBothKinds, DamagedFile, ::testing::ValuesIn(kinds),
                         [](const auto& about) { return about.param.name == "tree" ? "Tree" : "CompactTree"; });

TEST(Checksum, IsThatOfTheStandards) {
  const auto of = [](std::initializer_list<std::string_view> pieces) {
    space::Checksum c;
    for (const std::string_view piece : pieces) c.add(std::as_bytes(std::span(piece)));
    return c.value();
  };
  EXPECT_EQ(of({"123456789"}), 0xcbf43926'091e01deU);
  EXPECT_EQ(of({"1234", "", "56789"}), of({"123456789"}));
  EXPECT_EQ(of({}), 1U);
  const std::string large(200'000, 'x'), half(100'000, 'x');
  EXPECT_EQ(of({large}), of({half, half}));
}

}  // namespace
}  // namespace plumb
